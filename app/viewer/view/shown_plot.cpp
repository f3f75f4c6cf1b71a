#include "app/viewer/view/shown_plot.h"

#include <algorithm>
#include <utility>

#include "io/files/save_drawing.h"

namespace dapple {

void ShownPlot::prepare(std::uint64_t placing, const PlacedDrawing& page, const DrawingSettings& settings,
                        const SavingChoice& saving) {
    while (auto found = finding_.result()) {
        if (begun_ != asked_) continue;  // of a drawing that is gone
        film_ = std::move(*found);
        ++films_;
    }
    if (!page.settled()) return;
    const auto has_no_priority = [](const Dots& piece) { return piece.critical.size() < piece.size(); };
    if (saving.order == DotOrder::priority && std::ranges::any_of(page.dots.pieces, has_no_priority))
        return;  // dots that have are on their way
    Asked asked{placing, settings, saving.machine.value_or(usual_machine(DrawingFormat::svg, saving.tool)),
                saving.order};
    if (asked_ != asked) {
        asked_ = std::move(asked);
        film_.reset();
        finding_.stop();
    }
    if (finding_.busy() || begun_ == asked_) return;
    begun_ = asked_;
    finding_.begin([dots = page.dots, pens = page.plan.pens, sheet = page.layout.page,
                    radius_mm = page.dot_radius_mm(),
                    what = *asked_](const auto& task) -> std::optional<Found> {
        const DotOrder order =
            what.order.value_or(usual_order(DrawingFormat::svg, dots.size(), what.settings.style));
        const DotPieces sorted = sorted_by_pen(stream_of(dots), order, {.stop = task.stop(), .progress = {}});
        if (task.stop().stop_requested()) return std::nullopt;
        const double unit = sheet.mm_per_page_unit;
        const MachineProgram program = program_of(what.machine);
        Found found{.plot = {},
                    .pens = pens,
                    .mm_per_page_unit = unit,
                    .pen_width_mm = what.settings.pen_width_mm,
                    .pen_widths_mm = stroke_widths(what.settings.pens, what.settings.pen_width_mm, pens,
                                                   pen_use(what.settings))};
        const DrawingToSave drawing{.file = {.settings = what.settings},
                                    .dots = stream_of(sorted),
                                    .page = sheet,
                                    .pens = pens,
                                    .dot_radius_mm = radius_mm};
        if (const auto strokes = strokes_of(drawing))
            found.plot = plot_film(collected(*strokes), program);
        else
            found.plot = plot_film(sorted, unit, program);
        return found;
    });
}

PlacedDrawing ShownPlot::drawn(const PlacedDrawing& page, std::size_t count) const {
    PlacedDrawing now;
    now.plan = page.plan;
    if (!film_) return now;
    now.plan.pens = film_->pens;
    const PlotFilm& plot = film_->plot;
    if (!plot.strokes.points.empty()) {
        const Strokes strokes = first_points(plot.strokes, count);
        StrokeStream stream = stream_of(strokes, film_->pen_width_mm);
        stream.widths_mm = film_->pen_widths_mm;
        now.strokes = on_screen(stream, film_->pens, film_->mm_per_page_unit);
        return now;
    }
    now.dots = first_dots(plot.dots, count);
    now.blocks = dot_blocks(now.dots);
    return now;
}

std::vector<glm::dvec2> ShownPlot::trail(std::size_t count) const {
    constexpr std::size_t kLongest = 40;
    std::vector<glm::dvec2> trail;
    if (!film_) return trail;
    const double unit = film_->plot.strokes.points.empty() ? 1 : 1 / film_->mm_per_page_unit;
    for (std::size_t i = count > kLongest ? count - kLongest : 1; i <= count; ++i)
        if (const auto at = film_->plot.pen_at(i)) trail.push_back(*at * unit);
    return trail;
}

void ShownPlot::forget() {
    finding_.stop();
    asked_.reset();
    film_.reset();
}

}  // namespace dapple
