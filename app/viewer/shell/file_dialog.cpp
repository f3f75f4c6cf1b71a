#include "app/viewer/shell/file_dialog.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "app/files/file_ending.h"
#include "app/shown_text.h"
#include "app/viewer/panels/shortcuts.h"
#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/theme.h"
#include "app/viewer/widgets/widgets.h"

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

// ".svg, .png or .csv"
std::string listed(const std::vector<std::string>& endings) {
    std::string text;
    for (std::size_t i = 0; i < endings.size(); ++i)
        text += (i == 0 ? "" : i + 1 < endings.size() ? ", " : " or ") + endings[i];
    return text;
}

}  // namespace

std::vector<FolderEntry> list_folder(const fs::path& folder, const std::vector<std::string>& extensions) {
    std::vector<FolderEntry> entries;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        std::string name = entry->path().filename().string();
        if (name.starts_with('.')) continue;
        bool is_dir = is_folder(entry->path());
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

void FileDialog::ask_what_to_open(OpenQuestion question) {
    saves_ = false;
    open_question_ = std::move(question);
    show(open_question_.start);
}

void FileDialog::ask_where_to_save(SaveQuestion question) {
    saves_ = true;
    question_ = std::move(question);
    format_ = format_of(question_.start).value_or(0);
    show(question_.start);
}

void FileDialog::show(const fs::path& start) {
    open_ = just_opened_ = true;
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

std::optional<std::size_t> FileDialog::format_of(const fs::path& path) const {
    const std::string ending = ending_of(path);
    const auto is_its = [&](const FileFormat& format) {
        return !ending.empty() && (ending == format.ending || ending == format.others);
    };
    const auto found = std::ranges::find_if(question_.formats, is_its);
    if (found == question_.formats.end()) return std::nullopt;
    return static_cast<std::size_t>(found - question_.formats.begin());
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
    trouble_.clear();
    replaces_.clear();
}

std::optional<fs::path> FileDialog::accept(const fs::path& chosen) {
    trouble_.clear();
    replaces_.clear();
    if (is_folder(chosen)) {
        enter(chosen);
        return std::nullopt;
    }
    const fs::path path = with_ending(chosen);
    if (!saves_) {
        if (is_there(path)) return path;
        trouble_ = "There is no such file.";
    } else if (!is_folder(path.parent_path())) {
        trouble_ = "There is no such folder.";
    } else if (!format_of(path)) {
        trouble_ = "The name must end in " + listed(endings()) + ".";
    } else if (is_folder(path)) {
        trouble_ = "That is a folder.";
    } else if (is_there(path) && path != question_.own_file) {
        replaces_ = path;
    } else {
        return path;
    }
    return std::nullopt;
}

std::optional<fs::path> FileDialog::draw_entries() {
    std::optional<fs::path> chosen;
    const int rows = 2 + (saves_ ? question_.option_rows : 0);
    const float below =
        ImGui::GetFrameHeightWithSpacing() * static_cast<float>(rows) + ImGui::GetTextLineHeightWithSpacing();
    ImGui::BeginChild("entries", {0, -below}, true);
    fs::path walk_to;
    if (folder_.has_parent_path() && folder_ != folder_.root_path())
        if (ImGui::Selectable("..  (up)")) {
            fs::path here = folder_.has_filename() ? folder_ : folder_.parent_path();
            walk_to = here.parent_path();
        }
    for (const FolderEntry& entry : entries_) {
        std::string label = printable(entry.name) + (entry.folder ? "/" : "");
        bool is_typed = fs::path(typed_) == folder_ / entry.name;
        if (entry.folder) push_title_font();
        bool clicked = ImGui::Selectable(label.c_str(), is_typed, ImGuiSelectableFlags_AllowDoubleClick);
        if (entry.folder) pop_title_font();
        note_place(label.c_str());
        if (!clicked) continue;
        if (entry.folder) {
            walk_to = folder_ / entry.name;
        } else {
            typed_ = (folder_ / entry.name).string();
            trouble_.clear();
            replaces_.clear();
            if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) chosen = accept(typed_);
        }
    }
    ImGui::EndChild();
    if (!walk_to.empty()) enter(walk_to);
    return chosen;
}

void FileDialog::draw_formats() {
    fs::path path = typed_;
    if (const auto by_name = format_of(path)) format_ = *by_name;
    std::vector<const char*> names;
    for (const FileFormat& format : question_.formats) names.push_back(format.name);
    int chosen = static_cast<int>(format_);
    if (!segmented_row("Format", chosen, names)) return;
    format_ = static_cast<std::size_t>(chosen);
    if (path.filename().empty()) path /= "drawing";
    typed_ = path.replace_extension(question_.formats[format_].ending).string();
    trouble_.clear();
    replaces_.clear();
}

std::optional<fs::path> FileDialog::draw_buttons() {
    const float unit = ImGui::GetTextLineHeight() / 15, button = 110 * unit;
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, colour_of(ThemeColour::warning));
    ImGui::TextUnformatted(printable(trouble_).c_str());
    ImGui::PopStyleColor();
    ImGui::SameLine(ImGui::GetWindowWidth() - 2 * button - ImGui::GetStyle().ItemSpacing.x -
                    ImGui::GetStyle().WindowPadding.x);
    if (ImGui::Button("Cancel", {button, 0}) || escape_pressed()) open_ = false;
    note_place("Cancel");
    ImGui::SameLine();
    const bool accepted = ImGui::Button(saves_ ? question_.button : "Open", {button, 0});
    note_place("Accept");
    return accepted ? accept(typed_) : std::nullopt;
}

