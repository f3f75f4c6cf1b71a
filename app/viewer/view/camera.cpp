#include "app/viewer/view/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

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

namespace {

constexpr double kUnits = 0x1p62;  // of a PagePoint in a page unit
constexpr std::int64_t kPage = std::int64_t{1} << 62;

std::int64_t moved(std::int64_t from, double units) {
    const double end = static_cast<double>(from) + units;
    if (end >= 2 * kUnits) return std::numeric_limits<std::int64_t>::max();
    if (end <= -2 * kUnits) return std::numeric_limits<std::int64_t>::min();
    if (std::abs(units) >= 2 * kUnits) return static_cast<std::int64_t>(end);
    return from + std::llround(units);
}

PagePoint moved(PagePoint from, glm::dvec2 page_units) {
    return {moved(from.x, page_units.x * kUnits), moved(from.y, page_units.y * kUnits)};
}

// Exact wherever the difference is small.
double difference(std::int64_t a, std::int64_t b) {
    std::int64_t exact = 0;
    if (__builtin_sub_overflow(a, b, &exact)) return static_cast<double>(a) - static_cast<double>(b);
    return static_cast<double>(exact);
}

}  // namespace

PagePoint page_point(glm::dvec2 page_units) {
    return moved(PagePoint(0), page_units);
}

glm::dvec2 in_page_units(PagePoint point) {
    return glm::dvec2(point) / kUnits;
}

glm::dvec2 way_between(PagePoint from, PagePoint to) {
    return glm::dvec2(difference(to.x, from.x), difference(to.y, from.y)) / kUnits;
}

glm::dvec2 to_canvas(const Camera& camera, PagePoint point) {
    return way_between(camera.centre, point) * camera.pixels_per_unit + camera.canvas * 0.5;
}

PagePoint point_at(const Camera& camera, glm::dvec2 canvas_point) {
    return moved(camera.centre, (canvas_point - camera.canvas * 0.5) / camera.pixels_per_unit);
}

Camera fitted(glm::dvec2 canvas, glm::dvec2 page_size, glm::dvec2 corner) {
    double fit = std::min(canvas.x / page_size.x, canvas.y / page_size.y) * 0.9;
    return {canvas, page_point(corner + page_size * 0.5), std::clamp(fit, kSmallestZoom, kLargestZoom)};
}

Camera zoomed_at(const Camera& camera, glm::dvec2 canvas_point, double factor) {
    Camera zoomed = camera;
    zoomed.pixels_per_unit = std::clamp(camera.pixels_per_unit * factor, kSmallestZoom, kLargestZoom);
    const glm::dvec2 from_middle = canvas_point - camera.canvas * 0.5;
    zoomed.centre =
        moved(camera.centre, from_middle / camera.pixels_per_unit - from_middle / zoomed.pixels_per_unit);
    return zoomed;
}

Camera dragged(const Camera& camera, glm::dvec2 pixels) {
    Camera moved_camera = camera;
    moved_camera.centre = moved(camera.centre, -pixels / camera.pixels_per_unit);
    return moved_camera;
}

Camera resized(const Camera& camera, glm::dvec2 canvas) {
    Camera same = camera;
    same.canvas = canvas;
    return same;
}

PageWindow window_in_view(const Camera& camera, double margin) {
    const PagePoint low =
        glm::clamp(point_at(camera, -margin * camera.canvas), PagePoint(0), PagePoint(kPage));
    const PagePoint high =
        glm::clamp(point_at(camera, (1 + margin) * camera.canvas), PagePoint(0), PagePoint(kPage));
    const glm::dvec2 size = in_page_units(high - low);
    return {low.x, low.y, size.x, size.y};
}

}  // namespace dapple
