#include "app/viewer/panels/action_buttons.h"

#include <imgui.h>

#include "app/viewer/widgets/widgets.h"

namespace dapple {

void draw_action_buttons(const std::function<void(Action)>& act) {
    const float air = ImGui::GetStyle().ItemSpacing.x;
    const float third = (ImGui::GetContentRegionAvail().x - 2 * air) / 3;
    auto button = [&](const char* label, Action action) {
        if (ImGui::Button(label, {third, 0})) act(action);
        note_place(label);
    };
    button("Open...", Action::open);
    ImGui::SameLine();
    button("Export...", Action::save_as);
    ImGui::SameLine();
    button("Keys", Action::help);
}

}  // namespace dapple
