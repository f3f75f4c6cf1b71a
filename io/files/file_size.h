#pragma once
// How large a file will be, found before it is written.

#include <optional>

#include "io/files/save_drawing.h"

namespace dapple {

/// Bytes, within some 10 %. The format's own writer writes a part: of text the first dots, of pixels bands
/// across the page. Empty for lines in pixels, which a part does not stand for. Throws
/// std::runtime_error as the writer would.
std::optional<double> estimated_bytes(const DrawingToSave& drawing);

}  // namespace dapple
