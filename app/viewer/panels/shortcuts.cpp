#include "app/viewer/panels/shortcuts.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "app/viewer/widgets/keys.h"

namespace dapple {
namespace {

constexpr Shortcut kShortcuts[] = {
    {Action::open, "Ctrl+O", "Open a picture or a project"},
    {Action::open_tile, "Ctrl+T", "Open a tile"},
    {Action::find_picture, "", "Use another picture in this project"},
    {Action::open_mask, "", "Open a mask: black for no dots, middle grey as it is, white for more"},
    {Action::paste, "Ctrl+V", "Open what was copied: a picture, or a file by its path"},
    {Action::save, "Ctrl+S", "Save the drawing again where it was saved"},
    {Action::save_as, "Ctrl+E", "Export the drawing: SVG, PDF, PNG, G-code, ..."},
    {Action::save_project, "Ctrl+Shift+S", "Save the project: picture and settings"},
    {Action::undo, "Ctrl+Z", "Undo"},
    {Action::redo, "Ctrl+Y", "Redo"},
    {Action::fit, "F", "Fit the page into the window"},
    {Action::one_to_one, "Ctrl+0", "One picture pixel on one screen pixel"},
    {Action::zoom_in, "+", "Zoom in"},
    {Action::zoom_out, "-", "Zoom out"},
    {Action::pan_left, "Left", "Move the view left"},
    {Action::pan_right, "Right", "Move the view right"},
    {Action::pan_up, "Up", "Move the view up"},
    {Action::pan_down, "Down", "Move the view down"},
    {Action::toggle_tiles, "T", "Tile boundaries"},
    {Action::compare, "C", "Split view: beside another tile or placer"},
    {Action::loupe, "L", "Loupe: tiles laid on one another"},
    {Action::explain_dots, "I", "Where the dot under the pointer comes from"},
    {Action::play, "Space", "Play a film of the drawing, or let it rest"},
    {Action::film_growth, "", "Film: the drawing grows dot by dot"},
    {Action::film_levels, "", "Film: level by level of the tiles"},
    {Action::film_zoom, "", "Film: zoom in, with ever more dots"},
    {Action::film_plot, "", "Film: as a machine plots it"},
    {Action::save_film, "", "Save the film that is played"},
    {Action::smaller_brush, "[", "A smaller brush, while one paints the mask"},
    {Action::larger_brush, "]", "A larger brush"},
    {Action::photograph, "P, held", "The photograph instead of its dots"},
    {Action::toggle_panels, "Ctrl+B", "Hide or show the panels"},
    {Action::full_screen, "F11", "Full screen"},
    {Action::palette, "Ctrl+P", "All that can be done, found by typing"},
    {Action::preferences, "Ctrl+,", "Preferences: theme and text size"},
    {Action::about, "", "About Dapple: version and licences"},
    {Action::help, "?, F1", "These keys"},
    {Action::quit, "Ctrl+Q", "Quit"},
};

constexpr Shortcut kLightShortcuts[] = {
    {Action::open, "Ctrl+O", "Open a map"},
    {Action::open_tile, "Ctrl+T", "Open a tile"},
    {Action::paste, "Ctrl+V", "Open what was copied: a picture, or a file by its path"},
    {Action::save, "Ctrl+S", "Save the samples again where they were saved"},
    {Action::save_as, "Ctrl+E", "Export the samples: JSON, CSV, pbrt, Mitsuba or PNG"},
    {Action::back, "", "Back to the drawing that the map was opened from"},
    {Action::undo, "Ctrl+Z", "Undo"},
    {Action::redo, "Ctrl+Y", "Redo"},
    {Action::fit, "F", "Fit the map into the window"},
    {Action::one_to_one, "Ctrl+0", "One map pixel on one screen pixel"},
    {Action::zoom_in, "+", "Zoom in"},
    {Action::zoom_out, "-", "Zoom out"},
    {Action::pan_left, "Left", "Move the view left"},
    {Action::pan_right, "Right", "Move the view right"},
    {Action::pan_up, "Up", "Move the view up"},
    {Action::pan_down, "Down", "Move the view down"},
    {Action::lighter, "E", "Half a stop lighter"},
    {Action::darker, "Shift+E", "Half a stop darker"},
    {Action::toggle_panels, "Ctrl+B", "Hide or show the panel"},
    {Action::full_screen, "F11", "Full screen"},
    {Action::palette, "Ctrl+P", "All that can be done, found by typing"},
    {Action::preferences, "Ctrl+,", "Preferences: theme and text size"},
    {Action::about, "", "About Dapple: version and licences"},
    {Action::help, "?, F1", "These keys"},
    {Action::quit, "Ctrl+Q", "Quit"},
};

bool typed(ImWchar letter) {
    return ImGui::GetIO().InputQueueCharacters.contains(letter);
}

}  // namespace

std::span<const Shortcut> shortcuts() {
    return kShortcuts;
}

std::span<const Shortcut> light_shortcuts() {
    return kLightShortcuts;
}

std::string keys_of(Action action) {
    for (const auto table : {shortcuts(), light_shortcuts()})
        if (const auto found = std::ranges::find(table, action, &Shortcut::action); found != table.end())
            return found->keys;
    return {};
}

std::string with_keys(std::string_view tip, Action action) {
    const std::string keys = keys_of(action);
    return keys.empty() ? std::string(tip) : fmt::format("{}   {}", tip, keys);
}

bool photograph_key_down() {
    const ImGuiIO& io = ImGui::GetIO();
    return !io.WantCaptureKeyboard && !io.KeyCtrl && !io.KeySuper && key_down(Key::p);
}

bool escape_pressed() {
    return key_pressed(Key::escape);
}

bool help_pressed() {
    return key_pressed(Key::f1) || typed('?');
}

bool repeating_key_down() {
    return key_down(Key::left) || key_down(Key::right) || key_down(Key::up) || key_down(Key::down);
}

std::vector<Action> pressed_actions(bool row_has_keys) {
    const ImGuiIO& io = ImGui::GetIO();
    std::vector<Action> actions;
    if (io.WantCaptureKeyboard) return actions;
    auto when = [&](bool asked, Action action) {
        if (asked) actions.push_back(action);
    };
    bool command = io.KeyCtrl || io.KeySuper;
    if (command) {
        when(key_pressed(Key::o), Action::open);
        when(key_pressed(Key::t), Action::open_tile);
        when(key_pressed(Key::v), Action::paste);
        when(key_pressed(Key::s), io.KeyShift ? Action::save_project : Action::save);
        when(key_pressed(Key::e), Action::save_as);
        when(key_pressed(Key::z), io.KeyShift ? Action::redo : Action::undo);
        when(key_pressed(Key::y), Action::redo);
        when(key_pressed(Key::zero), Action::one_to_one);
        when(key_pressed(Key::b), Action::toggle_panels);
        when(key_pressed(Key::p), Action::palette);
        when(key_pressed(Key::comma), Action::preferences);
        when(key_pressed(Key::q), Action::quit);
    } else {
        when(key_pressed(Key::f), Action::fit);
        when(key_pressed(Key::t), Action::toggle_tiles);
        when(key_pressed(Key::c), Action::compare);
        when(key_pressed(Key::l), Action::loupe);
        when(key_pressed(Key::i), Action::explain_dots);
        when(typed('+'), Action::zoom_in);
        when(typed('-'), Action::zoom_out);
        when(typed('['), Action::smaller_brush);
        when(typed(']'), Action::larger_brush);
        when(typed('e'), Action::lighter);
        when(typed('E'), Action::darker);
    }
    if (!row_has_keys) {
        when(key_pressed(Key::space) && !command, Action::play);
        const auto repeated = [](Key key) { return ImGui::IsKeyPressed(key_code(key), true); };
        when(repeated(Key::left), Action::pan_left);
        when(repeated(Key::right), Action::pan_right);
        when(repeated(Key::up), Action::pan_up);
        when(repeated(Key::down), Action::pan_down);
    }
    when(key_pressed(Key::f11), Action::full_screen);
    when(help_pressed(), Action::help);
    return actions;
}

}  // namespace dapple
