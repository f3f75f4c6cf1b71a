#include "core/drawing/drawing_figures.h"

#include <algorithm>

#include "core/drawing/write_drawing.h"
#include "core/output/gcode.h"

namespace dapple {

DotsAs dots_as(const DrawingFile& file) {
    if (is_table(file.format)) return DotsAs::listed;
    if (!is_plotted(file.format)) return DotsAs::printed;
    if (file.settings.style != DrawingStyle::dots) return DotsAs::lines;
    const DotShape shape = mark_in(file).shape;
    if (shape == DotShape::point) return DotsAs::touches;
    if (shape != DotShape::circle) return DotsAs::shapes;
    return is_touched(file.format) ? DotsAs::touches : DotsAs::rings;
}

InkedDot inked_dot(const DrawingToSave& drawing) {
    const DrawingSettings& settings = drawing.file.settings;
    InkedDot ink{.as = dots_as(drawing.file),
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

DrawingFacts facts_of(const DrawingToSave& drawing) {
    const auto& [path, format, settings, saving, embedded] = drawing.file;
    DrawingFacts facts{.dots = drawing.dots.count,
                       .ink = inked_dot(drawing),
                       .is_svg = format == DrawingFormat::svg,
                       .has_margins = settings.page.margins.value_or(Margins{}) != Margins{},
                       .page = drawing.page};
    if (has_pixels(format)) facts.dpi = saving.dpi;
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
void add_plotting(DrawingFigures& figures, DrawingFacts& facts, const DrawingToSave& drawing,
                  const DotPieces* by_pen) {
    const PageSize& page = drawing.page;
    const GcodeProgram gcode = program_for(figures.machine, drawing);
    if (!by_pen) {
        facts.plotting = expected_plotting_time(static_cast<double>(drawing.dots.count),
                                                page.width_mm * page.height_mm, gcode.program);
    } else if (const auto strokes = strokes_of(drawing)) {
        figures.strokes = figures_of(*strokes, gcode.program);
        facts.plotting = figures.strokes->time;
        if (drawing.file.settings.style == DrawingStyle::line)
            facts.longest_link_mm = figures.strokes->longest_mm;
    } else {
        facts.plotting = time_of(stream_of(*by_pen), facts.ink, page, gcode.program) +
                         time_of(drawing.inking, gcode.program);
    }
    figures.plotting = facts.plotting;
    facts.gcode = gcode_facts(gcode, figures.strokes ? static_cast<double>(figures.strokes->segments) : 0,
                              facts.plotting.drawing_s);
}

// The same for each of several pens.
void add_pens(DrawingFigures& figures, DrawingFacts& facts, const DrawingToSave& drawing,
              const DotPieces& by_pen) {
    const PageSize& page = drawing.page;
    const MachineProgram program = program_for(figures.machine, drawing).program;
    figures.by_pen = pen_figures(by_pen, page, drawing.pens);
    const auto strokes = strokes_of(drawing);
    for (std::size_t i = 0; i < figures.by_pen.size(); ++i) {
        PenFigures& own = figures.by_pen[i];
        own.time = strokes ? figures_of(only(*strokes, own.pen), program).time
                           : time_of(stream_of(by_pen.pieces[i]), facts.ink, page, program);
        if (!strokes && own.pen == drawing.inking.pen) own.time = own.time + time_of(drawing.inking, program);
        const Pen& pen = drawing.pens[static_cast<std::size_t>(own.pen)];
        facts.pens.push_back({pen.name, own.dots, pen.gap_mm, own.nearer_than_gap});
    }
}

}  // namespace

DrawingFigures figures_of(const DrawingPlan& plan, const DrawnPage& page, const DrawingToSave& drawing,
                          const DotPieces* by_pen) {
    DrawingFigures figures;
    DrawingFacts facts = facts_of(drawing);
    facts.whole_page = page.draws_whole();
    if (by_pen) {
        const InkedDot& ink = facts.ink;
        const Dots inked = inked_dots(stream_of(*by_pen), ink, drawing.page);
        const Excerpt& excerpt = placed_on(page, drawing.file);
        const PageLayout& layout = page.layout;
        const Rectangle<double> paper{{0, 0}, {layout.page.width_mm, layout.page.height_mm}};
        facts.measured = preflight(inked, excerpt.size, ink.reach_mm(ink.radius_mm, 0),
                                   seen_from(excerpt, layout, layout.within_margins), glm::dvec2(0),
                                   seen_from(excerpt, layout, paper));
        figures.preflight = facts.measured;
    }
    figures.machine = facts.machine.value_or(figures.machine);
    if (facts.machine) add_plotting(figures, facts, drawing, by_pen);
    if (by_pen && !drawing.pens.empty()) {
        add_pens(figures, facts, drawing, *by_pen);
        const PagePart& part = page.part.part;
        if (page.draws_whole())
            figures.evenness = pen_evenness(*by_pen, {part.across.offset, part.down.offset}, plan.by_pen,
                                            drawing.dots.scale);
    }
    if (const auto tone = tone_reached(plan, drawing.dots.scale, drawing.file.settings))
        facts.for_tone = tone;
    figures.findings = findings_of(facts);
    return figures;
}

}  // namespace dapple
