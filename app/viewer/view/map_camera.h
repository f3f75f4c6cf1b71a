#pragma once
// The camera over an environment map, which always fills its canvas. The map is a page twice as wide as high,
// turned so that its middle is what the view's rotation brings there.

#include <glm/vec2.hpp>

#include "app/viewer/view/camera.h"

namespace dapple {

/// All of the map, on a canvas twice as wide as high.
Camera fitted_to_map(glm::dvec2 canvas);

/// Moved and zoomed as little as it takes for the map to fill the canvas, and not to be wider than `widest`
/// pixels.
Camera kept_on_map(Camera camera, double widest);

/// The same view on a canvas of another size.
Camera resized_on_map(Camera camera, glm::dvec2 canvas);

}  // namespace dapple
