#include "app/viewer/panels/action_buttons.h"

#include <imgui.h>

#include "app/viewer/widgets/widgets.h"

namespace dapple {
namespace {

constexpr int kButtonsARow = 3;

bool action_button(const char* label, int column) {
    const float air = ImGui::GetStyle().ItemSpacing.x;
    if (column > 0) ImGui::SameLine();
    // Of the whole row, wherever in it the cursor is.
    const float row = ImGui::GetWindowContentRegionMax().x - ImGui::GetWindowContentRegionMin().x;
    const bool pressed = ImGui::Button(label, {(row - (kButtonsARow - 1) * air) / kButtonsARow, 0});
    note_place(label);
    return pressed;
}

void undo_button(const char* label, const std::optional<std::string>& words, const char* keys, Action action,
                 int column, const std::function<void(Action)>& act) {
    if (!words) ImGui::BeginDisabled();
    if (action_button(label, column)) act(action);
    if (!words) ImGui::EndDisabled();
    if (words)
        tip((std::string(label) + ": " + (words->empty() ? "the last change" : *words) + "   " + keys)
                .c_str());
}

}  // namespace

void draw_action_buttons(const UndoInfo& info, bool has_project, const std::function<void(Action)>& act) {
    if (action_button("Open...", 0)) act(Action::open);
    if (action_button("Export...", 1)) act(Action::save_as);
    if (has_project && action_button("Project...", 2)) act(Action::save_project);
    if (has_project) tip("Saves picture and settings together, to go on another day.   Ctrl+Shift+S");
    undo_button("Undo", info.undo, "Ctrl+Z", Action::undo, 0, act);
    undo_button("Redo", info.redo, "Ctrl+Y", Action::redo, 1, act);
    if (action_button("Keys", 2)) act(Action::help);
}

}  // namespace dapple
