#pragma once
// The settings that a drawing was made with, inside the drawing: in an SVG's <metadata>, in a PNG's text.

#include <filesystem>
#include <optional>
#include <string>

#include "core/drawing/settings.h"

namespace dapple {

/// For a drawing to be saved there: what differs from the usual settings, in ASCII without <, > and &. Empty
/// if it cannot be said, as with a tile whose name is not UTF-8.
std::string embedded_settings(const std::filesystem::path& drawing_file, const DrawingSettings& drawing,
                              const SavingChoice& saving);

/// What a file has inside it, if it is an SVG or PNG of ours; none for any other file, whatever is in it.
std::optional<std::string> settings_inside(const std::filesystem::path& file);

struct SavedSettings {
    DrawingSettings drawing;
    SavingChoice saving;
};

/// Those of a drawing of ours, or of a project; what it does not say is as usual. Throws std::runtime_error
/// with one sentence if the file has none, or some that are wrong.
SavedSettings settings_from(const std::filesystem::path& file);

}  // namespace dapple
