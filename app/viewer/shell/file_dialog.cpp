#include "app/viewer/shell/file_dialog.h"

#include <algorithm>
#include <limits>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>

#include "app/viewer/panels/shortcuts.h"
#include "app/viewer/widgets/dialog.h"
#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/picture_entry.h"
#include "app/viewer/widgets/row.h"
#include "app/viewer/widgets/theme.h"
#include "app/viewer/widgets/widgets.h"
#include "core/text/shown_text.h"
#include "io/files/text_file.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

bool is_folder(const fs::path& path) {
    std::error_code ignored;
    return fs::is_directory(path, ignored);
}

bool is_there(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(path, ignored);
}

bool enter_pressed() {
    return key_pressed(Key::enter) || key_pressed(Key::keypad_enter);
}

// Without the slash at the end that folder_ may have.
fs::path plain_folder(const fs::path& folder) {
    return folder.has_filename() || folder == folder.root_path() ? folder : folder.parent_path();
}

float button_width() {
    return 110 * ImGui::GetTextLineHeight() / 15;
}

// Where two buttons at the right end of a row begin.
float place_of_buttons() {
    const ImGuiStyle& style = ImGui::GetStyle();
    return ImGui::GetWindowWidth() - 2 * button_width() - style.ItemSpacing.x - style.WindowPadding.x;
}

// A warning at the row's left, which ends before the buttons at its right; the cursor then is where they
// begin.
void warning_before(float buttons, const std::string& words) {
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float air = 2 * ImGui::GetStyle().WindowPadding.x;
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, colour_of(ThemeColour::warning));
    ImGui::PushClipRect(start, {start.x + std::max(buttons - air, 1.0f), start.y + ImGui::GetFrameHeight()},
                        true);
    ImGui::TextUnformatted(words.c_str());
    ImGui::PopClipRect();
    ImGui::PopStyleColor();
    if (!words.empty()) {
        tip(words.c_str());
        note_place("Trouble");
    }
    ImGui::SameLine(buttons);
}

}  // namespace

std::vector<FolderEntry> list_folder(const fs::path& folder, const std::vector<std::string>& extensions) {
    std::vector<FolderEntry> entries;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        std::string name = entry->path().filename().string();
        if (name.starts_with('.')) continue;
        // As the folder says, where it does: asking for each file takes long over a network.
        std::error_code ignored;
        const bool is_dir = entry->is_directory(ignored);
        auto wanted = std::ranges::find(extensions, ending_of(entry->path()));
        if (is_dir || extensions.empty() || wanted != extensions.end()) entries.push_back({name, is_dir});
    }
    std::ranges::sort(entries, [](const FolderEntry& a, const FolderEntry& b) {
        if (a.folder != b.folder) return a.folder;
        std::string la = lower_case(a.name), lb = lower_case(b.name);
        return la != lb ? la < lb : a.name < b.name;
    });
    return entries;
}

std::string completed(const std::string& typed, const fs::path& folder,
                      const std::vector<std::string>& extensions) {
    const fs::path path(typed), there = (folder / path).parent_path();
    const std::string begun = lower_case(path.filename().string());
    if (begun.empty()) return typed;
    std::optional<std::string> common;
    bool to_folder = false;
    for (const FolderEntry& entry : list_folder(there, extensions)) {
        if (!lower_case(entry.name).starts_with(begun)) continue;
        to_folder = !common && entry.folder;
        if (!common) common = entry.name;
        const auto end = std::ranges::mismatch(*common, entry.name).in1;
        common->erase(end, common->end());
    }
    if (!common || common->size() < begun.size()) return typed;
    return (path.parent_path() / *common).string() + (to_folder ? "/" : "");
}

void FileDialog::ask_what_to_open(OpenQuestion question) {
    saves_ = false;
    open_question_ = std::move(question);
    show(open_question_.start);
}

void FileDialog::ask_where_to_save(SaveQuestion question) {
    saves_ = true;
    question_ = std::move(question);
    format_ = format_of(question_, question_.start).value_or(0);
    options_height_ =
        std::numeric_limits<float>::max();  // until they are drawn: what is below is in the window
    show(question_.start);
    focus_path_ = !question_.begins_below;
}

