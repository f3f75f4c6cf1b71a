#include "app/viewer/shell/file_dialog.h"

#include <algorithm>
#include <limits>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>

#include "app/viewer/panels/shortcuts.h"
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

bool begins(const FolderEntry& entry, const fs::path& typed) {
    return lower_case(entry.name).starts_with(lower_case(typed.filename().string()));
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

std::string completed(const fs::path& typed, const std::vector<FolderEntry>& entries) {
    std::optional<std::string> common;
    bool to_folder = false;
    for (const FolderEntry& entry : entries) {
        if (!typed.has_filename() || !begins(entry, typed)) continue;
        to_folder = !common && entry.folder;
        if (!common) common = entry.name;
        common->erase(std::ranges::mismatch(*common, entry.name).in1, common->end());
    }
    if (!common || common->size() < typed.filename().string().size()) return typed.string();
    return (typed.parent_path() / *common).string() + (to_folder ? "/" : "");
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

void FileDialog::ask_what_to_open(const OpenQuestion& question) {
    question_ = {.title = question.title, .start = question.start, .button = "Open"};
    endings_ = question.endings;
    show();
}

void FileDialog::ask_where_to_save(SaveQuestion question) {
    question_ = std::move(question);
    endings_.clear();
    for (const FileFormat& format : question_.formats) {
        endings_.emplace_back(format.ending);
        if (!format.others.empty()) endings_.emplace_back(format.others);
    }
    format_ = format_of(question_, question_.start).value_or(0);
    options_height_ = std::numeric_limits<float>::max();  // until they are drawn
    show();
    focus_path_ = !question_.begins_below;
}

void FileDialog::show() {
    open_ = focus_path_ = true;
    path_ends_ = false;
    std::error_code error;
    fs::path whole = fs::absolute(question_.start, error);
    if (error) whole = question_.start;
    typed_ = is_folder(whole) ? "" : whole.string();
    enter(is_folder(whole) ? whole : whole.parent_path());
}

void FileDialog::enter(const fs::path& folder) {
    folder_ = (folder / "").lexically_normal();
    typed_ = (saves() ? folder_ / fs::path(typed_).filename() : folder_).string();
    listed_.clear();
    read_typed();
}

void FileDialog::read_typed() {
    trouble_.clear();
    replaces_.clear();
    const fs::path there = (folder_ / typed_).parent_path();
    if (there == listed_) return;
    listed_ = there;
    entries_ = list_folder(listed_, endings_);
    entry_keys_.forget();
}

void FileDialog::type_on() {
    focus_path_ = path_ends_ = true;
}

bool FileDialog::matches(const FolderEntry& entry) const {
    return saves() || begins(entry, typed_);
}

std::optional<fs::path> FileDialog::accept(const fs::path& chosen, const std::string& refusal) {
    const fs::path asked = std::exchange(replaces_, {});
    trouble_.clear();
    fs::path path = folder_ / chosen;
    const auto match =
        std::ranges::find_if(entries_, [&](const FolderEntry& entry) { return matches(entry); });
    if (!saves() && !is_there(path) && match != entries_.end()) path = listed_ / match->name;
    const bool has_folder = is_folder(path.parent_path());
    if (is_folder(path)) {
        enter(path);
        return std::nullopt;
    }
    if (saves() && path.has_filename() && !path.has_extension()) path += question_.formats[format_].ending;
    if (!saves() && !is_there(path)) {
        trouble_ = "No such file.";
    } else if (!has_folder) {
        trouble_ = "No such folder.";
    } else if (saves() && !format_of(question_, path)) {
        trouble_ = has_formats() ? "Unknown file type; choose one above."
                                 : "The name must end in " + endings_.front() + ".";
    } else if (!refusal.empty()) {
        trouble_ = "Cannot be written; see the reason above.";
    } else if (const auto there = files_there(path); saves() && !there.empty() && path != asked) {
        replaces_ = path;
        trouble_ = printable(there.front().filename().native()) +
                   (there.size() == 1 ? " exists. Replace it?"
                                      : fmt::format(" and {} more exist. Replace them?", there.size() - 1));
    } else {
        return path;
    }
    return std::nullopt;
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

std::optional<fs::path> FileDialog::draw_entries(float height) {
    std::optional<fs::path> pressed;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    entry_keys_.begin("entries", low, {low.x + ImGui::GetContentRegionAvail().x, low.y + height});
    ImGui::BeginChild("entries", {0, height}, true);
    const auto draw_entry = [&](const FolderEntry& entry) {
        const std::string label =
            entry.name == ".." ? "Parent folder" : printable(entry.name) + (entry.folder ? "/" : "");
        if (entry.folder) push_title_font();
        const bool clicked = text_entry(label, entry_keys_.next_is_marked());
        if (entry.folder) pop_title_font();
        if (entry_keys_.end_entry(entry.name).press || clicked) pressed = listed_ / entry.name;
    };
    draw_entry({"..", true});
    for (const FolderEntry& entry : entries_)
        if (matches(entry)) draw_entry(entry);
    ImGui::EndChild();
    return pressed;
}

void FileDialog::draw_formats() {
    fs::path path = typed_;
    if (const auto by_name = format_of(question_, path)) format_ = *by_name;
    std::vector<const char*> names;
    for (const FileFormat& format : question_.formats) names.push_back(format.name);
    int chosen = static_cast<int>(format_);
    if (!segmented_row("Format", chosen, names, "File type; the name's ending follows.")) return;
    format_ = static_cast<std::size_t>(chosen);
    if (path.filename().empty()) path /= "drawing";
    typed_ = path.replace_extension(question_.formats[format_].ending).string();
    read_typed();
}

std::string FileDialog::draw_options(const DrawOptions& options, float height) {
    const float top = ImGui::GetCursorPosY();
    ImGuiStorage* const storage = ImGui::GetStateStorage();
    ImGui::BeginChild("options", {0, height});
    ImGui::SetStateStorage(storage);  // Tab walks its rows as the dialog's
    const float begin = ImGui::GetCursorPosY();
    std::string refusal = options(format_);
    options_height_ = ImGui::GetCursorPosY() - begin;
    ImGui::EndChild();
    ImGui::SetCursorPosY(top + height);
    return refusal;
}

bool FileDialog::draw_buttons(const std::string& refusal, bool escape) {
    const bool asks = !replaces_.empty();
    bool accepted = false;
    {
        const Greyed greyed(refusal.empty() ? nullptr : refusal.c_str());
        ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
        accepted = key_button(asks ? "Replace" : question_.button);
        ImGui::PopStyleColor();
        note_place(asks ? "Replace" : "Accept");
    }
    ImGui::SameLine();
    if (key_button("Cancel") || escape) {
        open_ = asks;
        if (asks) read_typed(), type_on();
    }
    note_place("Cancel");
    if (trouble_.empty()) return accepted;
    ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_Text, colour_of(ThemeColour::warning));
    ImGui::TextUnformatted(printable(trouble_).c_str());
    ImGui::PopStyleColor();
    note_place("Trouble");
    tip(printable(trouble_).c_str());
    return accepted;
}

bool FileDialog::draw_path() {
    const ImGuiIO& io = ImGui::GetIO();
    const bool tab =
        path_has_keys_ && io.WantTextInput && key_pressed(Key::tab) && !io.KeyShift && !io.KeyCtrl;
    const std::string before = typed_;
    if (tab) typed_ = completed(typed_, entries_);
    const bool completes = typed_ != before;
    if (completes) path_ends_ = true;
    // Under another name the field is another one: the one that has the keyboard loses it.
    ImGui::PushID(path_turn_);
    ImGui::SetNextItemWidth(-1);
    if (std::exchange(focus_path_, false)) ImGui::SetKeyboardFocusHere();
    // ImGui has a copy of its own while it is typed in.
    const auto fill_in = [](ImGuiInputTextCallbackData* data) {
        FileDialog& dialog = *static_cast<FileDialog*>(data->UserData);
        if (!std::exchange(dialog.path_ends_, false)) return 0;
        data->DeleteChars(0, data->BufTextLen);
        data->InsertChars(0, editable(dialog.typed_).c_str());
        data->ClearSelection();
        return 0;
    };
    bool entered =
        bytes_box("##path", typed_, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackAlways,
                  fill_in, this);
    const bool typing = ImGui::IsItemActive(), activated = ImGui::IsItemActivated();
    ImGui::PopID();
    note_place("Path");
    if (typed_ != before) read_typed();
    if (completes) return false;  // that Tab goes to no other row
    path_has_keys_ = item_keys("path", typing).focused;
    if (typing && !path_has_keys_) ++path_turn_;
    // Enter also counts where the field has no keyboard: not yet, in the first frames, or no longer.
    const bool others_have_keys = !path_has_keys_ && a_row_has_keys();
    if (!others_have_keys && (activated || !ImGui::IsAnyItemActive())) entered = entered || enter_pressed();
    if (path_has_keys_ && !typing && !entered) type_on();  // walked to
    return entered;
}

std::optional<fs::path> FileDialog::draw(const DrawOptions& options) {
    if (!open_) return std::nullopt;
    const bool has_options = options && question_.has_options;
    const float unit = ImGui::GetTextLineHeight() / 15;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float height = has_options ? 800 : 400;  // with room for all options
    ImGui::SetNextWindowSize(
        {std::clamp(screen.x - 20, 1.0f, 660 * unit), std::clamp(screen.y - 20, 1.0f, height * unit)});
    // Tab walks its rows: ImGui is not to walk its text fields.
    if (!begin_dialog(question_.title.c_str(), open_, ImGuiWindowFlags_NoNavInputs)) return std::nullopt;

    // What is open above it has the keys first.
    const bool has_keys = !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId);
    const bool typing = ImGui::GetIO().WantTextInput;
    const bool opens = ImGui::IsWindowAppearing();  // by an Enter, perhaps, which then accepts nothing
    const bool entered = draw_path() && has_keys && !opens;
    // Escape first ends what is typed elsewhere.
    const bool escape = has_keys && escape_pressed() && (!typing || path_has_keys_);

    // In a low window the options scroll, so that some entries are left to be seen.
    const float row = ImGui::GetFrameHeightWithSpacing();
    const float room = ImGui::GetContentRegionAvail().y - (has_formats() ? 2 : 1) * row;
    const float room_for_options =
        has_options ? std::min(options_height_, std::max(room - 5 * row, 2 * row)) : 0;
    const std::optional<fs::path> pressed = draw_entries(std::max(room - room_for_options, 1.0f));
    if (has_formats()) draw_formats();
    const std::string refusal = has_options ? draw_options(options, room_for_options) : "";
    const bool accepted = draw_buttons(refusal, escape) || entered;

    std::optional<fs::path> chosen;
    if (pressed && saves() && !is_folder(*pressed)) {
        typed_ = pressed->string();
        read_typed();
        type_on();
    } else if (open_ && (pressed || accepted)) {
        chosen = accept(pressed ? *pressed : fs::path(typed_), refusal);
        // Typing goes on where it was wrong, or in the folder that was typed.
        if (!chosen && accepted) type_on();
    }
    if (chosen) open_ = false;
    if (!open_) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return chosen;
}

}  // namespace dapple
