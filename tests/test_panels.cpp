// What holds for several panels, clicked and dragged without a window.

#include <doctest/doctest.h>

#include <array>
#include <string>

#include "app/viewer/panels/compare_panel.h"
#include "app/viewer/panels/dots_panel.h"
#include "app/viewer/panels/method_panel.h"
#include "app/viewer/panels/page_panel.h"
#include "app/viewer/panels/tone_panel.h"
#include "tests/headless_ui.h"

namespace dapple {
namespace {

const std::array<std::string, 2> kTiles{"paper16", "wild64"};

}  // namespace

TEST_CASE("every panel fits its column without cutting a label") {
    ViewerSettings settings;
    HeadlessUi ui([&] {
        draw_tone_panel(settings.drawing, {});
        draw_dots_panel(settings.drawing, {});
        draw_page_panel(settings.drawing.page, settings.drawing.sheets, {200, 150, 200}, settings.unit);
        draw_method_rows(settings, {kTiles});
        draw_compare_panel(settings, {kTiles});
    });
    settings.comparison.on = true;
    ImGui::GetIO().DisplaySize.x = 340;
    ui.frame();
    ui.frame();
    for (const char* label : {"Black point", "White point", "Contrast", "Brightness", "Gamma", "Blur", "Dots",
                              "Orientation", "Sheets across", "Right placer"}) {
        CAPTURE(label);
        float start = ImGui::GetStyle().WindowPadding.x;
        CHECK(start + ImGui::CalcTextSize(label).x < ui.place(label).min.x);
        CHECK(ui.place(label).max.x < 340);
    }
}

}  // namespace dapple
