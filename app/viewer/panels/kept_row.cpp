#include "app/viewer/panels/window_panels.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <exception>
#include <utility>

#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/row.h"

namespace dapple {
namespace {

// Whether it was done; else the banner says why not.
bool done(const std::function<void(const std::string&)>& act, const std::string& name, Banner& banner) {
    try {
        act(name);
        return true;
    } catch (const std::exception& error) {
        banner = {BannerKind::error, error.what()};
        return false;
    }
}

}  // namespace

void KeptRow::draw_naming(const KeptThings& things, Banner& banner) {
    ImGui::PushID(things.label);
    const float button = 70 * ImGui::GetTextLineHeight() / 15;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x -
                            2 * (button + ImGui::GetStyle().ItemSpacing.x));
    if (std::exchange(ask_for_keys_, false)) ImGui::SetKeyboardFocusHere();
    const bool entered =
        ImGui::InputTextWithHint("##name", "name", &typed_, ImGuiInputTextFlags_EnterReturnsTrue);
    note_place(fmt::format("{} name", things.label).c_str());
    const bool left = ImGui::IsItemDeactivated() && key_pressed(Key::escape);
    ImGui::SameLine();
    const bool saved = key_button("Save", {button, 0}) || entered;
    note_place(fmt::format("Save {}", things.what).c_str());
    tip("Saves it under this name; choose it above.");
    ImGui::SameLine();
    if (key_button("Cancel", {button, 0}) || left) naming_ = false;
    tip(fmt::format("Closes this without saving a {}.", things.what).c_str());
    ImGui::PopID();
    if (!saved || !done(things.save, typed_, banner)) return;
    banner = {BannerKind::notice, fmt::format("Saved the {} {}", things.what, typed_)};
    naming_ = false;
    things.changed();
}

void KeptRow::draw(const KeptThings& things, Banner& banner) {
    const int before = things.chosen, count = static_cast<int>(things.all.size());
    std::vector<const char*> names{things.present};
    for (const KeptThing& thing : things.all) names.push_back(thing.name.c_str());
    const bool removable = things.may_keep && before >= 0 && things.all[static_cast<std::size_t>(before)].own;
    const std::string removal =
        removable ? "Remove " + things.all[static_cast<std::size_t>(before)].name : "";
    if (things.may_keep) names.push_back(things.keep);
    if (removable) names.push_back(removal.c_str());
    const auto draw_entry = [&](int entry, bool marked) {
        if (things.draw && entry > 0 && entry <= count) return things.draw(entry - 1, marked);
        const char* const name = names[static_cast<std::size_t>(entry)];
        const bool clicked = ImGui::Selectable(name, marked);
        note_place(name);
        return clicked;
    };
    // Arrows open the list: each on the way would take the place of what is about to be kept.
    int chosen = before + 1;
    if (choice_row(things.label, chosen, names, things.tip,
                   ListLook{.lines_wide = things.lines_wide, .draw = draw_entry})) {
        if (chosen == count + 1) {
            naming_ = ask_for_keys_ = true;
            typed_.clear();
        } else if (chosen > count) {
            done(things.remove, things.all[static_cast<std::size_t>(before)].name, banner);
            return things.changed();
        } else if (chosen > 0) {
            things.take(chosen - 1);
        }
    }
    if (naming_) draw_naming(things, banner);
}

}  // namespace dapple
