#include "core/drawing/pen_plan.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <vector>

#include "core/placing/page_density.h"

namespace dapple {
namespace {

constexpr int kLookedAt = 500;  // pixels, for automatic pens

// Nobody is to find a blue dot in a grey picture, which it would bring a hair nearer.
bool is_grey(glm::vec3 light) {
    const glm::vec3 lab = oklab_of(light);
    return glm::length(glm::vec2(lab.y, lab.z)) < 0.01f;
}

// Dots of some of the pens are neither as even as all dots together, which overlap least, nor as uneven as if
// they were drawn by lot: so far on the way from the first to the second. Measured on flat colours.
constexpr float kUnevenness = 0.5f;

// Whether a pen, white on brown paper for example, is hardly seen in ink that lets the paper through.
bool has_to_cover(const Pen& pen, glm::vec3 paper) {
    constexpr float kHardly = 0.25f;  // of what is seen of opaque ink
    const glm::vec3 light = linear_of(pen.colour), bare = linear_of(paper);
    const auto seen = [&](glm::vec3 drawn) { return glm::distance(oklab_of(drawn), oklab_of(bare)); };
    return luminance(light) > luminance(bare) && seen(light * bare) < kHardly * seen(light);
}

// From shares of the paper that are seen to the density of each pen's dots.
class OverlappingDots {
 public:
    OverlappingDots(const PenMixer& mixer, const InkCurve& ink) : ink_(ink), pens_(mixer.pens().size()) {
        const auto darkness_of = [&](glm::vec3 light) { return luminance(mixer.paper() - light); };
        for (std::size_t i = 0; i < pens_; ++i) {
            darkness_[i] = darkness_of(mixer.pens()[i]);
            for (std::size_t j = 0; j < i; ++j) {
                const glm::vec3 both =
                    mixer.pens()[i] * mixer.pens()[j] / glm::max(mixer.paper(), glm::vec3(1e-3f));
                pairs_.push_back({i, j, darkness_of(both), mixer.solve(both)});
            }
        }
    }

    // A pen's dots lie over those of the pens before it and hide some of them: from the last pen, of which
    // all is seen, down to the first.
    Shares opaque(const Shares& shares) const {
        const float all_covered = sum_of(shares), all = ink_.density(all_covered);
        Shares dots{};
        float covered = 0, above = 0;
        for (std::size_t pen = pens_; pen-- > 0;) {
            if (shares[pen] <= 0) continue;
            covered = std::min(covered + shares[pen], all_covered);
            const float so_far = density_of(covered, all);
            dots[pen] = std::max(so_far - above, 0.0f);
            above = so_far;
        }
        return dots;
    }

    // Where two pens' dots overlap, the light is multiplied by both, which looks much like some of the pens
    // side by side. So many dots of each pen as have it seen as its share asks for; and of all as many as
    // have the place as dark as it is to be, also where a pen without a share is seen.
    Shares transparent(const Shares& shares) const {
        constexpr int kRounds = 12;
        constexpr float kLeastSeen = 0.5f;  // of a pen's area: what is left out of account has bounds
        const float aim = darkness(shares);
        if (aim <= 0) return opaque(shares);
        Shares covered = shares, dots{};
        float all = ink_.density(sum_of(shares));
        for (int round = 0;; ++round) {
            for (std::size_t pen = 0; pen < pens_; ++pen) dots[pen] = density_of(covered[pen], all);
            all = sum_of(dots);
            if (all > 1) {
                for (float& density : dots) density /= all;
                all = 1;
            }
            if (round == kRounds) return dots;
            // By each pair in proportion to the product of their areas.
            float products = 0;
            for (const Pair& pair : pairs_) products += covered[pair.first] * covered[pair.second];
            const float twice = std::max(sum_of(covered) - ink_.coverage(all), 0.0f);
            Shares seen = covered;
            float dark = darkness(covered);
            for (const Pair& pair : pairs_) {
                const float product = covered[pair.first] * covered[pair.second];
                if (product <= 0) continue;
                const float area = twice * product / products;
                dark += area * (pair.darkness - darkness_[pair.first] - darkness_[pair.second]);
                seen[pair.first] -= area;
                seen[pair.second] -= area;
                for (std::size_t pen = 0; pen < pens_; ++pen) seen[pen] += area * pair.looks_like[pen];
            }
            const float before = darkness(covered);
            for (std::size_t pen = 0; pen < pens_; ++pen)
                if (shares[pen] > 0)
                    covered[pen] *= shares[pen] / std::max(seen[pen], kLeastSeen * covered[pen]);
            const float ratio = before / darkness(covered) * aim / std::max(dark, 1e-6f);
            for (float& share : covered) share *= ratio;
        }
    }

