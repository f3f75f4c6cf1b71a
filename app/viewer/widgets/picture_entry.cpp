#include "app/viewer/widgets/picture_entry.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

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

// Into a box from `start` on, in its middle; where it lies. None: there is no picture (yet).
std::optional<WidgetPlace> draw_picture(const EntryPicture& picture, ImVec2 start, ImVec2 box) {
    ImDrawList* const list = ImGui::GetWindowDrawList();
    if (picture.awaited) {
        const float inset = std::floor(box.y / 10);
        list->AddRectFilled({start.x + inset, start.y + inset},
                            {start.x + box.x - inset, start.y + box.y - inset},
                            ImGui::GetColorU32(ImGuiCol_FrameBg), ImGui::GetStyle().FrameRounding);
    }
    if (!picture.texture) return std::nullopt;
    const float fit = std::min(box.x / picture.size.x, box.y / picture.size.y);
    const ImVec2 size{std::floor(picture.size.x * fit), std::floor(picture.size.y * fit)};
    const ImVec2 corner{start.x + std::floor((box.x - size.x) / 2),
                        start.y + std::floor((box.y - size.y) / 2)};
    const ImVec2 far{corner.x + size.x, corner.y + size.y};
    list->AddImage(picture.texture, corner, far);
    return WidgetPlace{{corner.x, corner.y}, {far.x, far.y}};
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
    if (const auto place_of = draw_picture(picture, start, box))
        note_place(("Picture of " + label).c_str(), *place_of);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const float line = ImGui::GetTextLineHeight(), x = start.x + box.x + ImGui::GetStyle().ItemSpacing.x;
    const float text = words.empty() ? line : 2 * line;
    const float y = start.y + (box.y - text) / 2;
    list->AddText({x, y}, ImGui::GetColorU32(ImGuiCol_Text), label.c_str());
    list->AddText({x, y + line}, ImGui::GetColorU32(ImGuiCol_TextDisabled), words.c_str());
    return clicked;
}

bool strip_entry(const std::string& note, const std::string& name, bool chosen, const EntryPicture& picture,
                 const EntryBox& place) {
    const ImVec2 start = ImGui::GetCursorScreenPos(), box = size_of(place);
    const float line = ImGui::GetTextLineHeight(), unit = line / 15;
    ImGui::PushID(id_of(name));
    const bool clicked = press_area("entry", {box.x, box.y + line});
    ImGui::PopID();
    const ImVec2 low = ImGui::GetWindowDrawList()->GetClipRectMin(),
                 far = ImGui::GetWindowDrawList()->GetClipRectMax();
    const WidgetPlace seen{{std::max(start.x, low.x), start.y},
                           {std::min(start.x + box.x, far.x), start.y + box.y}};
    if (seen.min.x < seen.max.x) note_place(note.c_str(), seen);
    const bool hot = ImGui::IsItemHovered();
    draw_picture(picture, start, box);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const float width = ImGui::CalcTextSize(name.c_str()).x;
    list->PushClipRect(start, {start.x + box.x, start.y + box.y + line}, true);
    list->AddText({start.x + std::max(0.0f, std::floor((box.x - width) / 2)), start.y + box.y},
                  colour_of(chosen || hot ? ThemeColour::text : ThemeColour::quiet), name.c_str());
    list->PopClipRect();
    if (chosen || hot)
        list->AddRect({start.x + unit, start.y + unit}, {start.x + box.x - unit, start.y + box.y - unit},
                      colour_of(chosen ? ThemeColour::accent : ThemeColour::line), 3 * unit, 0, 2 * unit);
    return clicked;
}

float strip_height(const EntryBox& box) {
    return size_of(box).y + ImGui::GetTextLineHeight() + ImGui::GetStyle().ScrollbarSize + 2;
}

}  // namespace dapple
