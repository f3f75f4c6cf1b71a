#include "app/commands/render_figures.h"

#include <optional>

#include "core/drawing/drawing_facts.h"
#include "core/drawing/gcode_choice.h"
#include "core/image/ink_use.h"
#include "core/output/raster.h"

namespace dapple {
namespace {

std::optional<DrawingFacts::Tone> tone_reached(const DrawingPlan& plan, double scale,
                                               const DrawingSettings& settings) {
    const bool discs = settings.style == DrawingStyle::dots && is_disc(settings.mark.shape);
    if (plan.size.sizing != DotSizing::fixed || !discs) return std::nullopt;
    return DrawingFacts::Tone{plan.dots_for_tone(),
                              plan.radius_for_its_tone(scale) * plan.page.mm_per_page_unit};
}

// How long a machine takes for dots, or for what is drawn of them.
PlottingTime time_of(const Dots& dots, const InkedDot& ink, const PageSize& page,
                     const MachineSpeeds& speeds) {
    if (ink.as == DotsAs::rings)
        return plotting_time_of_rings(dots, page.mm_per_page_unit, ink.radius_mm, speeds);
    return plotting_time(dots, page.mm_per_page_unit, speeds);
}

Dots one_after_the_other(const DotPieces& by_pen) {
    Dots all;
    for (const Dots& own : by_pen.pieces) append(all, own);
    return all;
}

// The time that the machine takes, and the strokes if dots are drawn with some.
void add_plotting(Rendered& rendered, DrawingFacts& facts, const SavedDrawing& saved,
                  const RenderOptions& options) {
    const PageSize& page = saved.page.part.size;
    const MachineSpeeds speeds = speeds_for(rendered.machine, saved.from.file.format, options.saving);
    if (!saved.by_pen) {
        facts.plotting = expected_plotting_time(static_cast<double>(saved.dots.count),
                                                page.width_mm * page.height_mm, speeds);
    } else if (const auto strokes = strokes_of(options.drawing, saved.drawing, saved.from.file.format)) {
        rendered.strokes = figures_of(*strokes, speeds);
        facts.plotting = rendered.strokes->time;
        if (options.drawing.style == DrawingStyle::line) facts.longest_link_mm = rendered.strokes->longest_mm;
    } else {
        facts.plotting = time_of(one_after_the_other(*saved.by_pen), facts.ink, page, speeds);
    }
    rendered.plotting = facts.plotting;
}

// The same for each of several pens, and how even their dots are.
void add_pens(Rendered& rendered, DrawingFacts& facts, const SavedDrawing& saved,
              const RenderOptions& options) {
    const PageSize& page = saved.page.part.size;
    const MachineSpeeds speeds = speeds_for(rendered.machine, saved.from.file.format, options.saving);
    rendered.pens = saved.from.plan.pens;
    rendered.by_pen = pen_figures(*saved.by_pen, page, saved.from.plan.pens, speeds);
    const auto strokes = strokes_of(options.drawing, saved.drawing, saved.from.file.format);
    for (std::size_t i = 0; i < rendered.by_pen.size(); ++i) {
        PenFigures& own = rendered.by_pen[i];
        own.time = strokes ? figures_of(only(*strokes, own.pen), speeds).time
                           : time_of(saved.by_pen->pieces[i], facts.ink, page, speeds);
        const Pen& pen = saved.from.plan.pens[static_cast<std::size_t>(own.pen)];
        facts.pens.push_back({pen.name, own.dots, pen.gap_mm, own.nearer_than_gap});
    }
    if (!draws_whole_page(options)) return;
    const PagePart& part = saved.page.part.part;
    rendered.evenness = pen_evenness(*saved.by_pen, {part.across.offset, part.down.offset},
                                     saved.from.plan.by_pen, saved.dots.scale);
}

}  // namespace

Rendered figures_of(const SavedDrawing& saved, const RenderOptions& options) {
    const DrawingSettings& settings = options.drawing;
    const DrawingPlan& plan = saved.from.plan;
    const Excerpt& part = saved.page.part;
    DrawingFacts facts = facts_of(settings, options.saving, saved.from.file.format, saved.drawing);
    facts.whole_page = draws_whole_page(options);
    Rendered rendered{.width = saved.picture.x,
                      .height = saved.picture.y,
                      .mean_density = plan.density->mean(),
                      .tone = plan.tone,
                      .steps = plan.steps,
                      .dots = saved.dots.count,
                      .scale = saved.dots.scale,
                      .page = part.size,
                      .whole_page = saved.page.layout.page,
                      .picture = saved.page.layout.picture,
                      .radius_mm = saved.drawing.dot_radius_mm,
                      .mostly_black = mostly_black(*plan.histogram, plan.tone)};
    // Where on the page Figure 8's duplicates lie is not known.
    if (saved.dots.duplicates == 0 || facts.whole_page) rendered.duplicates = saved.dots.duplicates;
    if (has_pixels(saved.from.file.format)) {
        const RasterSize size = raster_size(part.size, options.saving.dpi);
        rendered.pixels = {size.width, size.height};
    }
    if (saved.by_pen) {
        const InkedDot& ink = facts.ink;
        const Dots inked = inked_dots(stream_of(*saved.by_pen), ink, part.size);
        const Excerpt& excerpt = placed_on(saved.page, saved.from.file);
        const PageLayout& layout = saved.page.layout;
        const Rectangle<double> paper{{0, 0}, {layout.page.width_mm, layout.page.height_mm}};
        facts.measured = preflight(inked, excerpt.size, ink.reach_mm(ink.radius_mm, 0),
                                   seen_from(excerpt, layout, layout.within_margins), glm::dvec2(0),
                                   seen_from(excerpt, layout, paper));
        rendered.preflight = facts.measured;
    }
    rendered.machine = facts.machine.value_or(rendered.machine);
    if (facts.machine) add_plotting(rendered, facts, saved, options);
    if (saved.by_pen && !plan.pens.empty()) add_pens(rendered, facts, saved, options);
    if (const auto tone = tone_reached(plan, saved.dots.scale, settings)) facts.for_tone = tone;
    rendered.findings = findings_of(facts);
    return rendered;
}

}  // namespace dapple