 private:
    // Of pens that overlap: the luminance that both take of the paper's, and the shares that look alike.
    struct Pair {
        std::size_t first, second;
        float darkness;
        Shares looks_like;
    };

    float sum_of(const Shares& shares) const { return std::accumulate(shares.begin(), shares.end(), 0.0f); }

    // Of dots that cover so much, where that is of all dots.
    float density_of(float covered, float all) const {
        // Of a share p of all dots, drawn by lot, p * load - p^2 * overlap is covered.
        const float load = static_cast<float>(ink_.full_load()) * all, overlap = load - ink_.coverage(all);
        const float root = std::sqrt(std::max(load * load - 4 * overlap * covered, 0.0f));
        const float by_lot = std::min(2 * covered / std::max(load + root, 1e-6f), 1.0f) * all;
        return std::lerp(ink_.density(covered), by_lot, kUnevenness);
    }

    // Luminance of the bare paper less that of the place, if dots lie side by side.
    float darkness(const Shares& covered) const {
        float sum = 0;
        for (std::size_t pen = 0; pen < pens_; ++pen) sum += covered[pen] * darkness_[pen];
        return sum;
    }

    const InkCurve& ink_;
    std::size_t pens_;
    Shares darkness_{};  // of each pen, as of a pair
    std::vector<Pair> pairs_;
};

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
        Palette candidates = choice.own;
        if (!from_own) candidates.assign(common_pens().begin(), common_pens().end());
        const auto coloured = [](const Pen& pen) { return has_colour({pen}); };
        if (std::ranges::all_of(some, is_grey) && !std::ranges::all_of(candidates, coloured))
            std::erase_if(candidates, coloured);
        for (Pen& pen : candidates) pen.ink = has_to_cover(pen, paper) ? PenInk::opaque : choice.ink;
        pens = best_pens(some, candidates, choice.automatic, paper);
        for (Pen& pen : pens) {
            if (from_own) break;
            pen.width_mm = choice.width_mm;
            pen.gain_mm = choice.gain_mm;
        }
    }
    const bool covers = std::ranges::any_of(pens, [&](const Pen& pen) { return has_to_cover(pen, paper); });
    for (Pen& pen : pens) pen.ink = covers ? PenInk::opaque : choice.ink;
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
    const OverlappingDots overlapping(separation.mixer(), ink);
    const bool transparent = pens.front().ink == PenInk::transparent;
    const auto opened = [&](Shares shares) {
        const float asked = std::min(std::accumulate(shares.begin(), shares.end(), 0.0f), 1.0f);
        const float given = ink.opened(asked);
        if (given < asked)
            for (float& share : shares) share *= given / asked;
        return shares;
    };
    // Which dots are seen as shares of transparent ink takes too long to find for each pixel.
    const Separation dots_of = transparent ? separation.changed([&](const Shares& shares) {
        return overlapping.transparent(opened(shares));
    })
                                           : separation;
    Grid<float> all(width, height);
    std::vector<Grid<float>> each(pens.size(), Grid<float>(width, height));
    tbb::parallel_for(0, height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            Shares dots = dots_of.shares(colour_at(tone, x, y));
            if (!transparent) dots = overlapping.opaque(opened(dots));
            float sum = 0;
            for (std::size_t pen = 0; pen < pens.size(); ++pen)
                sum += each[pen].at(x, y) = dots[pen] * dots_for_area[pen];
            all.at(x, y) = sum;
        }
    });
    PenDensities densities{std::make_shared<const Density>(page_density(std::move(all))), {}};
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
