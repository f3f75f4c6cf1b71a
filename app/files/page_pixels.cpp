#include "app/files/page_pixels.h"

#include <algorithm>

#include "core/output/raster.h"
#include "core/output/raster_strokes.h"
#include "core/text/length.h"

namespace dapple {

Grid<glm::u8vec3> page_pixels(const DrawingSettings& settings, const DrawingToSave& drawing) {
    if (const auto strokes = strokes_of(settings, drawing, DrawingFormat::png))
        return page_pixels(settings, *strokes, drawing.page, drawing.dpi);
    const RasterRequest request{.dot_radius_mm = drawing.dot_radius_mm, .dpi = drawing.dpi};
    return ink_on_paper(coverage_of(drawing.dots, drawing.page, request), settings.ink, settings.paper);
}

Grid<glm::u8vec3> page_pixels(const DrawingSettings& settings, const StrokeStream& strokes,
                              const PageSize& page, double dpi) {
    return ink_on_paper(coverage_of(strokes, page, {.dpi = dpi}), settings.ink, settings.paper);
}

double dpi_for(const PageSize& page, int longer_side) {
    return longer_side * kMmPerInch / std::max(page.width_mm, page.height_mm);
}

}  // namespace dapple
