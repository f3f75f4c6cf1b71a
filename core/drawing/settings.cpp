#include "core/drawing/settings.h"

#include <algorithm>
#include <cmath>

#include "core/pens/separation.h"

namespace dapple {

double reach_mm(const DotSize& size) {
    if (size.sizing == DotSizing::automatic) return 0;
    return size.sizing == DotSizing::fixed ? size.radius_mm : size.largest_mm;
}

namespace {

// Whether each pen has a width of its own, and not all of them one.
bool have_own_widths(const PenChoice& pens) {
    return pens.set == PenSet::own || chooses_from_own(pens);
}

constexpr double kSeenMm = 0.1;        // between dots, at reading distance
constexpr double kNoWait = 2'000'000;  // dots
// Few dots have to show a picture with what evenness they can get, and their steps take no time.
constexpr double kFew = 13'600, kMany = 40'000;

}  // namespace

bool draws_strokes(const DrawingSettings& settings) {
    return settings.style != DrawingStyle::dots || settings.mark.shape != DotShape::circle;
}

bool can_be_finer(const DrawingSettings& settings) {
    if (settings.style != DrawingStyle::dots || draws_touches(settings)) return false;
    const bool by_tone = settings.dot_size.sizing == DotSizing::by_tone;
    return by_tone || draws_strokes(settings) || !have_widths(settings.pens);
}

bool has_several_sizes(const DrawingSettings& settings) {
    return settings.edits.find("dot r") != settings.edits.npos ||
           settings.dot_size.sizing == DotSizing::by_tone ||
           (settings.mask.has_finer() && can_be_finer(settings));
}

std::vector<double> stroke_widths(const PenChoice& choice, double pen_width_mm, std::span<const Pen> pens,
                                  PenUse use) {
    std::vector<double> widths;
    for (const Pen& pen : pens) {
        Pen wide;
        wide.width_mm = choice.width_mm;
        wide.gain_mm = choice.gain_mm;
        if (have_own_widths(choice)) {
            // They come in another order, and may have lost their widths: see Pipeline::plan().
            const auto own = std::ranges::find(choice.own, pen.name, &Pen::name);
            wide = own == choice.own.end() ? Pen() : *own;
        }
        const double width = use == PenUse::touches ? dot_width_mm(wide) : wide.width_mm;
        widths.push_back(width > 0 ? width : pen_width_mm);
    }
    return widths;
}

bool have_widths(const PenChoice& pens) {
    if (pens.set == PenSet::one) return false;
    if (!have_own_widths(pens)) return pens.width_mm > 0;
    return std::ranges::any_of(pens.own, [](const Pen& pen) { return pen.width_mm > 0; });
}

bool draws_touches(const DrawingSettings& settings) {
    return settings.style == DrawingStyle::dots && settings.mark.shape == DotShape::point;
}

double widest_stroke(const DrawingSettings& settings) {
    if (!draws_strokes(settings)) return 0;
    const PenChoice& choice = settings.pens;
    Palette pens = have_own_widths(choice) ? choice.own : palette_of(choice);
    if (pens.empty() && choice.set == PenSet::automatic) pens.emplace_back();  // all are as wide
    const std::vector<double> widths = stroke_widths(choice, settings.pen_width_mm, pens, pen_use(settings));
    return widths.empty() ? settings.pen_width_mm : std::ranges::max(widths);
}

int usual_steps(double dots, double picture_area_mm2) {
    const bool unseen = std::sqrt(picture_area_mm2 / std::max(dots, 1.0)) < kSeenMm;
    if (unseen && dots > kNoWait) return 0;
    return static_cast<int>(
        std::lround(kFewestUsualSteps * std::sqrt(kMany / std::clamp(dots, kFew, kMany))));
}

std::string tile_in_use(const DrawingSettings& settings) {
    if (settings.tile != kDefaultTile) return settings.tile;
    if (settings.placer == PlacerKind::figure8) return "paper16";
    const bool one_by_one = settings.ranking.value_or(RankingMethod::energy) != RankingMethod::energy;
    return one_by_one ? "aperiodic4096" : settings.tile;
}

}  // namespace dapple
