#pragma once
// What is known of a drawing before it is plotted, for the command and the window alike: see
// core/output/findings.h.

#include "core/drawing/drawing.h"
#include "core/drawing/settings.h"
#include "core/output/findings.h"

namespace dapple {

/// How such a file brings the dots onto the paper.
DotsAs dots_as(const DrawingSettings& settings, const SavingChoice& saving, DrawingFormat format);

/// How far the ink of its dots reaches. Where a machine touches the paper and nothing says how large dots
/// are, they are as wide as the pen's line.
InkedDot inked_dot(const DrawingSettings& settings, DrawingFormat format, const DrawingToSave& drawing);

/// All that follows from the settings. Left to whoever has the dots: what is measured, the plotting time, the
/// pens, and the tone of dots of a size of their own.
DrawingFacts facts_of(const DrawingSettings& settings, const SavingChoice& saving, DrawingFormat format,
                      const DrawingToSave& drawing);

}  // namespace dapple
