#include "core/drawing/drawing_file.h"

#include <algorithm>
#include <utility>

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

DrawnPage drawn_region(const PageLayout& layout, const Rectangle<double>& region) {
    const glm::dvec2 corner = layout.picture.low;
    return {layout, sheet_of(layout.page, {}, corner), region_of(layout.page, region, corner), {}};
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

std::optional<DotsForFile> dots_for(const DrawingFile& file, Pipeline& pipeline, DrawingPlan plan,
                                    const std::stop_token& stop) {
    std::optional<PlannedDots> dots = pipeline.dots(plan, stop);
    if (!dots) return std::nullopt;
    DotsForFile result{.file = file,
                       .plan = std::move(plan),
                       .dots = std::move(*dots),
                       .outlines = {},
                       .tile_size = pipeline.tile().tile().size()};
    if (file.settings.show_tiles) result.outlines = pipeline.outlines(result.plan, result.dots.scale);
    return result;
}

DrawingToSave drawing_on(const DrawnPage& page, const DotsForFile& dots, const std::stop_token& stop) {
    const DrawingFile& file = dots.file;
    const DrawingPlan& plan = dots.plan;
    const PageSize& size = page.part.size;
    const glm::dvec2 corner = corner_of(page.part);
    DrawingToSave drawing{
        .dots = dots.dots.on(reached(page, file, plan.radius(dots.dots.scale)), stop),
        .page = size,
        .pens = plan.pens,
        .dot_radius_mm = dots.radius_mm(),
        .tiles = dots.outlines,
        .cut_marks = page.cut_marks,
        .picture = Rectangle<double>{-corner,
                                     -corner + glm::dvec2(plan.pixels) / static_cast<double>(std::max(
                                                                             plan.pixels.x, plan.pixels.y))},
        .tile_size = dots.tile_size,
        .saving = file.saving,
        .format = file.format,
        .settings = file.embedded};
    move_to(page.part.part, drawing.tiles);
    if (draws_lines(file) && !page.draws_whole())
        drawing.part_corner_mm = (corner - corner_of(page.whole)) * size.mm_per_page_unit;
    return drawing;
}

}  // namespace dapple
