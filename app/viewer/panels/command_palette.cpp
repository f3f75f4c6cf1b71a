#include "app/viewer/panels/command_palette.h"

#include <imgui.h>

#include <algorithm>
#include <optional>
#include <sstream>

#include "app/viewer/widgets/dialog.h"
#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/picture_entry.h"
#include "core/text/shown_text.h"
#include "io/files/text_file.h"

namespace dapple {
namespace {

constexpr float kPaletteWidth = 34;     // letters' heights, where the window is as wide
constexpr float kPaletteHeight = 0.6f;  // of the window's, at most; what is more is scrolled to

bool has_all_words(const std::string& entry, std::string_view text) {
    std::istringstream words(lower_case(std::string(text)));
    const std::string small = lower_case(entry);
    std::string word;
    bool all = true;
    while (words >> word) all &= small.find(word) != std::string::npos;
    return all;
}

float palette_width() {
    const float room = ImGui::GetIO().DisplaySize.x - 4 * ImGui::GetStyle().WindowPadding.x;
    return std::max(std::min(kPaletteWidth * ImGui::GetTextLineHeight(), room), 1.0f);
}

// Clear of the list's scroll bar.
void at_the_end_of_the_entry(const char* words) {
    const float air = ImGui::GetStyle().ItemSpacing.x;
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(words).x - air);
    ImGui::TextDisabled("%s", words);
}

// "Picture, Mask", and whether it is so already.
std::string where_in_words(const FoundRow& found) {
    std::string words;
    if (found.row->is_section && found.row->sections.empty()) return "section";
    for (const std::string& section : found.row->sections) words += (words.empty() ? "" : ", ") + section;
    if (found.value >= 0 && found.value == found.row->chosen) words += ", current";
    if (!found.row->why_not.empty()) words += ", not now";
    return words;
}

}  // namespace

std::vector<Shortcut> shortcuts_with(std::string_view text, std::span<const Shortcut> shortcuts) {
    std::vector<Shortcut> found;
    for (const Shortcut& shortcut : shortcuts) {
        if (shortcut.action == Action::palette) continue;
        if (has_all_words(std::string(shortcut.meaning) + ' ' + shortcut.keys, text))
            found.push_back(shortcut);
    }
    return found;
}

std::string FoundRow::words() const {
    return value < 0 ? row->label : row->label + ": " + row->values[static_cast<std::size_t>(value)];
}

std::vector<FoundRow> rows_with(std::string_view text, std::span<const ListedRow> rows) {
    std::vector<FoundRow> found, values;
    if (text.find_first_not_of(' ') == text.npos) return found;
    for (const ListedRow& row : rows) {
        std::string sections;
        for (const std::string& section : row.sections) sections += section + ' ';
        const auto wanted = [&](const FoundRow& each) {
            return has_all_words(sections + each.words(), text);
        };
        if (wanted({&row})) found.push_back({&row});
        for (int i = 0; row.why_not.empty() && i < static_cast<int>(row.values.size()); ++i)
            if (wanted({&row, i})) values.push_back({&row, i});
    }
    found.insert(found.end(), values.begin(), values.end());
    return found;
}

void CommandPalette::draw(std::span<const Shortcut> shortcuts, const std::function<void(Action)>& act,
                          const RecentFiles& recent, const RowsToFind& rows) {
    constexpr std::size_t kMostFiles = 8;  // of all that are remembered
    std::optional<Action> asked;
    std::optional<std::filesystem::path> file;
    std::optional<FoundRow> row;
    {
        const Dialog dialog("Commands", open_, DialogPlace::top);
        if (!dialog) return;
        if (ImGui::IsWindowAppearing()) {
            typed_[0] = 0;
            chosen_ = 0;
        }
        const float width = palette_width();
        ImGui::SetNextItemWidth(width);
        if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
        const std::string before = typed_;
        const bool entered = ImGui::InputTextWithHint("##typed", "type to search", typed_, sizeof typed_,
                                                      ImGuiInputTextFlags_EnterReturnsTrue);
        note_place("Commands");
        if (before != typed_) chosen_ = 0;
        const std::vector<Shortcut> found = shortcuts_with(typed_, shortcuts);
        std::vector<std::filesystem::path> files;
        for (const std::filesystem::path& each : recent.files)
            if (files.size() < kMostFiles && has_all_words(each.string(), typed_)) files.push_back(each);
        const std::vector<FoundRow> settings = rows_with(typed_, rows.rows);
        const int actions = static_cast<int>(found.size());
        const int before_files = actions + static_cast<int>(settings.size());
        const int entries = before_files + static_cast<int>(files.size());
        const int steps = step_between(Key::up, Key::down);
        chosen_ = std::clamp(chosen_ + steps, 0, std::max(entries - 1, 0));
        const float all = static_cast<float>(entries) * ImGui::GetTextLineHeightWithSpacing();
        ImGui::BeginChild("list",
                          {width, std::clamp(all, 1.0f, kPaletteHeight * ImGui::GetIO().DisplaySize.y)});
        const auto entry = [&](const std::string& label, int i) {
            ImGui::PushID(i);
            const bool clicked = text_entry(label, i == chosen_);
            ImGui::PopID();
            if (i == chosen_ && steps != 0) ImGui::SetScrollHereY();
            return clicked;
        };
        for (int i = 0; i < actions; ++i) {
            const Shortcut& each = found[static_cast<std::size_t>(i)];
            if (entry(each.meaning, i)) asked = each.action;
            at_the_end_of_the_entry(each.keys);
        }
        for (int i = actions; i < before_files; ++i) {
            const FoundRow& each = settings[static_cast<std::size_t>(i - actions)];
            if (entry(each.words(), i)) row = each;
            at_the_end_of_the_entry(where_in_words(each).c_str());
        }
        for (int i = before_files; i < entries; ++i) {
            const std::filesystem::path& each = files[static_cast<std::size_t>(i - before_files)];
            if (entry(printable(each.filename().native()), i)) file = each;
            tip(printable(each.native()).c_str());
            at_the_end_of_the_entry("recent");
        }
        ImGui::EndChild();
        note_place("Found");
        if (entries == 0) hint("Nothing matches; try fewer words.");
        if (entered && chosen_ < actions)
            asked = found[static_cast<std::size_t>(chosen_)].action;
        else if (entered && chosen_ < before_files)
            row = settings[static_cast<std::size_t>(chosen_ - actions)];
        else if (entered && !files.empty())
            file = files[static_cast<std::size_t>(chosen_ - before_files)];
        if (asked || row || file) open_ = false;
    }
    if (asked) act(*asked);
    if (row) rows.take(*row->row, row->value);
    if (file) recent.open(*file);
}

}  // namespace dapple
