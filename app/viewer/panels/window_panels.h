#pragma once
// What the window has around the drawing: buttons, banners, the status line, the player, and dialogs about
// itself.

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/viewer/model/banner.h"
#include "app/viewer/model/compared_panes.h"
#include "app/viewer/model/export_estimate.h"
#include "app/viewer/model/lit_map.h"
#include "app/viewer/model/session.h"
#include "app/viewer/model/variations.h"
#include "app/viewer/panels/method_panels.h"
#include "app/viewer/panels/shortcuts.h"
#include "app/viewer/view/loupe_square.h"
#include "app/viewer/widgets/picture_entry.h"
#include "app/viewer/widgets/theme.h"
#include "app/viewer/widgets/widgets.h"
#include "core/placing/page.h"
#include "core/text/number_words.h"
#include "io/files/save_lights.h"

namespace dapple {

// The title above the sections, its menu and the buttons.

/// What the column holds below its title: the drawing's settings, or one thing in their place.
enum class Column { drawing, crop, mask, retouch, method };

/// What would be undone and done again, in words; none: nothing.
struct UndoInfo {
    std::optional<std::string> undo, redo;
};

/// The name of what is shown, and at the end of its line small buttons: undo, redo, fit, and a menu of what
/// is asked for seldom: all commands, keys, preferences, about the program.
void draw_title(const std::string& name, const UndoInfo& info, const std::function<void(Action)>& act);

/// The menu that a right click opens in a rectangle which no ImGui window covers: views of the drawing, and
/// where it goes.
void draw_canvas_menu(glm::vec2 corner, glm::vec2 size, const std::function<void(Action)>& act);

/// Tools in a row over the canvas, from its corner on: crop, mask, retouch, rotate, compare. The one that is
/// in the column is marked. True while Compare is held.
bool draw_canvas_tools(glm::vec2 corner, Column column, const std::function<void(Action)>& act);

/// `has_project`: there are settings to be saved with the picture.
void draw_action_buttons(bool has_project, const std::function<void(Action)>& act);

// The message over the canvas.

/// Seconds until a notice looks different; 0: it fades. Infinity if it stays as it is.
double seconds_until_change(const Banner& banner);

/// Draws it within a rectangle; clicking the cross empties it. True when its offer is taken.
bool draw_banner(Banner& banner, glm::vec2 corner, glm::vec2 size);

// How far a file has been written, or other long work has come, and the button that stops it.

/// A bar at the bottom of the canvas that tells how far the saving of a file has come, 0..1. True when its
/// Cancel was clicked.
bool draw_saving_banner(const std::string& file_name, double share, glm::vec2 corner, glm::vec2 size);

/// The same while a picture is read; nobody knows how far that has come.
bool draw_opening_banner(const std::string& name, glm::vec2 corner, glm::vec2 size);

/// And while an environment map is sampled.
bool draw_sampling_banner(double share, glm::vec2 corner, glm::vec2 size);

// The line of figures below the canvas.

/// Someone who waits for longer wants to know for what, in seconds.
inline constexpr double kLongPlacing = 0.5;

struct StatusInfo {
    std::uint64_t dots = 0;        // of the whole page
    std::uint64_t duplicates = 0;  // among them
    double as_dense_as = 0;        // where a zoom brings more of them: so many on the page; 0: it does not
    bool figure8 = false;          // duplicates are worth a word
    double scale = 0;
    double tone_ms = 0, place_ms = 0, relax_ms = 0;
    int steps = 0, all_steps = 0;  // of relaxation: done, and to be done
    double draw_ms = 0;
    bool preview = false;                     // dots are left out of what is seen
    double placing_seconds = 0;               // that a placing under way has taken so far
    std::optional<double> placed_share = {};  // of its dots, 0..1, if that is known
    double frames_per_second = 0;
    std::string paper = {};            // "210 x 297 mm"
    double zoom = 1;                   // of the paper: 1 is as large as it is in the hand; 0: there is none
    bool method = false;               // whether its scale and its times are told too
    std::string plotting = {};         // how long a machine plots it: "plots about 31 min"; none: empty
    std::optional<LoupeInfo> loupe{};  // while it shows something
};

/// "40,000 dots", with how many there would be where a zoom brings more, and how many of them lie on another:
/// for Figure 8 only.
std::string dots_in_words(const StatusInfo& info);

/// "210 x 297 mm", "8.5 x 11 in".
std::string paper_in_words(const PageSize& page, LengthUnit unit);

/// What the line says, from the left to the right: dots and zoom first, and what only the method's section is
/// about where that is asked for. Where it is too narrow, the least important goes first.
struct StatusItem {
    std::string text;
    int importance = 0;
};
/// While a placing takes more than half a second it says how far it has come instead of how long the last one
/// took.
std::vector<StatusItem> status_items(const StatusInfo& info);

/// How far a placing of more than half a second, or what settles after it, has come, 0..1.
std::optional<double> progress_of(const StatusInfo& info);

/// Those that fit into a width, in their order; one at least.
std::vector<StatusItem> fitting(std::vector<StatusItem> items, float width);

/// A line over the whole width of a rectangle, with a bar at its upper edge while there is progress.
void draw_status_line(glm::vec2 corner, glm::vec2 size, const StatusInfo& info);

// What each side of the split view shows, under it.

/// The height of the strip that they need.
float side_captions_height();

/// Draws into a strip below the canvas, in the middle of each side of the divider, what it is drawn with and
/// what that came to. On a side too narrow for it a line ends in dots.
void draw_side_captions(const ComparedPanes& compared, glm::vec2 corner, glm::vec2 size);

// The bar below the canvas while a film is played.

/// How high the bar is, in ImGui's points: it grows with the window's text.
float player_bar_height();

/// What a click in the bar asks for beside what it changes in the film.
enum class PlayerWish { none, close, save, other_film };

/// Over the whole width of a rectangle. `words` tell the moment: "1,234 dots". `chosen` becomes the kind of
/// another film, if one is wished.
PlayerWish draw_player_bar(PlayedFilm& film, const std::string& words, FilmKind& chosen, glm::vec2 corner,
                           glm::vec2 size);

// A row of what is kept by name, as presets and palettes are: chooses one, keeps the present one under a name
// that is typed below the row, removes one of the person's own.

struct KeptThing {
    std::string name;
    bool own = false;  // the person's, which can be removed
};

/// What a row is about.
struct KeptThings {
    const char* label = "";  // "Preset"
    const char* tip = "";
    const char* what = "";     // "preset"
    const char* present = "";  // the entry of what none of them is: "as set below"
    const char* keep = "";     // the entry that keeps it: "Save these settings as..."
    std::vector<KeptThing> all = {};
    int chosen = -1;        // which of them is as the present one; -1: none
    bool may_keep = false;  // there is a place to keep them in
    std::function<void(int which)> take = {};
    /// What they throw is told in the banner.
    std::function<void(const std::string&name)> save = {}, remove = {};
    std::function<void()> changed = {};                     // told after either
    float lines_wide = 0;                                   // as in ListLook
    std::function<bool(int which, bool marked)> draw = {};  // one of them; none: by their names
};

class KeptRow {
 public:
    /// The banner says what went wrong, or that one was saved.
    void draw(const KeptThings& things, Banner& banner);

