#include "app/viewer/panels/dots_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "app/grouped.h"
#include "app/viewer/widgets/widgets.h"
#include "core/relaxing/relax.h"

namespace dapple {
namespace {

constexpr SliderRange kScale{.min = 10,
                             .max = 100'000,
                             .neutral = 2500,
                             .curve = SliderCurve::logarithmic,
                             .format = "%.0f",
                             .hard_min = 0,
                             .hard_max = 1e8,
                             .grouped = true};
constexpr SliderRange kCount{.min = 100,
                             .max = 2'000'000,
                             .neutral = kDefaultDots,
                             .curve = SliderCurve::logarithmic,
                             .format = "%.0f",
                             .hard_min = 1,
                             .grouped = true};
constexpr SliderRange kRadius{.min = 0.02,
                              .max = 5,
                              .neutral = 0.3,
                              .curve = SliderCurve::logarithmic,
                              .format = "%.3f",
                              .hard_min = 0.001,
                              .hard_max = 100};
constexpr SliderRange kWidth{.min = 20,
                             .max = 2000,
                             .neutral = 200,
                             .curve = SliderCurve::logarithmic,
                             .format = "%.0f",
                             .hard_min = 1,
                             .hard_max = 100'000};

void use_scale(StippleRequest& request, const DrawnFacts& drawn) {
    if (drawn.scale > 0) request.scale = drawn.scale;
    request.count.reset();
}

bool draw_amount(StippleRequest& request, const DrawnFacts& drawn) {
    bool changed = false;
    const auto most = static_cast<double>(drawn.most_dots);
    const std::string why = fmt::format(
        "At most {} dots: as many as this computer's memory holds while they are shown. `dapple render` "
        "writes more, since it need not hold them.",
        grouped(drawn.most_dots));
    // Figure 8 knows a scale only.
    if (request.placer == PlacerKind::exact) {
        int by = request.count ? 1 : 0;
        if (segmented_row("Set by", by, std::array{"scale", "count"})) {
            if (by == 0)
                use_scale(request, drawn);
            else
                request.count = std::clamp<std::uint64_t>(drawn.dots, 1, drawn.most_dots);
            changed = true;
        }
    }
    if (request.count) {
        auto count = static_cast<double>(*request.count);
        SliderRange range = kCount;
        range.max = std::min(range.max, most);
        range.hard_max = most;
        range.tip = why.c_str();
        if (slider_row("Dots", count, range)) {
            request.count = static_cast<std::uint64_t>(std::llround(count));
            changed = true;
        }
    } else {
        SliderRange range = kScale;
        // Dots are in proportion to the scale.
        if (drawn.dots > 0)
            range.hard_max = std::min(most / static_cast<double>(drawn.dots) * drawn.scale, range.hard_max);
        range.max = std::min(range.max, range.hard_max);
        range.tip = why.c_str();
        changed |= slider_row("Scale", request.scale, range);
    }
    if (static_cast<double>(drawn.dots) > 0.99 * most) {
        hint(("More than " + grouped(drawn.most_dots) + " dots do not fit into this computer's memory.")
                 .c_str());
        note_place("Most dots");
    }
    return changed;
}

bool draw_size(DotSize& size, const DrawnFacts& drawn) {
    bool changed = false;
    int chosen = static_cast<int>(size.sizing);
    if (segmented_row(
            "Dot size", chosen, std::array{"auto", "fixed", "by tone"},
            "auto: one size, the one that gives the picture's tone. fixed: one size of your own. by tone: "
            "small dots in light areas, large ones in dark areas.")) {
        const double radius = std::max(drawn.dot_radius_mm, kRadius.hard_min);
        size = {.sizing = static_cast<DotSizing>(chosen),
                .radius_mm = radius,
                .smallest_mm = std::max(0.5 * radius, kRadius.hard_min),
                .largest_mm = 1.2 * radius};
        changed = true;
    }
    if (size.sizing == DotSizing::fixed) changed |= slider_row("Radius, mm", size.radius_mm, kRadius);
    if (size.sizing != DotSizing::by_tone) return changed;
    if (slider_row("Smallest, mm", size.smallest_mm, kRadius)) {
        size.largest_mm = std::max(size.largest_mm, size.smallest_mm);
        changed = true;
    }
    if (slider_row("Largest, mm", size.largest_mm, kRadius)) {
        size.smallest_mm = std::min(size.smallest_mm, size.largest_mm);
        changed = true;
    }
    return changed;
}

bool draw_relax(std::optional<int>& relax, const DrawnFacts& drawn) {
    double steps = relax.value_or(drawn.steps);
    if (!slider_row(
            "Relax", steps,
            {.min = 0,
             .max = 20,
             .neutral = kUsualSteps,
             .format = "%.0f",
             .hard_max = kMostRelaxingSteps,
             .tip = "Steps that move each dot to the middle of the ink around it: more even. From 1 on the "
                    "first dots of the drawing are no longer a lighter drawing by themselves."}))
        return false;
    relax = static_cast<int>(std::lround(steps));
    return true;
}

}  // namespace

bool ranking_row(const char* label, std::optional<RankingOrder>& ranking) {
    // The tile's own comes first, then RankingOrder's.
    int chosen = ranking ? static_cast<int>(*ranking) + 1 : 0;
    if (!choice_row(label, chosen,
                    std::array{"the tile's own", "paper's ranks", "farthest point", "even tone (energy)"}))
        return false;
    ranking.reset();
    if (chosen > 0) ranking = static_cast<RankingOrder>(chosen - 1);
    return true;
}

bool draw_dots_panel(DrawingSettings& settings, const DrawnFacts& drawn, const TileList& tiles) {
    if (!section("Dots")) return false;
    bool changed = false;
    if (settings.dot_size.sizing == DotSizing::by_tone)
        hint("As many dots as their sizes and the tone ask for.");
    else
        changed |= draw_amount(settings.stipple, drawn);
    changed |= draw_size(settings.dot_size, drawn);
    if (settings.stipple.placer == PlacerKind::exact) changed |= draw_relax(settings.relax, drawn);
    changed |= slider_row("Page, mm", settings.width_mm, kWidth);

    int placer = settings.stipple.placer == PlacerKind::figure8 ? 1 : 0;
    if (segmented_row("Placer", placer, std::array{"exact", "Figure 8"})) {
        settings.stipple.placer = placer == 1 ? PlacerKind::figure8 : PlacerKind::exact;
        if (placer == 1) use_scale(settings.stipple, drawn);
        settings.tile = tile_in_use(settings);
        changed = true;
    }
    changed |= tile_row("Tile", settings.tile, tiles);
    if (settings.stipple.placer == PlacerKind::exact) changed |= ranking_row("Order", settings.ranking);
    return changed;
}

}  // namespace dapple
