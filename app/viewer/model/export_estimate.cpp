#include "app/viewer/model/export_estimate.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <glm/vec4.hpp>
#include <random>

#include "core/drawing/drawing_figures.h"
#include "core/drawing/write_drawing.h"
#include "core/output/pen_figures.h"
#include "core/routing/short_way.h"
#include "io/files/file_size.h"

namespace dapple {
namespace {

constexpr std::size_t kSample = 8000;             // dots of a pen whose way is found,
constexpr std::size_t kMostSorted = 1'000'000;    // of at most so many that are sorted for it
constexpr std::size_t kMostInOrder = 20'000;      // which are not put in order, but taken as they follow
constexpr std::size_t kRuns = 16;                 // of dots whose way is made shorter, so that there is one,
constexpr std::size_t kRunsInOrder = 64;          // and of those that stay row by row: from all over the page
constexpr std::uint64_t kMostMeasured = 500'000;  // which take no longer than a fifth of a second

// How many dots each pen has, in the order in which they come.
struct PenCount {
    int pen = 0;
    std::size_t dots = 0;
};

std::vector<PenCount> counts_of(const DotStream& dots) {
    std::vector<PenCount> counts;
    dots.for_each_piece([&](const Dots& piece) {
        if (counts.empty() || counts.back().pen != piece.pen) counts.push_back({piece.pen});
        counts.back().dots += piece.size();
        return true;
    });
    return counts;
}

// Some of one pen's dots: `count` at most, from `first` on each `step`-th.
struct Choice {
    std::size_t first = 0, step = 1, count = 0;
};

Dots some_of(const DotStream& dots, int pen, const Choice& choice) {
    Dots some;
    some.pen = pen;
    std::size_t next = choice.first, passed = 0;
    dots.for_each_piece([&](const Dots& piece) {
        if (piece.pen != pen) return true;
        for (; next < passed + piece.size() && some.size() < choice.count; next += choice.step) {
            some.x.push_back(piece.x[next - passed]);
            some.y.push_back(piece.y[next - passed]);
            if (!piece.radius.empty()) some.radius.push_back(piece.radius[next - passed]);
        }
        passed += piece.size();
        return some.size() < choice.count;
    });
    return some;
}

void shuffle(Dots& dots) {
    std::mt19937 random(1);
    for (std::size_t i = dots.size(); i > 1; --i) {
        const std::size_t k = random() % i;
        std::swap(dots.x[i - 1], dots.x[k]);
        std::swap(dots.y[i - 1], dots.y[k]);
        if (!dots.radius.empty()) std::swap(dots.radius[i - 1], dots.radius[k]);
    }
}

// Those of one pen's dots that are looked at, in the order in which they are plotted: runs that follow each
// other in it, as dots from here and there are less even than all, and so leave more to shorten.
std::vector<Dots> parts_of(const DotStream& dots, const PenCount& own, DotOrder order) {
    const auto each = [&](std::size_t most) { return Choice{0, 1 + own.dots / most, own.dots}; };
    if (order == DotOrder::priority) {
        Dots some = some_of(dots, own.pen, each(kSample));
        shuffle(some);  // dots that follow each other lie anywhere
        return {std::move(some)};
    }
    const auto runs_of = [&](const DotStream& stream, std::size_t count, std::size_t most, std::size_t many) {
        const std::size_t runs = count > most ? many : 1, step = std::max<std::size_t>(count / runs, 1);
        std::vector<Dots> parts;
        for (std::size_t run = 0; run < runs; ++run)
            parts.push_back(some_of(stream, own.pen, {run * step, 1, std::min(step, most / runs)}));
        return parts;
    };
    if (order == DotOrder::recursion) return runs_of(dots, own.dots, kMostInOrder, kRunsInOrder);
    Dots sorted = some_of(dots, own.pen, each(kMostSorted));
    sort_dots(sorted, DotOrder::space);
    const float closer = std::sqrt(static_cast<float>(sorted.size()) / static_cast<float>(own.dots));
    for (FloatBuffer* column : {&sorted.x, &sorted.y})
        for (float& place : *column) place *= closer;
    return runs_of(stream_of(sorted), sorted.size(), kSample, kRuns);
}

std::vector<DrawingFacts::OfPen> pens_of(const PlacedDrawing& drawing, const PageSize& page) {
    std::vector<DrawingFacts::OfPen> pens;
    const DotPieces by_pen = sorted_by_pen(stream_of(drawing.dots), DotOrder::recursion);
    for (const PenFigures& own : pen_figures(by_pen, page, drawing.plan.pens)) {
        const Pen& pen = drawing.plan.pens[static_cast<std::size_t>(own.pen)];
        pens.push_back({pen.name, own.dots, pen.gap_mm, own.nearer_than_gap});
    }
    return pens;
}

DotPieces dots_on(const PagePart& part, const DotPieces& dots) {
    DotPieces some;
    for (const Dots& piece : dots.pieces) cut_to(part, some.pieces.emplace_back(piece));
    return some;
}

// In page units, as it is shown.
double longest_line(const ShownStrokes& strokes) {
    double longest = 0;
    for (const glm::vec4& line : strokes.lines)
        longest = std::max(longest, std::hypot(double(line.z) - line.x, double(line.w) - line.y));
    return longest;
}

void add_time(PlottingTime& sum, const PlottingTime& time, double times, double times_lifting) {
    sum.moving_s += times * time.moving_s;
    sum.lifting_s += times_lifting * time.lifting_s;
    sum.dots_s += times * time.dots_s;
    sum.drawing_s += times * time.drawing_s;
}

}  // namespace

PlottingEstimate estimated_plotting(const DrawingToSave& drawing, DotOrder order,
                                    const MachineProgram& program) {
    PlottingEstimate estimate;
    const InkedDot ink = inked_dot(drawing);
    // What comes once, whatever is drawn, and the rest.
    MachineClock once(program);
    MachineProgram of_dots = program;
    of_dots.end = of_dots.pen = {};
    of_dots.registration.clear();
    of_dots.from_origin = false;
    for (const PenCount& own : counts_of(drawing.dots)) {
        once.take(own.pen);
        std::vector<Dots> parts = parts_of(drawing.dots, own, order);
        std::size_t taken = 0;
        for (const Dots& part : parts) taken += part.size();
        const double unit = drawing.page.mm_per_page_unit;
        const double share = static_cast<double>(own.dots) / std::max(static_cast<double>(taken), 1.0);
        // All dots of a pen are on one line.
        const double lifts =
            drawing.file.settings.style == DrawingStyle::line ? 1 / static_cast<double>(parts.size()) : share;
        for (Dots& part : parts) {
            if (part.size() == 0) continue;
            const auto way_m = [&] { return share * way_length(part.x, part.y) * unit / 1000; };
            estimate.way_before_m += way_m();
            if (order == DotOrder::shortest) shorten_way(part);
            estimate.way_m += way_m();
            DrawingToSave some = drawing;
            some.dots = stream_of(part, drawing.dots.scale);
            PlottingTime time;
            if (const auto strokes = strokes_of(some)) {
                const StrokeFigures figures = figures_of(*strokes, of_dots);
                time = figures.time;
                estimate.segments += share * static_cast<double>(figures.segments);
            } else if (ink.as == DotsAs::rings)
                time = plotting_time_of_rings(some.dots, unit, ink.radius_mm, of_dots);
            else
                time = plotting_time(some.dots, unit, of_dots);
            add_time(estimate.time, time, share, lifts);
        }
    }
    add_time(estimate.time, once.finish(), 1, 1);
    return estimate;
}

ExportInfo ExportEstimate::info(const Pane& pane, const ViewerSettings& settings, DrawingFormat format) {
    EstimateKey key{pane.placings(), format, settings.drawing, settings.saving};
    if (key_ == key) return info_;
    key_ = std::move(key);
    const PlacedDrawing& drawing = pane.page();
    PageSize page = drawing.layout.page;
    info_ = {.dots = drawing.dots.size(), .bytes = {}, .trouble = {}};
    if (!drawing.is_there()) {
        info_.trouble = "There is no drawing to save";
        return info_;
    }
    std::optional<PagePart> region;
    DotPieces on_region;
    if (settings.saving.region && !is_several(settings.drawing.sheets)) {
        try {
            const Excerpt part = drawn_page(drawing.layout, settings.saving).part;
            region = part.part;
            on_region = dots_on(part.part, drawing.dots);
            page = part.size;
        } catch (const std::exception& error) {
            info_.trouble = error.what();
            return info_;
        }
        info_.dots = on_region.size();
    }
    DrawingToSave estimated{
        .file = {.format = format, .settings = settings.drawing, .saving = settings.saving},
        .dots = stream_of(region ? on_region : drawing.dots, drawing.scale),
        .page = page,
        .pens = drawing.plan.pens,
        .dot_radius_mm = drawing.dot_radius_mm(),
        .tile_size = pane.tile_size()};
    if (format == DrawingFormat::svg) estimated.tiles = drawing.outlines;
    if (region) move_to(*region, estimated.tiles);
    const DotOrder order =
        settings.saving.order.value_or(usual_order(format, info_.dots, settings.drawing.style));
    DrawingFacts drawn = facts_of(estimated);
    if (region) drawn.whole_page = false;
    if (const Sheet& sheets = settings.drawing.sheets; is_several(sheets)) {
        drawn.whole_page = false;
        drawn.page.width_mm = page.width_mm / sheets.columns + sheets.overlap_mm;
        drawn.page.height_mm = page.height_mm / sheets.rows + sheets.overlap_mm;
    }
    info_.page = page;
    if (drawn.machine && drawing.settled()) {
        const GcodeProgram gcode = program_for(*drawn.machine, estimated);
        const PlottingEstimate plotting = estimated_plotting(estimated, order, gcode.program);
        info_.plotting = drawn.plotting = plotting.time;
        drawn.gcode = gcode_facts(gcode, plotting.segments, plotting.time.drawing_s);
        info_.way_m = plotting.way_m;
    }
    if (settings.drawing.style == DrawingStyle::line)
        drawn.longest_link_mm = longest_line(drawing.strokes) * page.mm_per_page_unit;
    if (drawing.dots_for_tone > 0) drawn.for_tone = {drawing.dots_for_tone, drawing.radius_for_tone_mm()};
    if (drawing.dots.size() <= kMostMeasured) drawn.measured = measured(pane, drawn.ink);
    if (drawn.measured && !drawing.plan.pens.empty()) drawn.pens = pens_of(drawing, page);
    info_.findings = findings_of(drawn);
    try {
        info_.bytes = estimated_bytes(estimated);
    } catch (const std::exception& error) {
        info_.trouble = error.what();
    }
    return info_;
}

Preflight ExportEstimate::measured(const Pane& pane, const InkedDot& ink) {
    const std::pair key{pane.placings(), ink};
    if (measured_key_ == key) return measured_;
    measured_key_ = key;
    const PlacedDrawing& drawing = pane.page();
    const PageLayout& layout = drawing.layout;
    measured_ = preflight(inked_dots(stream_of(drawing.dots), ink, layout.page), layout.page,
                          ink.reach_mm(ink.radius_mm, 0), layout.within_margins, layout.picture.low);
    return measured_;
}

std::optional<PlottingTime> PlottingClock::time(const Pane& pane, const ViewerSettings& settings) {
    const PlacedDrawing& drawing = pane.page();
    if (!drawing.settled() || drawing.dots.size() == 0) return std::nullopt;
    const DrawingFormat format = DrawingFormat::svg;
    EstimateKey key{pane.placings(), format, settings.drawing, settings.saving};
    if (key_ == key) return time_;
    const DrawingToSave estimated{.file = {.format = format, .settings = settings.drawing},
                                  .dots = stream_of(drawing.dots, drawing.scale),
                                  .page = drawing.layout.page,
                                  .pens = drawing.plan.pens,
                                  .dot_radius_mm = drawing.dot_radius_mm()};
    const DotOrder order =
        settings.saving.order.value_or(usual_order(format, drawing.dots.size(), settings.drawing.style));
    const Machine machine = settings.saving.machine.value_or(usual_machine(format, settings.saving.tool));
    time_ = estimated_plotting(estimated, order, program_of(machine)).time;
    key_ = std::move(key);
    return time_;
}

}  // namespace dapple
