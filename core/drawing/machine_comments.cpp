#include "core/drawing/machine_comments.h"

#include <fmt/format.h>

#include "core/drawing/gcode_choice.h"
#include "core/output/plotting_time.h"
#include "core/output/stroke_figures.h"
#include "core/text/number_words.h"

namespace dapple {
namespace {

PlottingTime time_for(const DrawingToSave& drawing, const std::optional<StrokeStream>& strokes,
                      const MachineSpeeds& speeds) {
    if (strokes) return figures_of(*strokes, speeds).time;
    const PageSize& page = drawing.page;
    const DotStream& dots = drawing.dots;
    // More are not held in memory.
    if (dots.count > kMostSortedDots)
        return expected_plotting_time(static_cast<double>(dots.count), page.width_mm * page.height_mm,
                                      speeds);
    return plotting_time(sorted_dots(dots, DotOrder::recursion), page.mm_per_page_unit, speeds);
}

}  // namespace

std::vector<std::string> machine_comments(const DrawingToSave& drawing,
                                          const std::optional<StrokeStream>& strokes, DrawingFormat format) {
    const SavingChoice& saving = drawing.saving;
    const Machine machine = saving.machine.value_or(usual_machine(format, saving.tool));
    const PlottingTime time = time_for(drawing, strokes, speeds_for(machine, format, saving));
    const std::string by = drawing.pens.size() == 1 ? " by the pen " + drawing.pens[0].name : "";
    return {fmt::format("{} dots{} on a page of {:.4g} x {:.4g} mm", grouped(drawing.dots.count), by,
                        drawing.page.width_mm, drawing.page.height_mm),
            "0 0 is the lower left corner of the page",
            fmt::format("{} on {}", time_in_words(time.total_s()), words_for(machine))};
}

}  // namespace dapple