void FileDialog::show(const fs::path& start) {
    open_ = focus_path_ = true;
    path_ends_ = false;
    std::error_code error;
    fs::path whole = fs::absolute(start, error);
    if (error) whole = start;
    enter(is_folder(whole) ? whole : whole.parent_path());
    if (saves_ && !is_folder(whole)) typed_ = whole.string();
}

std::vector<std::string> FileDialog::endings() const {
    if (!saves_) return open_question_.endings;
    std::vector<std::string> endings;
    for (const FileFormat& format : question_.formats) {
        endings.emplace_back(format.ending);
        if (!format.others.empty()) endings.emplace_back(format.others);
    }
    return endings;
}

std::optional<std::size_t> format_of(const SaveQuestion& question, const fs::path& file) {
    const std::string ending = ending_of(file);
    const auto is_its = [&](const FileFormat& format) {
        return !ending.empty() && (ending == format.ending || ending == format.others);
    };
    const auto found = std::ranges::find_if(question.formats, is_its);
    if (found == question.formats.end()) return std::nullopt;
    return static_cast<std::size_t>(found - question.formats.begin());
}

fs::path FileDialog::with_ending(const fs::path& path) const {
    const bool named = path.has_filename() && !path.has_extension();
    return saves_ && named ? fs::path(path).concat(question_.formats[format_].ending) : path;
}

void FileDialog::enter(const fs::path& folder) {
    folder_ = folder.lexically_normal();
    entries_ = list_folder(folder_, endings());
    fs::path name = fs::path(typed_).filename();
    bool keeps_name = saves_ && !name.empty();
    typed_ = (keeps_name ? folder_ / name : folder_ / "").string();
    filter_.clear();
    trouble_.clear();
    replaces_.clear();
    entry_keys_.forget();
}

void FileDialog::take_name(const fs::path& file) {
    typed_ = file.string();
    filter_.clear();
    trouble_.clear();
    replaces_.clear();
}

// Of another folder than the one that is listed, perhaps.
void FileDialog::follow_typed() {
    const fs::path path(typed_), there = path.parent_path();
    if (path.is_absolute() && there != plain_folder(folder_) && is_folder(there)) {
        folder_ = there / "";
        entries_ = list_folder(folder_, endings());
        entry_keys_.forget();
    }
    filter_ = saves_ ? "" : lower_case(path.filename().string());
    jumps_ = true;
    trouble_.clear();
    replaces_.clear();
}

std::optional<fs::path> FileDialog::accept(const fs::path& chosen, const std::string& refusal) {
    trouble_.clear();
    replaces_.clear();
    const fs::path named = folder_ / chosen;  // a name alone is one of the folder's
    const FolderEntry* const begun = is_there(named) ? nullptr : entry_begun();
    const fs::path path = with_ending(begun ? folder_ / begun->name : named);
    if (is_folder(path)) {
        enter(path);
        return std::nullopt;
    }
    if (!saves_) {
        if (is_there(path)) return path;
        trouble_ = "There is no such file.";
    } else if (!is_folder(path.parent_path())) {
        trouble_ = "There is no such folder.";
    } else if (!format_of(question_, path)) {
        trouble_ = has_formats() ? "No format has that ending; choose one above."
                                 : "The name must end in " + endings().front() + ".";
    } else if (is_folder(path)) {
        trouble_ = "That is a folder.";
    } else if (!refusal.empty()) {
        trouble_ = "That cannot be written; the reason is shown above.";
    } else if (replaced_ = files_there(path); !replaced_.empty()) {
        replaces_ = path;
    } else {
        return path;
    }
    return std::nullopt;
}

const FolderEntry* FileDialog::entry_begun() const {
    const fs::path typed = folder_ / typed_;
    const std::string begin = lower_case(typed.filename().string());
    if (saves_ || begin.empty() || typed.parent_path() != plain_folder(folder_)) return nullptr;
    const auto found = std::ranges::find_if(
        entries_, [&](const FolderEntry& entry) { return lower_case(entry.name).starts_with(begin); });
    return found == entries_.end() ? nullptr : &*found;
}

