#include "core/drawing/pen_plan.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace dapple {
namespace {

constexpr int kLookedAt = 500;  // pixels, for automatic pens

// Dots of some of the pens are neither as even as all dots together, which overlap least, nor as uneven as if
// they were drawn by lot: so far on the way from the first to the second. Measured on flat colours.
constexpr float kUnevenness = 0.5f;

// The density of each pen's dots of which that share of the paper is seen. A pen's dots lie over those of the
// pens before it and hide some of them: from the last pen, of which all is seen, down to the first.
Shares dots_that_show(Shares shares, std::size_t pens, const InkCurve& ink) {
    const float asked = std::min(std::accumulate(shares.begin(), shares.end(), 0.0f), 1.0f);
    const float all_covered = ink.opened(asked);
    if (all_covered < asked)
        for (float& share : shares) share *= all_covered / asked;
    const float all = ink.density(all_covered);
    const float load = static_cast<float>(ink.full_load()) * all, overlap = load - all_covered;
    // Of a share p of all dots, drawn by lot, p * load - p^2 * overlap is seen.
    const auto by_lot = [&](float covered) {
        const float root = std::sqrt(std::max(load * load - 4 * overlap * covered, 0.0f));
        return std::min(2 * covered / (load + root), 1.0f) * all;
    };
    Shares dots{};
    float covered = 0, above = 0;
    for (std::size_t pen = pens; pen-- > 0;) {
        if (shares[pen] <= 0) continue;
        covered = std::min(covered + shares[pen], all_covered);
        const float so_far = std::lerp(ink.density(covered), by_lot(covered), kUnevenness);
        dots[pen] = std::max(so_far - above, 0.0f);
        above = so_far;
    }
    return dots;
}

}  // namespace

Palette pens_for(const PenChoice& choice, const ColourGrid& colours, float exposure, glm::vec3 paper) {
    Palette pens = palette_of(choice);
    if (choice.set == PenSet::automatic) {
        std::vector<glm::vec3> some;
        const std::size_t pixels = colours.values.size();
        const std::size_t step = std::max<std::size_t>(pixels / kLookedAt, 1) | 1;
        for (std::size_t i = step / 2; i < pixels; i += step)
            some.push_back(glm::clamp(unpacked(colours.values[i]) * std::exp2(exposure), 0.0f, 1.0f));
        if (some.empty()) some.assign({glm::vec3(0.2f), glm::vec3(0.5f)});
        const bool from_own = chooses_from_own(choice);
        pens = best_pens(some, from_own ? choice.own : common_pens(), choice.automatic, paper);
        for (Pen& pen : pens) {
            if (from_own) break;
            pen.width_mm = choice.width_mm;
            pen.gain_mm = choice.gain_mm;
        }
    }
    sort_pens(pens, choice.order);
    return pens;
}

glm::vec3 colour_at(const ColourTone& tone, int x, int y) {
    const float light = tone.seen.at(x, y);
    glm::vec3 colour(light);
    if (!tone.colours.empty()) {
        const glm::vec3 own = glm::max(unpacked(tone.colours.at(x, y)), 0.0f);
        const float its_light = luminance(own);
        if (its_light > 1e-5f) colour = own * (light / its_light);
        const float most = std::max({colour.r, colour.g, colour.b});
        if (most > 1) colour = light + (colour - light) * ((1 - light) / std::max(most - light, 1e-6f));
    }
    return tone.invert ? 1.0f - colour : colour;
}

PenDensities separated(const ColourTone& tone, const Separation& separation, std::span<const Pen> pens,
                       const InkCurve& ink) {
    const int width = tone.seen.width, height = tone.seen.height;
    const double widest = width_of_pens(pens).value_or(1);
    std::vector<float> dots_for_area;  // of each pen, over those of the widest
    for (const Pen& pen : pens) {
        const double ratio = widest / (pen.width_mm > 0 ? dot_width_mm(pen) : widest);
        dots_for_area.push_back(static_cast<float>(ratio * ratio));
    }
    Grid<float> all(width, height);
    std::vector<Grid<float>> each(pens.size(), Grid<float>(width, height));
    tbb::parallel_for(0, height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            const Shares shares = separation.shares(colour_at(tone, x, y));
            const Shares dots = dots_that_show(shares, pens.size(), ink);
            float sum = 0;
            for (std::size_t pen = 0; pen < pens.size(); ++pen)
                sum += each[pen].at(x, y) = dots[pen] * dots_for_area[pen];
            all.at(x, y) = sum;
        }
    });
    PenDensities densities{std::make_shared<const Density>(std::move(all)), {}};
    for (Grid<float>& grid : each) densities.each.push_back(std::make_shared<const Density>(std::move(grid)));
    return densities;
}

double dot_radius_mm(const Pen& pen, double usual) {
    return pen.width_mm > 0 ? dot_width_mm(pen) / 2 : usual;
}

std::optional<double> width_of_pens(std::span<const Pen> pens) {
    double widest = 0;
    for (const Pen& pen : pens) widest = std::max(widest, dot_width_mm(pen));
    return widest > 0 ? std::optional(widest) : std::nullopt;
}

}  // namespace dapple
