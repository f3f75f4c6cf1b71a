#include <doctest/doctest.h>

#include "app/viewer/canvas/camera_mouse.h"
#include "app/viewer/canvas/crop_frame.h"
#include "tests/headless_ui.h"

namespace dapple {
namespace {

/// A canvas over all of the screen, which no window covers.
struct CanvasUi {
    Camera camera = fitted({400, 900}, {1, 1});
    CanvasPlace place{{0, 0}, {400, 900}, {1, 1}};
    CameraMouse mouse;
    HeadlessUi ui{[this] {
        ImGui::GetIO().WantCaptureMouse = false;
        mouse.move(camera, place);
    }};
};

}  // namespace

TEST_CASE("a drag moves the page by the pointer's way since the press") {
    CanvasUi f;
    const glm::dvec2 before = to_canvas(f.camera, PagePoint(0));
    f.ui.move_to({100, 300});
    f.ui.press();
    f.ui.move_to({130, 280});
    f.ui.move_to({150, 310});
    f.ui.release();
    CHECK(glm::length(to_canvas(f.camera, PagePoint(0)) - before - glm::dvec2(50, 10)) < 1e-6);
    f.ui.move_to({10, 10});
    CHECK(glm::length(to_canvas(f.camera, PagePoint(0)) - before - glm::dvec2(50, 10)) < 1e-6);
}

TEST_CASE("a press that comes in the same frame as a long way of the pointer moves nothing") {
    CanvasUi f;
    f.ui.move_to({100, 300});
    const Camera before = f.camera;
    // A slow frame: the pointer went far and the button down before the next began.
    put_mouse_position(300, 500);
    f.ui.press();
    CHECK(f.camera == before);
    f.ui.release();
    CHECK(f.camera == before);
}

TEST_CASE("the page point under the pointer stays there while the wheel zooms") {
    CanvasUi f;
    f.ui.move_to({120, 330});
    const PagePoint under = point_at(f.camera, {120, 330});
    const double zoom = f.camera.pixels_per_unit;
    ImGui::GetIO().MouseWheel = 2;
    f.ui.frame();
    CHECK(f.camera.pixels_per_unit > zoom * 1.3);
    CHECK(glm::length(to_canvas(f.camera, under) - glm::dvec2(120, 330)) < 1e-6);
}

TEST_CASE("an edge of the crop's frame goes with the pointer, however the picture is turned") {
    // A page of 400 by 400 points, of a square picture of 200 pixels.
    struct CropUi {
        Framing framing{{{0, 0}, {200, 200}}, 0};
        Camera camera{{400, 400}, page_point({0.5, 0.5}), 400};
        CanvasPlace place{{0, 0}, {400, 400}, {1, 1}};
        std::optional<Crop> crop = {};
        CropFrame frame = {};
        HeadlessUi ui{[this] {
            ImGui::GetIO().WantCaptureMouse = false;
            frame.drag(crop, 0, framing, {200, 200}, camera, place);
            frame.draw(crop, framing, {200, 200}, camera, place);
        }};
    };
    // What is at the page's right is, before the turn: right, top, left, bottom.
    constexpr Rectangle<double> kLeft[] = {
        {{0, 0}, {75, 100}}, {{0, 25}, {100, 100}}, {{25, 0}, {100, 100}}, {{0, 0}, {100, 75}}};
    for (int turns = 0; turns < 4; ++turns) {
        CAPTURE(turns);
        CropUi f;
        f.framing.quarter_turns = turns;
        const glm::dvec2 pixel(130, 30);
        CHECK(glm::length(framed_pixel(f.framing, opened_pixel(f.framing, pixel)) - pixel) < 1e-9);
        const Framing mirrored{f.framing.pixels, turns, true};
        CHECK(glm::length(framed_pixel(mirrored, opened_pixel(mirrored, pixel)) - pixel) < 1e-9);
        f.ui.move_to({398, 200});
        f.ui.press();
        f.ui.move_to({298, 200});
        f.ui.release();
        REQUIRE(f.crop);
        CHECK(glm::length(f.crop->box.low - kLeft[turns].low) < 0.01);
        CHECK(glm::length(f.crop->box.high - kLeft[turns].high) < 0.01);
    }
}

}  // namespace dapple
