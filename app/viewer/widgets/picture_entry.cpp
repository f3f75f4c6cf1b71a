#include "app/viewer/widgets/picture_entry.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "app/viewer/widgets/theme.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {

namespace {

ImVec2 size_of(const EntryBox& box) {
    const float line = ImGui::GetTextLineHeight();
    return {std::floor(box.width * line), std::floor(box.height * line)};
}

// An id for any name: Dear ImGui itself would leave out what stands before "###".
int id_of(const std::string& name) {
    return static_cast<int>(std::hash<std::string>()(name));
}

}  // namespace

bool next_entry_shows(const EntryBox& box) {
    return ImGui::IsRectVisible(size_of(box));
}

bool text_entry(const std::string& label, bool chosen, ImGuiSelectableFlags flags) {
    const ImVec2 start = ImGui::GetCursorScreenPos();
    ImGui::PushID(id_of(label));
    const bool clicked = ImGui::Selectable("##name", chosen, flags);
    ImGui::PopID();
    ImGui::GetWindowDrawList()->AddText(start, ImGui::GetColorU32(ImGuiCol_Text), label.c_str());
    note_place(label.c_str());
    return clicked;
}

bool picture_entry(const std::string& label, const std::string& words, bool chosen,
                   const EntryPicture& picture, const EntryBox& place, ImGuiSelectableFlags flags) {
    const ImVec2 start = ImGui::GetCursorScreenPos(), box = size_of(place);
    ImGui::PushID(id_of(label));
    const bool clicked = ImGui::Selectable("##entry", chosen, flags, {0, box.y});
    ImGui::PopID();
    note_place(label.c_str());
    ImDrawList* const list = ImGui::GetWindowDrawList();
    if (picture.texture) {
        const float fit = std::min(box.x / picture.size.x, box.y / picture.size.y);
        const ImVec2 size{std::floor(picture.size.x * fit), std::floor(picture.size.y * fit)};
        const ImVec2 corner{start.x + std::floor((box.x - size.x) / 2),
                            start.y + std::floor((box.y - size.y) / 2)};
        const ImVec2 far{corner.x + size.x, corner.y + size.y};
        list->AddImage(picture.texture, corner, far);
        note_place(("Picture of " + label).c_str(), {{corner.x, corner.y}, {far.x, far.y}});
    }
    if (picture.awaited) {
        const float inset = std::floor(box.y / 10);
        list->AddRectFilled({start.x + inset, start.y + inset},
                            {start.x + box.x - inset, start.y + box.y - inset},
                            ImGui::GetColorU32(ImGuiCol_FrameBg), ImGui::GetStyle().FrameRounding);
    }
    const float line = ImGui::GetTextLineHeight(), x = start.x + box.x + ImGui::GetStyle().ItemSpacing.x;
    const float text = words.empty() ? line : 2 * line;
    const float y = start.y + (box.y - text) / 2;
    list->AddText({x, y}, ImGui::GetColorU32(ImGuiCol_Text), label.c_str());
    list->AddText({x, y + line}, ImGui::GetColorU32(ImGuiCol_TextDisabled), words.c_str());
    return clicked;
}

}  // namespace dapple
