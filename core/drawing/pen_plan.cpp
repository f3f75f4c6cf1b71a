#include "core/drawing/pen_plan.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>
#include <vector>

#include "core/image/detail.h"
#include "core/maths/portable_math.h"
#include "core/placing/page.h"

namespace dapple {
namespace {

constexpr int kLookedAt = 500;  // pixels, for automatic pens

// Nobody is to find a blue dot in a grey picture, which it would bring a hair nearer.
bool is_grey(glm::vec3 light) {
    const glm::vec3 lab = oklab_of(light);
    return glm::length(glm::vec2(lab.y, lab.z)) < 0.01f;
}

// Whether a pen, white on brown paper for example, is hardly seen in ink that lets the paper through.
bool has_to_cover(const Pen& pen, glm::vec3 paper) {
    constexpr float kHardly = 0.25f;  // of what is seen of opaque ink
    const glm::vec3 light = linear_of(pen.colour), bare = linear_of(paper);
    const auto seen = [&](glm::vec3 drawn) { return glm::distance(oklab_of(drawn), oklab_of(bare)); };
    return luminance(light) > luminance(bare) && seen(light * bare) < kHardly * seen(light);
}

// Where one pen has nearly all dots they only get more even: they are as after the steps that leave many
// pens' dots as even as `among` does, and the pens' own steps.
int steps_of_one_pen(int among) {
    constexpr int kOfPens = 4;
    return among == 0 ? 0 : static_cast<int>(std::lround(portable::pow(among / 2.0, 4))) + kOfPens;
}

// From shares of the paper that are seen to the density of each pen's dots.
class OverlappingDots {
 public:
    OverlappingDots(const PenMixer& mixer, InkedDots dots)
        : ink_(dots),
          joined_(dots.joined),
          sizes_{static_cast<float>(dots.smallest_area)},
          pens_(mixer.pens().size()) {
        dots.relaxing_steps = steps_of_one_pen(dots.relaxing_steps);
        alone_ = InkCurve(dots, ink_.full_load());
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

    const InkCurve& ink() const { return ink_; }

    // A pen's dots lie over those of the pens before it and hide some of them: from the last pen, of which
    // all is seen, down to the first.
    Shares opaque(const Shares& shares) const {
        constexpr int kRounds = 3;
        constexpr float kRounding = 1e-5f;
        const float all_covered = sum_of(shares);
        Shares dots = shares;
        for (int round = 0; round < kRounds; ++round) {
            const AllDots all = dots_covering(all_covered, dots);
            const Shares before = std::exchange(dots, {});
            Shares upper{};
            float covered = 0, so_far = 0;
            for (std::size_t pen = pens_; pen-- > 0;) {
                if (shares[pen] <= 0) continue;
                covered += shares[pen];
                upper[pen] = before[pen];
                const float above = so_far;
                so_far = all.density;
                if (covered < all_covered - kRounding)
                    so_far = std::min(density_of(covered, all, power_of(upper, all)), so_far);
                dots[pen] = std::max(so_far - above, 0.0f);
            }
        }
        return dots;
    }

    // Where two pens' dots overlap, the light is multiplied by both, which looks much like some of the pens
    // side by side. Each pen gets as many dots as make it seen as its share asks for; and all together are as
    // many as make the place as dark as it is to be, also where a pen without a share is seen.
    Shares transparent(const Shares& shares) const {
        constexpr int kRounds = 12;
        constexpr float kLeastSeen = 0.5f;  // of a pen's area: what is left out of account has bounds
        const float aim = darkness(shares);
        if (aim <= 0) return opaque(shares);
        Shares covered = shares, dots{};
        AllDots all = dots_covering(sum_of(shares), shares);
        for (int round = 0;; ++round) {
            for (std::size_t pen = 0; pen < pens_; ++pen)
                dots[pen] = density_of(covered[pen], all, own_power(all));
            if (sizes_.differ()) fit_sizes(dots, all.density);
            const float sum = sum_of(dots);
            if (sum > 1) {  // more than there can be: no more is covered, in the same proportions
                for (float& density : dots) density /= sum;
                for (float& share : covered) share /= sum;
            }
            if (round == kRounds) return dots;
            all = all_of(dots);
            // Two pens that have few dots hardly overlap, as they lie apart from each other, too.
            const auto meeting = [&](const Pair& pair) {
                const float one = covered[pair.first], other = covered[pair.second];
                return one * other * std::sqrt(one + other);
            };
            float meetings = 0;
            for (const Pair& pair : pairs_) meetings += meeting(pair);
            const float twice = std::max(sum_of(covered) - all.covered, 0.0f);
            Shares seen = covered;
            float dark = darkness(covered);
            for (const Pair& pair : pairs_) {
                if (meeting(pair) <= 0) continue;
                const float area = twice * meeting(pair) / meetings;
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
    // Two pens that overlap: the luminance that both together take from the paper's, and the shares that look
    // alike.
    struct Pair {
        std::size_t first, second;
        float darkness;
        Shares looks_like;
    };

    // The dots of all pens together.
    struct AllDots {
        float density, covered;
    };

    float sum_of(const Shares& shares) const { return std::accumulate(shares.begin(), shares.end(), 0.0f); }

    // How nearly dots that pens share so are as even as one pen's, 0..1.
    float evenness(const Shares& dots) const {
        const float part = *std::ranges::max_element(dots) / std::max(sum_of(dots), 1e-6f);
        return part * part * part * part * part;
    }
    AllDots all_of(const Shares& dots) const {
        const float all = sum_of(dots);
        if (joined_) {  // lines cross by chance
            float bare = 1;
            for (const float density : dots) bare *= 1 - ink_.coverage(density);
            return {all, 1 - bare};
        }
        return {all, std::lerp(ink_.coverage(all), alone_.coverage(all), evenness(dots))};
    }
    // All dots, if they cover so much and pens share them about like this.
    AllDots dots_covering(float covered, const Shares& dots) const {
        return {std::lerp(ink_.density(covered), alone_.density(covered), evenness(dots)), covered};
    }

    // A share p of all dots, of all dots' load, covers p * load less p^power of what all dots overlap: 2 if
    // they were drawn by lot. A pen's own dots lie apart, the more so the less all dots overlap; those of
    // several pens together nearly as if by lot, unless one pen has nearly all of them.
    float own_power(const AllDots& all, float least = 3.1f) const {
        constexpr float kAtLoad1 = 6.2f, kMost = 20;
        const float load = ink_.load(all.density);
        return std::clamp(kAtLoad1 / std::max(load * load, 1e-6f), least, kMost);
    }
    float power_of(const Shares& some, const AllDots& all) const {
        constexpr float kOfMany = 2.4f;
        const float alone = evenness(some);
        return alone == 1 ? own_power(all) : std::lerp(kOfMany, own_power(all, kOfMany), alone);
    }

    // The density of dots that cover so much and are some of all dots: by Newton's method, from below.
    float density_of(float covered, const AllDots& all, float power) const {
        constexpr int kRounds = 4;
        constexpr float kLeastSlope = 0.2f;  // of the load, where the formula overshoots
        constexpr float kMostShare = 4;      // where no share covers so much, more and more would be tried
        const float load = ink_.load(all.density), overlap = std::max(load - all.covered, 0.0f);
        if (joined_) return ink_.density(covered);
        if (covered <= 0 || load <= 0) return 0;
        float share = covered / load;
        for (int round = 0; round < kRounds; ++round) {
            const float twice = overlap * portable::pow(share, power - 1);
            const float slope = std::max(load - power * twice, kLeastSlope * load);
            share = std::min(share + (covered - share * (load - twice)) / slope, kMostShare);
        }
        return share * all.density;
    }

    // Dots that are right if they were as large as at another density of all dots become as many as cover as
    // much with the size that they have.
    void fit_sizes(Shares& dots, float as_at) const {
        const float sum = sum_of(dots);
        if (sum <= 0) return;
        const float ratio = sizes_.tone_of(sum * sizes_.at(as_at, {})) / sum;
        for (float& density : dots) density *= ratio;
    }

    // Luminance of the bare paper less that of the place, if dots lie side by side.
    float darkness(const Shares& covered) const {
        float sum = 0;
        for (std::size_t pen = 0; pen < pens_; ++pen) sum += covered[pen] * darkness_[pen];
        return sum;
    }

    InkCurve ink_;    // of all dots, where many pens share them
    InkCurve alone_;  // where one pen has all
    bool joined_;     // by lines, whose length follows from each pen's own dots
    DotAreas sizes_;  // by tone
    std::size_t pens_;
    Shares darkness_{};  // of each pen, as of a pair
    std::vector<Pair> pairs_;
};

}  // namespace

// This and the powers above were measured on flat shares of two to four pens, of 3,000 to 40,000 dots relaxed
// for 1 to 50 steps.
int steps_among_pens(int steps) {
    return static_cast<int>(std::lround(2 * portable::pow(steps, 0.25)));
}

Palette pens_for(const PenChoice& choice, const ColourGrid& colours, float exposure, glm::vec3 paper) {
    Palette pens = palette_of(choice);
    if (choice.set == PenSet::automatic) {
        std::vector<glm::vec3> some;
        const std::size_t pixels = colours.values.size();
        const std::size_t step = std::max<std::size_t>(pixels / kLookedAt, 1) | 1;
        for (std::size_t i = step / 2; i < pixels; i += step)
            some.push_back(glm::clamp(unpacked(colours.values[i]) * portable::exp2(exposure), 0.0f, 1.0f));
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
                       const InkedDots& dots) {
    const int width = tone.seen.width, height = tone.seen.height;
    const std::vector<double> areas = dot_areas(pens);
    const OverlappingDots overlapping(separation.mixer(), dots);
    const bool transparent = pens.front().ink == PenInk::transparent;
    const auto opened = [&](Shares shares) {
        const float asked = std::min(std::accumulate(shares.begin(), shares.end(), 0.0f), 1.0f);
        const float given = overlapping.ink().opened(asked);
        if (given < asked)
            for (float& share : shares) share *= given / asked;
        return shares;
    };
    // Takes too long to be found for each pixel.
    const Separation dots_of = separation.changed([&](const Shares& shares) {
        return transparent ? overlapping.transparent(opened(shares)) : overlapping.opaque(opened(shares));
    });
    Grid<float> all(width, height);
    std::vector<Grid<float>> each(pens.size(), Grid<float>(width, height));
    tbb::parallel_for(0, height, [&](int y) {
        for (int x = 0; x < width; ++x) {
            const Shares of_pens = dots_of.shares(colour_at(tone, x, y));
            float sum = 0;
            for (std::size_t pen = 0; pen < pens.size(); ++pen)
                sum += each[pen].at(x, y) = of_pens[pen] / static_cast<float>(areas[pen]);
            all.at(x, y) = sum;
        }
    });
    PenDensities densities{std::make_shared<const Density>(page_density(std::move(all))), {}};
    for (Grid<float>& grid : each) densities.each.push_back(std::make_shared<const Density>(std::move(grid)));
    return densities;
}

std::vector<double> dot_areas(std::span<const Pen> pens) {
    const double widest = width_of_pens(pens).value_or(1);
    std::vector<double> areas;
    for (const Pen& pen : pens)
        areas.push_back(portable::pow(2 * dot_radius_mm(pen, widest / 2) / widest, 2));
    return areas;
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
