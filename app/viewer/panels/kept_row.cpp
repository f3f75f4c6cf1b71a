#include "app/viewer/panels/window_panels.h"

#include <fmt/format.h>

#include <imgui.h>
#include <imgui_stdlib.h>
#include <algorithm>
#include <cctype>
#include <cstddef>
#include <exception>
#include <string>
#include <utility>

#include "app/viewer/panels/settings_panels.h"
#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/row.h"
#include "app/viewer/widgets/widgets.h"
#include "core/pens/separation.h"

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

void PaletteRow::read(Banner& banner) {
    palettes_ = built_in_palettes();
    const auto add = [this](const std::string& name) { palettes_.push_back(palette_named(name, folder_)); };
    for (const std::string& name : own_palettes(folder_)) done(add, name, banner);
}

bool PaletteRow::draw(PenChoice& pens, const Palette& now, Banner& banner) {
    if (palettes_.empty()) read(banner);
    bool taken = false;
    const bool automatic = pens.set == PenSet::automatic;
    KeptThings things{
        .label = "Palette",
        .tip =
            "Named sets of pens: common ones and those you save here. Automatic pens are chosen from them. "
            "Commands take them as --pens NAME.",
        .what = "palette",
        .present = automatic ? "custom pens" : "Custom",
        .keep = "Save these pens as...",
        .may_keep = !folder_.empty() && !now.empty(),
        .take =
            [&](int which) {
                taken = true;
                if (automatic && which == 0) return pens.own.clear();
                pens.own = palettes_[static_cast<std::size_t>(which - automatic)].pens;
                const int others = static_cast<int>(pens.own.size()) - 1;
                if (!automatic || others == 0) pens.set = PenSet::own;
                if (pens.set == PenSet::automatic) pens.automatic = std::min(pens.automatic, others);
            },
        .save = [&](const std::string& name) { save_palette(name, now, folder_); },
        .remove = [&](const std::string& name) { remove_palette(name, folder_); },
        .changed = [&] { read(banner); },
    };
    // As a file has them, whose colours are of 8 bits.
    const bool own = pens.set == PenSet::own || chooses_from_own(pens);
    const std::string present = own ? text_of(PenChoice{.set = PenSet::own, .own = pens.own}) : "";
    if (automatic) {
        if (!own) things.chosen = 0;
        things.all.push_back({"common pens"});
    }
    for (const NamedPalette& palette : palettes_) {
        if (text_of(PenChoice{.set = PenSet::own, .own = palette.pens}) == present)
            things.chosen = static_cast<int>(things.all.size());
        things.all.push_back({palette.name, palette.about.empty()});
    }
    row_.draw(things, banner);
    return taken;
}

namespace {

// In heights of a line of text.
constexpr EntryBox kPresetBox{6, 4};
constexpr float kListWidth = 30;
constexpr EntryBox kStripBox{5.5f, 3.6f};

}  // namespace

void PresetRow::read(Banner& banner) {
    presets_ = built_in_presets();
    const auto add = [this](const std::string& name) { presets_.push_back(preset_named(name, folder_)); };
    for (const std::string& name : own_presets(folder_)) done(add, name, banner);
}

static EntryPicture picture_of(const Preset& preset, const EntryBox& box, const DrawingSettings& now,
                               const PresetRow::Preview& preview) {
    return next_entry_shows(box) ? preview(with_preset(preset.settings.drawing, now)) : EntryPicture{};
}

// The built-in "fine-pen" as "Fine pen"; a person's own as typed.
static std::string shown_name(const Preset& preset) {
    if (preset.about.empty()) return preset.name;
    std::string name = preset.name;
    std::ranges::replace(name, '-', ' ');
    name[0] = static_cast<char>(std::toupper(name[0]));
    return name;
}

void PresetRow::draw(const SavedSettings& now, const std::function<void(const SavedSettings&)>& take,
                     const Preview& preview, Banner& banner) {
    if (presets_.empty()) read(banner);
    KeptThings things{
        .label = "Preset",
        .tip = "Sets everything except crop, rotation and exposure. One undo restores yours.",
        .what = "preset",
        .present = "Custom",
        .keep = "Save these settings as...",
        .may_keep = !folder_.empty(),
        .take = [&](int which) { take(presets_[static_cast<std::size_t>(which)].settings); },
        .save = [&](const std::string& name) { save_preset(name, now, folder_); },
        .remove = [&](const std::string& name) { remove_preset(name, folder_); },
        .changed = [&] { read(banner); },
        .lines_wide = kListWidth,
    };
    for (const Preset& preset : presets_) {
        if (with_preset(preset.settings.drawing, now.drawing) == now.drawing &&
            preset.settings.saving == now.saving)
            things.chosen = static_cast<int>(things.all.size());
        things.all.push_back({shown_name(preset), preset.about.empty()});
    }
    things.draw = [&](int which, bool marked) {
        const Preset& preset = presets_[static_cast<std::size_t>(which)];
        return picture_entry(shown_name(preset), preset.about.empty() ? "your preset" : preset.about, marked,
                             picture_of(preset, kPresetBox, now.drawing, preview), kPresetBox);
    };
    row_.draw(things, banner);
    draw_strip(now, take, preview, things.chosen);
}

void PresetRow::draw_strip(const SavedSettings& now, const std::function<void(const SavedSettings&)>& take,
                           const Preview& preview, int chosen) {
    ImGui::BeginChild("##strip", {0, strip_height(kStripBox)}, false,
                      ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoNavInputs);
    for (int i = 0; i < static_cast<int>(presets_.size()); ++i) {
        const Preset& preset = presets_[static_cast<std::size_t>(i)];
        if (i > 0) ImGui::SameLine();
        const EntryPicture picture = picture_of(preset, kStripBox, now.drawing, preview);
        if (strip_entry("Style " + preset.name, shown_name(preset), i == chosen, picture, kStripBox))
            take(preset.settings);
        tip(preset.about.empty() ? "Your preset." : (preset.about + ".").c_str());
    }
    ImGui::EndChild();
}

}  // namespace dapple
