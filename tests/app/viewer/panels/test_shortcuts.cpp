#include <doctest/doctest.h>

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "app/viewer/model/compared_panes.h"
#include "app/viewer/model/mask_brush.h"
#include "app/viewer/panels/shortcuts.h"
#include "tests/headless_ui.h"

namespace dapple {
namespace {

struct Keyboard {
    std::vector<Action> actions;
    std::function<void()> each_frame = [] {};
    char text[32] = "";
    HeadlessUi ui{[this] {
        each_frame();
        for (Action action : pressed_actions(shortcuts())) actions.push_back(action);
        ImGui::InputText("text", text, sizeof text);
        note_place("text");
    }};

    std::vector<Action> press(Key key, bool ctrl = false, bool shift = false) {
        put_modifiers((ctrl ? GLFW_MOD_CONTROL : 0) | (shift ? GLFW_MOD_SHIFT : 0));
        put_key(key, true);
        actions.clear();
        ui.frame();
        ui.frame();  // held down: no second time
        put_key(key, false);
        put_modifiers(0);
        ui.frame();
        return actions;
    }
};

using Actions = std::vector<Action>;

}  // namespace

TEST_CASE("keys do what the help says, once a press") {
    Keyboard keyboard;
    CHECK(keyboard.press(Key::f) == Actions{Action::fit});
    CHECK(keyboard.press(Key::zero, true) == Actions{Action::one_to_one});
    CHECK(keyboard.press(Key::o, true) == Actions{Action::open});
    CHECK(keyboard.press(Key::k, true) == Actions{Action::palette});
    CHECK(keyboard.press(Key::p, true) == Actions{Action::palette});
    CHECK(keyboard.press(Key::t, true) == Actions{Action::open_tile});
    CHECK(keyboard.press(Key::t) == Actions{Action::toggle_tiles});
    CHECK(keyboard.press(Key::s, true) == Actions{Action::save});
    CHECK(keyboard.press(Key::e, true) == Actions{Action::save_as});
    CHECK(keyboard.press(Key::z, true) == Actions{Action::undo});
    CHECK(keyboard.press(Key::z, true, true) == Actions{Action::redo});
    CHECK(keyboard.press(Key::tab).empty());  // walks the rows
    CHECK(keyboard.press(Key::b, true) == Actions{Action::toggle_panels});
    CHECK(keyboard.press(Key::c, false, true) == Actions{Action::compare});
    CHECK(keyboard.press(Key::c, true) == Actions{Action::copy_picture});
    CHECK(keyboard.press(Key::l) == Actions{Action::loupe});
    CHECK(keyboard.press(Key::i) == Actions{Action::explain_dots});
    CHECK(keyboard.press(Key::m) == Actions{Action::method});
    CHECK(keyboard.press(Key::v) == Actions{Action::variations});
    CHECK(keyboard.press(Key::x) == Actions{Action::crop});
    CHECK(keyboard.press(Key::b) == Actions{Action::mask});
    CHECK(keyboard.press(Key::d) == Actions{Action::retouch});
    CHECK(keyboard.press(Key::r) == Actions{Action::rotate});
    CHECK(keyboard.press(Key::f11) == Actions{Action::full_screen});
    CHECK(keyboard.press(Key::o).empty());
}

TEST_CASE("C, the backslash and P show the photograph while they are held, and do nothing else") {
    bool shown = false;
    Keyboard keyboard;
    keyboard.each_frame = [&] { shown = comparison_held() == SeenInstead::photograph; };
    for (const Key key : {Key::c, Key::backslash, Key::p}) {
        put_key(key, true);
        keyboard.actions.clear();
        for (int frame = 0; frame < 3; ++frame) {
            keyboard.ui.frame();
            CHECK(shown);
        }
        CHECK(keyboard.actions.empty());
        // With a modifier it is another key.
        for (const int modifier : {GLFW_MOD_SHIFT, GLFW_MOD_CONTROL}) {
            put_modifiers(modifier);
            keyboard.ui.frame();
            CHECK_FALSE(shown);
        }
        put_modifiers(0);
        put_key(key, false);
        keyboard.ui.frame();
        CHECK_FALSE(shown);
    }
    keyboard.ui.click("text");
    put_key(Key::c, true);
    keyboard.ui.frame();
    CHECK_FALSE(shown);
}

TEST_CASE(
    "W and the backslash with Shift show the drawing as it was while they are held, and do nothing else") {
    std::optional<SeenInstead> shown;
    Keyboard keyboard;
    keyboard.each_frame = [&] { shown = comparison_held(); };
    for (const auto& [key, modifiers] : {std::pair{Key::w, 0}, std::pair{Key::backslash, GLFW_MOD_SHIFT}}) {
        put_modifiers(modifiers);
        put_key(key, true);
        keyboard.actions.clear();
        for (int frame = 0; frame < 3; ++frame) {
            keyboard.ui.frame();
            CHECK(shown == SeenInstead::as_it_was);
        }
        CHECK(keyboard.actions.empty());
        put_modifiers(modifiers | GLFW_MOD_CONTROL);
        keyboard.ui.frame();
        CHECK_FALSE(shown);
        put_modifiers(0);
        put_key(key, false);
        keyboard.ui.frame();
        CHECK_FALSE(shown);
    }
}

TEST_CASE("a question mark asks for help wherever the keyboard has it") {
    Keyboard keyboard;
    keyboard.actions.clear();
    keyboard.ui.type("?");
    CHECK(keyboard.actions == Actions{Action::help});
}

TEST_CASE("the brackets size the mask's brush, never beyond its limits") {
    Keyboard keyboard;
    keyboard.actions.clear();
    keyboard.ui.type("]");
    CHECK(keyboard.actions == Actions{Action::larger_brush});
    keyboard.actions.clear();
    keyboard.ui.type("[");
    CHECK(keyboard.actions == Actions{Action::smaller_brush});
    MaskBrush tool;
    const double before = tool.brush.radius;
    resize_brush(tool, 1);
    CHECK(tool.brush.radius > before);
    resize_brush(tool, -1);
    CHECK(tool.brush.radius == doctest::Approx(before));
    resize_brush(tool, 100);
    CHECK(tool.brush.radius == kLargestBrush);
    resize_brush(tool, -200);
    CHECK(tool.brush.radius == kSmallestBrush);
}

TEST_CASE("while text is typed, keys are letters") {
    Keyboard keyboard;
    keyboard.ui.click("text");
    REQUIRE(ImGui::GetIO().WantCaptureKeyboard);
    CHECK(keyboard.press(Key::f).empty());
    CHECK(keyboard.press(Key::z, true).empty());
}

TEST_CASE("every action is in a window's help, and no help has one twice") {
    std::set<Action> all;
    for (const auto help : {shortcuts(), light_shortcuts()}) {
        std::set<Action> seen;
        for (const Shortcut& shortcut : help) {
            CHECK(seen.insert(shortcut.action).second);
            CHECK(std::string(shortcut.meaning).size() > 3);
        }
        all.merge(seen);
    }
    CHECK(all.size() == static_cast<std::size_t>(Action::quit) + 1);
}

}  // namespace dapple
