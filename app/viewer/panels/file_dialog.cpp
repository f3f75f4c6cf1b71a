#include "app/viewer/panels/file_dialog.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <system_error>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "app/viewer/shortcuts.h"
#include "app/viewer/theme.h"
#include "app/viewer/widgets.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

constexpr std::array kFormats{".svg", ".png", ".csv"};
constexpr std::array kFormatNames{"SVG", "PNG", "CSV"};

std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

std::vector<std::string> extensions_for(FileDialog::Purpose purpose) {
    if (purpose == FileDialog::Purpose::save_drawing) return {kFormats.begin(), kFormats.end()};
    return {".png", ".jpg", ".jpeg", ".tif", ".tiff", ".exr",  ".hdr", ".webp", ".gif", ".bmp", ".tga",
            ".psd", ".ppm", ".pgm",  ".pnm", ".jp2",  ".heic", ".dpx", ".fits", ".ico", ".pic"};
}

bool is_folder(const fs::path& path) {
    std::error_code ignored;
    return fs::is_directory(path, ignored);
}

bool is_there(const fs::path& path) {
    std::error_code ignored;
    return fs::exists(path, ignored);
}

}  // namespace

std::vector<FolderEntry> list_folder(const fs::path& folder, const std::vector<std::string>& extensions) {
    std::vector<FolderEntry> entries;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        std::string name = entry->path().filename().string();
        if (name.starts_with('.')) continue;
        bool is_dir = is_folder(entry->path());
        auto wanted = std::ranges::find(extensions, lower(entry->path().extension().string()));
        if (is_dir || extensions.empty() || wanted != extensions.end()) entries.push_back({name, is_dir});
    }
    std::ranges::sort(entries, [](const FolderEntry& a, const FolderEntry& b) {
        if (a.folder != b.folder) return a.folder;
        std::string la = lower(a.name), lb = lower(b.name);
        return la != lb ? la < lb : a.name < b.name;
    });
    return entries;
}

void FileDialog::show(Purpose purpose, const fs::path& start) {
    purpose_ = purpose;
    open_ = just_opened_ = true;
    std::error_code error;
    fs::path whole = fs::absolute(start, error);
    if (error) whole = start;
    enter(is_folder(whole) ? whole : whole.parent_path());
    if (purpose == Purpose::save_drawing && !is_folder(whole)) typed_ = whole.string();
}

void FileDialog::enter(const fs::path& folder) {
    folder_ = folder.lexically_normal();
    entries_ = list_folder(folder_, extensions_for(purpose_));
    fs::path name = fs::path(typed_).filename();
    bool keeps_name = purpose_ == Purpose::save_drawing && !name.empty();
    typed_ = (keeps_name ? folder_ / name : folder_ / "").string();
    trouble_.clear();
}

std::optional<fs::path> FileDialog::accept(const fs::path& path) {
    trouble_.clear();
    if (is_folder(path)) {
        enter(path);
        return std::nullopt;
    }
    if (purpose_ == Purpose::open_picture) {
        if (!is_there(path)) {
            trouble_ = "There is no such file.";
            return std::nullopt;
        }
    } else if (!is_folder(path.parent_path())) {
        trouble_ = "There is no such folder.";
        return std::nullopt;
    } else if (std::ranges::find(kFormats, lower(path.extension().string())) == kFormats.end()) {
        trouble_ = "The name must end in .svg, .png or .csv.";
        return std::nullopt;
    }
    return path;
}

std::optional<fs::path> FileDialog::draw_entries() {
    std::optional<fs::path> chosen;
    float below = ImGui::GetFrameHeightWithSpacing() * 2 + ImGui::GetTextLineHeightWithSpacing();
    ImGui::BeginChild("entries", {0, -below}, true);
    fs::path walk_to;
    if (folder_.has_parent_path() && folder_ != folder_.root_path())
        if (ImGui::Selectable("..  (up)")) {
            fs::path here = folder_.has_filename() ? folder_ : folder_.parent_path();
            walk_to = here.parent_path();
        }
    for (const FolderEntry& entry : entries_) {
        std::string label = entry.folder ? entry.name + "/" : entry.name;
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
            if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) chosen = accept(typed_);
        }
    }
    ImGui::EndChild();
    if (!walk_to.empty()) enter(walk_to);
    return chosen;
}

void FileDialog::draw_formats() {
    fs::path path = typed_;
    int format =
        static_cast<int>(std::ranges::find(kFormats, lower(path.extension().string())) - kFormats.begin());
    if (segmented_row("Format", format, kFormatNames)) {
        if (path.filename().empty()) path /= "drawing";
        typed_ = path.replace_extension(kFormats[format]).string();
        trouble_.clear();
    }
}

std::optional<fs::path> FileDialog::draw() {
    if (!open_) return std::nullopt;
    bool saving = purpose_ == Purpose::save_drawing;
    const char* title = saving ? "Export the drawing" : "Open a picture";
    if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    float unit = ImGui::GetTextLineHeight() / 15;
    ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(660 * unit, screen.x - 20), std::min(500 * unit, screen.y - 20)});
    if (!ImGui::BeginPopupModal(title, &open_, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize))
        return std::nullopt;

    std::optional<fs::path> chosen;
    ImGui::SetNextItemWidth(-1);
    if (just_opened_) ImGui::SetKeyboardFocusHere();
    just_opened_ = false;
    if (ImGui::InputText("##path", &typed_, ImGuiInputTextFlags_EnterReturnsTrue)) chosen = accept(typed_);
    note_place("Path");
    if (auto entry = draw_entries()) chosen = entry;
    if (saving)
        draw_formats();
    else
        ImGui::Dummy({0, ImGui::GetFrameHeight()});

    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, colour_of(ThemeColour::warning));
    ImGui::TextUnformatted(trouble_.c_str());
    ImGui::PopStyleColor();
    float button = 110 * unit;
    ImGui::SameLine(ImGui::GetWindowWidth() - 2 * button - ImGui::GetStyle().ItemSpacing.x -
                    ImGui::GetStyle().WindowPadding.x);
    if (ImGui::Button("Cancel", {button, 0}) || escape_pressed()) open_ = false;
    note_place("Cancel");
    ImGui::SameLine();
    bool replaces = saving && !is_folder(typed_) && is_there(typed_);
    if (ImGui::Button(replaces ? "Replace" : saving ? "Export" : "Open", {button, 0}))
        chosen = accept(typed_);
    note_place("Accept");
    if (chosen) open_ = false;
    if (!open_) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return chosen;
}

}  // namespace dapple
