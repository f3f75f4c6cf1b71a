#include <doctest/doctest.h>

#include <GLFW/glfw3.h>

#include <set>
#include <string>

#include "app/viewer/shortcuts.h"
#include "tests/headless_ui.h"

namespace dapple {
namespace {

struct Keyboard {
    std::vector<Action> actions;
    char text[32] = "";
    HeadlessUi ui{[this] {
        for (Action action : pressed_actions()) actions.push_back(action);
        ImGui::InputText("text", text, sizeof text);
        note_place("text");
    }};

    std::vector<Action> press(int key, bool ctrl = false, bool shift = false) {
        ImGuiIO& io = ImGui::GetIO();
        io.KeyCtrl = ctrl;
        io.KeyShift = shift;
        io.KeyMods = (ctrl ? ImGuiKeyModFlags_Ctrl : 0) | (shift ? ImGuiKeyModFlags_Shift : 0);
        io.KeysDown[key] = true;
        actions.clear();
        ui.frame();
        ui.frame();  // held down: no second time
        io.KeysDown[key] = false;
        io.KeyCtrl = io.KeyShift = false;
        io.KeyMods = 0;
        ui.frame();
        return actions;
    }
};

using Actions = std::vector<Action>;

}  // namespace

TEST_CASE("keys do what the help says, once a press") {
    Keyboard keyboard;
    CHECK(keyboard.press(GLFW_KEY_F) == Actions{Action::fit});
    CHECK(keyboard.press(GLFW_KEY_0, true) == Actions{Action::one_to_one});
    CHECK(keyboard.press(GLFW_KEY_O, true) == Actions{Action::open});
    CHECK(keyboard.press(GLFW_KEY_T, true) == Actions{Action::open_tile});
    CHECK(keyboard.press(GLFW_KEY_T) == Actions{Action::toggle_tiles});
    CHECK(keyboard.press(GLFW_KEY_S, true) == Actions{Action::save});
    CHECK(keyboard.press(GLFW_KEY_E, true) == Actions{Action::save_as});
    CHECK(keyboard.press(GLFW_KEY_Z, true) == Actions{Action::undo});
    CHECK(keyboard.press(GLFW_KEY_Z, true, true) == Actions{Action::redo});
    CHECK(keyboard.press(GLFW_KEY_TAB) == Actions{Action::toggle_panels});
    CHECK(keyboard.press(GLFW_KEY_B, true) == Actions{Action::toggle_panels});
    CHECK(keyboard.press(GLFW_KEY_C) == Actions{Action::compare});
    CHECK(keyboard.press(GLFW_KEY_L) == Actions{Action::loupe});
    CHECK(keyboard.press(GLFW_KEY_F11) == Actions{Action::full_screen});
    CHECK(keyboard.press(GLFW_KEY_O).empty());
}

TEST_CASE("a question mark asks for help wherever the keyboard has it") {
    Keyboard keyboard;
    keyboard.actions.clear();
    keyboard.ui.type("?");
    CHECK(keyboard.actions == Actions{Action::help});
}

TEST_CASE("while text is typed, keys are letters") {
    Keyboard keyboard;
    keyboard.ui.click("text");
    REQUIRE(ImGui::GetIO().WantCaptureKeyboard);
    CHECK(keyboard.press(GLFW_KEY_F).empty());
    CHECK(keyboard.press(GLFW_KEY_Z, true).empty());
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
