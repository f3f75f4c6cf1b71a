#pragma once
// A drawing as text: every kind of file that needs no library. PDF and pixels are written by app/files, which
// has the libraries for them.

#include <ostream>

#include "core/drawing/drawing.h"
#include "core/output/progress.h"

namespace dapple {

/// Whether write_text_drawing() writes it.
bool is_text(DrawingFormat format);

/// Into the stream, the dots in the order they come in. Throws if the format cannot hold such a drawing.
void write_text_drawing(std::ostream& out, DrawingFormat format, const DrawingSettings& settings,
                        const DrawingToSave& drawing, const WritingProgress& progress = {});

/// The crosses that each of several pens draws, if the settings ask for them.
std::vector<CutMark> registration_of(const DrawingSettings& settings, const DrawingToSave& drawing);

}  // namespace dapple
