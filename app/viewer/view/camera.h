#pragma once
// From the page to the canvas and back, as deep as one likes.
//
// Page frame: core/image/density.h. Canvas frame: pixels, x right, y down, (0, 0) the canvas's upper left
// corner. Page points are integers, so that a page 2^50 pixels wide still moves by whole pixels: only
// differences between points that are near each other become floating-point numbers.

#include <glm/gtc/type_precision.hpp>
#include <glm/vec2.hpp>

#include "core/placing/placer.h"

namespace dapple {

/// In 2^-62 of a page unit, as PageWindow has it; from -2 to below 2 page units.
using PagePoint = glm::i64vec2;

/// Rounded; what is out of range goes to its end.
PagePoint page_point(glm::dvec2 page_units);
glm::dvec2 in_page_units(PagePoint point);
/// In page units, exact where they are near each other. Points may be so far apart that a PagePoint does not
/// reach from one to the other.
glm::dvec2 way_between(PagePoint from, PagePoint to);

struct Camera {
    glm::dvec2 canvas{1, 1};                 // size in pixels
    PagePoint centre{1LL << 61, 1LL << 61};  // in the canvas's middle
    double pixels_per_unit = 500;            // the picture's longer side is so many pixels

    bool operator==(const Camera&) const = default;
};

inline constexpr double kSmallestZoom = 16;     // pixels per unit
inline constexpr double kLargestZoom = 0x1p50;  // a pixel is still 4096 steps of a PagePoint

glm::dvec2 to_canvas(const Camera& camera, PagePoint point);
PagePoint point_at(const Camera& camera, glm::dvec2 canvas_point);

/// The whole page in view with a margin of a twentieth around it. `corner` is the page's where that is not
/// the picture's, in page units.
Camera fitted(glm::dvec2 canvas, glm::dvec2 page_size, glm::dvec2 corner = {0, 0});

/// Zoomed by a factor, the page point under canvas_point staying there.
Camera zoomed_at(const Camera& camera, glm::dvec2 canvas_point, double factor);

/// Moved as when the page is dragged by so many pixels.
Camera dragged(const Camera& camera, glm::dvec2 pixels);

/// The same view on a canvas of another size: what was in the middle stays there.
Camera resized(const Camera& camera, glm::dvec2 canvas);

/// The part of the page's square that is in view, with a margin of so many canvases on each side. Its width
/// or height is 0 if nothing is.
PageWindow window_in_view(const Camera& camera, double margin);

// The camera over an environment map, which always fills its canvas. The map is a page twice as wide as high,
// turned so that its middle is what the view's rotation brings there.

/// All of the map, on a canvas twice as wide as high.
Camera fitted_to_map(glm::dvec2 canvas);

/// Moved and zoomed as little as it takes for the map to fill the canvas, and not to be wider than `widest`
/// pixels.
Camera kept_on_map(Camera camera, double widest);

/// The same view on a canvas of another size.
Camera resized_on_map(Camera camera, glm::dvec2 canvas);

}  // namespace dapple
