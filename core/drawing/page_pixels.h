#pragma once
// A page as a picture in memory: small ones, to be shown or to be part of a film.

#include "core/drawing/drawing.h"
#include "core/drawing/settings.h"
#include "core/image/grid.h"

namespace dapple {

/// 8 bits a channel, with the settings' ink and paper, of dots in the order given.
Grid<glm::u8vec3> page_pixels(const DrawingSettings& settings, const DrawingToSave& drawing);

/// The same for strokes.
Grid<glm::u8vec3> page_pixels(const DrawingSettings& settings, const StrokeStream& strokes,
                              std::span<const Pen> pens, const PageSize& page, double dpi);

/// The resolution at which a page's longer side has so many pixels.
double dpi_for(const PageSize& page, int longer_side);

}  // namespace dapple
