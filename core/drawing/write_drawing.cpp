#include "core/drawing/write_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/drawing/drawing.h"
#include "core/output/ink.h"
#include "core/output/pen_figures.h"
#include "core/output/plotting_time.h"
#include "core/output/raster.h"
#include "core/strokes/strokes.h"
#include "core/text/number_words.h"

namespace dapple {

GcodeStyle gcode_style_of(const SavingChoice& saving) {
    const std::string_view text = saving.gcode_template.text.empty()
                                      ? gcode_template_of(saving.tool, saving.dwell_s)
                                      : saving.gcode_template.text;
    const GcodeHeights usual = usual_heights(saving.tool);
    return {.lines = parse_gcode_template(text),
            .feed_mm_per_min = saving.feed_mm_per_min,
            .dwell_s = saving.dwell_s,
            .heights = {saving.pen_up.value_or(usual.up), saving.pen_down.value_or(usual.down)},
            .laser_power = saving.laser_power};
}

void check_heights(const SavingChoice& saving) {
    const GcodeStyle style = gcode_style_of(saving);
    const auto names = [](const std::vector<GcodePiece>& pieces, GcodePiece::Kind kind) {
        return std::ranges::find(pieces, kind, &GcodePiece::kind) != pieces.end();
    };
    const std::vector<GcodePiece>& dot = style.lines.each_dot;
    if (!names(dot, GcodePiece::Kind::up) || !names(dot, GcodePiece::Kind::down)) return;
    if (style.heights.up != style.heights.down) return;
    throw std::runtime_error(fmt::format(
        "the pen is up at {0:g} and down at {0:g}, so it would never be lifted; give it two heights",
        style.heights.up));
}

GcodeProgram program_for(Machine machine, const DrawingToSave& drawing) {
    const SavingChoice& saving = drawing.file.saving;
    const std::vector<CutMark> marks = registration_of(drawing);
    if (drawing.file.format == DrawingFormat::gcode)
        return program_of({.size = drawing.page,
                           .dot_radius_mm = drawing.dot_radius_mm,
                           .pens = drawing.pens,
                           .registration = marks,
                           .gcode = gcode_style_of(saving)},
                          saving.tool, saving.acceleration_mm_per_s2);
    GcodeProgram result{.program = program_of(machine)};
    result.program.registration = marks;
    return result;
}

DrawingFacts::Gcode gcode_facts(const GcodeProgram& gcode, double segments, double drawing_s) {
    DrawingFacts::Gcode facts{.uncounted = gcode.uncounted,
                              .no_time = gcode.no_time,
                              .milliseconds = gcode.is_marlin && gcode.p_of_dwell};
    if (segments > 0 && drawing_s > 0 && gcode.line_bytes > 0) {
        facts.lines_per_s = segments / drawing_s;
        facts.most_lines_per_s = kSerialBaud / 10.0 / gcode.line_bytes;  // ten bits a byte
    }
    return facts;
}

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

namespace {

// Lines and solid blacks on a part of the page: filled where dots are filled circles or pixels, else drawn by
// the darkest pen.
DrawnInking inking_on(const Excerpt& excerpt, const DrawingPlan& plan, const DrawingFile& file) {
    DrawnInking drawn{.shapes = {}, .strokes = {}, .pen = darkest_of(plan.pens)};
    const double unit = excerpt.size.mm_per_page_unit;
    const glm::dvec2 corner = corner_of(excerpt);
    const glm::dvec2 size = glm::dvec2(excerpt.size.width_mm, excerpt.size.height_mm) / unit;
    if (has_pixels(file.format) || (has_colours(file.format) && !draws_strokes(file.settings))) {
        drawn.shapes = shapes_of(*plan.inking, {corner, corner + size}, unit);
    } else if (!is_table(file.format)) {
        const std::vector<double> widths =
            stroke_widths(file.settings.pens, file.settings.pen_width_mm, plan.pens, PenUse::lines);
        const double pen_mm =
            widths.empty() ? file.settings.pen_width_mm : widths[static_cast<std::size_t>(drawn.pen)];
        const Strokes strokes = strokes_of(*plan.inking, pen_mm, unit);
        drawn.strokes = cut_to({corner * unit, (corner + size) * unit}, stream_of(strokes, pen_mm));
    }
    return drawn;
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
    const double radius = std::max(plan.radius(drawing.scale), drawing.radius_mm() / size.mm_per_page_unit);
    DrawingToSave result{.file = file,
                         .dots = drawing.dots(reached(page, file, radius), stop),
                         .page = size,
                         .pens = plan.pens,
                         .dot_radius_mm = drawing.radius_mm(),
                         .cut_marks = page.cut_marks,
                         .picture = Rectangle<double>{-corner, -corner + plan.picture_size()},
                         .tile_size = drawing.tile_size};
    if (plan.inking) result.inking = inking_on(page.part, plan, file);
    if (file.settings.show_tiles) result.tiles = drawing.outlines();
    move_to(page.part.part, result.tiles);
    if (draws_lines(file) && !page.draws_whole())
        result.part_corner_mm = (corner - corner_of(page.whole)) * size.mm_per_page_unit;
    return result;
}

Grid<glm::u8vec3> page_pixels(const DrawingToSave& drawing) {
    const InkPage page = ink_page(drawing);
    const RasterRequest request{.dpi = drawing.file.saving.dpi};
    const RasterSize size = raster_size(page.size, request.dpi);
    Grid<glm::u8vec3> all(size.width, size.height);
    rasterise(page, request, [&](int first_row, std::span<const Grid<float>> coverage) {
        std::ranges::copy(ink_on_paper(coverage, page, drawing.file.settings.paper).values,
                          all.row(first_row));
    });
    return all;
}

double dpi_for(const PageSize& page, int longer_side) {
    return longer_side * kMmPerInch / std::max(page.width_mm, page.height_mm);
}

namespace {

// The comments at the head of a file for a machine, for whoever finds it a year later.

PlottingTime time_for(const DrawingToSave& drawing, const std::optional<StrokeStream>& strokes,
                      const MachineProgram& program) {
    if (strokes) return figures_of(*strokes, program).time;
    const PageSize& page = drawing.page;
    const DotStream& dots = drawing.dots;
    const PlottingTime inking = time_of(drawing.inking, program);
    // More are not placed a second time.
    if (dots.count > kMostSortedDots)
        return inking + expected_plotting_time(static_cast<double>(dots.count),
                                               page.width_mm * page.height_mm, program);
    return inking + plotting_time(dots, page.mm_per_page_unit, program);
}

// Its dots and its page, where the origin is, and how long the machine takes for the strokes, or for the
// dots, in the order in which they come.
std::vector<std::string> machine_comments(const DrawingToSave& drawing,
                                          const std::optional<StrokeStream>& strokes) {
    const SavingChoice& saving = drawing.file.saving;
    const Machine machine = saving.machine.value_or(usual_machine(drawing.file.format, saving.tool));
    const PlottingTime time = time_for(drawing, strokes, program_for(machine, drawing).program);
    const std::string by = drawing.pens.size() == 1 ? " by the pen " + drawing.pens[0].name : "";
    return {fmt::format("{} dots{} on a page of {:.4g} x {:.4g} mm", grouped(drawing.dots.count), by,
                        drawing.page.width_mm, drawing.page.height_mm),
            "0 0 is the lower left corner of the page",
            fmt::format("{} on {}", time_in_words(time.total_s()), words_for(machine))};
}

}  // namespace

std::vector<CutMark> registration_of(const DrawingToSave& drawing) {
    if (!drawing.file.settings.registration || drawing.pens.empty()) return {};
    return registration_marks(drawing.page);
}

InkPage ink_page(const DrawingToSave& drawing) {
    const auto& [path, format, settings, saving, embedded] = drawing.file;
    InkPage page{.size = drawing.page,
                 .dots = drawing.dots,
                 .strokes = strokes_of(drawing),
                 .dot_radius_mm = drawing.dot_radius_mm,
                 .inking = drawing.inking,
                 .ink = settings.ink,
                 .pens = drawing.pens,
                 .registration = registration_of(drawing),
                 .tiles = drawing.tiles,
                 .picture = drawing.picture,
                 .cut_marks = drawing.cut_marks,
                 .tile_size = drawing.tile_size,
                 .figure8 = settings.placer == PlacerKind::figure8,
                 .settings = embedded};
    if (page.strokes) page.inking.strokes = {};  // they are among these
    if (settings.background) page.background = settings.paper;
    const bool gcode = format == DrawingFormat::gcode;
    if (gcode) {
        check_heights(saving);
        page.gcode = gcode_style_of(saving);
    }
    // In a template of one's own they may begin otherwise.
    if (is_touched(format) && !(gcode && !saving.gcode_template.text.empty()))
        page.comments = machine_comments(drawing, page.strokes);
    return page;
}

}  // namespace dapple
