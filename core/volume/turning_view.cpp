#include "core/volume/turning_view.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <numbers>
#include <vector>

#include "core/image/tone.h"
#include "core/volume/space_cells.h"

namespace dapple {

Grid<glm::u8vec3> turned_view(std::span<const glm::dvec3> dots, double turn, int side) {
    constexpr double kDownwards = 0.35;          // radians
    constexpr int kParts = 4;                    // of a pixel's side, for soft edges
    constexpr float kNear = 0.15f, kFar = 0.9f;  // the root of light
    const Box box = box_around(dots);
    const glm::dvec3 middle = (box.low + box.high) / 2.0;
    const double reach = std::max(glm::length(box.high - box.low) / 2, 1e-300);
    const double pixels = side / 2.1 / reach;
    // A quarter of the distance that dots have which fill the box.
    const double radius =
        std::clamp(0.3 * reach / std::cbrt(static_cast<double>(dots.size() + 1)) * pixels, 0.6, side / 30.0);
    struct Seen {
        double x, y, depth;
    };
    std::vector<Seen> seen;
    const double angle = 2 * std::numbers::pi * turn, c = std::cos(angle), s = std::sin(angle);
    for (const glm::dvec3& dot : dots) {
        const glm::dvec3 at = dot - middle;
        const double across = c * at.x - s * at.y, away = s * at.x + c * at.y;
        seen.push_back({side / 2.0 + pixels * across,
                        side / 2.0 - pixels * (at.z * std::cos(kDownwards) + away * std::sin(kDownwards)),
                        (away * std::cos(kDownwards) - at.z * std::sin(kDownwards)) / reach});
    }
    std::ranges::stable_sort(seen, std::greater(), &Seen::depth);
    Grid<float> light(side * kParts, side * kParts, 1.0f);
    const double nearest = seen.empty() ? 0 : seen.back().depth,
                 range = seen.empty() ? 1 : std::max(seen.front().depth - nearest, 1e-9);
    for (const Seen& dot : seen) {
        const double x = dot.x * kParts, y = dot.y * kParts, r = radius * kParts;
        const float root = glm::mix(kNear, kFar, static_cast<float>((dot.depth - nearest) / range));
        for (int v = std::max(0, static_cast<int>(y - r)); v <= std::min(light.height - 1.0, y + r); ++v)
            for (int u = std::max(0, static_cast<int>(x - r)); u <= std::min(light.width - 1.0, x + r); ++u)
                if (std::hypot(u + 0.5 - x, v + 0.5 - y) <= r) light.at(u, v) = root * root;
    }
    Grid<glm::u8vec3> picture(side, side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            float sum = 0;
            for (int v = 0; v < kParts; ++v)
                for (int u = 0; u < kParts; ++u) sum += light.at(x * kParts + u, y * kParts + v);
            picture.at(x, y) = glm::u8vec3(
                static_cast<std::uint8_t>(std::lround(255 * linear_to_srgb(sum / (kParts * kParts)))));
        }
    return picture;
}

}  // namespace dapple
