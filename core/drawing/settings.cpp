#include "core/drawing/settings.h"

#include <algorithm>

#include "core/pens/separation.h"

namespace dapple {
namespace {

// Whether each pen has a width of its own, and not all of them one.
bool have_own_widths(const PenChoice& pens) {
    return pens.set == PenSet::own || chooses_from_own(pens);
}

}  // namespace

std::string tile_in_use(const DrawingSettings& settings) {
    if (settings.tile != kDefaultTile) return settings.tile;
    if (settings.placer == PlacerKind::figure8) return "paper16";
    const bool one_by_one = settings.ranking.value_or(RankingMethod::energy) != RankingMethod::energy;
    return one_by_one ? "aperiodic4096" : settings.tile;
}

bool draws_strokes(const DrawingSettings& settings) {
    return settings.style != DrawingStyle::dots || settings.mark.shape != DotShape::circle;
}

std::vector<double> stroke_widths(const PenChoice& choice, double pen_width_mm, std::span<const Pen> pens,
                                  PenUse use) {
    std::vector<double> widths;
    for (const Pen& pen : pens) {
        Pen wide;
        wide.width_mm = choice.width_mm;
        wide.gain_mm = choice.gain_mm;
        if (have_own_widths(choice)) {
            // They come in another order, and may have lost their widths: see request_of().
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

DrawingRequest request_of(const DrawingSettings& settings) {
    DrawingRequest request = settings;
    const bool touches = draws_touches(settings);
    if (touches && !have_widths(request.pens) && request.dot_size.sizing != DotSizing::by_tone) {
        request.dot_size.sizing = DotSizing::fixed;
        request.dot_size.radius_mm = settings.pen_width_mm / 2;
    }
    if (draws_strokes(settings) && !touches) {
        request.pens.width_mm = 0;
        for (Pen& pen : request.pens.own) pen.width_mm = 0;
    }
    return request;
}

DrawingTerms terms_of(const DrawingSettings& settings) {
    return {.joined = settings.style != DrawingStyle::dots,
            // It has no say elsewhere.
            .stroke_width_mm = keeps_dots_inside(settings.page) ? widest_stroke(settings) : 0};
}

}  // namespace dapple
