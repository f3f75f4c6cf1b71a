#pragma once
// A drawing as pixels, the way a PNG has it.

#include "core/drawing/drawing.h"
#include "core/drawing/pipeline.h"
#include "core/drawing/write_drawing.h"

namespace dapple {

/// The whole page, its longer side so many pixels.
inline Grid<glm::u8vec3> drawn_pixels(const DrawingSettings& settings, const DrawingPlan& plan,
                                      const Stippling& drawn, int longer_side) {
    const PageSize page = plan.layout(drawn.scale).page;
    return page_pixels({.file = {.format = DrawingFormat::png,
                                 .settings = settings,
                                 .saving = {.dpi = dpi_for(page, longer_side)}},
                        .dots = stream_of(drawn.dots),
                        .page = page,
                        .pens = plan.pens,
                        .dot_radius_mm = plan.radius_mm(drawn.scale)});
}

}  // namespace dapple
