// The rows of a panel by keyboard, without a window.

#include <doctest/doctest.h>

#include <array>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "app/viewer/widgets/row.h"
#include "tests/headless_ui.h"

namespace dapple {
namespace {

/// One row of each kind, and one that is greyed.
struct KeyRows {
    double tone = 0, count = 40'000, locked = 0.5;
    bool on = false;
    int paper = 0, fit = 0, pressed = 0;
    glm::vec3 ink{};
    bool folded_open = false;
    HeadlessUi ui{[this] {
        slider_row("Tone", tone, {.min = -1, .max = 1, .neutral = 0});
        slider_row("Count", count,
                   {.min = 1,
                    .max = 1e6,
                    .neutral = 40'000,
                    .curve = SliderCurve::logarithmic,
                    .hard_max = 1e6,
                    .grouped = true});
        {
            const Greyed greyed("Not now.");
            slider_row("Locked", locked, {});
        }
        switch_row("On", on, "Whether.");
        choice_row("Paper", paper, std::array{"A4", "A3", "A2"}, "Which.");
        segmented_row("Fit", fit, std::array{"inside", "fill"}, "How.");
        colour_row("Ink", ink, "In which colour.", glm::vec3(0));
        if (key_button("Press")) ++pressed;
        note_place("Press");
        folded_open = section("More", false);
    }};

