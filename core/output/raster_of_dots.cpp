#include "core/output/raster_of_dots.h"

#include "core/output/raster.h"
#include "core/text/length.h"

namespace dapple {

Grid<float> raster_of_dots(std::span<const glm::dvec2> dots, double radius, const PixelPage& page) {
    Dots columns;
    columns.reserve(dots.size(), false);
    for (const glm::dvec2 dot : dots) {
        columns.x.push_back(float(dot.x));
        columns.y.push_back(float(dot.y));
    }
    // A millimetre is a pixel.
    const PageSize size{double(page.width), double(page.height), page.pixels_per_unit};
    return coverage_of(stream_of(columns), size,
                       {.dot_radius_mm = radius * page.pixels_per_unit, .dpi = kMmPerInch, .threads = 0});
}

}  // namespace dapple
