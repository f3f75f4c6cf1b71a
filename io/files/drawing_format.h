#pragma once
// The kind of file that a name asks for.

#include <filesystem>

#include "core/output/drawing_format.h"

namespace dapple {

/// What a name's ending says, in upper or lower case. Throws std::runtime_error if it is another.
DrawingFormat drawing_format(const std::filesystem::path& path);

}  // namespace dapple
