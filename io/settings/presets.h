#pragma once
// Presets: how drawings are made and saved, by a name, for any picture. Some come with the program; a
// person's own are settings, as fields.h has them, in $XDG_CONFIG_HOME/dapple/presets/NAME.dapple.

#include <filesystem>
#include <string>
#include <vector>

#include "io/settings/project.h"

namespace dapple {

struct Preset {
    std::string name;   // "fine-pen"
    std::string about;  // "many small dots on A4, in a short way for a pen"; empty: a person's own
    SavedSettings settings;
};

/// In the order to show them.
const std::vector<Preset>& built_in_presets();

/// The names of the person's own, sorted; none without a folder. A file is not read before it is used.
std::vector<std::string> own_presets(const std::filesystem::path& folder);

/// Throws std::runtime_error with one sentence if there is none of that name, or its file is wrong.
Preset preset_named(const std::string& name, const std::filesystem::path& folder);

/// Writes one of the person's own, in the place of one that has that name. Throws std::runtime_error with a
/// sentence if the name is empty, a built-in one's or none for a file, and as save_atomically().
void save_preset(const std::string& name, const SavedSettings& settings, const std::filesystem::path& folder);

/// Throws std::runtime_error if it is not there or stays.
void remove_preset(const std::string& name, const std::filesystem::path& folder);

/// A preset's settings, except for what is the picture's own: its crop, its turns, its exposure, its mask and
/// its edits.
DrawingSettings with_preset(const DrawingSettings& preset, const DrawingSettings& present);

}  // namespace dapple