std::vector<fs::path> FileDialog::files_there(const fs::path& name) const {
    std::vector<fs::path> files = question_.files ? question_.files(name) : std::vector{name};
    const auto is_own = [&](const fs::path& file) {
        const auto& own = question_.own_files;
        if (name != question_.own_file) return false;
        return own.empty() ? file == name : std::ranges::find(own, file) != own.end();
    };
    std::erase_if(files, [&](const fs::path& file) { return !is_there(file) || is_own(file); });
    return files;
}

fs::path FileDialog::draw_folders(const std::vector<fs::path>& folders) {
    fs::path walk_to;
    ImGui::PushID(&folders);
    for (const fs::path& place : folders) {
        const std::string name = printable(place.filename().native());
        ImGui::PushID(place.c_str());
        const bool chosen = place == plain_folder(folder_) || place_keys_.next_is_marked();
        if (text_entry(name, chosen)) walk_to = place;
        if (place_keys_.end_entry(name).press) walk_to = place;
        ImGui::PopID();
        note_place(("Place " + name).c_str());
        tip(printable(place.native()).c_str());
    }
    ImGui::PopID();
    return walk_to;
}

// Folders to go to, and files to open at once.
FileDialog::Wanted FileDialog::draw_places() {
    Wanted chosen;
    fs::path walk_to = draw_folders(open_question_.places);
    int id = 0;
    if (!open_question_.recent.empty()) hint("Opened before");
    for (const fs::path& file : open_question_.recent) {
        const std::string name = printable(file.filename().native());
        ImGui::PushID(id++);
        if (text_entry(name, place_keys_.next_is_marked())) chosen = file;
        if (place_keys_.end_entry(name).press) chosen = file;
        ImGui::PopID();
        note_place(("Recent " + name).c_str());
        tip(printable(file.native()).c_str());
    }
    if (!walk_to.empty()) enter(walk_to);
    return chosen;
}

FileDialog::Wanted FileDialog::draw_lists() {
    Wanted chosen;
    // The buttons, and above them what is chosen of a file to save.
    const float rows = has_formats() ? 2 : 1;
    const float below = ImGui::GetFrameHeightWithSpacing() * rows +
                        (has_formats() && question_.has_options ? options_room() : 0);
    const float height = std::max(ImGui::GetContentRegionAvail().y - below, 1.0f);
    const auto begin_list = [&](const char* name, ListKeys& keys, float width) {
        const ImVec2 low = ImGui::GetCursorScreenPos();
        keys.begin(name, low, {low.x + width, low.y + height});
        ImGui::BeginChild(name, {width, height}, true);
    };
    const bool has_places = !open_question_.places.empty() || !open_question_.recent.empty();
    if (!saves_ && has_places) {
        begin_list("places", place_keys_, 190 * ImGui::GetTextLineHeight() / 15);
        chosen = draw_places();
        ImGui::EndChild();
        ImGui::SameLine();
    }
    begin_list("entries", entry_keys_, ImGui::GetContentRegionAvail().x);
    if (auto entry = draw_entries()) chosen = entry;
    ImGui::EndChild();
    return chosen;
}

FileDialog::Wanted FileDialog::draw_entries() {
    Wanted chosen;
    fs::path walk_to;
    if (folder_.has_parent_path() && folder_ != folder_.root_path()) {
        const bool clicked = text_entry("..  (up)", entry_keys_.next_is_marked());
        if (entry_keys_.end_entry().press || clicked) {
            fs::path here = folder_.has_filename() ? folder_ : folder_.parent_path();
            walk_to = here.parent_path();
        }
    }
    const FolderEntry* const begun = entry_begun();
    const bool jumps = std::exchange(jumps_, false);
    bool any = false;
    for (const FolderEntry& entry : entries_) {
        if (lower_case(entry.name).find(filter_) == std::string::npos) continue;
        any = true;
        const fs::path path = folder_ / entry.name;
        if (&entry == begun && jumps) ImGui::SetScrollHereY();
        const std::string label = printable(entry.name) + (entry.folder ? "/" : "");
        const bool is_chosen = &entry == begun || folder_ / typed_ == path || entry_keys_.next_is_marked();
        if (entry.folder) push_title_font();
        const bool clicked = text_entry(label, is_chosen, ImGuiSelectableFlags_AllowDoubleClick);
        if (entry.folder) pop_title_font();
        const RowKeys keys = entry_keys_.end_entry(entry.name);
        if (!clicked && !keys.press) continue;
        if (entry.folder) {
            walk_to = path;
        } else {
            take_name(path);
            if (keys.enter || (clicked && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))) chosen = path;
        }
    }
    if (!any && !filter_.empty()) hint("No file or folder here has these letters.");
    if (!walk_to.empty()) enter(walk_to);
    return chosen;
}

