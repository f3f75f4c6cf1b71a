#include "app/viewer/panels/export_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/shown_text.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {
namespace {

constexpr const char* kOrders =
    "The order of the dots in the file, in which a plotter draws them.\n"
    "as placed: tile by tile.\n"
    "short moves: each near the one before, found at once.\n"
    "shortest: by the shortest way for the pen that is soon found; a million dots take a minute or so.\n"
    "by priority: the first n dots are the drawing with n dots if they are not relaxed, so that a plot may "
    "stop at any time.";

constexpr const char* kTools =
    "What the machine does at a dot.\n"
    "pen: lowers it by the Z axis.\n"
    "servo: turns a servo by M3.\n"
    "laser: burns for a moment.\n"
    "dapple render --help tells how to write a template of your own.";

bool draw_order(std::optional<DotOrder>& choice, DotOrder usual) {
    const DotOrder order = choice.value_or(usual);
    constexpr std::array kShown{DotOrder::recursion, DotOrder::space, DotOrder::shortest, DotOrder::priority};
    int chosen = static_cast<int>(std::ranges::find(kShown, order) - kShown.begin());
    const bool changed = segmented_row(
        "Dot order", chosen, std::array{"as placed", "short moves", "shortest", "by priority"}, kOrders);
    if (changed) choice = kShown[static_cast<std::size_t>(chosen)];
    return changed;
}

bool draw_tool(GcodeTool& tool) {
    int chosen = static_cast<int>(tool);
    const bool changed = segmented_row("G-code for", chosen, std::array{"pen", "servo", "laser"}, kTools);
    if (changed) tool = static_cast<GcodeTool>(chosen);
    return changed;
}

bool draw_machine(SavingChoice& saving, DrawingFormat format, const ExportInfo& info) {
    // As Machine has them.
    const Machine machine = saving.machine.value_or(usual_machine(format, saving.tool));
    int chosen = static_cast<int>(machine);
    const bool changed = choice_row(
        "Machine", chosen, std::array{"AxiDraw V3", "AxiDraw SE/A3", "GRBL pen plotter", "GRBL laser"},
        "Whose time is told below; the file is the same for all of them.");
    if (changed) saving.machine = static_cast<Machine>(chosen);
    if (info.dots == 0) return changed;
    const PlottingTime time =
        expected_plotting_time(static_cast<double>(info.dots), info.area_mm2, speeds_of(machine));
    hint(fmt::format("Plots for {}: {}.", time_in_words(time.total_s()), what_takes_longest(time)).c_str());
    note_place("Plotting time");
    return changed;
}

// Two digits, or a whole number below a hundred thousand bytes.
std::string bytes_in_words(double bytes) {
    const char* unit = "kB";
    double size = bytes / 1e3;
    for (const char* larger : {"MB", "GB", "TB"}) {
        if (size < 999.5) break;
        size /= 1e3;
        unit = larger;
    }
    if (size < 9.95) return fmt::format("{:.1f} {}", std::max(size, 0.1), unit);
    const double step = size < 99.5 ? 1 : 10;
    return fmt::format("{:.0f} {}", std::round(size / step) * step, unit);
}

}  // namespace

std::string size_in_words(const ExportInfo& info) {
    const std::string dots = grouped(info.dots) + (info.dots == 1 ? " dot" : " dots");
    return info.bytes ? "about " + bytes_in_words(*info.bytes) + ", " + dots : dots;
}

bool draw_export_panel(ViewerSettings& settings, DrawingFormat format, const ExportInfo& info) {
    bool changed = false;
    if (has_pixels(format))
        changed |= slider_row("Dots per inch", settings.saving.dpi,
                              {.min = 50,
                               .max = 1200,
                               .neutral = 300,
                               .curve = SliderCurve::logarithmic,
                               .format = "%.0f",
                               .hard_min = 1,
                               .hard_max = 100'000,
                               .tip = "Pixels to the inch of the page, whose width is under Dots."});
    else
        changed |= draw_order(settings.saving.order, usual_order(format, info.dots));
    if (format == DrawingFormat::gcode) changed |= draw_tool(settings.saving.tool);
    if (is_plotted(format)) changed |= draw_machine(settings.saving, format, info);
    if (has_optional_paper(format))
        changed |= switch_row(format == DrawingFormat::svg ? "Paper in SVG" : "Paper in PDF",
                              settings.drawing.background);
    if (!info.trouble.empty()) {
        hint(info.trouble.c_str());
        return changed;
    }
    hint(size_in_words(info).c_str());
    note_place("File size");
    if (!settings.drawing.show_tiles) return changed;
    hint(format == DrawingFormat::svg ? "With the tile boundaries as a layer of their own."
                                      : "Without the tile boundaries: only an SVG has layers.");
    note_place("Tile layer");
    return changed;
}

}  // namespace dapple
