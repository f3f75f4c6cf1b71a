#include <doctest/doctest.h>

#include <glm/geometric.hpp>
#include <random>

#include "app/viewer/view/camera.h"

namespace dapple {
namespace {

const glm::dvec2 kCanvas{600, 300};

bool fills_canvas(const Camera& camera) {
    const glm::dvec2 first = to_canvas(camera, page_point({0, 0}));
    const glm::dvec2 last = to_canvas(camera, page_point({1, 0.5}));
    constexpr double kSlack = 1e-6;
    return first.x <= kSlack && first.y <= kSlack && last.x >= camera.canvas.x - kSlack &&
           last.y >= camera.canvas.y - kSlack;
}

}  // namespace

TEST_CASE("the fitted camera sees all of the map and nothing else") {
    const Camera camera = fitted_to_map(kCanvas);
    CHECK(glm::length(to_canvas(camera, page_point({0, 0}))) < 1e-9);
    CHECK(glm::length(to_canvas(camera, page_point({1, 0.5})) - kCanvas) < 1e-9);
    CHECK(kept_on_map(camera, 5000) == camera);
}

TEST_CASE("however one zooms and drags, the map fills its canvas") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> x(0, kCanvas.x), y(0, kCanvas.y), factor(0.5, 2.2), way(-900, 900);
    Camera camera = fitted_to_map(kCanvas);
    for (int i = 0; i < 500; ++i) {
        camera = zoomed_at(camera, {x(random), y(random)}, factor(random));
        camera = kept_on_map(dragged(camera, {way(random), way(random)}), 5000);
        CHECK(fills_canvas(camera));
        CHECK(camera.pixels_per_unit <= 5000);
    }
}

TEST_CASE("within the map a zoom keeps the place under the pointer") {
    const Camera before = fitted_to_map(kCanvas);
    const PagePoint under = point_at(before, {450, 100});
    const Camera camera = kept_on_map(zoomed_at(before, {450, 100}, 3), 5000);
    CHECK(glm::length(to_canvas(camera, under) - glm::dvec2(450, 100)) < 1e-6);
}

TEST_CASE("a map smaller than its canvas still fills it") {
    CHECK(kept_on_map(fitted_to_map(kCanvas), 16) == fitted_to_map(kCanvas));
}

TEST_CASE("a canvas of another size shows the same part of the map") {
    const Camera before = kept_on_map(zoomed_at(fitted_to_map(kCanvas), {100, 50}, 4), 5000);
    const Camera after = resized_on_map(before, 2.0 * kCanvas);
    for (const glm::dvec2 corner : {glm::dvec2(0), kCanvas}) {
        const PagePoint seen = point_at(before, corner);
        CHECK(glm::length(to_canvas(after, seen) - 2.0 * corner) < 1e-6);
    }
}

}  // namespace dapple
