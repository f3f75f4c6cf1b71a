#include "core/image/refinement.h"

#include <algorithm>

namespace dapple {

Refinement::Refinement(const Mask& mask, const Framing& framing, glm::ivec2 picture) {
    if (!mask.has_finer()) return;
    mask_ = mask;
    const Grid<std::uint8_t>& fineness = mask.fineness();
    const glm::dvec2 share(double(fineness.width) / picture.x, double(fineness.height) / picture.y);
    const double unit = std::max(framing.size().x, framing.size().y);
    const auto in_mask = [&](glm::dvec2 framed) { return opened_pixel(framing, framed) * share; };
    corner_ = in_mask({0, 0});
    across_ = in_mask({unit, 0}) - corner_;
    down_ = in_mask({0, unit}) - corner_;
    const auto [least, most] = std::ranges::minmax(fineness.values);
    least_times_ = times_finer(least);
    most_times_ = times_finer(most);
}

}  // namespace dapple