std::optional<fs::path> FileDialog::draw_replace_question() {
    const float unit = ImGui::GetTextLineHeight() / 15, button = 110 * unit;
    const float buttons = ImGui::GetWindowWidth() - 2 * button - ImGui::GetStyle().ItemSpacing.x -
                          ImGui::GetStyle().WindowPadding.x;
    const std::string question = printable(replaces_.filename().native()) + " exists. Replace it?";
    const ImVec2 start = ImGui::GetCursorScreenPos();
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, colour_of(ThemeColour::warning));
    ImGui::PushClipRect(
        start, {start.x + buttons - 2 * ImGui::GetStyle().WindowPadding.x, start.y + ImGui::GetFrameHeight()},
        true);
    ImGui::TextUnformatted(question.c_str());
    ImGui::PopClipRect();
    ImGui::PopStyleColor();
    ImGui::SameLine(buttons);
    const bool kept = ImGui::Button("Keep", {button, 0}) || escape_pressed();
    note_place("Keep");
    ImGui::SameLine();
    const bool replaced = ImGui::Button("Replace", {button, 0}) || enter_pressed();
    note_place("Replace");
    fs::path path = replaces_;
    if (kept || replaced) replaces_.clear();
    return replaced && !kept ? std::optional(path) : std::nullopt;
}

std::optional<fs::path> FileDialog::draw(const DrawOptions& options) {
    if (!open_) return std::nullopt;
    const char* title = saves_ ? question_.title : open_question_.title;
    if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    float unit = ImGui::GetTextLineHeight() / 15;
    ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize(
        {std::clamp(screen.x - 20, 1.0f, 660 * unit), std::clamp(screen.y - 20, 1.0f, 560 * unit)});
    if (!ImGui::BeginPopupModal(title, &open_, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize))
        return std::nullopt;

    std::optional<fs::path> chosen;
    // Who was asked whether to replace answers first; nothing that is pressed now is another choice.
    const bool asked = !replaces_.empty();
    ImGui::SetNextItemWidth(-1);
    if (just_opened_) ImGui::SetKeyboardFocusHere();
    just_opened_ = false;
    const std::string before = typed_;
    // Enter also counts where the field has no focus: not yet, in the first frames, or no longer.
    bool entered = ImGui::InputText("##path", &typed_, ImGuiInputTextFlags_EnterReturnsTrue);
    if (ImGui::IsItemActivated() || !ImGui::IsAnyItemActive()) entered = entered || enter_pressed();
    note_place("Path");
    if (typed_ != before) replaces_.clear();
    if (entered && !asked) chosen = accept(typed_);
    if (auto entry = draw_entries()) chosen = entry;
    if (saves_ && question_.formats.size() > 1) {
        draw_formats();
        const float top = ImGui::GetCursorPosY();
        if (options) options(format_);
        ImGui::SetCursorPosY(top +
                             ImGui::GetFrameHeightWithSpacing() * static_cast<float>(question_.option_rows));
    } else {
        ImGui::Dummy({0, ImGui::GetFrameHeight()});
    }
    if (asked && !replaces_.empty())
        chosen = draw_replace_question();
    else if (auto accepted = draw_buttons())
        chosen = accepted;
    if (chosen) open_ = false;
    if (!open_) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return chosen;
}

}  // namespace dapple
