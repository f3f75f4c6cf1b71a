#pragma once
// A round brush that paints a mask.

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>

#include "core/image/grid.h"
#include "core/image/mask.h"

namespace dapple {

enum class BrushKind { more, fewer, none, finer, erase };

struct Brush {
    BrushKind kind = BrushKind::more;
    double radius = 0.05;   // in units of the picture's longer side
    double softness = 0.5;  // the share of the radius over which it fades, 0..1
    double strength = 1;    // how far towards its level one stroke goes, 0..1

    bool operator==(const Brush&) const = default;
};

/// How much of the brush is at a distance from the stroke, in radii: 1 up to 1 - softness, then falling as
/// 3t^2 - 2t^3 does to 0 at 1.
double brush_cover(double radii, double softness);

/// From pressing the button to letting it go. Where it goes over itself it does not become stronger, so that
/// it depends neither on how fast the mouse moves nor on how often it is asked.
class BrushStroke {
 public:
    /// On a picture of so many pixels.
    BrushStroke(const Mask& mask, glm::ivec2 picture, const Brush& brush);

    /// Goes on in a straight line; the first point is where it begins. In units of the picture's longer side.
    void go_to(glm::dvec2 point);

    /// The mask with all of the stroke so far.
    Mask mask() const;

 private:
    Grid<std::uint8_t> levels_, fineness_;  // before the stroke
    Grid<float> cover_;
    Brush brush_;
    glm::dvec2 pixels_per_unit_;  // of the mask
    std::optional<glm::dvec2> last_;
};

}  // namespace dapple
