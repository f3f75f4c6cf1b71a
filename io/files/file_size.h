#pragma once
// How large a file will be, found before it is written.

#include <optional>

#include "io/files/save_drawing.h"

namespace dapple {

/// Bytes, about. Of text the format's own writer writes the first dots, and the rest is taken to be like
/// them. Pixels are counted along the dots' edges, where all of a compressed picture lies: what they come to
/// was measured, and errs by a fifth; none where a pen's strokes are drawn, of which nothing is known so
/// simply. Throws std::runtime_error as the writer would.
std::optional<double> estimated_bytes(DrawingFormat format, const DrawingSettings& settings,
                                      const DrawingToSave& drawing);

}  // namespace dapple
