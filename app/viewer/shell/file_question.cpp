#include "app/viewer/shell/file_question.h"

#include <imgui.h>

#include <algorithm>
#include <string>
#include <utility>

#include "app/viewer/widgets/dialog.h"
#include "app/viewer/widgets/picture_entry.h"
#include "app/viewer/widgets/row.h"
#include "app/viewer/widgets/widgets.h"
#include "core/text/shown_text.h"

namespace dapple {
namespace {

constexpr float kAnswersWidth = 30;     // letters' heights
constexpr float kAnswersHeight = 0.6f;  // of the window's, at most

bool answer_button(const char* label) {
    const bool pressed = key_button(label);
    note_place(label);
    return pressed;
}

}  // namespace

void FileQuestion::ask(std::vector<std::filesystem::path> files, const IsBoth& is_both) {
    if (files.empty()) return;
    offered_ = std::move(files);
    is_plain_ = offered_.size() == 1 && !is_both(offered_.front());
    keys_.forget();
}

std::optional<FileQuestion::Answer> FileQuestion::draw(const IsBoth& is_both) {
    if (offered_.empty()) return std::nullopt;
    if (offered_.size() > 1) draw_several(is_both);
    if (offered_.size() != 1) return std::nullopt;
    if (is_plain_) return Answer{std::exchange(offered_, {}).front()};
    return draw_both();
}

std::optional<FileQuestion::Answer> FileQuestion::draw_both() {
    bool open = true;
    std::optional<Answer> answer;
    if (const Dialog dialog("A drawing of Dapple's", open); dialog) {
        const std::filesystem::path& file = offered_.front();
        const std::string name = printable(file.filename().native());
        ImGui::TextUnformatted((name + " is a picture, and holds the settings it was drawn with.").c_str());
        if (answer_button("Take its settings")) answer = {file};
        ImGui::SameLine();
        if (answer_button("Open as a picture")) answer = {file, true};
        if (answer) open = false;
    }
    if (!open) offered_.clear();
    return answer;
}

void FileQuestion::draw_several(const IsBoth& is_both) {
    bool open = true;
    std::optional<std::filesystem::path> chosen;
    if (const Dialog dialog("Which one is to be opened?", open); dialog) {
        const float line = ImGui::GetTextLineHeight(), air = 2 * ImGui::GetStyle().WindowPadding.y;
        const float all = static_cast<float>(offered_.size()) * ImGui::GetTextLineHeightWithSpacing() + air;
        const ImVec2 size{kAnswersWidth * line, std::min(all, kAnswersHeight * ImGui::GetIO().DisplaySize.y)};
        const ImVec2 low = ImGui::GetCursorScreenPos();
        keys_.begin("files", low, {low.x + size.x, low.y + size.y});
        ImGui::BeginChild("files", size, true);
        for (const std::filesystem::path& file : offered_) {
            const std::string name = printable(file.filename().native());
            ImGui::PushID(&file);
            if (text_entry(name, keys_.next_is_marked())) chosen = file;
            if (keys_.end_entry(name).press) chosen = file;
            ImGui::PopID();
            note_place(("Open " + name).c_str());
            tip(printable(file.native()).c_str());
        }
        ImGui::EndChild();
        if (chosen) open = false;
    }
    if (!open) offered_.clear();
    if (chosen) ask({*chosen}, is_both);
}

}  // namespace dapple
