#pragma once
// How light a part of a picture is.

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_precision.hpp>

#include "core/image/grid.h"
#include "core/image/rectangle.h"
#include "core/image/tone.h"

namespace dapple {

/// The mean linear light of the picture's sRGB-encoded pixels, or parts of them, in the box, which has to be
/// within it.
template <class Pixel>
glm::dvec3 mean_light(const Grid<Pixel>& picture, const Rectangle<double>& box) {
    const auto share = [](int at, double low, double high) {
        return std::min(at + 1.0, high) - std::max<double>(at, low);
    };
    glm::dvec3 sum(0);
    for (int y = static_cast<int>(box.low.y); y < box.high.y; ++y) {
        for (int x = static_cast<int>(box.low.x); x < box.high.x; ++x) {
            const double weight = share(x, box.low.x, box.high.x) * share(y, box.low.y, box.high.y);
            const glm::vec3 encoded = glm::vec3(picture.at(x, y)) / 255.0f;
            for (int c = 0; c < 3; ++c) sum[c] += weight * srgb_to_linear(encoded[c]);
        }
    }
    return sum / ((box.high.x - box.low.x) * (box.high.y - box.low.y));
}

}  // namespace dapple
