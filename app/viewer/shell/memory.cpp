#include "app/viewer/shell/memory.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/file.h>
#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

#include "core/settings/drawing_fields.h"
#include "core/settings/fields.h"
#include "core/text/shown_text.h"
#include "io/files/atomic_file.h"
#include "io/settings/project.h"
#include "io/settings/xdg_folders.h"

namespace dapple {

StartMark::StartMark(const std::filesystem::path& folder) : file_(folder / "starting") {
    std::error_code ignored;
    const bool was_there = std::filesystem::exists(file_, ignored);
    held_ = Descriptor(::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600));
    if (!held_) return;
    if (::flock(held_.get(), LOCK_EX | LOCK_NB) != 0)
        held_ = Descriptor();  // another window's
    else
        was_left_ = was_there;
}

void StartMark::begun() {
    if (!held_) return;
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
    held_ = Descriptor();
}

namespace {

namespace fs = std::filesystem;

constexpr double kFarthest = 100'000;  // of a window's place: further than any desktop is wide

void describe(Fields& fields, Preferences& preferences) {
    auto& [appearance, dialog] = preferences;
    auto& [theme, text_size] = appearance;
    fields.choice("theme", theme);
    fields.number("text_size", text_size, {kSmallestText, kLargestText});
    fields.choice("dialog", dialog);
}

void describe(Fields& fields, WindowPlace& place) {
    auto& [x, y, width, height, maximised] = place;
    fields.whole("x", x, {-kFarthest, kFarthest});
    fields.whole("y", y, {-kFarthest, kFarthest});
    fields.whole("width", width, {0, kFarthest});
    fields.whole("height", height, {0, kFarthest});
    fields.flag("maximised", maximised);
}

void describe(Fields& fields, KeptView& view) {
    auto& [zoom_mode, unit, saving, drawing] = view;
    fields.choice("zoom_mode", zoom_mode);
    fields.choice("unit", unit);
    fields.group("saving", saving);
    fields.group("drawing", drawing);
}

void describe(Fields& fields, WindowState& state) {
    auto& [window, panels_shown, panel_width, folder, view, recent] = state;
    fields.group("window", [&](Fields& inner) { describe(inner, state.window); });
    fields.flag("panels_shown", panels_shown);
    fields.number({"panel_width"}, panel_width, {kLeastPanelWidth, kMostPanelWidth});
    fields.remembered_files("folder", folder, 1);
    fields.group("view", [&](Fields& inner) { describe(inner, state.view); });
    fields.remembered_files("recent", recent, kMostRecent);
}

/// Its text, and what it says; neither if there is no such file.
template <class Settings>
std::string read_remembered(const fs::path& file, Settings& settings) {
    std::error_code ignored;
    if (file.empty() || !fs::exists(file, ignored)) return {};
    std::string text = text_of_settings(file);
    Settings read;
    read_settings(text, {file}, [&](Fields& fields) { describe(fields, read); });
    settings = std::move(read);
    return text;
}

template <class Settings>
void read_or_move_aside(const fs::path& file, Settings& settings, std::optional<std::string>& trouble) {
    try {
        read_remembered(file, settings);
    } catch (const std::exception& error) {
        const fs::path aside = fs::path(file).concat(".broken");
        std::error_code failed;
        fs::rename(file, aside, failed);
        trouble = fmt::format("{}; default values are used, and the file {}", error.what(),
                              failed ? "stays as it is" : "was moved to " + printable(aside.native()));
    }
}

/// Takes over what this window changed.
template <class Value>
void take_changed(Value& there, const Value& ours, const Value& known) {
    if (ours != known) there = ours;
}

// Held while a file is read, changed and written again. A window that hangs with it stops no other for longer
// than a second.
class MemoryLock {
 public:
    explicit MemoryLock(const fs::path& folder) {
        constexpr std::chrono::milliseconds kPause(5);
        constexpr int kTries = 200;
        make_folder(folder);
        file_ = Descriptor(::open((folder / ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600));
        for (int i = 0; file_ && i < kTries && ::flock(file_.get(), LOCK_EX | LOCK_NB) != 0; ++i)
            std::this_thread::sleep_for(kPause);
    }

 private:
    Descriptor file_;  // its lock goes with it
};

/// Has what this window changed taken over into what is there now, and written. A file that another window
/// broke meanwhile is written anew. False: nothing was changed.
template <class Settings, class Take>
bool save_changed(const fs::path& file, const Settings& ours, Settings& known, const Take& take) {
    if (file.empty() || ours == known) return false;
    const MemoryLock lock(file.parent_path());
    Settings there;
    std::string kept;
    try {
        kept = read_remembered(file, there);
    } catch (const std::exception&) {
    }
    take(there);
    const std::string text = settings_text(kept, {file}, [&](Fields& fields) { describe(fields, there); });
    if (text != kept) save_atomically(file, [&](std::ostream& out) { out << text; });
    known = ours;
    return true;
}

}  // namespace

std::vector<fs::path> with_recent(const fs::path& file, std::vector<fs::path> recent) {
    std::erase(recent, file);
    recent.insert(recent.begin(), file);
    if (recent.size() > kMostRecent) recent.resize(kMostRecent);
    return recent;
}

Memory::Memory(const fs::path& config_folder, const fs::path& state_folder)
    : preferences_file_(within_folder(config_folder, "preferences.json")),
      state_file_(within_folder(state_folder, "state.json")) {
    read_or_move_aside(preferences_file_, preferences, trouble_);
    read_or_move_aside(state_file_, state, trouble_);
    known_preferences_ = preferences;
    known_state_ = state;
    if (state_folder.empty()) return;
    start_ = StartMark(state_folder);
    if (!start_.was_left() || state.view == KeptView{}) return;
    state.view = {};
    trouble_ = "Dapple closed before it could draw with the last settings; these are the defaults";
}

void Memory::opened(const fs::path& file) {
    const fs::path whole = whole_path(file);
    opened_.push_back(whole);
    std::erase(forgotten_, whole);
    state.recent = with_recent(whole, std::move(state.recent));
    state.folder = {whole.parent_path()};
}

void Memory::forget(const fs::path& file) {
    std::erase(state.recent, file);
    std::erase(opened_, file);
    forgotten_.push_back(file);
}

void Memory::save() {
    save_changed(preferences_file_, preferences, known_preferences_, [&](Preferences& there) {
        take_changed(there.appearance, preferences.appearance, known_preferences_.appearance);
        take_changed(there.dialog, preferences.dialog, known_preferences_.dialog);
    });
    std::vector<fs::path> recent;
    const bool saved = save_changed(state_file_, state, known_state_, [&](WindowState& there) {
        take_changed(there.window, state.window, known_state_.window);
        take_changed(there.panels_shown, state.panels_shown, known_state_.panels_shown);
        take_changed(there.panel_width, state.panel_width, known_state_.panel_width);
        take_changed(there.folder, state.folder, known_state_.folder);
        take_changed(there.view, state.view, known_state_.view);
        for (const fs::path& file : forgotten_) std::erase(there.recent, file);
        for (const fs::path& file : opened_) there.recent = with_recent(file, std::move(there.recent));
        recent = there.recent;
    });
    if (!saved) return;
    opened_.clear();
    forgotten_.clear();
    known_state_.recent = state.recent = std::move(recent);
}

std::optional<std::string> Memory::take_trouble() {
    return std::exchange(trouble_, std::nullopt);
}

}  // namespace dapple
