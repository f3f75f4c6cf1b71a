#include "core/settings/mask_text.h"

#include <zlib.h>

#include <stdexcept>
#include <vector>

#include "core/text/base64.h"

namespace dapple {

std::string packed_levels(const Grid<std::uint8_t>& grid) {
    const std::vector<std::uint8_t>& levels = grid.values;
    uLongf size = compressBound(static_cast<uLong>(levels.size()));
    std::string packed(size, '\0');
    const int outcome = compress2(reinterpret_cast<Bytef*>(packed.data()), &size, levels.data(),
                                  static_cast<uLong>(levels.size()), Z_BEST_COMPRESSION);
    if (outcome != Z_OK) throw std::runtime_error("no memory to pack a mask");
    packed.resize(size);
    return base64_of(packed);
}

Grid<std::uint8_t> unpacked_levels(std::string_view text, int width, int height) {
    const std::string packed = bytes_of_base64(text);
    Grid<std::uint8_t> levels(width, height);
    uLongf size = static_cast<uLongf>(levels.values.size());
    const int outcome = uncompress(levels.values.data(), &size, reinterpret_cast<const Bytef*>(packed.data()),
                                   static_cast<uLong>(packed.size()));
    if (outcome != Z_OK || size != levels.values.size())
        throw std::runtime_error("are not as many as width and height say, or damaged");
    return levels;
}

}  // namespace dapple
