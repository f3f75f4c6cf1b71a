// What holds for several panels, clicked and dragged without a window.

#include <doctest/doctest.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <string>

#include "app/viewer/panels/method_panels.h"
#include "app/viewer/panels/settings_panels.h"
#include "app/viewer/panels/window_panels.h"
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
        draw_page_panel(settings.drawing.page, settings.drawing.sheets, {.page = {200, 150, 200}},
                        settings.unit);
        draw_method_rows(settings, {kTiles});
        draw_compare_panel(settings, {kTiles});
    });
    settings.comparison.on = true;
    settings.drawing.page.paper = Paper::a4;
    ImGui::GetIO().DisplaySize = {340, 2000};
    for (const char* more : {"More tone settings", "More page settings"}) ui.click(more);
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

TEST_CASE("five steps lead through the method, a click each, from whatever was shown") {
    ViewerSettings settings;
    settings.drawing.placer = PlacerKind::figure8;
    HeadlessUi ui([&] { draw_steps(settings); });
    ui.click("tile");
    CHECK(settings.drawing.placer == PlacerKind::exact);
    CHECK(settings.drawing.show_tiles);
    CHECK(settings.deepest_level == 0);
    ui.click("copies");
    CHECK(settings.deepest_level == kDeepestStep);
    CHECK(settings.colouring == DotColouring::level);
    ui.click("ranks");
    CHECK(settings.colouring == DotColouring::rank);
    CHECK_FALSE(settings.loupe.on);
    ui.click("period");
    CHECK(settings.drawing.tile == "paper16");
    CHECK(settings.loupe.on);
    CHECK(settings.colouring == DotColouring::ink);
    CHECK(settings.density.source == DensitySource::grey);
    ui.click("cure");
    CHECK(settings.drawing.tile == kDefaultTile);
    ui.click("tile");
    CHECK_FALSE(settings.loupe.on);
    CHECK(settings.density.source == DensitySource::photograph);
}

TEST_CASE("over the canvas Compare is held as long as the mouse holds it") {
    bool held = false;
    HeadlessUi ui([&] {
        held = draw_canvas_tools({10, 100}, Column::drawing, [](Action) {});
        ImGui::BringWindowToDisplayFront(ImGui::FindWindowByName("##tools"));  // from behind the others
    });
    ui.move_to(ui.at("Hold to compare", 0.5f));
    CHECK_FALSE(held);
    ui.press();
    ui.frame();
    CHECK(held);
    ui.release();
    ui.frame();
    CHECK_FALSE(held);
}

TEST_CASE("text that is too wide goes on in another line, and no line ends within a number") {
    const std::string sentence =
        "10 dots are nearer than 0.152 mm, 1,794 than 0.5 mm.\nFewer dots part them.";
    HeadlessUi ui([&] {});
    const float widest = ImGui::CalcTextSize("nearer").x;
    std::size_t most_lines = 0;
    for (float width = ImGui::CalcTextSize(sentence.c_str()).x; width >= widest; width -= 1) {
        const std::string text = in_lines(sentence, width);
        CAPTURE(text);
        std::string words = text;
        std::ranges::replace(words, '\n', ' ');
        std::string all = sentence;
        std::ranges::replace(all, '\n', ' ');
        CHECK(words == all);
        CHECK(text.find(".\nFewer") != text.npos);
        CHECK(ImGui::CalcTextSize(text.c_str()).x <= width);
        // A word that would have found room in the line before has no line of its own.
        for (std::size_t end = text.find('\n'); end != text.npos; end = text.find('\n', end + 1)) {
            if (text.compare(end - 1, 7, ".\nFewer") == 0) continue;
            const std::size_t line = end == 0 ? 0 : text.rfind('\n', end - 1) + 1;
            std::string longer = text.substr(line, text.find_first_of(" \n", end + 1) - line);
            longer[end - line] = ' ';
            CHECK(ImGui::CalcTextSize(longer.c_str()).x > width);
        }
        most_lines = std::max<std::size_t>(most_lines, std::ranges::count(text, '\n'));
    }
    CHECK(most_lines > 10);
    CHECK(in_lines("", widest).empty());
}

}  // namespace dapple
