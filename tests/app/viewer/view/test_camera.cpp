#include <doctest/doctest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

#include "app/viewer/view/camera.h"
#include "core/placing/stipple.h"

namespace dapple {
namespace {

void check_same(glm::dvec2 a, glm::dvec2 b, double tolerance = 1e-9) {
    CHECK(a.x == doctest::Approx(b.x).epsilon(tolerance));
    CHECK(a.y == doctest::Approx(b.y).epsilon(tolerance));
}

glm::dvec2 to_canvas(const Camera& camera, glm::dvec2 p) {
    return to_canvas(camera, page_point(p));
}
glm::dvec2 to_page(const Camera& camera, glm::dvec2 canvas_point) {
    return in_page_units(point_at(camera, canvas_point));
}

}  // namespace

TEST_CASE("page to canvas and back is the identity") {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(0.1, 1);
    for (int i = 0; i < 100; ++i) {
        Camera camera{{1000 * unit(random), 800 * unit(random)},
                      page_point({unit(random), unit(random)}),
                      1e4 * unit(random)};
        glm::dvec2 p{unit(random), unit(random)};
        check_same(to_page(camera, to_canvas(camera, p)), p);
    }
}

TEST_CASE("a fitted page lies inside the canvas, in its middle") {
    for (glm::dvec2 page : {glm::dvec2(1, 1), glm::dvec2(1, 0.2), glm::dvec2(0.05, 1)})
        for (glm::dvec2 canvas : {glm::dvec2(900, 700), glm::dvec2(300, 1200)}) {
            Camera camera = fitted(canvas, page);
            glm::dvec2 low = to_canvas(camera, glm::dvec2(0)), high = to_canvas(camera, page);
            CHECK(low.x > 0);
            CHECK(low.y > 0);
            CHECK(high.x < canvas.x);
            CHECK(high.y < canvas.y);
            check_same(low + high, canvas);
            // It is as large as the margin allows.
            CHECK(std::max((high.x - low.x) / canvas.x, (high.y - low.y) / canvas.y) == doctest::Approx(0.9));
        }
}

TEST_CASE("zooming keeps the page point under the mouse where it is") {
    Camera camera = fitted({900, 700}, {1, 0.75});
    glm::dvec2 mouse{123, 456};
    glm::dvec2 under = to_page(camera, mouse);
    for (double factor : {1.2, 3.0, 0.1, 7.0, 50.0}) {
        camera = zoomed_at(camera, mouse, factor);
        check_same(to_page(camera, mouse), under);
    }
}

TEST_CASE("zooming in and out again is no change, and zoom has limits") {
    Camera camera = fitted({900, 700}, {1, 1});
    Camera back = zoomed_at(zoomed_at(camera, {10, 20}, 4), {10, 20}, 0.25);
    check_same(in_page_units(back.centre), in_page_units(camera.centre));
    CHECK(back.pixels_per_unit == doctest::Approx(camera.pixels_per_unit));
    CHECK(zoomed_at(camera, {0, 0}, 1e30).pixels_per_unit == kLargestZoom);
    CHECK(zoomed_at(camera, {0, 0}, 1e-30).pixels_per_unit == kSmallestZoom);
}

TEST_CASE("dragging moves the page with the mouse") {
    Camera camera = fitted({900, 700}, {1, 1});
    glm::dvec2 p{0.3, 0.4}, by{50, -20};
    check_same(to_canvas(dragged(camera, by), p), to_canvas(camera, p) + by);
}

TEST_CASE("a resized canvas keeps its middle and zoom") {
    Camera camera = dragged(fitted({900, 700}, {1, 1}), {30, 10});
    Camera wide = resized(camera, {1600, 500});
    check_same(to_page(wide, {800, 250}), to_page(camera, {450, 350}));
    CHECK(wide.pixels_per_unit == camera.pixels_per_unit);
}

TEST_CASE("a page 2^50 pixels wide moves by whole pixels, as integers say") {
    // 4096 steps of a page point are a pixel there.
    std::mt19937_64 random(2);
    for (int i = 0; i < 100; ++i) {
        const auto x = static_cast<std::int64_t>(random() >> 2), y = static_cast<std::int64_t>(random() >> 2);
        Camera camera{{900, 700}, {x, y}, kLargestZoom};
        const auto right = static_cast<std::int64_t>(random() % 800'000);
        CHECK(to_canvas(camera, PagePoint(x + right, y - right)) ==
              glm::dvec2(450 + static_cast<double>(right) / 4096, 350 - static_cast<double>(right) / 4096));
        CHECK(point_at(camera, {451, 352}) == PagePoint(x + 4096, y + 2 * 4096));
        CHECK(dragged(camera, {7, -3}).centre == PagePoint(x - 7 * 4096, y + 3 * 4096));
    }
}

TEST_CASE("zooming in 2^40 times and out again comes back to the same pixel") {
    Camera camera = fitted({900, 700}, {1, 1});
    const glm::dvec2 mouse{321.5, 123.25};
    const PagePoint under = point_at(camera, mouse);
    Camera deep = camera;
    for (int i = 0; i < 40; ++i) {
        deep = zoomed_at(deep, mouse, 2);
        const glm::dvec2 now = to_canvas(deep, under);
        CHECK(glm::distance(now, mouse) < 0.01);
    }
    CHECK(deep.pixels_per_unit == camera.pixels_per_unit * 0x1p40);
    for (int i = 0; i < 40; ++i) deep = zoomed_at(deep, mouse, 0.5);
    check_same(in_page_units(deep.centre), in_page_units(camera.centre));
}

TEST_CASE("the window in view is the page's part of it, empty beside the page") {
    Camera camera{{800, 600}, page_point({0.5, 0.5}), 2000};
    PageWindow window = window_in_view(camera, 0);
    check_same(in_page_units({window.x, window.y}), {0.3, 0.35});
    check_same({window.width, window.height}, {0.4, 0.3});
    window = window_in_view(fitted({800, 600}, {1, 1}), 0.5);
    CHECK(window == PageWindow{});
    camera.centre = page_point({1.5, 0.5});
    CHECK(window_in_view(camera, 0).width == 0);
}

TEST_CASE("two windows a pixel apart, 2^40 times enlarged, show the same dots in the same places") {
    RankedTile tile(make_tile(14217, 2895, 16), RankingMethod::energy);
    const Density grey(Grid<float>(4, 4, 0.5f));
    Camera camera{{400, 300}, page_point({0.7123, 0.4321}), 400 * 0x1p40};
    auto dots_in_view = [&](const Camera& seen) {
        PlacingRequest request{.scale = 50 * 0x1p80, .window = window_in_view(seen, 0)};
        DotPieces dots;
        CHECK(tile.placer().place(grey, request, dots));
        const glm::dvec2 corner = to_canvas(camera, PagePoint(request.window.x, request.window.y));
        std::vector<glm::dvec2> pixels;
        for_each_position(dots, [&](float x, float y) {
            pixels.push_back(corner + glm::dvec2(x, y) * camera.pixels_per_unit);
        });
        return pixels;
    };
    const auto here = dots_in_view(camera), there = dots_in_view(dragged(camera, {-1, 0}));
    // 16 * 50 * 0.5 dots to 400 x 400 pixels of constant density.
    CHECK(here.size() == doctest::Approx(16 * 50 * 0.5 * 0.75).epsilon(0.1));
    std::size_t matched = 0;
    for (glm::dvec2 dot : here)
        for (glm::dvec2 other : there) matched += glm::distance(dot, other) < 0.01;
    const auto on_the_edge = std::ranges::count_if(here, [](glm::dvec2 dot) { return dot.x < 1.01; });
    CHECK(matched >= here.size() - static_cast<std::size_t>(on_the_edge));
    CHECK(matched <= here.size());
}

}  // namespace dapple
