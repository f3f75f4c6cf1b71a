#pragma once
// Which part of a picture is drawn, and how it is turned.

#include <glm/gtc/type_precision.hpp>
#include <glm/vec2.hpp>

#include "core/image/grid.h"
#include "core/image/rectangle.h"

namespace dapple {

/// Pixels of the picture as it was opened, cut out first; then so many quarter turns clockwise, 0..3.
struct Framing {
    Rectangle<int> pixels;
    int quarter_turns = 0;

    bool operator==(const Framing&) const = default;

    /// The result's size in pixels.
    glm::ivec2 size() const {
        const glm::ivec2 cut = pixels.size();
        return quarter_turns % 2 ? glm::ivec2(cut.y, cut.x) : cut;
    }
};

/// All of a picture of that size, as it is.
inline Framing whole_picture(glm::ivec2 size) {
    return {{{0, 0}, size}, 0};
}

/// Where a point of the framed picture lies on the picture as it was opened, both in pixels from the upper
/// left corner.
glm::dvec2 opened_pixel(const Framing& framing, glm::dvec2 framed);

/// The picture's pixels, moved and none changed. Needs a rectangle within the picture that is not empty.
Grid<float> framed(const Grid<float>& picture, const Framing& framing);
Grid<glm::u16vec3> framed(const Grid<glm::u16vec3>& picture, const Framing& framing);

}  // namespace dapple
