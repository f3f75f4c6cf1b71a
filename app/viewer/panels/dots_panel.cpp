#include "app/viewer/panels/settings_panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "app/viewer/panels/method_panels.h"
#include "app/viewer/widgets/widgets.h"
#include "core/image/density.h"
#include "core/relaxing/relax.h"
#include "core/text/number_words.h"

namespace dapple {
namespace {

void use_scale(PlacingRequest& request, const DrawnInfo& drawn) {
    if (drawn.scale > 0) request.scale = drawn.scale;
    request.count.reset();
}

// Shown as what it makes of black: so many dots on a square centimetre or inch.
bool draw_scale(double& scale, const PageSize& page, const std::optional<double>& largest, LengthUnit unit) {
    const bool inches = unit == LengthUnit::inch;
    // Before the first drawing there is no page yet.
    const double mm = page.mm_per_page_unit > 0 ? page.mm_per_page_unit : setting::width.usual;
    const double side = mm / (inches ? kMmPerInch : 10);
    const double dots = kDotsPerScale / (side * side);  // where the scale is 1
    SliderRange range = range_of(
        setting::scale, {.most = largest, .tip = "How many dots black gets; a darker picture gets more."});
    for (double* const end : {&range.min, &range.max, &range.neutral, &range.hard_min, &range.hard_max})
        *end *= dots;
    // On large pages they are few.
    if (inches)
        range.format = range.neutral < 10 ? "%.2f /in2" : "%.0f /in2";
    else
        range.format = range.neutral < 10 ? "%.2f /cm2" : "%.0f /cm2";
    double shown = scale * dots;
    if (!slider_row(setting::scale.names.row, shown, range)) return false;
    scale = shown / dots;
    return true;
}

// `follows`: how many there are follows from their sizes, which are chosen below.
bool draw_amount(PlacingRequest& request, const DrawnInfo& drawn, bool follows, LengthUnit unit) {
    const auto most = static_cast<double>(drawn.most_dots);
    if (!request.count) {
        // Dots are in proportion to the scale.
        std::optional<double> largest;
        if (drawn.dots > 0) largest = most / static_cast<double>(drawn.dots) * drawn.scale;
        return draw_scale(request.scale, drawn.page, largest, unit);
    }
    const std::string why =
        fmt::format("Number of dots; type one, such as 40k. This computer's memory holds at most {}.",
                    grouped(drawn.most_dots));
    std::uint64_t count = follows ? drawn.dots : *request.count;
    SliderRange range = range_of(setting::count, {.most = most, .tip = why.c_str()});
    range.grouped = true;
    if (!slider_row(setting::count.names.row, count, range)) return false;
    request.count = count;
    return true;
}

bool draw_amount_by(PlacingRequest& request, const DrawnInfo& drawn) {
    int by = request.count ? 1 : 0;
    if (!segmented_row("Dot count", by, std::array{"from tone", "as set"},
                       "as set: exactly this many dots. from tone: a darker picture gets more.", 1))
        return false;
    if (by == 0)
        use_scale(request, drawn);
    else
        request.count = std::clamp<std::uint64_t>(drawn.dots, 1, drawn.most_dots);
    return true;
}

bool draw_size(DotSize& size, const DrawnInfo& drawn, LengthUnit unit) {
    bool changed = false;
    DotSizing sizing = size.sizing;
    if (segmented_row("Dot size", sizing, std::array{"auto", "fixed", "by tone"},
                      "auto: the one size that gives the picture's tone. fixed: a size that you choose. by "
                      "tone: small dots in light areas, large ones in dark areas.")) {
        size = dot_size_from(sizing, drawn.dot_radius_mm);
        changed = true;
    }
    {
        const bool fixed = size.sizing == DotSizing::fixed;
        const Absent absent(fixed ? nullptr : "Applies to dots of a fixed size only.");
        changed |= slider_row(setting::radius, size.radius_mm, {.unit = unit});
    }
    const Absent absent(size.sizing == DotSizing::by_tone ? nullptr : "Applies to dots sized by tone only.");
    if (slider_row(setting::smallest, size.smallest_mm, {.unit = unit})) {
        size.largest_mm = std::max(size.largest_mm, size.smallest_mm);
        changed = true;
    }
    if (slider_row(setting::largest, size.largest_mm, {.unit = unit})) {
        size.smallest_mm = std::min(size.smallest_mm, size.largest_mm);
        changed = true;
    }
    return changed;
}

bool is_dot_path(const std::string& text) {
    try {
        static_cast<void>(parse_dot_path(text));
        return true;
    } catch (const std::runtime_error&) {
        return false;
    }
}

constexpr const char* kUsualPath = "M0.5,0 L1,0.5 L0.5,1 L0,0.5 Z";

bool draw_shape(DrawingSettings& settings) {
    const bool dots = settings.style == DrawingStyle::dots;
    const Absent absent(dots ? nullptr : "Applies to dots only.");
    bool changed = false;
    // As DotShape has them.
    constexpr std::array kShapes{"circle", "point", "stroke", "spiral",
                                 "hatch",  "ring",  "cross",  "custom path"};
    if (choice_row("Dot shape", settings.mark.shape, kShapes,
                   "circle: filled. point: pen down and up. stroke: a short line. spiral, hatch: filled by "
                   "the pen. custom path: any path you type.")) {
        if (settings.mark.shape == DotShape::path && settings.mark.path.empty())
            settings.mark.path = kUsualPath;
        changed = true;
    }
    const bool own = dots && settings.mark.shape == DotShape::path;
    const Absent not_own(own ? nullptr : "Applies to the dot shape \"custom path\" only.");
    return text_row(
               "Custom path", settings.mark.path, is_dot_path,
               "A path in a box from 0,0 to 1,1: M, L, H, V, C, Q, A and Z, as in M0,0 L1,1",
               "An SVG path in a box around each dot; 0,0 is its upper left corner, 1,1 its lower right.",
               kUsualPath) ||
           changed;
}

bool draw_strokes(DrawingSettings& settings, LengthUnit unit) {
    bool changed =
        segmented_row("Draw", settings.style, std::array{"dots", "one line", "network"},
                      "dots: each by itself. one line: through all dots, by a short route that takes some "
                      "seconds to find. network: lines from each dot to its nearest few.");
    changed |= draw_shape(settings);
    const Absent absent(draws_strokes(settings) ? nullptr : "Filled circles need no pen.");
    changed |= slider_row(setting::pen_width, settings.pen_width_mm, {.unit = unit});
    return changed;
}

// The usual steps are automatic again: another number of dots has its own.
bool draw_relax(std::optional<int>& relax, const DrawnInfo& drawn) {
    int steps = relax.value_or(drawn.steps);
    if (!slider_row(setting::relax, steps, {.usual = drawn.usual_steps})) return false;
    relax.reset();
    if (steps != drawn.usual_steps) relax = steps;
    return true;
}

}  // namespace

bool draw_amount_rows(DrawingSettings& settings, const DrawnInfo& drawn, LengthUnit unit) {
    const bool follows = settings.dot_size.sizing == DotSizing::by_tone;
    const Greyed greyed(follows ? "With sizes by tone, the count is calculated." : nullptr);
    const bool changed = draw_amount(settings.placing, drawn, follows, unit);
    return draw_amount_by(settings.placing, drawn) || changed;
}

bool draw_dots_panel(DrawingSettings& settings, const DrawnInfo& drawn, LengthUnit unit) {
    if (!section("Drawing")) return false;
    bool changed = draw_amount_rows(settings, drawn, unit);
    changed |= draw_size(settings.dot_size, drawn, unit);
    changed |= draw_strokes(settings, unit);
    changed |= slider_row(setting::contours, settings.contours);
    changed |= slider_row(setting::solid, settings.solid);
    const Absent absent(why_only_exact(settings.placer));
    return draw_relax(settings.relax, drawn) || changed;
}

}  // namespace dapple
