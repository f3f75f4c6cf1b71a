#include "app/viewer/panels/side_captions.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/viewer/theme.h"

namespace dapple {
namespace {

ImVec2 title_size(const std::string& title) {
    push_title_font();
    const ImVec2 size = ImGui::CalcTextSize(title.c_str());
    pop_title_font();
    return size;
}

void draw_caption(const SideCaption& caption, float left, float right, float top, float height) {
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    const float air = ImGui::GetFontSize() * 0.7f;
    const ImVec2 title = title_size(caption.title), facts = ImGui::CalcTextSize(caption.facts.c_str());
    const float y = std::floor(top + (height - title.y - facts.y) / 2);
    const auto centred = [&](float width) {
        return std::floor(std::max(left + air, (left + right - width) / 2));
    };
    list->PushClipRect({left, top}, {right - air / 2, top + height}, true);
    push_title_font();
    list->AddText({centred(title.x), y}, colour_of(ThemeColour::text), caption.title.c_str());
    pop_title_font();
    list->AddText({centred(facts.x), y + title.y}, colour_of(ThemeColour::quiet), caption.facts.c_str());
    list->PopClipRect();
}

}  // namespace

float side_captions_height() {
    return std::round(ImGui::GetFontSize() * 3.1f);
}

void draw_side_captions(const std::array<SideCaption, 2>& captions, float share, glm::vec2 corner,
                        glm::vec2 size) {
    const float middle = corner.x + size.x * share, right = corner.x + size.x;
    ImGui::GetBackgroundDrawList()->AddRectFilled({corner.x, corner.y}, {right, corner.y + size.y},
                                                  colour_of(ThemeColour::surround));
    draw_caption(captions[0], corner.x, middle, corner.y, size.y);
    draw_caption(captions[1], middle, right, corner.y, size.y);
}

}  // namespace dapple
