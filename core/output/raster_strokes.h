#pragma once
// Strokes as pixels, as core/output/raster.h has it for dots: a pixel's coverage is the share of its sample
// points that a pen of that width, with round ends, has gone over.

#include "core/output/raster.h"
#include "core/strokes/strokes.h"

namespace dapple {

/// Draws the page in bands as rasterise() does of dots; request.dots_at_once is of lines here, 32 bytes each,
/// and the radius has no say.
void rasterise(const StrokeStream& strokes, const PageSize& page, const RasterRequest& request,
               const CoverageSink& sink);

/// The same for strokes of several pens, so many: a coverage for each.
void rasterise_pens(const StrokeStream& strokes, const PageSize& page, const RasterRequest& request,
                    std::size_t pens, const PenCoverageSink& sink);

/// All bands in one.
Grid<float> coverage_of(const StrokeStream& strokes, const PageSize& page, const RasterRequest& request);

}  // namespace dapple
