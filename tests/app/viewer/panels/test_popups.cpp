// What opens above the panels, and goes away again.

#include <doctest/doctest.h>

#include <array>
#include <filesystem>
#include <glm/common.hpp>
#include <string>
#include <vector>

#include "app/viewer/panels/command_palette.h"
#include "app/viewer/panels/window_panels.h"
#include "app/viewer/widgets/dialog.h"
#include "app/viewer/widgets/row.h"
#include "app/viewer/widgets/widgets.h"
#include "core/image/colour.h"
#include "tests/headless_ui.h"

using namespace dapple;

TEST_CASE("Escape closes a list and chooses nothing") {
    int chosen = 0;
    HeadlessUi ui([&] { choice_row("Fruit", chosen, std::array{"apple", "pear"}, "Which."); });
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
    HeadlessUi ui([&] { colour_row("Ink", colour, "In which colour."); });
    ui.click("Ink");
    REQUIRE(ui.has("Colour picker"));
    ui.key(Key::escape);
    ui.frame();
    CHECK_FALSE(ui.has("Colour picker"));
    CHECK(colour == glm::vec3(0.2f, 0.4f, 0.6f));
}

// Dear ImGui's own way would open a window at the pointer, in whatever frame a dialog opens.
TEST_CASE("a row's colour cannot be dragged away") {
    glm::vec3 ink(0.2f, 0.4f, 0.6f), paper(1, 1, 1);
    HeadlessUi ui([&] {
        colour_row("Ink", ink, "In which colour.");
        colour_row("Paper", paper, "On which colour.");
    });
    const glm::vec2 from = ui.at("Ink", 0.5f), to = ui.at("Paper", 0.5f);
    ui.move_to(from);
    ui.press();
    for (const float share : {0.3f, 0.6f, 1.0f}) {
        ui.move_to(glm::mix(from, to, share));
        CHECK_FALSE(ImGui::GetDragDropPayload());
    }
    ui.release();
    CHECK(ink == glm::vec3(0.2f, 0.4f, 0.6f));
    CHECK(paper == glm::vec3(1));
}

TEST_CASE("where the clock stands still, or goes backwards, frames are drawn all the same") {
    bool on = false;
    HeadlessUi ui([&] { switch_row("Switch", on, "Whether.", false); });
    for (const float seconds : {0.0f, -1.0f, 0.0f}) ui.frame(seconds);
    ui.click("Switch");
    CHECK(on);
}

TEST_CASE("a colour may be typed, and what is none changes nothing") {
    glm::vec3 colour(0.2f, 0.4f, 0.6f);
    HeadlessUi ui([&] { colour_row("Ink", colour, "In which colour."); });
    ui.click("Ink");
    ui.click("Colour as text");
    ui.type("none");
    ui.key(Key::enter);
    ui.frame();
    CHECK(colour == glm::vec3(0.2f, 0.4f, 0.6f));
    REQUIRE(ui.has("Colour as text"));
    ui.click("Colour as text");
    ui.type("#ff8000");
    ui.key(Key::enter);
    ui.frame();
    CHECK(hex_of(colour) == "#ff8000");
    CHECK_FALSE(ui.has("Colour picker"));
}

