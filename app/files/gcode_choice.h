#pragma once
// How G-code is written, as it was chosen.

#include <filesystem>

#include "app/drawing_settings.h"
#include "core/output/gcode.h"

namespace dapple {

/// Millimetres a minute.
inline constexpr double kSlowestFeed = 0.01, kFastestFeed = 1e6;
inline constexpr double kLongestDwellS = 60;

/// Reads a template. Throws std::runtime_error naming the file, and the line that is wrong.
OwnTemplate read_gcode_template(const std::filesystem::path& file);

/// Throws what parse_gcode_template() throws.
GcodeStyle gcode_style_of(const SavingChoice& saving);

}  // namespace dapple
