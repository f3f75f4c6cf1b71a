#pragma once
// The row "Preset" at the top of the column: chooses one, saves the settings as one, removes one. Below it a
// strip of what all of them make of the picture.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/viewer/model/banner.h"
#include "app/viewer/panels/kept_row.h"
#include "app/viewer/widgets/picture_entry.h"
#include "io/settings/presets.h"

namespace dapple {

class PresetRow {
 public:
    /// Without a folder there are the built-in presets only, and none is saved.
    explicit PresetRow(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// What settings make of the picture shown, small; asked for in every frame that shows it.
    using Preview = std::function<EntryPicture(const DrawingSettings&)>;

    /// For settings as they are now. The chosen preset's are given to `take`; the banner says what went wrong
    /// with a file, or that one was saved.
    void draw(const SavedSettings& now, const std::function<void(const SavedSettings&)>& take,
              const Preview& preview, Banner& banner);

 private:
    void read(Banner& banner);
    void draw_strip(const SavedSettings& now, const std::function<void(const SavedSettings&)>& take,
                    const Preview& preview, int chosen);
    bool draw_preset(const Preset& preset, bool marked, const SavedSettings& now, const Preview& preview);

    std::filesystem::path folder_;
    std::vector<Preset> presets_;  // all that can be chosen; empty: not read yet
    KeptRow row_;
};

}  // namespace dapple
