#include "core/drawing/page_pixels.h"

#include <algorithm>

#include "core/output/raster.h"
#include "core/output/raster_strokes.h"
#include "core/text/length.h"

namespace dapple {

namespace {

// The pixels of a drawing with one pen, or with several.
template <class Ink>
Grid<glm::u8vec3> pixels_of(const DrawingSettings& settings, const Ink& ink, std::span<const Pen> pens,
                            const PageSize& page, const RasterRequest& request) {
    if (pens.empty()) return ink_on_paper(coverage_of(ink, page, request), settings.ink, settings.paper);
    const RasterSize size = raster_size(page, request.dpi);
    Grid<glm::u8vec3> all(size.width, size.height);
    rasterise_pens(ink, page, request, pens.size(),
                   [&](int first_row, std::span<const Grid<float>> coverage) {
                       const auto band = ink_on_paper(coverage, pens, settings.paper);
                       std::ranges::copy(band.values, &all.at(0, first_row));
                   });
    return all;
}

}  // namespace

Grid<glm::u8vec3> page_pixels(const DrawingSettings& settings, const DrawingToSave& drawing) {
    if (const auto strokes = strokes_of(settings, drawing, DrawingFormat::png))
        return page_pixels(settings, *strokes, drawing.pens, drawing.page, drawing.saving.dpi);
    return pixels_of(settings, drawing.dots, drawing.pens, drawing.page,
                     {.dot_radius_mm = drawing.dot_radius_mm, .dpi = drawing.saving.dpi});
}

Grid<glm::u8vec3> page_pixels(const DrawingSettings& settings, const StrokeStream& strokes,
                              std::span<const Pen> pens, const PageSize& page, double dpi) {
    return pixels_of(settings, strokes, pens, page, {.dpi = dpi});
}

double dpi_for(const PageSize& page, int longer_side) {
    return longer_side * kMmPerInch / std::max(page.width_mm, page.height_mm);
}

}  // namespace dapple
