#include "app/viewer/shell/changes_question.h"

#include <fmt/format.h>
#include <imgui.h>

#include <optional>

#include "app/viewer/widgets/dialog.h"
#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/row.h"
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

ChangesAnswer ask(const char* title, const std::string& sentence, const Button& save, const Button& discard,
                  const std::optional<Button>& next = {}) {
    bool open = true;
    ChangesAnswer answer = ChangesAnswer::none;
    if (const Dialog dialog(title, open); dialog) {
        ImGui::TextUnformatted(sentence.c_str());
        if (pressed(save)) answer = ChangesAnswer::save;
        ImGui::SameLine();
        if (pressed(discard)) answer = ChangesAnswer::discard;
        ImGui::SameLine();
        if (next) {
            if (pressed(*next)) answer = ChangesAnswer::next;
            ImGui::SameLine();
        }
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

ChangesAnswer ask_about_saving(const std::string& name) {
    return ask("Quit while a file is being saved?", name + " is not completely written yet.",
               {"Quit once it is saved", Key::enter, "Return"},
               {"Quit without it", Key::d, "What was there before stays.   D"});
}

ChangesAnswer ask_about_kept(const std::string& name, std::size_t others) {
    std::string sentence = "Dapple ended before the drawing of " + name + " was saved.";
    std::optional<Button> next;
    if (others > 0) {
        sentence += fmt::format("\nThere {} from before.",
                                others == 1 ? "is one more" : fmt::format("are {} more", others));
        next = Button{"An older one", Key::o, "This one is kept, and you are asked about the next.   O"};
    }
    return ask("Bring the drawing back?", sentence, {"Bring it back", Key::enter, "Return"},
               {"Discard", Key::d, "It is lost.   D"}, next);
}

}  // namespace dapple
