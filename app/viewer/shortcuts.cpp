#include "app/viewer/shortcuts.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

namespace dapple {
namespace {

constexpr Shortcut kShortcuts[] = {
    {Action::open, "Ctrl+O", "Open a picture"},
    {Action::open_tile, "Ctrl+T", "Open a tile"},
    {Action::save, "Ctrl+S", "Save the drawing again where it was saved"},
    {Action::save_as, "Ctrl+E", "Export the drawing: SVG, PNG or CSV"},
    {Action::undo, "Ctrl+Z", "Undo"},
    {Action::redo, "Ctrl+Y", "Redo"},
    {Action::fit, "F", "Fit the page into the window"},
    {Action::one_to_one, "Ctrl+0", "One picture pixel on one screen pixel"},
    {Action::zoom_in, "+", "Zoom in"},
    {Action::zoom_out, "-", "Zoom out"},
    {Action::toggle_tiles, "T", "Tile boundaries"},
    {Action::compare, "C", "Split view: beside another tile or placer"},
    {Action::loupe, "L", "Loupe: tiles laid on one another"},
    {Action::photograph, "P, held", "The photograph instead of its dots"},
    {Action::toggle_panels, "Tab, Ctrl+B", "Hide or show the panels"},
    {Action::full_screen, "F11", "Full screen"},
    {Action::help, "?, F1", "These keys"},
    {Action::quit, "Ctrl+Q", "Quit"},
};

constexpr Shortcut kLightShortcuts[] = {
    {Action::open, "Ctrl+O", "Open a map"},
    {Action::open_tile, "Ctrl+T", "Open a tile"},
    {Action::save, "Ctrl+S", "Save the samples again where they were saved"},
    {Action::save_as, "Ctrl+E", "Export the samples: JSON, CSV, pbrt, Mitsuba or PNG"},
    {Action::undo, "Ctrl+Z", "Undo"},
    {Action::redo, "Ctrl+Y", "Redo"},
    {Action::fit, "F", "Fit the map into the window"},
    {Action::one_to_one, "Ctrl+0", "One map pixel on one screen pixel"},
    {Action::zoom_in, "+", "Zoom in"},
    {Action::zoom_out, "-", "Zoom out"},
    {Action::lighter, "E", "Half a stop lighter"},
    {Action::darker, "Shift+E", "Half a stop darker"},
    {Action::toggle_panels, "Tab, Ctrl+B", "Hide or show the panel"},
    {Action::full_screen, "F11", "Full screen"},
    {Action::help, "?, F1", "These keys"},
    {Action::quit, "Ctrl+Q", "Quit"},
};

bool typed(ImWchar letter) {
    return ImGui::GetIO().InputQueueCharacters.contains(letter);
}

bool pressed(int key) {
    return ImGui::IsKeyPressed(key, false);
}

}  // namespace

std::span<const Shortcut> shortcuts() {
    return kShortcuts;
}

std::span<const Shortcut> light_shortcuts() {
    return kLightShortcuts;
}

bool photograph_key_down() {
    const ImGuiIO& io = ImGui::GetIO();
    return !io.WantCaptureKeyboard && !io.KeyCtrl && !io.KeySuper && ImGui::IsKeyDown(GLFW_KEY_P);
}

bool escape_pressed() {
    return pressed(GLFW_KEY_ESCAPE);
}

std::vector<Action> pressed_actions() {
    const ImGuiIO& io = ImGui::GetIO();
    std::vector<Action> actions;
    if (io.WantCaptureKeyboard) return actions;
    auto when = [&](bool asked, Action action) {
        if (asked) actions.push_back(action);
    };
    bool command = io.KeyCtrl || io.KeySuper;
    if (command) {
        when(pressed(GLFW_KEY_O), Action::open);
        when(pressed(GLFW_KEY_T), Action::open_tile);
        when(pressed(GLFW_KEY_S), Action::save);
        when(pressed(GLFW_KEY_E), Action::save_as);
        when(pressed(GLFW_KEY_Z), io.KeyShift ? Action::redo : Action::undo);
        when(pressed(GLFW_KEY_Y), Action::redo);
        when(pressed(GLFW_KEY_0), Action::one_to_one);
        when(pressed(GLFW_KEY_B), Action::toggle_panels);
        when(pressed(GLFW_KEY_Q), Action::quit);
    } else {
        when(pressed(GLFW_KEY_F), Action::fit);
        when(pressed(GLFW_KEY_T), Action::toggle_tiles);
        when(pressed(GLFW_KEY_C), Action::compare);
        when(pressed(GLFW_KEY_L), Action::loupe);
        when(pressed(GLFW_KEY_TAB), Action::toggle_panels);
        when(typed('+'), Action::zoom_in);
        when(typed('-'), Action::zoom_out);
        when(typed('e'), Action::lighter);
        when(typed('E'), Action::darker);
    }
    when(pressed(GLFW_KEY_F11), Action::full_screen);
    when(pressed(GLFW_KEY_F1) || typed('?'), Action::help);
    return actions;
}

}  // namespace dapple
