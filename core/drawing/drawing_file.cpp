#include "core/drawing/drawing_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace dapple {
namespace {

// Lines from dot to dot, which go on over the edges of a part.
bool draws_lines(const DrawingFile& file) {
    return file.settings.style != DrawingStyle::dots && !is_table(file.format);
}

glm::dvec2 corner_of(const Excerpt& excerpt) {
    return {excerpt.part.across.offset, excerpt.part.down.offset};
}

// The part that dots are placed for: what is seen shows the part of a dot that reaches over from beside it.
PagePart reached(const DrawnPage& page, const DrawingFile& file, double radius) {
    const PagePart& part = placed_on(page, file).part;
    const bool reach_over = has_colours(file.format) && !page.draws_whole() && !draws_lines(file);
    return reach_over ? widened(part, radius) : part;
}

}  // namespace

DrawnPage drawn_page(const PageLayout& layout, const Sheet& sheet) {
    const glm::dvec2 corner = layout.picture.low;
    return {layout, sheet_of(layout.page, {}, corner), sheet_of(layout.page, sheet, corner),
            cut_marks(layout.page, sheet)};
}

DrawnPage drawn_page(const PageLayout& layout, const SavingChoice& saving) {
    DrawnPage page = drawn_page(layout);
    if (!saving.region) return page;
    const glm::dvec2 size = saving.region->size();
    if (std::min(size.x, size.y) < kShortestSideMm)
        throw std::runtime_error(fmt::format("{:g} x {:g} mm is too small; give {:g} mm or more", size.x,
                                             size.y, kShortestSideMm));
    page.part = region_of(layout.page, *saving.region, layout.picture.low);
    return page;
}

Rectangle<double> seen_from(const Excerpt& excerpt, const PageLayout& layout,
                            const Rectangle<double>& on_page) {
    const glm::dvec2 corner = layout.picture.low + corner_of(excerpt) * layout.page.mm_per_page_unit;
    return {on_page.low - corner, on_page.high - corner};
}

const Excerpt& placed_on(const DrawnPage& page, const DrawingFile& file) {
    return draws_lines(file) ? page.whole : page.part;
}

bool needs_thresholds(const DrawingFile& file) {
    return is_table(file.format) ||
           (has_order(file.format, file.settings.style) && file.saving.order == DotOrder::priority);
}

DrawingToSave drawing_on(const DrawnPage& page, const PlannedDrawing& drawing, const DrawingFile& file,
                         const std::stop_token& stop) {
    const DrawingPlan& plan = drawing.plan;
    const PageSize& size = page.part.size;
    const glm::dvec2 corner = corner_of(page.part);
    const double longer = std::max(plan.pixels.x, plan.pixels.y);
    DrawingToSave result{.dots = drawing.dots(reached(page, file, plan.radius(drawing.scale)), stop),
                         .page = size,
                         .pens = plan.pens,
                         .dot_radius_mm = drawing.radius_mm(),
                         .cut_marks = page.cut_marks,
                         .picture = Rectangle<double>{-corner, -corner + glm::dvec2(plan.pixels) / longer},
                         .tile_size = drawing.tile_size,
                         .saving = file.saving,
                         .format = file.format,
                         .settings = file.embedded};
    if (file.settings.show_tiles) result.tiles = drawing.outlines();
    move_to(page.part.part, result.tiles);
    if (draws_lines(file) && !page.draws_whole())
        result.part_corner_mm = (corner - corner_of(page.whole)) * size.mm_per_page_unit;
    return result;
}

}  // namespace dapple
