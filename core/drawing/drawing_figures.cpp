#include "core/drawing/drawing_figures.h"

#include <algorithm>

#include "core/drawing/gcode_choice.h"
#include "core/output/gcode.h"

namespace dapple {

DotsAs dots_as(const DrawingSettings& settings, const SavingChoice& saving, DrawingFormat format) {
    if (is_table(format)) return DotsAs::listed;
    if (!is_plotted(format)) return DotsAs::printed;
    if (settings.style != DrawingStyle::dots) return DotsAs::lines;
    const DotShape shape = mark_in(settings, saving, format).shape;
    if (shape == DotShape::point) return DotsAs::touches;
    if (shape != DotShape::circle) return DotsAs::shapes;
    return is_touched(format) ? DotsAs::touches : DotsAs::rings;
}

InkedDot inked_dot(const DrawingSettings& settings, DrawingFormat format, const DrawingToSave& drawing) {
    InkedDot ink{.as = dots_as(settings, drawing.saving, format),
                 .radius_mm = drawing.dot_radius_mm,
                 .stroke_width_mm = settings.pen_width_mm};
    ink.widths_mm = stroke_widths(settings.pens, settings.pen_width_mm, drawing.pens,
                                  ink.as == DotsAs::touches ? PenUse::touches : PenUse::lines);
    if (ink.as == DotsAs::printed) {
        // What a pen would draw is printed as wide as its lines.
        if (settings.style != DrawingStyle::dots) ink.radius_mm = widest_stroke(settings) / 2;
        return ink;
    }
    const bool circles = !draws_strokes(settings);
    if (circles && ink.as == DotsAs::touches && settings.dot_size.sizing != DotSizing::automatic) {
        ink.stroke_width_mm = 2 * drawing.dot_radius_mm;
        if (!have_widths(settings.pens)) ink.widths_mm.clear();
    }
    return ink;
}

DrawingFacts facts_of(const DrawingSettings& settings, const SavingChoice& saving, DrawingFormat format,
                      const DrawingToSave& drawing) {
    DrawingFacts facts{.dots = drawing.dots.count,
                       .ink = inked_dot(settings, format, drawing),
                       .is_svg = format == DrawingFormat::svg,
                       .has_margins = settings.page.margins.value_or(Margins{}) != Margins{},
                       .page = drawing.page};
    if (has_pixels(format)) facts.dpi = drawing.saving.dpi;
    if (format == DrawingFormat::hpgl) facts.reach_mm = kHpglReachMm;
    if (is_plotted(format)) facts.machine = saving.machine.value_or(usual_machine(format, saving.tool));
    if (format == DrawingFormat::gcode) {
        const bool built_in = saving.gcode_template.text.empty();
        const bool touches = facts.ink.as == DotsAs::touches;
        if (built_in && touches && bursts_move(saving.tool, saving.dwell_s))
            facts.burst_s = saving.dwell_s;
        else if (built_in && (touches || saving.tool == GcodeTool::servo))
            facts.dwell_s = saving.dwell_s;
    }
    // Dots of a size for the picture's tone, touched by a pen of another.
    const bool automatic = settings.dot_size.sizing == DotSizing::automatic && !draws_strokes(settings);
    if (automatic && facts.ink.as == DotsAs::touches && facts.ink.widths_mm.empty()) {
        const double times = 2 * drawing.dot_radius_mm / facts.ink.stroke_width_mm;
        facts.for_tone = {static_cast<double>(facts.dots) * times * times, drawing.dot_radius_mm};
    }
    facts.has_tile_layer = facts.is_svg && !drawing.tiles.empty();
    facts.has_background = facts.is_svg && settings.background;
    return facts;
}

namespace {

std::optional<DrawingFacts::Tone> tone_reached(const DrawingPlan& plan, double scale,
                                               const DrawingSettings& settings) {
    const bool discs = settings.style == DrawingStyle::dots && is_disc(settings.mark.shape);
    if (plan.size.sizing != DotSizing::fixed || !discs) return std::nullopt;
    return DrawingFacts::Tone{plan.dots_for_tone(),
                              plan.radius_for_its_tone(scale) * plan.page.mm_per_page_unit};
}

// How long a machine takes for dots, or for what is drawn of them.
PlottingTime time_of(const DotStream& dots, const InkedDot& ink, const PageSize& page,
                     const MachineProgram& program) {
    if (ink.as == DotsAs::rings)
        return plotting_time_of_rings(dots, page.mm_per_page_unit, ink.radius_mm, program);
    return plotting_time(dots, page.mm_per_page_unit, program);
}

// The time that the machine takes, and the strokes if dots are drawn with some.
void add_plotting(DrawingFigures& figures, DrawingFacts& facts, const LaidOutDrawing& laid_out) {
    const DrawingFile& file = laid_out.file;
    const PageSize& page = laid_out.page.part.size;
    const GcodeProgram gcode = program_for(figures.machine, file.format, file.settings, laid_out.drawing);
    if (!laid_out.by_pen) {
        facts.plotting = expected_plotting_time(static_cast<double>(laid_out.drawing.dots.count),
                                                page.width_mm * page.height_mm, gcode.program);
    } else if (const auto strokes = strokes_of(file.settings, laid_out.drawing, file.format)) {
        figures.strokes = figures_of(*strokes, gcode.program);
        facts.plotting = figures.strokes->time;
        if (file.settings.style == DrawingStyle::line) facts.longest_link_mm = figures.strokes->longest_mm;
    } else {
        facts.plotting = time_of(stream_of(*laid_out.by_pen), facts.ink, page, gcode.program);
    }
    figures.plotting = facts.plotting;
    facts.gcode = gcode_facts(gcode, figures.strokes ? static_cast<double>(figures.strokes->segments) : 0,
                              facts.plotting.drawing_s);
}

// The same for each of several pens, and how even their dots are.
void add_pens(DrawingFigures& figures, DrawingFacts& facts, const LaidOutDrawing& laid_out) {
    const DrawingFile& file = laid_out.file;
    const PageSize& page = laid_out.page.part.size;
    const Palette& pens = laid_out.plan.pens;
    const MachineProgram program =
        program_for(figures.machine, file.format, file.settings, laid_out.drawing).program;
    figures.by_pen = pen_figures(*laid_out.by_pen, page, pens);
    const auto strokes = strokes_of(file.settings, laid_out.drawing, file.format);
    for (std::size_t i = 0; i < figures.by_pen.size(); ++i) {
        PenFigures& own = figures.by_pen[i];
        own.time = strokes ? figures_of(only(*strokes, own.pen), program).time
                           : time_of(stream_of(laid_out.by_pen->pieces[i]), facts.ink, page, program);
        const Pen& pen = pens[static_cast<std::size_t>(own.pen)];
        facts.pens.push_back({pen.name, own.dots, pen.gap_mm, own.nearer_than_gap});
    }
    if (!laid_out.page.draws_whole()) return;
    const PagePart& part = laid_out.page.part.part;
    figures.evenness = pen_evenness(*laid_out.by_pen, {part.across.offset, part.down.offset},
                                    laid_out.plan.by_pen, laid_out.drawing.dots.scale);
}

}  // namespace

DrawingFigures figures_of(const LaidOutDrawing& laid_out) {
    const auto& [plan, file, page, drawing, by_pen] = laid_out;
    DrawingFigures figures;
    DrawingFacts facts = facts_of(file.settings, file.saving, file.format, drawing);
    facts.whole_page = page.draws_whole();
    if (by_pen) {
        const InkedDot& ink = facts.ink;
        const Dots inked = inked_dots(stream_of(*by_pen), ink, page.part.size);
        const Excerpt& excerpt = placed_on(page, file);
        const PageLayout& layout = page.layout;
        const Rectangle<double> paper{{0, 0}, {layout.page.width_mm, layout.page.height_mm}};
        facts.measured = preflight(inked, excerpt.size, ink.reach_mm(ink.radius_mm, 0),
                                   seen_from(excerpt, layout, layout.within_margins), glm::dvec2(0),
                                   seen_from(excerpt, layout, paper));
        figures.preflight = facts.measured;
    }
    figures.machine = facts.machine.value_or(figures.machine);
    if (facts.machine) add_plotting(figures, facts, laid_out);
    if (by_pen && !plan.pens.empty()) add_pens(figures, facts, laid_out);
    if (const auto tone = tone_reached(plan, drawing.dots.scale, file.settings)) facts.for_tone = tone;
    figures.findings = findings_of(facts);
    return figures;
}

}  // namespace dapple
