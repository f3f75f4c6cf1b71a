#include "app/viewer/panels/settings_panels.h"

#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <exception>
#include <string>

#include "app/viewer/widgets/widgets.h"

namespace dapple {
namespace {

// In heights of a line of text.
constexpr EntryBox kPresetBox{6, 4};
constexpr float kListWidth = 30;
constexpr EntryBox kStripBox{5.5f, 3.6f};

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
