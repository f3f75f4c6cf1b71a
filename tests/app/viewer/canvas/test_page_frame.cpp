// The lines of margins and sheets, where ImGui is told to draw them.

#include <doctest/doctest.h>
#include <imgui.h>

#include <functional>
#include <vector>

#include "app/viewer/canvas/page_frame.h"
#include "tests/headless_ui.h"

namespace dapple {
namespace {

/// A page of 200 x 100 mm with margins of 10 mm, two pixels a millimetre, its corner in the canvas's.
struct ShownPage {
    PageLayout layout{
        .page = {200, 100, 180}, .picture = {{10, 10}, {190, 90}}, .within_margins = {{10, 10}, {190, 90}}};
    Camera camera;
    CanvasPlace place{.corner = {0, 0}, .size = {400, 200}};
    std::function<void()> draw;
    std::vector<glm::vec2> corners;  // of what was drawn behind ImGui's windows
    HeadlessUi ui{[this] {
        if (!draw) return;
        draw();
        corners.clear();
        for (const ImDrawVert& each : ImGui::GetBackgroundDrawList()->VtxBuffer)
            corners.emplace_back(each.pos.x, each.pos.y);
    }};

    ShownPage() {
        ImGui::GetIO().DisplaySize = {400, 200};
        camera.canvas = {400, 200};
        camera.pixels_per_unit = 360;
        camera.centre = page_point({0.5, 40.0 / 180});
    }
    void show(std::function<void()> drawn) {
        draw = std::move(drawn);
        ui.frame();
    }
    /// Whether some corner lies there, but for a line's width and the softness of its edge.
    bool has(glm::vec2 at) const {
        for (const glm::vec2 corner : corners)
            if (glm::distance(corner, at) < 2.5f) return true;
        return false;
    }
};

}  // namespace

TEST_CASE("margins are a frame on the page, and a page without them has none") {
    ShownPage page;
    page.show([&] { draw_margin_lines(page.layout, page.camera, page.place); });
    for (const glm::vec2 corner :
         {glm::vec2(20, 20), glm::vec2(380, 20), glm::vec2(20, 180), glm::vec2(380, 180)})
        CHECK(page.has(corner));
    for (const glm::vec2 corner : page.corners)
        CHECK((corner.x < 25 || corner.x > 375 || corner.y < 25 || corner.y > 175));
    page.layout.within_margins = {{0, 0}, {200, 100}};
    page.show([&] { draw_margin_lines(page.layout, page.camera, page.place); });
    CHECK(page.corners.empty());
}

TEST_CASE("sheets are lines where one ends and the next begins, and a strip where they overlap") {
    ShownPage page;
    Sheet sheets{.columns = 2, .rows = 1};
    const auto show = [&] {
        page.show([&] { draw_sheet_lines(page.layout, sheets, page.camera, page.place); });
    };
    show();
    CHECK(page.has({200, 0}));
    CHECK(page.has({200, 200}));
    sheets.overlap_mm = 20;  // of sheets of 110 mm
    show();
    for (const glm::vec2 corner :
         {glm::vec2(180, 0), glm::vec2(220, 0), glm::vec2(180, 200), glm::vec2(220, 200)})
        CHECK(page.has(corner));
    CHECK_FALSE(page.has({200, 0}));
    sheets = {.columns = 1, .rows = 4};
    show();
    for (const float y : {50.0f, 100.0f, 150.0f}) CHECK(page.has({400, y}));
    for (const Sheet& none : {Sheet{}, Sheet{.columns = 2, .rows = 1, .overlap_mm = 300}}) {
        sheets = none;
        show();
        CHECK(page.corners.empty());
    }
}

}  // namespace dapple
