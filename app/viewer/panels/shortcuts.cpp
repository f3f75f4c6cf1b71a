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
    {Action::redo, "Ctrl+Y, Ctrl+Shift+Z", "Redo"},
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
    {Action::redo, "Ctrl+Y, Ctrl+Shift+Z", "Redo"},
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

struct NamedKey {
    std::string_view name;
    Key key;
};
constexpr NamedKey kKeys[] = {
    {"B", Key::b},         {"C", Key::c},   {"E", Key::e},       {"F", Key::f},       {"I", Key::i},
    {"L", Key::l},         {"O", Key::o},   {"P", Key::p},       {"Q", Key::q},       {"S", Key::s},
    {"T", Key::t},         {"V", Key::v},   {"Y", Key::y},       {"Z", Key::z},       {"0", Key::zero},
    {",", Key::comma},     {"Up", Key::up}, {"Down", Key::down}, {"Left", Key::left}, {"Right", Key::right},
    {"Space", Key::space}, {"F1", Key::f1}, {"F11", Key::f11},
};

bool is_arrow(Key key) {
    return key == Key::left || key == Key::right || key == Key::up || key == Key::down;
}

// Whether one of an entry's keys went down, "Ctrl+Y, Ctrl+Shift+Z". What is no key's name is a letter that
// has its place elsewhere on each keyboard. A row that has the keys keeps arrows and Space.
bool are_pressed(std::string_view keys, bool row_has_keys) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool commands = io.KeyCtrl || io.KeySuper;
    while (!keys.empty()) {
        const std::size_t end = std::min(keys.find(", "), keys.size());
        std::string_view key = keys.substr(0, end);
        keys.remove_prefix(std::min(end + 2, keys.size()));
        const auto takes = [&key](std::string_view modifier) {
            const bool has = key.starts_with(modifier);
            if (has) key.remove_prefix(modifier.size());
            return has;
        };
        const bool command = takes("Ctrl+"), shift = takes("Shift+");
        const auto named = std::ranges::find(kKeys, key, &NamedKey::name);
        if (named == std::end(kKeys)) {
            if (key.size() == 1 && !commands &&
                io.InputQueueCharacters.contains(static_cast<ImWchar>(key[0])))
                return true;
            continue;
        }
        const bool arrow = is_arrow(named->key);
        if (row_has_keys && (arrow || named->key == Key::space)) continue;
        if (command == commands && shift == io.KeyShift && ImGui::IsKeyPressed(key_code(named->key), arrow))
            return true;
    }
    return false;
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
    return are_pressed(keys_of(Action::help), false);
}

bool repeating_key_down() {
    return std::ranges::any_of(kKeys, [](const NamedKey& key) { return is_arrow(key.key) && key_down(key.key); });
}

std::vector<Action> pressed_actions(std::span<const Shortcut> shortcuts, bool row_has_keys) {
    std::vector<Action> actions;
    if (ImGui::GetIO().WantCaptureKeyboard) return actions;
    for (const auto& [action, keys, meaning] : shortcuts)
        if (are_pressed(keys, row_has_keys)) actions.push_back(action);
    return actions;
}

}  // namespace dapple
