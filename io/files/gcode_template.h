#pragma once
// A person's own template for G-code, out of a file.

#include <filesystem>

#include "core/drawing/settings.h"

namespace dapple {

/// Throws std::runtime_error naming the file, and the line that is wrong.
OwnTemplate read_gcode_template(const std::filesystem::path& file);

}  // namespace dapple
