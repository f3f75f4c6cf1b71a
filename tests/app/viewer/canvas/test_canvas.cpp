// The part of the window that shows the page, with Dear ImGui but without a window.

#include "app/viewer/canvas/canvas.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <span>

#include "tests/headless_ui.h"
#include "tests/offscreen_gl.h"

namespace dapple {
namespace {

/// What the canvas has put behind ImGui's windows, the top row first.
Grid<glm::u8vec4> shown_pixels() {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    GlFramebuffer window;
    window.resize({size.x, size.y});
    window.bind();
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    const ImDrawList* const list = ImGui::GetBackgroundDrawList();
    for (const ImDrawCmd& command : list->CmdBuffer)
        if (command.UserCallback) command.UserCallback(list, &command);
    window.bind();
    const Grid<glm::u8vec4> upside_down = read_pixels(window.size());
    Grid<glm::u8vec4> pixels(upside_down.width, upside_down.height);
    for (int y = 0; y < pixels.height; ++y)
        std::ranges::copy(std::span(upside_down.row(y), pixels.width), pixels.row(pixels.height - 1 - y));
    return pixels;
}

}  // namespace

TEST_CASE("the left side of the split view is as wide as the divider says, quickly drawn and fully") {
    const OffscreenContext context;
    Canvas canvas;
    PlacedDrawing drawing;
    for (const Side side : kSides) canvas.set_drawing(side, drawing);
    SplitLook look;
    look.sides[0].paper = {1, 0, 0};
    look.sides[1].paper = {0, 0, 1};
    HeadlessUi ui([&] { canvas.show({.corner = {0, 0}, .size = {200, 150}}, look, Redraw::when_changed); });
    canvas.zoom(3);  // the page is all that is seen
    for (const float divider : {0.2f, 0.5f, 0.85f, 1.0f}) {
        look.divider = divider;
        for (const bool rested : {false, true}) {
            CAPTURE(divider);
            CAPTURE(rested);
            ui.frame();
            if (rested)
                while (canvas.seconds_to_next_frame() || canvas.drawing()) ui.frame();
            const Grid<glm::u8vec4> pixels = shown_pixels();
            int red = 0, blue = 0;
            for (int x = 0; x < 200; ++x) {
                const glm::u8vec4 pixel = pixels.at(x, 75);
                const bool on_left = static_cast<float>(x) < 200 * divider;
                red += on_left && pixel.r > 200 && pixel.b < 50;
                blue += !on_left && pixel.b > 200 && pixel.r < 50;
            }
            CHECK(red + blue == 200);
            CHECK(red > 30);
        }
    }
}

TEST_CASE(
    "the canvas is shown where it lies in the window, its top at the top, also when it is drawn again") {
    const OffscreenContext context;
    Canvas canvas;
    PlacedDrawing drawing;
    drawing.dots.pieces.resize(1);
    drawing.dots.pieces[0].x = {0.1f};
    drawing.dots.pieces[0].y = {0.2f};
    drawing.blocks = dot_blocks(drawing.dots);
    canvas.set_drawing(Side::left, drawing);
    SplitLook look;
    for (CanvasLook& side : look.sides) side = {.desk = {1, 0, 0}, .ink = {0, 0, 1}, .dot_radius = 0.05};
    HeadlessUi ui([&] { canvas.show({.corner = {40, 30}, .size = {200, 150}}, look, Redraw::when_changed); });
    for (const bool again : {false, true}) {
        CAPTURE(again);
        if (again) {  // the desk stays, the paper is another
            for (CanvasLook& side : look.sides) side.paper = {0, 1, 0};
            canvas.set_drawing(Side::left, drawing);
        }
        ui.frame();
        const Grid<glm::u8vec4> pixels = shown_pixels();
        const auto at = [&](glm::vec2 on_canvas) {
            return glm::ivec4(
                pixels.at(40 + static_cast<int>(on_canvas.x), 30 + static_cast<int>(on_canvas.y)));
        };
        const glm::vec2 corner = to_canvas(canvas.camera(), PagePoint(0)),
                        end = to_canvas(canvas.camera(), page_point({1, 1}));
        CHECK(at(glm::mix(corner, end, glm::vec2(0.1f, 0.2f))) == glm::ivec4(0, 0, 255, 255));
        CHECK(at(glm::mix(corner, end, glm::vec2(0.1f, 0.8f))) ==
              glm::ivec4(again ? 0 : 255, 255, again ? 0 : 255, 255));
        CHECK(at({2, 2}).g == 0);  // the desk
        CHECK(at({2, 2}).r > 150);
        CHECK(pixels.at(39, 100).r == 0);  // beside the canvas
        CHECK(pixels.at(100, 181).r == 0);
    }
    for (CanvasLook& side : look.sides) side.desk = {0, 1, 1};
    ui.frame();
    CHECK(shown_pixels().at(42, 32).r == 0);
    CHECK(shown_pixels().at(42, 32).g > 150);
}

}  // namespace dapple
