#include "app/viewer/model/shown_pens.h"

#include <algorithm>

namespace dapple {

std::uint32_t hidden_among(std::span<const Pen> pens, const ShownPens& shown) {
    const bool alone = std::ranges::find(pens, shown.only, &Pen::name) != pens.end();
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < pens.size(); ++i) {
        const std::string& name = pens[i].name;
        if (alone ? name != shown.only : shown.hidden.contains(name)) bits |= std::uint32_t{1} << i;
    }
    return bits;
}

}  // namespace dapple