bool FileDialog::has_formats() const {
    return saves_ && question_.formats.size() > 1;
}

void FileDialog::draw_formats() {
    fs::path path = typed_;
    if (const auto by_name = format_of(question_, path)) format_ = *by_name;
    std::vector<const char*> names;
    for (const FileFormat& format : question_.formats) names.push_back(format.name);
    int chosen = static_cast<int>(format_);
    if (!segmented_row("Format", chosen, names, "What kind of file is written; its name ends accordingly."))
        return;
    format_ = static_cast<std::size_t>(chosen);
    if (path.filename().empty()) path /= "drawing";
    take_name(path.replace_extension(question_.formats[format_].ending));
}

float FileDialog::options_room() const {
    // Title, path, four of the folder's entries, formats, buttons.
    constexpr float kOtherRows = 9;
    const float row = ImGui::GetFrameHeightWithSpacing();
    return std::min(options_height_, std::max(ImGui::GetWindowHeight() - kOtherRows * row, 2 * row));
}

std::string FileDialog::draw_options(const DrawOptions& options) {
    const float room = options_room(), top = ImGui::GetCursorPosY();
    ImGuiStorage* const storage = ImGui::GetStateStorage();
    // Whether they scroll or not, so that a row stays the same one when what is said above it grows.
    ImGui::BeginChild("options", {0, room});
    ImGui::SetStateStorage(storage);  // Tab walks its rows as the dialog's
    const float begin = ImGui::GetCursorPosY();
    std::string refusal = options(format_);
    options_height_ = ImGui::GetCursorPosY() - begin;
    ImGui::EndChild();
    ImGui::SetCursorPosY(top + room);
    return refusal;
}

FileDialog::Wanted FileDialog::draw_buttons(const std::string& refusal, bool escape) {
    const float button = button_width();
    warning_before(place_of_buttons(), printable(trouble_));
    if (key_button("Cancel", {button, 0}) || escape) open_ = false;
    note_place("Cancel");
    ImGui::SameLine();
    const Greyed greyed(refusal.empty() ? nullptr : refusal.c_str());
    const bool accepted = key_button(saves_ ? question_.button : "Open", {button, 0});
    note_place("Accept");
    return accepted ? Wanted(typed_) : std::nullopt;
}

std::optional<fs::path> FileDialog::draw_replace_question(bool enter, bool escape) {
    const float button = button_width();
    std::string question = printable(replaced_.front().filename().native());
    question += replaced_.size() == 1
                    ? " exists. Replace it?"
                    : fmt::format(" and {} more exist. Replace them?", replaced_.size() - 1);
    warning_before(place_of_buttons(), question);
    const bool kept = key_button("Keep", {button, 0}) || escape;
    note_place("Keep");
    ImGui::SameLine();
    const bool replaced = key_button("Replace", {button, 0}) || enter;
    note_place("Replace");
    fs::path path = replaces_;
    if (kept || replaced) replaces_.clear();
    return replaced && !kept ? std::optional(path) : std::nullopt;
}