    void key(Key key, int modifiers = 0) {
        put_modifiers(modifiers);
        ui.key(key);
        put_modifiers(0);
        ui.frame();
    }
    /// The row that the ring is around; empty: none.
    std::string row() const {
        if (!ui.has(kRowWithKeys)) return "";
        const WidgetPlace ring = ui.place(kRowWithKeys);
        for (const char* name : {"Tone", "Count", "Locked", "On", "Paper", "Fit", "Ink", "Press", "More"}) {
            // A choice side by side is noted by its first entry.
            const glm::vec2 middle = ui.at(std::string(name) == "Fit" ? "inside" : name, 0.5f);
            if (middle.y > ring.min.y && middle.y < ring.max.y) return name;
        }
        return "none";
    }
    void walk_to(const std::string& name) {
        for (int i = 0; i < 20 && row() != name; ++i) key(Key::tab);
        REQUIRE(row() == name);
    }
};

}  // namespace

TEST_CASE("Tab walks the rows in order, passes greyed ones over and comes round; Shift+Tab walks back") {
    KeyRows rows;
    CHECK(rows.row().empty());
    const std::vector<std::string> order{"Tone", "Count", "On", "Paper", "Fit", "Ink", "Press", "More"};
    for (const std::string& name : order) {
        rows.key(Key::tab);
        CHECK(rows.row() == name);
    }
    rows.key(Key::tab);
    CHECK(rows.row() == "Tone");
    for (auto name = order.rbegin(); name != order.rend(); ++name) {
        rows.key(Key::tab, GLFW_MOD_SHIFT);
        CHECK(rows.row() == *name);
    }
    rows.key(Key::escape);
    CHECK(rows.row().empty());
    rows.key(Key::tab, GLFW_MOD_SHIFT);
    CHECK(rows.row() == "More");
    rows.ui.click("On");
    CHECK(rows.row().empty());
}

TEST_CASE("arrows change the row that has the ring, with Shift ten times as much and with Alt a tenth") {
    KeyRows rows;
    rows.key(Key::right);
    CHECK(rows.tone == 0);  // no row has the keys yet
    rows.walk_to("Tone");
    rows.key(Key::right);
    CHECK(rows.tone == doctest::Approx(0.02));  // a hundredth of the track
    rows.key(Key::down, GLFW_MOD_ALT);
    CHECK(rows.tone == doctest::Approx(0.018));
    rows.key(Key::up, GLFW_MOD_SHIFT);
    CHECK(rows.tone == doctest::Approx(0.218));
    for (int i = 0; i < 9; ++i) rows.key(Key::left, GLFW_MOD_SHIFT);
    CHECK(rows.tone == -1);
    rows.key(Key::backspace);
    CHECK(rows.tone == 0);
    rows.walk_to("Count");
    rows.key(Key::right);
    CHECK(rows.count == 45'926);  // 40,000 x 10^0.06
    rows.count = 3;               // where a hundredth of the track is less than one
    rows.key(Key::left);
    CHECK(rows.count == 2);
    rows.walk_to("Paper");
    rows.key(Key::up);
    CHECK(rows.paper == 0);
    rows.key(Key::down);
    rows.key(Key::down);
    CHECK(rows.paper == 2);
    rows.walk_to("Fit");
    rows.key(Key::right);
    CHECK(rows.fit == 1);
    rows.walk_to("More");
    rows.key(Key::right);
    CHECK(rows.folded_open);
    rows.key(Key::left);
    CHECK_FALSE(rows.folded_open);
    CHECK(rows.locked == 0.5);
}

TEST_CASE("Enter types into a row, Space and Enter press what can be pressed") {
    KeyRows rows;
    rows.walk_to("Count");
    rows.key(Key::enter);
    REQUIRE(rows.ui.has("Typing"));
    rows.ui.type("2*210");
    rows.key(Key::enter);
    CHECK(rows.count == 420);
    CHECK(rows.row() == "Count");
    for (const Key key : {Key::space, Key::enter}) {
        const bool was_on = rows.on, was_open = rows.folded_open;
        const int pressed = rows.pressed;
        rows.walk_to("On");
        rows.key(key);
        CHECK(rows.on != was_on);
        rows.walk_to("Press");
        rows.key(key);
        CHECK(rows.pressed == pressed + 1);
        rows.walk_to("More");
        rows.key(key);
        CHECK(rows.folded_open != was_open);
    }
    rows.walk_to("Ink");
    rows.key(Key::space);
    CHECK(rows.ui.has("Colour picker"));
    rows.key(Key::escape);
    CHECK_FALSE(rows.ui.has("Colour picker"));
}

TEST_CASE("a number being typed is taken wherever the focus goes, and Escape alone drops it") {
    KeyRows rows;
    const auto type_count = [&](const char* text) {
        rows.ui.click("Count value");
        rows.ui.frame();
        rows.ui.type(text);
    };
    type_count("900");
    rows.ui.click("Tone");  // drawn before it
    CHECK(rows.count == 900);
    type_count("2*100");
    rows.ui.click("On");  // and after it; the click counts as well
    CHECK(rows.count == 200);
    CHECK(rows.on);
    type_count("300");
    rows.key(Key::tab);
    CHECK(rows.count == 300);
    CHECK(rows.row() == "On");
    type_count("400");
    rows.key(Key::tab, GLFW_MOD_SHIFT);
    CHECK(rows.count == 400);
    CHECK(rows.row() == "Tone");
    type_count("500");
    rows.key(Key::escape);
    rows.ui.click("On");
    CHECK(rows.count == 400);
    type_count("a few");
    rows.ui.click("On");
    CHECK(rows.count == 400);
    CHECK(rows.ui.has("Refusal"));
    // What is only looked at keeps the digits that are not shown.
    rows.tone = 0.12345;
    rows.ui.click("Tone value");
    rows.ui.frame();
    rows.ui.click("On");
    CHECK(rows.tone == 0.12345);
}

TEST_CASE("undo in a row that is typed into again takes back what was typed now, and nothing before") {
    KeyRows rows;
    rows.ui.enter("Tone", "0.123456");
    CHECK(rows.tone == doctest::Approx(0.123456));
    rows.ui.begin_typing("Tone");
    for (int i = 0; i < 12; ++i) rows.key(Key::z, GLFW_MOD_CONTROL);
    rows.key(Key::enter);
    CHECK(rows.tone == doctest::Approx(0.12).epsilon(0.05));
}

TEST_CASE("Enter opens a list, arrows walk it, Enter takes an entry and Escape leaves it as it was") {
    KeyRows rows;
    rows.walk_to("Paper");
    for (const Key key : {Key::enter, Key::space}) {
        rows.paper = 0;
        rows.key(key);
        REQUIRE(rows.ui.has("A3"));
        rows.key(Key::down);
        rows.key(Key::down);
        CHECK(rows.paper == 0);  // not before it is taken
        rows.key(Key::tab);      // is no row's while the list is open
        rows.key(Key::enter);
        CHECK(rows.paper == 2);
        CHECK_FALSE(rows.ui.has("A3"));
        CHECK(rows.row() == "Paper");
    }
    rows.key(Key::enter);
    rows.key(Key::up);
    rows.key(Key::escape);
    CHECK(rows.paper == 2);
    CHECK_FALSE(rows.ui.has("A3"));
    CHECK(rows.row() == "Paper");
}

TEST_CASE("while a list is open no key is the window's") {
    KeyRows rows;
    rows.walk_to("Paper");
    CHECK_FALSE(ImGui::GetIO().WantCaptureKeyboard);
    rows.key(Key::enter);
    rows.ui.frame();
    CHECK(ImGui::GetIO().WantCaptureKeyboard);
    rows.key(Key::escape);
    rows.ui.frame();
    CHECK_FALSE(ImGui::GetIO().WantCaptureKeyboard);
}

TEST_CASE("arrows on a closed list choose values but never what does something, which Enter reaches") {
    int chosen = 0;
    constexpr std::array kNames{"one", "two", "Other..."};
    HeadlessUi ui([&] { choice_row("Values", chosen, kNames, "Which.", ListLook{.by_arrows = 2}); });
    ui.key(Key::tab);
    for (int i = 0; i < 4; ++i) ui.key(Key::down);
    CHECK(chosen == 1);
    ui.key(Key::enter);
    ui.key(Key::down);
    ui.key(Key::enter);
    CHECK(chosen == 2);
}

TEST_CASE("a double-click on a row's name, and Backspace, bring its usual value back, whatever the row is") {
    double tone = 3;
    bool on = true;
    int paper = 2, fit = 0;
    std::string name = "x";
    glm::vec3 ink(1);
    const auto spoil = [&] {
        tone = 3;
        on = true;
        paper = 2;
        fit = 0;
        name = "x";
        ink = glm::vec3(1);
    };
    const auto good = [](const std::string&) { return true; };
    HeadlessUi ui([&] {
        slider_row("Tone", tone, {.min = 0, .max = 9, .neutral = 5});
        switch_row("On", on, "Whether.");
        choice_row("Paper", paper, std::array{"A4", "A3", "A2"}, "Which.", 1);
        segmented_row("Fit", fit, std::array{"inside", "fill"}, "How.", 1);
        text_row("Name", name, good, "", "Whose.", "usual");
        colour_row("Ink", ink, "In which colour.", glm::vec3(0.5f));
    });
    const auto check_all = [&] {
        CHECK(tone == 5);
        CHECK_FALSE(on);
        CHECK(paper == 1);
        CHECK(fit == 1);
        CHECK(name == "usual");
        CHECK(ink == glm::vec3(0.5f));
    };
    for (int twice = 0; twice < 2; ++twice) {  // what is usual stays: a switch is not turned
        for (const char* label : {"Tone", "On", "Paper", "Fit", "Name", "Ink"})
            ui.double_click(std::string(label) + " name");
        check_all();
    }
    spoil();
    for (int i = 0; i < 6; ++i) {
        ui.key(Key::tab);
        ui.key(Key::backspace);
    }
    check_all();
}

TEST_CASE("words side by side have air between them, and become a list where they have no room") {
    int chosen = 0;
    constexpr std::array kBrushes{"off", "more", "fewer", "none", "erase"};
    HeadlessUi ui([&] { segmented_row("Brush", chosen, kBrushes, "What it paints."); });
    const auto make_wide = [&](float width) {
        ImGui::GetIO().DisplaySize.x = width;
        ui.frame();
        ui.frame();
    };
    const auto check_side_by_side = [&](float least_air) {
        float before = ui.place("Brush name").min.x;
        for (const char* brush : kBrushes) {
            const WidgetPlace place = ui.place(brush);
            CHECK(place.min.x >= before);
            CHECK(place.max.x <= ImGui::GetIO().DisplaySize.x);
            CHECK(place.max.x - place.min.x > ImGui::CalcTextSize(brush).x + least_air);
            before = place.max.x;
        }
    };
    const float line = ImGui::GetTextLineHeight();
    make_wide(340);
    CHECK(ui.place("off").min.x >= ui.place("Brush name").min.x + ImGui::CalcTextSize("Brush").x);
    check_side_by_side(line / 2);
    make_wide(280);
    check_side_by_side(0);

    make_wide(120);
    for (const char* brush : kBrushes) CHECK_FALSE(ui.has(brush));
    ui.click("Brush");
    ui.click("fewer");
    CHECK(chosen == 2);
}

TEST_CASE("of two greyed rows that say the same each tells it to a mouse that rests there") {
    double value = 0;
    HeadlessUi ui([&] {
        for (const char* name : {"First", "Second"}) {
            const Greyed greyed("Not now.");
            slider_row(name, value, {});
        }
    });
    for (const char* name : {"First", "Second"}) {
        CAPTURE(name);
        ui.move_to(ui.at(name, 0.5f));
        CHECK_FALSE(ui.has("Tip"));
        for (int i = 0; i < 60; ++i) ui.frame();  // a second
        CHECK(ui.has("Tip"));
    }
}

}  // namespace dapple
