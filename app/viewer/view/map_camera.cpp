#include "app/viewer/view/map_camera.h"

#include <algorithm>
#include <glm/common.hpp>

namespace dapple {

namespace {

constexpr glm::dvec2 kMapSize{1, 0.5};  // page units

}  // namespace

Camera fitted_to_map(glm::dvec2 canvas) {
    return {canvas, page_point(kMapSize / 2.0), canvas.x};
}

Camera kept_on_map(Camera camera, double widest) {
    const double least = std::max(camera.canvas.x / kMapSize.x, camera.canvas.y / kMapSize.y);
    camera.pixels_per_unit = std::max(std::min(camera.pixels_per_unit, widest), least);
    const glm::dvec2 half = glm::min(camera.canvas / camera.pixels_per_unit, kMapSize) / 2.0;
    camera.centre = page_point(glm::clamp(in_page_units(camera.centre), half, kMapSize - half));
    return camera;
}

Camera resized_on_map(Camera camera, glm::dvec2 canvas) {
    camera.pixels_per_unit *= canvas.x / camera.canvas.x;
    camera.canvas = canvas;
    return camera;
}

}  // namespace dapple
