// The part of the window that shows the page, with Dear ImGui but without a window.

#include "app/viewer/canvas/canvas.h"

#include <doctest/doctest.h>

#include "tests/headless_ui.h"
#include "tests/offscreen_gl.h"

namespace dapple {
namespace {

/// What the canvas has put behind ImGui's windows.
Grid<glm::u8vec4> shown_pixels() {
    GLuint texture = 0;
    for (const ImDrawCmd& command : ImGui::GetBackgroundDrawList()->CmdBuffer)
        if (command.ElemCount > 0)
            texture = static_cast<GLuint>(
                reinterpret_cast<std::uintptr_t>(reinterpret_cast<void*>(command.GetTexID())));
    GLint width = 0, height = 0;
    glBindTexture(GL_TEXTURE_2D, texture);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &height);
    Grid<glm::u8vec4> pixels(width, height);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels.values.data());
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
            REQUIRE(pixels.width == 200);
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

}  // namespace dapple
