#pragma once
// What the window remembers from one day to the next, in files of the person's own:
//
//     $XDG_CONFIG_HOME/dapple/preferences.json   what was chosen: theme, text size
//     $XDG_STATE_HOME/dapple/state.json          what just was so: the window's place, recent files
//
// Both are settings as fields.h has them.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/viewer/model/viewer_settings.h"
#include "app/viewer/widgets/theme.h"
#include "core/drawing/settings.h"
#include "core/text/names.h"
#include "io/descriptor.h"

namespace dapple {

// Tells the next window that one ended before it could draw, as by settings that crash it.

/// A file that is there from the window's start to its first drawing. Held by one window at a time; of others
/// that begin meanwhile nothing is known.
class StartMark {
 public:
    StartMark() = default;
    explicit StartMark(const std::filesystem::path& folder);
    StartMark(StartMark&&) = default;
    StartMark& operator=(StartMark&&) = default;
    /// A window that ends in good order, as where there is no display, leaves none.
    ~StartMark() { begun(); }

    /// There was one that no window holds any more.
    bool was_left() const { return was_left_; }
    void begun();

 private:
    std::filesystem::path file_;
    Descriptor held_;
    bool was_left_ = false;
};

struct Preferences {
    Appearance appearance = {};
    DialogChoice dialog = DialogChoice::desktop;

    bool operator==(const Preferences&) const = default;
};

/// In the desktop's units.
struct WindowPlace {
    int x = 0, y = 0, width = 0, height = 0;  // of no width: as usual
    bool maximised = false;                   // the rest is what it is then made smaller to

    bool operator==(const WindowPlace&) const = default;
};

/// How pictures are shown, drawn and saved whatever they are, as if the window had not been closed. What is
/// one picture's own, as with_preset() has it, is not among it. Projects bring their own.
struct KeptView {
    ZoomMode zoom_mode = ZoomMode::drawing;
    LengthUnit unit = LengthUnit::mm;
    SavingChoice saving = {};
    DrawingSettings drawing = {};

    bool operator==(const KeptView&) const = default;
};

/// How wide the column of panels is, at 96 dpi; no wider than half of the window.
inline constexpr float kUsualPanelWidth = 340, kLeastPanelWidth = 240, kMostPanelWidth = 800;

struct WindowState {
    WindowPlace window = {};
    bool panels_shown = true;
    float panel_width = kUsualPanelWidth;
    std::vector<std::filesystem::path> folder = {};  // one at most: where files were opened last
    KeptView view = {};
    std::vector<std::filesystem::path> recent = {};  // the last one opened first

    bool operator==(const WindowState&) const = default;
};

inline constexpr std::size_t kMostRecent = 20;

/// A list of recent files with another opened: it goes to the front, and is not there twice.
std::vector<std::filesystem::path> with_recent(const std::filesystem::path& file,
                                               std::vector<std::filesystem::path> recent);

class Memory {
 public:
    /// Remembers nothing and writes nothing.
    Memory() = default;
    /// Reads what is there. A file that cannot be read is moved aside, to its name with ".broken", and
    /// trouble() says so; the usual values stand in. An empty folder: nothing is read or written there.
    Memory(const std::filesystem::path& config_folder, const std::filesystem::path& state_folder);

    Preferences preferences;
    WindowState state;

    /// The window has drawn with what was remembered: if it had not, the next would begin with the usual
    /// settings, and trouble() say so.
    void begun() { start_.begun(); }

    /// Takes a file into the recent ones; its folder is the last one.
    void opened(const std::filesystem::path& file);
    /// Takes one out that is not there any more.
    void forget(const std::filesystem::path& file);

    /// Writes what was changed since it was read or written last, and only that: what another window wrote
    /// meanwhile stays, and its recent files come after ours. If two windows save at once, one waits for the
    /// other, a second at most. Throws as save_atomically().
    void save();

    /// One sentence for the person, once; none: nothing was wrong.
    std::optional<std::string> take_trouble();

 private:
    std::filesystem::path preferences_file_, state_file_;  // empty: none
    Preferences known_preferences_;                        // as in the file, as far as this window knows
    WindowState known_state_;
    std::vector<std::filesystem::path> opened_, forgotten_;  // since the last save
    std::optional<std::string> trouble_;
    StartMark start_;
};

}  // namespace dapple
