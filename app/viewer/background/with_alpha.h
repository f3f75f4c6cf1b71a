#pragma once
// Pictures as textures take them.

#include <algorithm>
#include <glm/gtc/type_precision.hpp>

#include "core/image/grid.h"

namespace dapple {

inline Grid<glm::u8vec4> with_alpha(const Grid<glm::u8vec3>& picture) {
    Grid<glm::u8vec4> opaque(picture.width, picture.height);
    std::ranges::transform(picture.values, opaque.values.begin(),
                           [](glm::u8vec3 pixel) { return glm::u8vec4(pixel, 255); });
    return opaque;
}

}  // namespace dapple
