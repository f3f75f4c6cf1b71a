// What opens above the panels, and goes away again.

#include <doctest/doctest.h>

#include <array>

#include "app/viewer/panels/help_panel.h"
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
