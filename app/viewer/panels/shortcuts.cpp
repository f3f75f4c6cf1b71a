#include "app/viewer/panels/shortcuts.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "app/viewer/model/compared_panes.h"
#include "app/viewer/widgets/keys.h"

namespace dapple {
namespace {

// In which windows.
enum class In { both, drawing, map };

struct Entry {
    In in;
    Shortcut shortcut;
};

constexpr const char *kOpenTip = "Opens a picture, project or environment map.",
                     *kExportTip = "Export for other programs, printers and plotters.",
                     *kFitTip = "Shows the whole page or map.";

constexpr Entry kEntries[] = {
    {In::drawing, {Action::open, "Ctrl+O", "Open a picture or a project", "Open...", kOpenTip}},
    {In::map, {Action::open, "Ctrl+O", "Open a map", "Open...", kOpenTip}},
    {In::both, {Action::open_tile, "Ctrl+T", "Open a tile"}},
    {In::drawing, {Action::find_picture, "", "Use another picture in this project"}},
    {In::drawing,
     {Action::open_mask, "", "Open a mask: black for no dots, middle grey for no change, white for more"}},
    {In::both, {Action::paste, "Ctrl+V", "Paste a picture or a file's path"}},
    {In::drawing, {Action::save, "Ctrl+S", "Export again"}},
    {In::map, {Action::save, "Ctrl+S", "Export the samples again"}},
    {In::drawing,
     {Action::save_as, "Ctrl+E", "Export the drawing: SVG, PDF, PNG, G-code, ...", "Export...", kExportTip}},
    {In::map,
     {Action::save_as, "Ctrl+E", "Export the samples: JSON, CSV, pbrt, Mitsuba or PNG", "Export...",
      kExportTip}},
    {In::drawing,
     {Action::save_project, "Ctrl+Shift+S", "Save the project: picture and settings", "Project...",
      "Saves picture and settings, to continue later."}},
    {In::drawing, {Action::copy_picture, "Ctrl+C", "Copy the drawing as a picture", "Copy picture"}},
    {In::drawing, {Action::as_lights, "", "Use the picture as an environment map"}},
    {In::map, {Action::back, "", "Back to the drawing"}},
    {In::both, {Action::undo, "Ctrl+Z", "Undo", "Undo"}},
    {In::both, {Action::redo, "Ctrl+Y, Ctrl+Shift+Z", "Redo", "Redo"}},
    {In::drawing, {Action::fit, "F", "Fit the page into the window", "Fit", kFitTip}},
    {In::map, {Action::fit, "F", "Fit the map into the window", "Fit", kFitTip}},
    {In::drawing, {Action::one_to_one, "Ctrl+0", "One picture pixel per screen pixel", "1:1"}},
    {In::map, {Action::one_to_one, "Ctrl+0", "One map pixel per screen pixel"}},
    {In::both, {Action::zoom_in, "+", "Zoom in"}},
    {In::both, {Action::zoom_out, "-", "Zoom out"}},
    {In::both, {Action::pan_left, "Left", "Move the view left"}},
    {In::both, {Action::pan_right, "Right", "Move the view right"}},
    {In::both, {Action::pan_up, "Up", "Move the view up"}},
    {In::both, {Action::pan_down, "Down", "Move the view down"}},
    {In::map, {Action::lighter, "E", "Half a stop lighter"}},
    {In::map, {Action::darker, "Shift+E", "Half a stop darker"}},
    {In::drawing, {Action::toggle_tiles, "T", "Tile boundaries"}},
    {In::drawing, {Action::compare, "Shift+C", "Split view: beside another tile or placer"}},
    {In::drawing, {Action::loupe, "L", "Loupe: tiles overlaid"}},
    {In::drawing, {Action::explain_dots, "I", "Explain the dot under the pointer"}},
    {In::drawing, {Action::play, "Space", "Play or pause the film"}},
    {In::drawing,
     {Action::film_growth, "", "Film: the drawing grows dot by dot", "Watch it grow",
      "From a few dots to all, which then relax; until then dots only appear."}},
    {In::drawing,
     {Action::film_levels, "", "Film: level by level of the tiles", "Levels",
      "The page divided into tiles, level by level, each in its colour."}},
    {In::drawing,
     {Action::film_zoom, "", "Film: zoom in, with ever more dots", "Zoom",
      "Zooms into the middle of the view, with new dots between the others."}},
    {In::drawing,
     {Action::film_plot, "", "Film: as a machine plots it", "Watch the plot",
      "Shows the pen's route and how long a machine takes."}},
    {In::drawing, {Action::save_film, "", "Save the film"}},
    {In::drawing,
     {Action::crop, "X", "Crop the picture", "Crop", "Drag the frame, its edges or its corners."}},
    {In::drawing,
     {Action::mask, "B", "Paint a mask: more, fewer or no dots", "Mask",
      "Paint where to have more, fewer or no dots."}},
    {In::drawing,
     {Action::retouch, "D", "Retouch: remove, add, move or resize single dots", "Retouch",
      "Removes, adds, moves or resizes single dots, with a whitener and a lasso for many."}},
    {In::drawing,
     {Action::rotate, "R", "Rotate the picture by a quarter turn", "Rotate",
      "Rotates the picture clockwise."}},
    {In::drawing,
     {Action::variations, "V", "Variations: nine drawings to choose from", "Variations",
      "Nine small drawings: lighter, darker, with fewer or more dots, in colour. Click one to use it."}},
    {In::drawing,
     {Action::method, "M", "The method: tiles, ranks, spectrum", "The method",
      "How it works: the tile that all dots come from, its boundaries and ranks, whether it repeats, the "
      "dots' spectrum, and films."}},
    {In::drawing, {Action::smaller_brush, "[", "Smaller brush for the mask"}},
    {In::drawing, {Action::larger_brush, "]", "Larger brush for the mask"}},
    {In::drawing,
     {Action::photograph, "C, \\, P, held", "Compare with the photograph", "Compare: the photograph"}},
    {In::drawing,
     {Action::as_it_was, "W, Shift+\\, held", "Compare with the drawing as opened or kept",
      "Compare: as it was"}},
    {In::drawing, {Action::keep_to_compare, "", "Keep these settings for comparison"}},
    {In::drawing, {Action::toggle_panels, "Ctrl+B", "Hide or show the panels"}},
    {In::map, {Action::toggle_panels, "Ctrl+B", "Hide or show the panel"}},
    {In::both, {Action::full_screen, "F11", "Full screen", "Full screen"}},
    {In::both, {Action::palette, "Ctrl+K, Ctrl+P", "Search all commands", "All commands..."}},
    {In::both, {Action::preferences, "Ctrl+,", "Preferences: theme and text size", "Preferences..."}},
    {In::both, {Action::about, "", "About Dapple: version and licences", "About Dapple"}},
    {In::both, {Action::help, "?, F1", "Keyboard shortcuts", "Keys"}},
    {In::both, {Action::quit, "Ctrl+Q", "Quit"}},
};

constexpr const Entry* entry_of(Action action) {
    return std::ranges::find(kEntries, action, [](const Entry& entry) { return entry.shortcut.action; });
}
static_assert(
    [] {
        for (int i = 0; i <= static_cast<int>(Action::quit); ++i)
            if (entry_of(static_cast<Action>(i)) == std::end(kEntries)) return false;
        return true;
    }(),
    "an action without its line");

std::vector<Shortcut> those_in(In window) {
    std::vector<Shortcut> those;
    for (const Entry& entry : kEntries)
        if (entry.in == In::both || entry.in == window) those.push_back(entry.shortcut);
    return those;
}

struct NamedKey {
    std::string_view name;
    Key key;
};
constexpr NamedKey kKeys[] = {
    {"B", Key::b},       {"C", Key::c},       {"E", Key::e},         {"F", Key::f},         {"I", Key::i},
    {"L", Key::l},       {"M", Key::m},       {"R", Key::r},         {"X", Key::x},         {"O", Key::o},
    {"P", Key::p},       {"Q", Key::q},       {"S", Key::s},         {"T", Key::t},         {"V", Key::v},
    {"Y", Key::y},       {"Z", Key::z},       {"0", Key::zero},      {",", Key::comma},     {"Up", Key::up},
    {"Down", Key::down}, {"Left", Key::left}, {"Right", Key::right}, {"Space", Key::space}, {"F1", Key::f1},
    {"F11", Key::f11},   {"K", Key::k},       {"D", Key::d},
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
    static const std::vector<Shortcut> those = those_in(In::drawing);
    return those;
}

std::span<const Shortcut> light_shortcuts() {
    static const std::vector<Shortcut> those = those_in(In::map);
    return those;
}

const Shortcut& shortcut_of(Action action) {
    return entry_of(action)->shortcut;
}

ActionGroup group_of(Action action) {
    constexpr std::array kLast{Action::back, Action::full_screen, Action::film_plot, Action::film_zoom};
    return static_cast<ActionGroup>(std::ranges::lower_bound(kLast, action) - kLast.begin());
}

std::string with_keys(std::string_view tip, Action action) {
    const char* const keys = shortcut_of(action).keys;
    return *keys ? fmt::format("{}   {}", tip, keys) : std::string(tip);
}

std::optional<SeenInstead> comparison_held() {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantCaptureKeyboard || io.KeyCtrl || io.KeySuper) return std::nullopt;
    const bool backslash = key_down(Key::backslash);
    if (io.KeyShift ? backslash : key_down(Key::w)) return SeenInstead::as_it_was;
    if (!io.KeyShift && (key_down(Key::c) || backslash || key_down(Key::p))) return SeenInstead::photograph;
    return std::nullopt;
}

bool escape_pressed() {
    return key_pressed(Key::escape);
}

bool help_pressed() {
    return are_pressed(shortcut_of(Action::help).keys, false);
}

bool repeating_key_down() {
    return std::ranges::any_of(kKeys,
                               [](const NamedKey& key) { return is_arrow(key.key) && key_down(key.key); });
}

std::vector<Action> pressed_actions(std::span<const Shortcut> shortcuts, bool row_has_keys) {
    std::vector<Action> actions;
    if (ImGui::GetIO().WantCaptureKeyboard) return actions;
    for (const Shortcut& shortcut : shortcuts)
        // While a key of these two is held it is so anyway.
        if (shortcut.action != Action::photograph && shortcut.action != Action::as_it_was &&
            are_pressed(shortcut.keys, row_has_keys))
            actions.push_back(shortcut.action);
    return actions;
}

}  // namespace dapple
