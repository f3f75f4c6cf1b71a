#include "app/settings/drawing_fields.h"

#include "core/image/exposure.h"
#include "core/relaxing/relax.h"

namespace dapple {
namespace {

constexpr double kLargestRadiusMm = 1000;
constexpr double kSmallestRadiusMm = 1e-6;

}  // namespace

// Each begins with all members by name: with one more or less it doesn't compile.

static void describe(Fields& fields, Tone& tone) {
    auto& [exposure, black_point, white_point, contrast, brightness, gamma, blur, detail, invert] = tone;
    fields.number("exposure", exposure, {-kMostStops, kMostStops});
    fields.number("black_point", black_point, {0, 1});
    fields.number("white_point", white_point, {0, 1});
    fields.number("contrast", contrast, {-1, 1});
    fields.number("brightness", brightness, {-1, 1});
    fields.number("gamma", gamma, {0.1, 10});
    fields.number("blur", blur, {0, 100});
    fields.number("detail", detail, {0, 1});
    fields.flag("invert", invert);
    if (!(black_point < white_point)) fields.refuse("black_point", "has to be below white_point");
}

static void describe(Fields& fields, DotSize& size) {
    auto& [sizing, radius_mm, smallest_mm, largest_mm] = size;
    fields.choice("sizing", sizing,
                  {NamedValue{"automatic", DotSizing::automatic}, NamedValue{"fixed", DotSizing::fixed},
                   NamedValue{"by_tone", DotSizing::by_tone}});
    fields.number("radius_mm", radius_mm, {kSmallestRadiusMm, kLargestRadiusMm});
    fields.number("smallest_mm", smallest_mm, {kSmallestRadiusMm, kLargestRadiusMm});
    fields.number("largest_mm", largest_mm, {kSmallestRadiusMm, kLargestRadiusMm});
    if (smallest_mm > largest_mm) fields.refuse("smallest_mm", "has to be at most largest_mm");
}

void describe(Fields& fields, DrawingSettings& drawing) {
    auto& [automatic_tone, automatic_exposure, tone, tile, ranking, placer, placing, relax, dot_size,
           width_mm, ink, paper, background, show_tiles] = drawing;
    fields.flag("automatic_tone", automatic_tone);
    fields.flag("automatic_exposure", automatic_exposure);
    fields.group("tone", tone);
    fields.tile("tile", tile);
    fields.choice("ranking", ranking, {RankingMethod::paper, RankingMethod::farthest, RankingMethod::energy});
    fields.choice("placer", placer, {PlacerKind::exact, PlacerKind::figure8});
    // Of the placing, what people choose; the number of threads belongs to the computer.
    fields.whole("count", placing.count, 1, kMostDots);
    fields.number("scale", placing.scale, {});
    fields.whole("relax", relax, {0, kMostRelaxingSteps});
    fields.group("dot_size", dot_size);
    fields.number("width_mm", width_mm, {kShortestSideMm, kLongestSideMm});
    fields.colour("ink", ink);
    fields.colour("paper", paper);
    fields.flag("background", background);
    fields.flag("show_tiles", show_tiles);
}

void describe(Fields& fields, SavingChoice& saving) {
    auto& [order, dpi] = saving;
    fields.choice("order", order, {DotOrder::recursion, DotOrder::priority, DotOrder::space});
    fields.number("dpi", dpi, {1, 100'000});
}

void describe_drawing(Fields& fields, DrawingSettings& drawing, SavingChoice& saving) {
    fields.group("drawing", drawing);
    fields.group("saving", saving);
}

}  // namespace dapple
