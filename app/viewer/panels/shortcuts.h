#pragma once
// All that can be asked for by a key, a button, the menu or the palette, in one table: what the help shows is
// what the keys do. What an action then does is in Shell::act() and in each Document's.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dapple {

enum class SeenInstead;  // see compared_panes.h

/// In the order of their groups: see group_of().
enum class Action {
    open,  // files
    open_tile,
    find_picture,  // that a project is to have, as where its own is missing
    open_mask,
    paste,
    save,
    save_as,
    save_project,
    save_film,
    copy_picture,
    as_lights,  // the picture is an environment map
    back,       // from an environment map to the drawing that it was opened from
    fit,        // the view
    one_to_one,
    zoom_in,
    zoom_out,
    pan_left,  // the view goes there, by arrows
    pan_right,
    pan_up,
    pan_down,
    photograph,  // in the drawing's place until it is asked for again, or while a key is held: see
    as_it_was,   // comparison_held()
    keep_to_compare,
    lighter,
    darker,
    toggle_panels,
    full_screen,
    undo,  // the drawing
    redo,
    crop,  // tools, which take the column's place until they are asked for again
    mask,
    retouch,
    rotate,
    variations,
    smaller_brush,
    larger_brush,
    play,  // or rest, while a film is shown
    film_growth,
    film_plot,
    method,  // what students look at, in the column's place likewise
    toggle_tiles,
    compare,
    loupe,
    explain_dots,
    film_levels,
    film_zoom,
    help,  // the program
    palette,
    preferences,
    about,
    quit,
};

struct Shortcut {
    Action action;
    const char* keys;     // "Ctrl+O", or several, "?, F1"; empty: none
    const char* meaning;  // "Open a picture"
    // What its button, or its entry in the menu, shows; both empty if there is none.
    const char* label = "";
    const char* tip = "";
};
/// The shortcuts of a drawing's window, and those of an environment map's.
std::span<const Shortcut> shortcuts();
std::span<const Shortcut> light_shortcuts();
/// What there is to say of an action, in the drawing's window or else in the map's.
const Shortcut& shortcut_of(Action action);
/// What help lists together.
enum class ActionGroup { files, view, drawing, method, program };
ActionGroup group_of(Action action);
/// A tip, with the action's keys behind it.
std::string with_keys(std::string_view tip, Action action);

/// What the keys pressed since the last frame ask for, of these; nothing while a text field has the keyboard.
/// The arrows and Space are the view's unless a row of the panels has them.
std::vector<Action> pressed_actions(std::span<const Shortcut> shortcuts, bool row_has_keys = false);

/// A key is held that moves or changes something again and again, so that frames have to follow one another.
bool repeating_key_down();

/// What a key that is held shows in the drawing's place.
std::optional<SeenInstead> comparison_held();

bool escape_pressed();

/// A key that asks for help, or sends it away.
bool help_pressed();

}  // namespace dapple
