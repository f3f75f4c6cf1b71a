// What opens above the panels, and goes away again.

#include <doctest/doctest.h>

#include <array>
#include <string>
#include <vector>

#include "app/viewer/panels/command_palette.h"
#include "app/viewer/panels/help_panel.h"
#include "app/viewer/widgets/dialog.h"
#include "app/viewer/widgets/widgets.h"
#include "tests/headless_ui.h"

using namespace dapple;

TEST_CASE("Escape closes a list and chooses nothing") {
    int chosen = 0;
    HeadlessUi ui([&] { choice_row("Fruit", chosen, std::array{"apple", "pear"}); });
    ui.click("Fruit");
    REQUIRE(ui.has("pear"));
    ui.key(Key::escape);
    ui.frame();
    CHECK_FALSE(ui.has("pear"));
    CHECK(chosen == 0);
}

TEST_CASE("a dialog may open in the very frame in which a row's tip appears, which then waits") {
    bool open = false;
    double value = 3;
    HeadlessUi ui([&] {
        if (const Dialog dialog("Keys", open); dialog) ImGui::TextUnformatted("none");
        slider_row("Number", value, {.min = 1, .max = 9, .tip = "How many."});
    });
    ui.move_to(ui.at("Number", 0.5f));
    open = true;
    ui.frame(10);
    CHECK_FALSE(ui.has("Tip"));
    open = false;
    ui.frame();
    ui.frame(10);
    ui.frame(10);
    CHECK(ui.has("Tip"));
}

TEST_CASE("Escape closes the colour picker, and the colour stays as it is") {
    glm::vec3 colour(0.2f, 0.4f, 0.6f);
    HeadlessUi ui([&] { colour_row("Ink", colour); });
    ui.click("Ink");
    REQUIRE(ui.has("Colour picker"));
    ui.key(Key::escape);
    ui.frame();
    CHECK_FALSE(ui.has("Colour picker"));
    CHECK(colour == glm::vec3(0.2f, 0.4f, 0.6f));
}

TEST_CASE("the question mark that brings help sends it away again, as Escape does") {
    bool open = false;
    HeadlessUi ui([&] { draw_help_panel(open, shortcuts()); });
    for (const bool by_escape : {false, true}) {
        open = true;
        ui.frame();
        ui.frame();
        REQUIRE(open);
        if (by_escape)
            ui.key(Key::escape);
        else
            ui.type("?");
        CHECK_FALSE(open);
        ui.frame();
    }
    open = true;
    ui.type("?");  // in the frame in which it opens
    CHECK(open);
}

TEST_CASE("the command palette finds what has every word typed, and Enter does it") {
    std::vector<const char*> found;
    for (const Shortcut& each : shortcuts_with("PICTURE open", shortcuts())) found.push_back(each.meaning);
    REQUIRE(found.size() == 1);
    CHECK(std::string(found[0]) == "Open a picture or a project");
    CHECK(shortcuts_with("", shortcuts()).size() > 15);
    CHECK(shortcuts_with("zebra", shortcuts()).empty());

    CommandPalette palette;
    std::vector<Action> asked;
    HeadlessUi ui([&] { palette.draw(shortcuts(), [&](Action action) { asked.push_back(action); }); });
    palette.toggle();
    ui.frame();
    ui.frame();
    for (const char* letter : {"z", "o", "o", "m"}) ui.type(letter);
    CHECK(ui.has("Zoom in"));
    CHECK_FALSE(ui.has("Redo"));
    ui.key(Key::down);
    ui.key(Key::enter);
    ui.frame();
    CHECK(asked == std::vector{Action::zoom_out});
    CHECK_FALSE(ui.has("Zoom in"));
    palette.toggle();
    ui.frame();
    ui.frame();
    ui.click("Undo");  // of what was typed before nothing is left
    CHECK(asked.back() == Action::undo);
}
