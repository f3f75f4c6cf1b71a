#include "app/viewer/panels/dots_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "app/grouped.h"
#include "app/viewer/widgets.h"

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

bool draw_radius(DrawingSettings& settings, const DrawnFacts& drawn) {
    bool changed = false;
    int chosen = settings.dot_radius_mm ? 1 : 0;
    if (segmented_row("Dot size", chosen, std::array{"by tone", "fixed"})) {
        settings.dot_radius_mm.reset();
        if (chosen == 1) settings.dot_radius_mm = std::max(drawn.dot_radius_mm, kRadius.hard_min);
        changed = true;
    }
    if (settings.dot_radius_mm) changed |= slider_row("Radius, mm", *settings.dot_radius_mm, kRadius);
    return changed;
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
    bool changed = draw_amount(settings.stipple, drawn);
    changed |= draw_radius(settings, drawn);
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
