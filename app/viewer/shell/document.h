#pragma once
// What the window is about: the drawing of a photograph, or an environment map with its samples. The shell
// owns the window, its dialogs and the loop, and asks the document for the rest.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/vec2.hpp>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>

#include "app/viewer/panels/shortcuts.h"
#include "app/viewer/panels/window_panels.h"
#include "app/viewer/shell/file_dialog.h"
#include "app/viewer/shell/memory.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {

// What the window tells programs that drive it.

/// What a drawing's window tells: {"dots": .., "duplicates": .., "scale": .., "zoom": .., "placings": ..,
/// "place_ms": .., "draw_ms": .., "steps": .., "all_steps": .., "right": {"dots": .., "duplicates": ..,
/// "scale": .., "divider": .., "repetition": .., "left_repetition": ..}, "loupe": {"repetition": ..,
/// "layers": .., "level": ..}}. placings counts since the start. "right" is there while the split view shows
/// dots (an unknown repetition is null), "loupe" while the lens shows something.
nlohmann::ordered_json status_json(const StatusInfo& info, std::uint64_t placings);

/// Says "ready" on the standard output once something is shown, and then, if it was asked for, a line of JSON
/// whenever something in the window changed: what the document tells, and what both kinds have:
/// {"longest_frame_ms": .., "longest_work_ms": .., "gl_errors": .., "mouse": [x, y], "mouse_down": ..,
/// "row_with_keys": .., "widgets": {"Dots in black": [x0, y0, x1, y1], ..}}, places in window coordinates.
/// row_with_keys is a number of its own for each row, 0 for none.
class StatusLog {
 public:
    explicit StatusLog(bool all) : all_(all) {}

    bool ready() const { return ready_; }
    /// What the window took for a frame, from the events it knew to showing it, and of that its own processor
    /// time: the machine does other things too. The first frame, which makes everything ready, is left out.
    void took(double frame_ms, double work_ms);
    /// After each frame: what the document tells; none before something is shown.
    void write(std::optional<nlohmann::ordered_json> status, const WidgetNotes& widgets);

 private:
    bool all_, ready_ = false;
    int frames_ = 0;
    double longest_frame_ms_ = 0, longest_work_ms_ = 0;
    int gl_errors_ = 0;
    std::string written_;
};

class Session;
class Window;

/// An arrow key moves the view by so much of the canvas's shorter side.
inline constexpr double kPanStep = 0.1;

inline void toggle(bool& value) {
    value = !value;
}

/// What a document draws itself into: the canvas to the left, the panels beside it.
struct Frame {
    Window& window;
    glm::vec2 canvas{1};  // in ImGui's points, from the upper left corner
    glm::vec2 panels{0};  // their size; not shown if they have no width
    glm::dvec2 pixels_per_point{1};
    const std::function<void(Action)>& act;  // for buttons
    double last_seconds = 0;                 // that the frame before took
    bool can_go_back = false;                // to the drawing that this was opened from
};

class Document {
 public:
    virtual ~Document() = default;

    virtual std::span<const Shortcut> shortcuts() const = 0;
    /// What the drawing of a photograph is about: its project, its film, its unit of lengths. Null: it is
    /// none.
    virtual Session* session() { return nullptr; }

    virtual void open_tile(const std::filesystem::path& file) = 0;
    /// A picture that says where there are more dots or fewer: see mask.h.
    virtual void open_mask(const std::filesystem::path&) {}
    virtual void take_dropped(const std::filesystem::path& file) = 0;
    /// Whether a file is both: a picture, and settings that take_dropped() would take from it.
    virtual bool is_picture_with_settings(const std::filesystem::path&) const { return false; }
    /// Whatever settings it holds.
    virtual void open_as_picture(const std::filesystem::path& file) = 0;
    virtual void save(const std::filesystem::path& file) = 0;

    /// The file that is being saved, by its name, before the window goes; empty: none.
    virtual std::string saving() const { return {}; }
    /// Gives up saving it, where that takes long: what was at its place stays.
    virtual void stop_saving() {}
    /// Whether there is a sentence about something that went wrong, which nobody has closed yet.
    virtual bool tells_of_trouble() const = 0;

    // What the dialogs for these ask.
    virtual OpenQuestion what_to_open() const = 0;
    /// The tile in use, as tile_named() takes it.
    virtual const std::string& tile() const = 0;
    /// None: there is nothing to save yet.
    virtual std::optional<SaveQuestion> where_to_save() const = 0;
    /// The same for a project: all settings. None: it has no projects.
    virtual std::optional<SaveQuestion> where_to_save_project() const { return std::nullopt; }
    /// The same for a film. None: none is played.
    virtual std::optional<SaveQuestion> where_to_save_film() const { return std::nullopt; }
    /// What of a session is not saved, by its name; empty: nothing that would be missed.
    virtual std::string unsaved() const { return {}; }
    /// For a format of where_to_save(), as FileDialog::DrawOptions.
    virtual std::string draw_saving_options(std::size_t format) = 0;
    /// Their rows alone, to be listed as those of draw_rows().
    virtual void draw_saving_rows(std::size_t) {}

    /// The file that is shown, for the list of recent ones; empty: none, or none yet.
    virtual std::filesystem::path file() const = 0;
    /// One sentence about the program itself.
    virtual void say(const std::string& sentence) = 0;
    /// What of how it is shown is remembered for the next.
    virtual std::optional<KeptView> kept_view() const { return std::nullopt; }

    /// Does what the shell does not do itself: open, save, panels, help, the window.
    virtual void act(Action action, const Frame& frame) = 0;

    /// Takes what came from the background, draws panels and canvas. Throws std::runtime_error if what it was
    /// to show first cannot be read.
    virtual void draw(const Frame& frame) = 0;

    /// The rows of its panels alone, to be listed: see RowListing.
    virtual void draw_rows() = 0;

    /// Seconds without an event after which it is to be drawn all the same; 0: at once.
    virtual double seconds_to_next_frame() const = 0;

    /// What is to take its place in the window, once; null: nothing.
    virtual std::unique_ptr<Document> take_successor() { return nullptr; }

    /// For scripts that drive the window, see status_log.h; none before something is shown.
    virtual std::optional<nlohmann::ordered_json> status() const = 0;
};

}  // namespace dapple
