#include "core/drawing/machine_comments.h"

#include <fmt/format.h>

#include "core/drawing/gcode_choice.h"
#include "core/output/machine_clock.h"
#include "core/output/stroke_figures.h"
#include "core/text/number_words.h"

namespace dapple {
namespace {

PlottingTime time_for(const DrawingToSave& drawing, const std::optional<StrokeStream>& strokes,
                      const MachineProgram& program) {
    if (strokes) return figures_of(*strokes, program).time;
    const PageSize& page = drawing.page;
    const DotStream& dots = drawing.dots;
    // More are not placed a second time.
    if (dots.count > kMostSortedDots)
        return expected_plotting_time(static_cast<double>(dots.count), page.width_mm * page.height_mm,
                                      program);
    return plotting_time(dots, page.mm_per_page_unit, program);
}

}  // namespace

std::vector<std::string> machine_comments(const DrawingSettings& settings, const DrawingToSave& drawing,
                                          const std::optional<StrokeStream>& strokes, DrawingFormat format) {
    const SavingChoice& saving = drawing.saving;
    const Machine machine = saving.machine.value_or(usual_machine(format, saving.tool));
    const PlottingTime time =
        time_for(drawing, strokes, program_for(machine, format, settings, drawing).program);
    const std::string by = drawing.pens.size() == 1 ? " by the pen " + drawing.pens[0].name : "";
    return {fmt::format("{} dots{} on a page of {:.4g} x {:.4g} mm", grouped(drawing.dots.count), by,
                        drawing.page.width_mm, drawing.page.height_mm),
            "0 0 is the lower left corner of the page",
            fmt::format("{} on {}", time_in_words(time.total_s()), words_for(machine))};
}

}  // namespace dapple
