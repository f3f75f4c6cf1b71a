#include "app/viewer/panels/preset_row.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <exception>
#include <utility>

#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/row_keys.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {
namespace {

// In heights of a line of text.
constexpr EntryBox kPresetBox{6, 4};
constexpr float kListWidth = 30;

}  // namespace

void PresetRow::read(Banner& banner) {
    presets_ = built_in_presets();
    for (const std::string& name : own_presets(folder_)) {
        try {
            presets_.push_back(preset_named(name, folder_));
        } catch (const std::exception& error) {
            banner = {BannerKind::error, error.what()};
        }
    }
}

void PresetRow::draw_naming(const SavedSettings& now, Banner& banner) {
    const float button = 70 * ImGui::GetTextLineHeight() / 15;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x -
                            2 * (button + ImGui::GetStyle().ItemSpacing.x));
    if (std::exchange(ask_for_keys_, false)) ImGui::SetKeyboardFocusHere();
    const bool entered =
        ImGui::InputTextWithHint("##preset name", "its name", &typed_, ImGuiInputTextFlags_EnterReturnsTrue);
    note_place("Preset name");
    const bool left = ImGui::IsItemDeactivated() && key_pressed(Key::escape);
    ImGui::SameLine();
    const bool saved = key_button("Save", {button, 0}) || entered;
    note_place("Save preset");
    tip("Keeps all settings under this name, to be chosen above.");
    ImGui::SameLine();
    if (key_button("Cancel", {button, 0}) || left) naming_ = false;
    tip("Saves no preset.");
    if (!saved) return;
    try {
        save_preset(typed_, now, folder_);
        banner = {BannerKind::notice, "Saved the preset " + typed_};
        naming_ = false;
        read(banner);
    } catch (const std::exception& error) {
        banner = {BannerKind::error, error.what()};
    }
}

bool PresetRow::draw_preset(const Preset& preset, bool marked, const SavedSettings& now,
                            const Preview& preview) {
    const EntryPicture picture = next_entry_shows(kPresetBox)
                                     ? preview(with_preset(preset.settings.drawing, now.drawing))
                                     : EntryPicture{};
    return picture_entry(preset.name, preset.about.empty() ? "your own" : preset.about, marked, picture,
                         kPresetBox);
}

void PresetRow::draw(const SavedSettings& now, const std::function<void(const SavedSettings&)>& take,
                     const Preview& preview, Banner& banner) {
    if (presets_.empty()) read(banner);
    std::vector<const char*> names{"as set below"};
    int chosen = 0;
    for (const Preset& preset : presets_) {
        const bool is_it = with_preset(preset.settings.drawing, now.drawing) == now.drawing &&
                           preset.settings.saving == now.saving;
        if (is_it) chosen = static_cast<int>(names.size());
        names.push_back(preset.name.c_str());
    }
    const int presets = static_cast<int>(names.size());
    const bool is_own =
        chosen > 0 && presets_[static_cast<std::size_t>(chosen - 1)].about.empty() && !folder_.empty();
    const std::string removal =
        is_own ? std::string("Remove ") + names[static_cast<std::size_t>(chosen)] : "";
    if (!folder_.empty()) names.push_back("Save these settings as...");
    if (is_own) names.push_back(removal.c_str());
    const int before = chosen;
    const auto draw_entry = [&](int entry, bool marked) {
        if (entry > 0 && entry < presets)
            return draw_preset(presets_[static_cast<std::size_t>(entry - 1)], marked, now, preview);
        const char* const name = names[static_cast<std::size_t>(entry)];
        const bool clicked = ImGui::Selectable(name, marked);
        note_place(name);
        return clicked;
    };
    // Arrows open the list: each preset on the way would take the place of what is about to be saved.
    if (choice_row(
            "Preset", chosen, names,
            "All settings at once, but for the picture's own crop, turns and exposure. One undo brings "
            "yours back.",
            ListLook{.lines_wide = kListWidth, .draw = draw_entry})) {
        if (chosen == presets) {
            naming_ = ask_for_keys_ = true;
            typed_.clear();
        } else if (chosen > presets) {
            try {
                remove_preset(presets_[static_cast<std::size_t>(before - 1)].name, folder_);
            } catch (const std::exception& error) {
                banner = {BannerKind::error, error.what()};
            }
            return read(banner);
        } else if (chosen > 0) {
            take(presets_[static_cast<std::size_t>(chosen - 1)].settings);
        }
    }
    if (naming_) draw_naming(now, banner);
}

}  // namespace dapple