 private:
    void draw_naming(const KeptThings& things, Banner& banner);

    bool naming_ = false;        // the present one is about to be kept,
    std::string typed_;          // under this name
    bool ask_for_keys_ = false;  // its field is to have the keyboard
};

// Nine small drawings in the canvas's place: the one there is in the middle, and others around it. A click
// takes one, which is in the middle then, with others around it again.

/// `preview`: what settings make of the picture, small. The one that was clicked; the middle one ends the
/// choice.
std::optional<std::size_t> draw_variations(const std::array<Variation, 9>& variations,
                                           const std::function<EntryPicture(const DrawingSettings&)>& preview,
                                           glm::vec2 corner, glm::vec2 size);

/// The list of keys over everything else, while `open`; a click outside or Escape closes it.
void draw_help_panel(bool& open, std::span<const Shortcut> shortcuts);

// The dialogs about the program itself: how it looks, and what it is.

/// Theme and size of the text, whether the desktop's own dialog asks for files to open, and the unit that the
/// document shows lengths in; none: it shows none. True when something was changed but that unit, which is
/// the document's.
bool draw_preferences(Appearance& appearance, DialogChoice& dialog, LengthUnit* unit);
/// The same in a dialog.
bool draw_preferences_panel(bool& open, Appearance& appearance, DialogChoice& dialog, LengthUnit* unit);

/// Version, licence, and the libraries it stands on with theirs.
void draw_about_panel(bool& open);

// What the file dialog asks beside a name when a drawing is saved.

/// What goes with a format: the order of the dots, paper, resolution; and how large the file will be. True
/// while something changes.
bool draw_export_panel(ViewerSettings& settings, DrawingFormat format, const ExportInfo& info);

/// "about 24 MB, 400,000 dots".
std::string size_in_words(const ExportInfo& info);

// The column beside an environment map: its samples, its view, how good they are.

/// Sections "Samples" and "View", and the figures. True while something changes. `tiles` can be chosen from.
/// Without them the samples are still being taken, and it says so in their place.
bool draw_lights_panel(LightsSettings& settings, const std::optional<LightsInfo>& info,
                       const TileList& tiles);

/// What goes with a kind of file: the axes of its directions. True when another is chosen.
bool draw_light_export_panel(LightsSettings& settings, LightFile format);

}  // namespace dapple
