#pragma once
// The comments at the head of a file for a machine, for whoever finds it a year later.

#include <optional>
#include <string>
#include <vector>

#include "core/drawing/drawing.h"
#include "core/strokes/strokes.h"

namespace dapple {

/// Its dots and its page, where the origin is, and how long the machine takes for the strokes, or for the
/// dots, in the order in which they come.
std::vector<std::string> machine_comments(const DrawingSettings& settings, const DrawingToSave& drawing,
                                          const std::optional<StrokeStream>& strokes, DrawingFormat format);

}  // namespace dapple
