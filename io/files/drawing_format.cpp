#include "io/files/drawing_format.h"

#include <stdexcept>

#include "io/files/text_file.h"

namespace dapple {

DrawingFormat drawing_format(const std::filesystem::path& path) {
    if (const auto format = format_with_ending(ending_of(path))) return *format;
    throw std::runtime_error(path.string() + ": a drawing's name must end in " + drawing_endings());
}

}  // namespace dapple