TEST_CASE("by keyboard alone a row's colour is opened, typed and entered") {
    glm::vec3 colour(0.2f, 0.4f, 0.6f);
    HeadlessUi ui([&] { colour_row("Ink", colour, "In which colour."); });
    ui.key(Key::tab);
    ui.key(Key::enter);
    ui.frame();
    REQUIRE(ui.has("Colour picker"));
    ui.type("#102030");
    ui.key(Key::enter);
    ui.frame();
    CHECK(hex_of(colour) == "#102030");
    CHECK_FALSE(ui.has("Colour picker"));
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
    for (const Shortcut& each : shortcuts_with("PROJECT open", shortcuts())) found.push_back(each.meaning);
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

namespace {

/// Rows of each kind in two sections, of which the first is folded.
struct RowsOfSections {
    bool invert = false;
    double gamma = 1, width = 200;
    int paper = 0;
    void draw() {
        if (section("Picture", false)) {
            switch_row("Invert", invert, "Whether.");
            slider_row("Gamma", gamma, {.min = 0, .max = 4, .neutral = 1});
        }
        if (!section("Page")) return;
        choice_row("Paper size", paper, std::array{"as the picture", "A4", "A3"}, "Which.");
        const Greyed greyed("Not now.");
        slider_row("Width", width, {});
    }
    std::vector<ListedRow> listed(const ListedRow* taken = nullptr, int value = -1) {
        std::vector<ListedRow> rows;
        const RowListing listing(rows, taken, value);
        draw();
        return rows;
    }
};

std::vector<std::string> words_of(const std::vector<FoundRow>& found) {
    std::vector<std::string> words;
    for (const FoundRow& each : found) words.push_back(each.words());
    return words;
}

}  // namespace

TEST_CASE("the command palette finds rows and their values in folded sections too, and brings them") {
    RowsOfSections rows;
    CommandPalette palette;
    std::vector<ListedRow> listed;
    int value = 7;
    const auto take = [&](const ListedRow& row, int chosen) {
        value = chosen;
        if (chosen >= 0) rows.listed(&row, chosen);
        static_cast<WidgetNotes*>(ImGui::GetIO().UserData)->reveal = row;
    };
    HeadlessUi ui([&] {
        listed = rows.listed();
        palette.draw(shortcuts(), [](Action) {}, {}, {listed, take});
        rows.draw();
    });
    using Words = std::vector<std::string>;
    CHECK(words_of(rows_with("a4", listed)) == Words{"Paper size: A4"});
    CHECK(words_of(rows_with("invert", listed)) == Words{"Invert", "Invert: off", "Invert: on"});
    CHECK(words_of(rows_with("picture gam", listed)) == Words{"Gamma"});
    CHECK(words_of(rows_with("width", listed)) == Words{"Width"});
    CHECK(rows_with(" ", listed).empty());

    const auto choose = [&](const char* text) {
        palette.toggle();
        for (int i = 0; i < 3; ++i) ui.frame();
        const WidgetPlace field = ui.place("Commands");
        ui.type(text);
        ui.frame();
        CHECK(ui.place("Commands") == field);  // it stays under the eyes
        ui.key(Key::enter);
        ui.frame();
    };
    choose("a4");
    CHECK(rows.paper == 1);
    CHECK_FALSE(ui.has("Gamma"));
    choose("invert: on");
    CHECK(rows.invert);
    choose("width");
    CHECK(rows.width == 200);
    CHECK(value == -1);

    choose("gamma");
    REQUIRE(ui.has("Gamma"));  // unfolded
    ui.key(Key::right);        // and its own: nothing is typed into it
    CHECK(rows.gamma > 1);
}

TEST_CASE("the key that closes a dialog does nothing to the row behind it") {
    bool open = false;
    int pressed = 0;
    HeadlessUi ui([&] {
        if (const Dialog dialog("Question", open); dialog && key_button("Yes")) open = false;
        if (key_button("Behind")) ++pressed;
    });
    ui.key(Key::tab);
    ui.key(Key::space);
    CHECK(pressed == 1);
    for (const Key key : {Key::enter, Key::space}) {
        open = true;
        for (int i = 0; i < 3; ++i) ui.frame();
        ui.key(Key::tab);
        ui.key(key);
        CHECK_FALSE(open);
        CHECK(pressed == 1);
    }
    ui.frame();
    ui.key(Key::enter);
    CHECK(pressed == 2);
}

TEST_CASE("by mouse alone a menu beside the title reaches all commands, keys, preferences and about") {
    std::vector<Action> asked;
    HeadlessUi ui([&] {
        const auto act = [&](Action action) { asked.push_back(action); };
        draw_title("a picture of such a long name that it would reach over the menu beside it.jpeg", {}, act);
        draw_action_buttons(true, act);
    });
    for (const auto& [entry, action] : {std::pair("All commands...", Action::palette),
                                        {"Keys", Action::help},
                                        {"Preferences...", Action::preferences},
                                        {"About Dapple", Action::about}}) {
        CAPTURE(entry);
        ui.click("Menu");
        ui.click(entry);
        REQUIRE_FALSE(asked.empty());
        CHECK(asked.back() == action);
        CHECK_FALSE(ui.has(entry));  // it is closed
    }
    ui.click("Fit");
    CHECK(asked.back() == Action::fit);
    ui.click("Menu");
    ui.key(Key::escape);
    CHECK_FALSE(ui.has("Keys"));
    CHECK(asked.size() == 5);
    // By keyboard as well, from "Fit" on.
    ui.key(Key::tab);
    ui.key(Key::tab);
    ui.key(Key::enter);
    ui.key(Key::down);
    ui.key(Key::down);
    ui.key(Key::enter);
    CHECK(asked.back() == Action::help);
    CHECK(ui.place("Menu").max.x <= 400);
}

TEST_CASE("what the arrows choose in the command palette is scrolled to, and a key that is held goes on") {
    CommandPalette palette;
    std::vector<Action> asked;
    std::vector<std::filesystem::path> files;
    for (int i = 0; i < 8; ++i) files.emplace_back("/pictures/cat" + std::to_string(i) + ".png");
    std::filesystem::path opened;
    HeadlessUi ui([&] {
        palette.draw(shortcuts(), [&](Action action) { asked.push_back(action); },
                     {files, [&](const std::filesystem::path& file) { opened = file; }});
    });
    ImGui::GetIO().DisplaySize = {900, 500};  // of less height than all of them
    palette.toggle();
    for (int i = 0; i < 4; ++i) ui.frame();
    const auto shows = [&](const std::string& name) {
        const WidgetPlace entry = ui.place(name), list = ui.place("Found");
        const float middle = (entry.min.y + entry.max.y) / 2;
        return middle > list.min.y && middle < list.max.y;
    };
    CHECK(ui.place("Found").max.y < 500);
    CHECK(shows("Open a tile"));
    CHECK_FALSE(shows("cat7.png"));
    put_key(Key::down, true);
    for (int i = 0; i < 200; ++i) ui.frame();  // held for a few seconds
    put_key(Key::down, false);
    ui.frame();
    CHECK(shows("cat7.png"));
    CHECK_FALSE(shows("Open a tile"));
    ui.key(Key::enter);
    CHECK(opened == "/pictures/cat7.png");
    CHECK(asked.empty());
}

TEST_CASE("once Escape has closed a list, the wheel turns the panel again") {
    int chosen = 0;
    float scrolled = 0;
    HeadlessUi ui([&] {
        choice_row("Fruit", chosen, std::array{"apple", "pear"}, "One of two.");
        for (int line = 0; line < 200; ++line) ImGui::TextUnformatted("more");
        scrolled = ImGui::GetScrollY();
    });
    ui.click("Fruit");
    ui.key(Key::escape);
    ui.frame();
    ui.move_to({100, 500});
    ImGui::GetIO().MouseWheel = -3;
    ui.frame();
    ui.frame();
    CHECK(scrolled > 0);
}

TEST_CASE("About tells the version and the licences, and Escape sends it away") {
    bool open = true;
    std::string written;
    HeadlessUi ui([&] {
        ImGui::LogToClipboard();
        draw_about_panel(open);
        ImGui::LogFinish();
        if (open) written = ImGui::GetClipboardText();
    });
    for (const char* words : {"Dapple 0.", "MIT licence", "Dear ImGui " IMGUI_VERSION, "Apache 2.0"})
        CHECK(written.find(words) != std::string::npos);
    ui.key(Key::escape);
    CHECK_FALSE(open);
}
