#include <doctest/doctest.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "app/viewer/panels/window_panels.h"
#include "app/viewer/widgets/theme.h"
#include "tests/file_text.h"
#include "tests/headless_ui.h"
#include "tests/temporary_folder.h"

namespace dapple {
namespace {

/// As WCAG 2.1 defines the contrast of two colours: relative luminances, with 0.05 for stray light.
double contrast(glm::vec3 a, glm::vec3 b) {
    const auto luminance = [](glm::vec3 c) {
        const auto linear = [](double v) {
            return v <= 0.03928 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
        };
        return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
    };
    const double of_a = luminance(a) + 0.05, of_b = luminance(b) + 0.05;
    return std::max(of_a, of_b) / std::min(of_a, of_b);
}

}  // namespace

TEST_CASE("a font that Dear ImGui cannot draw is not taken") {
    const auto font = find_font("sans-serif");
    REQUIRE(font);
    CHECK(is_outline_font(*font));
    const std::string bytes = text_of(*font);
    const TemporaryFolder folder;
    const auto is_taken = [&](const std::string& text) {
        const std::filesystem::path file = folder.path() / "font";
        put_text(file, text);
        return is_outline_font(file);
    };
    CHECK(is_taken(bytes));
    CHECK_FALSE(is_taken(bytes.substr(0, bytes.size() - 1)));
    CHECK_FALSE(is_taken(bytes.substr(0, 13)));
    CHECK_FALSE(is_taken(""));
    CHECK_FALSE(is_taken("STARTFONT 2.1\nFONT tiny\nSIZE 8 75 75\n"));
    std::string without_letters = bytes;
    without_letters.replace(bytes.find("cmap"), 4, "mapc");
    CHECK_FALSE(is_taken(without_letters));
    CHECK_FALSE(is_outline_font(folder.path()));
}

TEST_CASE("in each theme text stands out from what is behind it by 4.5:1, and in high contrast by 7:1") {
    HeadlessUi ui([] {});
    CHECK(contrast({0, 0, 0}, {1, 1, 1}) == doctest::Approx(21));
    for (const Theme theme : {Theme::light, Theme::dark, Theme::high_contrast}) {
        CAPTURE(static_cast<int>(theme));
        apply_theme({.theme = theme}, 1);
        const double least = theme == Theme::high_contrast ? 7 : 4.5;
        using enum ThemeColour;
        for (const ThemeColour behind : {panel, track, surround})
            CHECK(contrast(rgb_of(text), rgb_of(behind)) >= least);
        for (const ThemeColour behind : {panel, track})
            CHECK(contrast(rgb_of(quiet), rgb_of(behind)) >= least);
        CHECK(contrast(rgb_of(warning), rgb_of(panel)) >= 4.5);
        CHECK(contrast(rgb_of(panel), rgb_of(accent)) >= least);  // of a chosen segment
        // What can be dragged, and what tells whether a switch is on or off, by 3:1 (1.4.11).
        CHECK(contrast(rgb_of(off), rgb_of(panel)) >= 3);  // also of a slider's empty track
        CHECK(contrast(rgb_of(accent), rgb_of(track)) >= 3);
        CHECK(contrast(rgb_of(accent), rgb_of(panel)) >= 3);  // of the ring around the row with the keys
    }
}

TEST_CASE("the preferences change the theme and the size of the text") {
    bool open = true;
    Appearance appearance;
    DialogChoice dialog = DialogChoice::own;
    HeadlessUi ui([&] { draw_preferences_panel(open, appearance, dialog, nullptr); });
    ui.click("dark");
    CHECK(appearance.theme == Theme::dark);
    ui.click("large");
    CHECK(appearance.text_size == 1.25f);
    ui.key(Key::escape);
    CHECK_FALSE(open);
    const float before = ImGui::GetStyle().WindowPadding.x;
    apply_theme(appearance, 1);
    CHECK(ImGui::GetStyle().WindowPadding.x == doctest::Approx(1.25 * before));
}

}  // namespace dapple