bool FileDialog::draw_path() {
    // Under another name the field is another one: the one that has the keyboard loses it.
    ImGui::PushID(path_turn_);
    ImGui::SetNextItemWidth(-1);
    if (std::exchange(focus_path_, false)) ImGui::SetKeyboardFocusHere();
    const std::string before = typed_;
    const ImGuiIO& io = ImGui::GetIO();
    const bool tab =
        path_has_keys_ && io.WantTextInput && key_pressed(Key::tab) && !io.KeyShift && !io.KeyCtrl;
    const std::string whole = tab ? completed(typed_, folder_, endings()) : typed_;
    const bool completes = whole != typed_;
    // ImGui has a copy of its own while it is typed in.
    struct Edit {
        bool &ends, completes;
        const std::string& whole;
    } edit{path_ends_, completes, whole};
    const auto follow = [](ImGuiInputTextCallbackData* data) {
        Edit& wanted = *static_cast<Edit*>(data->UserData);
        if (wanted.completes) {
            data->DeleteChars(0, data->BufTextLen);
            data->InsertChars(0, editable(wanted.whole).c_str());
        }
        if (std::exchange(wanted.ends, false) || std::exchange(wanted.completes, false)) {
            data->ClearSelection();
            data->CursorPos = data->BufTextLen;
        }
        return 0;
    };
    bool entered =
        bytes_box("##path", typed_, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackAlways,
                  follow, &edit);
    const bool typing = ImGui::IsItemActive(), activated = ImGui::IsItemActivated();
    ImGui::PopID();
    note_place("Path");
    if (typed_ != before) follow_typed();
    if (completes) return false;  // that Tab goes to no other row
    path_has_keys_ = item_keys("path", typing).focused;
    if (typing && !path_has_keys_) ++path_turn_;
    // Enter also counts where the field has no keyboard: not yet, in the first frames, or no longer.
    const bool others_have_keys = !path_has_keys_ && a_row_has_keys();
    if (!others_have_keys && (activated || !ImGui::IsAnyItemActive())) entered = entered || enter_pressed();
    // Walked to, it is typed into.
    if (path_has_keys_ && !typing && !entered && replaces_.empty()) focus_path_ = path_ends_ = true;
    return entered;
}

std::optional<fs::path> FileDialog::draw(const DrawOptions& options) {
    if (!open_) return std::nullopt;
    const char* title = saves_ ? question_.title : open_question_.title;
    float unit = ImGui::GetTextLineHeight() / 15;
    ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float height = has_formats() && question_.has_options ? 800 : 560;  // with room for all options
    ImGui::SetNextWindowSize(
        {std::clamp(screen.x - 20, 1.0f, 660 * unit), std::clamp(screen.y - 20, 1.0f, height * unit)});
    // Tab walks its rows: ImGui is not to walk its text fields.
    if (!begin_dialog(title, open_, ImGuiWindowFlags_NoNavInputs)) return std::nullopt;

    // What is open above it has the keys first.
    const bool has_keys = !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId);
    const bool typing = ImGui::GetIO().WantTextInput;
    // Who was asked whether to replace answers first; nothing that is pressed now is another choice.
    const bool asked = !replaces_.empty();
    const bool opens = ImGui::IsWindowAppearing();  // by an Enter, perhaps, which then accepts nothing
    const bool entered = draw_path() && has_keys && !opens;
    // Escape first ends what is typed elsewhere.
    const bool escape = has_keys && escape_pressed() && (!typing || path_has_keys_);
    Wanted wanted = draw_lists();
    if (entered && !asked) wanted = typed_;
    std::string refusal;
    if (has_formats()) {
        draw_formats();
        if (options && question_.has_options) refusal = draw_options(options);
    }
    std::optional<fs::path> chosen;
    if (asked && !replaces_.empty()) {
        chosen = draw_replace_question(entered, escape);
        if (!chosen && replaces_.empty()) focus_path_ = path_ends_ = true;  // for another name
    } else if (auto accepted = draw_buttons(refusal, escape)) {
        wanted = accepted;
    }
    if (wanted) {
        chosen = accept(*wanted, refusal);
        // Typing goes on where it was wrong, or in the folder that was typed.
        if (!trouble_.empty() || entered) focus_path_ = path_ends_ = !chosen && replaces_.empty();
    }
    if (chosen) open_ = false;
    if (!open_) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return chosen;
}

}  // namespace dapple
