#include "app/viewer/shell/changes_question.h"

#include <imgui.h>

#include <optional>

#include "app/viewer/widgets/dialog.h"
#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/row_keys.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {
namespace {

struct Button {
    const char* label;
    std::optional<Key> key;  // that presses it while no button has the keys
    const char* tip;
};

bool pressed(const Button& button) {
    const bool by_mouse = key_button(button.label);
    note_place(button.label);
    tip(button.tip);
    const bool by_key = button.key && !a_row_has_keys() && !ImGui::IsWindowAppearing();
    return by_mouse || (by_key && key_pressed(*button.key));
}

ChangesAnswer ask(const char* title, const std::string& sentence, const Button& save, const Button& discard) {
    bool open = true;
    ChangesAnswer answer = ChangesAnswer::none;
    if (const Dialog dialog(title, open); dialog) {
        ImGui::TextUnformatted(sentence.c_str());
        if (pressed(save)) answer = ChangesAnswer::save;
        ImGui::SameLine();
        if (pressed(discard)) answer = ChangesAnswer::discard;
        ImGui::SameLine();
        if (pressed({"Cancel", {}, "Escape"})) answer = ChangesAnswer::cancel;
        if (answer != ChangesAnswer::none) open = false;
    }
    return open || answer != ChangesAnswer::none ? answer : ChangesAnswer::cancel;
}

}  // namespace

ChangesAnswer ask_about_changes(const std::string& name) {
    return ask("Save the changes?", name + " has changes that are not saved.",
               {"Save", Key::enter, "As a project.   Return"}, {"Discard", Key::d, "They are lost.   D"});
}

ChangesAnswer ask_about_kept(const std::string& name) {
    return ask("Bring the drawing back?", "Dapple ended before the drawing of " + name + " was saved.",
               {"Bring it back", Key::enter, "Return"}, {"Discard", Key::d, "It is lost.   D"});
}

}  // namespace dapple
