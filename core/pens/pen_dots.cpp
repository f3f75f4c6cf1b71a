#include "core/pens/pen_dots.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "core/maths/portable_math.h"
#include "core/placing/dot_order.h"
#include "core/placing/pieces.h"
#include "core/relaxing/relax.h"
#include "core/routing/near_dots.h"

namespace dapple {

namespace {

constexpr float kSigma2 = 0.62f * 0.62f;  // over the area that a pen has for each of its dots
constexpr float kFarthest = 12;           // u, beyond which dots don't matter to each other
constexpr float kSmallestShare = 1.0f / 64;
constexpr std::size_t kMostNear = 96;
constexpr std::size_t kMostPairs = std::size_t{1} << 27;  // in memory, 4 bytes each
constexpr std::size_t kPartners = 10;                     // nearest dots that exchange labels
// A pen does not go where it has less than so much of the share that it had.
constexpr float kLeastOfShare = 0.3f;
constexpr std::size_t kBlock = 4096;  // dots that exchange among themselves at a time
constexpr int kSweepsInBlock = 4;
constexpr std::size_t kKernelSteps = 1024;
constexpr float kKernelStep = kFarthest / kKernelSteps;

template <class Work>
void in_parts(std::size_t dots, std::size_t threads, const Work& work) {
    for_each_on_threads((dots + kBlock - 1) / kBlock, threads,
                        [&](std::size_t part) { work(part * kBlock, std::min(dots, (part + 1) * kBlock)); });
}

}  // namespace

PenLabels shared_out(const DotsToShare& dots) {
    PenLabels labels(dots.dots.size());
    Shares lag{};
    for (std::size_t i = 0; i < labels.size(); ++i) {
        std::size_t pen = 0;
        for (std::size_t k = 0; k < dots.pens; ++k) {
            lag[k] += dots.shares[i][k];
            // Where a pen has no share at all it has no dot.
            const bool has_share = dots.shares[i][k] > 0, best_has = dots.shares[i][pen] > 0;
            if (has_share && (!best_has || lag[k] > lag[pen])) pen = k;
        }
        lag[pen] -= 1;
        labels[i] = static_cast<std::uint8_t>(pen);
    }
    return labels;
}

LabelExchange::LabelExchange(const DotsToShare& dots, int threads)
    : dots_(dots), threads_(threads_for(threads)) {
    const std::size_t n = dots.dots.size();
    if (dots.pens < 2 || n < 2) return;
    near_ = std::clamp(kMostPairs / n, kPartners, kMostNear);
    near_ = std::min(near_, n - 1);
    others_ = near_dots(dots.dots.x, dots.dots.y, near_, threads);
    per_sigma2_.resize(n * dots.pens);
    energy_.resize(n * dots.pens);
    kernel_.resize(kKernelSteps + 2);
    for (std::size_t i = 0; i < kernel_.size(); ++i) {
        const float u = static_cast<float>(i) * kKernelStep;
        kernel_[i] = portable::exp(-u / 2) + 3 * portable::exp(-2 * u);
    }
}

void LabelExchange::exchange(PenLabels& labels, int sweeps) {
    if (others_.empty()) return;
    in_parts(labels.size(), threads_, [&](std::size_t first, std::size_t last) {
        for (std::size_t dot = first; dot < last; ++dot)
            for (std::size_t pen = 0; pen < dots_.pens; ++pen)
                per_sigma2_[dot * dots_.pens + pen] =
                    std::max(dots_.shares[dot][pen], kSmallestShare) / (kSigma2 * dots_.area[dot]);
    });
    for (int sweep = 0, round = 0; sweep < sweeps; sweep += kSweepsInBlock, ++round)
        exchange_once(labels, round % 2 == 1);
}

// The blocks of every second round lie half a block further.
void LabelExchange::exchange_once(PenLabels& labels, bool shifted) {
    const std::size_t n = labels.size();
    in_parts(n, threads_, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) sum_up(labels, i);
    });
    const std::size_t shift = shifted ? kBlock / 2 : 0;
    for_each_on_threads((n + shift + kBlock - 1) / kBlock, threads_, [&](std::size_t block) {
        const std::size_t from = block * kBlock;
        const std::size_t first = from > shift ? from - shift : 0;
        const std::size_t last = std::min(n, from + kBlock - shift);
        for (int sweep = 0; sweep < kSweepsInBlock; ++sweep) {
            bool changed = false;
            for (std::size_t i = first; i < last; ++i) changed |= improve(labels, i, first, last);
            if (!changed) break;
        }
    });
}

float LabelExchange::distance2(std::size_t a, std::size_t b) const {
    const float dx = dots_.dots.x[a] - dots_.dots.x[b], dy = dots_.dots.y[a] - dots_.dots.y[b];
    return dx * dx + dy * dy;
}

// The energy of a pair, as dots of that pen; the same from both sides.
float LabelExchange::between(std::size_t a, std::size_t b, float distance2, std::size_t pen) const {
    const float u =
        distance2 * 0.5f * (per_sigma2_[a * dots_.pens + pen] + per_sigma2_[b * dots_.pens + pen]);
    if (!(u < kFarthest)) return 0;
    const float at = u / kKernelStep;
    const auto i = static_cast<std::size_t>(at);
    return kernel_[i] + (kernel_[i + 1] - kernel_[i]) * (at - static_cast<float>(i));
}

// A dot's energy for each pen that it might have.
void LabelExchange::sum_up(const PenLabels& labels, std::size_t dot) {
    float* const energy = &energy_[dot * dots_.pens];
    std::fill_n(energy, dots_.pens, 0.0f);
    for (std::size_t k = 0; k < near_; ++k) {
        const std::size_t other = others_[dot * near_ + k];
        if (other == dot) continue;
        energy[labels[other]] += between(dot, other, distance2(dot, other), labels[other]);
    }
}

// What changes for the dots around when a dot of the block gets another pen.
void LabelExchange::relabel(PenLabels& labels, std::size_t dot, std::size_t pen, std::size_t first,
                            std::size_t last) {
    const std::size_t old = labels[dot];
    for (std::size_t k = 0; k < near_; ++k) {
        const std::size_t other = others_[dot * near_ + k];
        if (other < first || other >= last || other == dot) continue;
        const float far = distance2(dot, other);
        energy_[other * dots_.pens + old] -= between(dot, other, far, old);
        energy_[other * dots_.pens + pen] += between(dot, other, far, pen);
    }
    labels[dot] = static_cast<std::uint8_t>(pen);
}

// Exchanges a dot's pen with the one near it that gains most.
bool LabelExchange::improve(PenLabels& labels, std::size_t dot, std::size_t first, std::size_t last) {
    const auto fits = [&](std::size_t it, std::size_t pen, std::size_t from) {
        return dots_.shares[it][pen] >= kLeastOfShare * dots_.shares[from][pen] && dots_.shares[it][pen] > 0;
    };
    const std::size_t mine = labels[dot];
    const float* const here = &energy_[dot * dots_.pens];
    std::size_t best = dot;
    float most = 1e-4f;
    for (std::size_t k = 0; k < std::min(kPartners, near_); ++k) {
        const std::size_t other = others_[dot * near_ + k];
        if (other < first || other >= last) continue;
        const std::size_t its = labels[other];
        if (its == mine) continue;
        const float* const there = &energy_[other * dots_.pens];
        if (!fits(dot, its, other) || !fits(other, mine, dot)) continue;
        const float far = distance2(dot, other);
        // The other's new place does not see its old one.
        const float gain = here[mine] + there[its] - (here[its] - between(dot, other, far, its)) -
                           (there[mine] - between(dot, other, far, mine));
        if (gain > most) most = gain, best = other;
    }
    if (best == dot) return false;
    const std::size_t its = labels[best];
    relabel(labels, dot, its, first, last);
    relabel(labels, best, mine, first, last);
    return true;
}

namespace {

constexpr int kMovingRounds = 4;  // of exchanging and moving
constexpr int kWarpsOfAll = 2;
constexpr int kFirstSweeps = 24;  // of exchanging
constexpr int kSweeps = 12;
constexpr float kForAll = 0.67f;       // of a move; the rest is for the pen's own dots
constexpr int kRoundsForSizes = 8;     // of moving alone, where pens' dots differ in size
constexpr float kForAllSizes = 0.8f;   // of such a move
constexpr float kFarthestOwn = 0.22f;  // that a dot moves for its own pen, over the distance between dots

constexpr RelaxingStep kWarp{RelaxingStep::Kind::warp};

// All dots in one piece, near ones near each other.
Dots along_curve(const DotPieces& dots) {
    Dots all;
    for (const Dots& piece : dots.pieces) append(all, piece);
    sort_dots(all, DotOrder::space);
    return all;
}

class Sharing {
 public:
    Sharing(Dots& dots, const PenDensities& densities, const PenDotsRequest& request)
        : dots_(dots), densities_(densities), request_(request) {
        if (!request_.areas.empty()) ink_.emplace(ink());
        look();
    }

    DotsToShare to_share() const { return {dots_, shares_, area_, densities_.each.size()}; }

    // Each dot goes towards the middle of its Voronoi cell, some of the way that among all dots and some of
    // the way that among its own pen's. False if stopped.
    bool move(const PenLabels& labels, float for_all, const std::stop_token& stop) {
        if (ink_) give_room(labels);
        Dots to = ink_ ? stepped(dots_, *ink_, true, stop) : stepped(dots_, *densities_.all, false, stop);
        dots_.radius.clear();
        if (stop.stop_requested()) return false;
        for (std::size_t i = 0; i < dots_.size(); ++i) {
            to.x[i] = dots_.x[i] + for_all * (to.x[i] - dots_.x[i]);
            to.y[i] = dots_.y[i] + for_all * (to.y[i] - dots_.y[i]);
        }
        for_each_pens_step(labels, {}, stop, [&](std::size_t i, float dx, float dy) {
            const float way = std::sqrt(dx * dx + dy * dy), most = kFarthestOwn * std::sqrt(area_[i]);
            const float share = (1 - for_all) * (way > most ? most / way : 1.0f);
            to.x[i] += share * dx;
            to.y[i] += share * dy;
        });
        if (stop.stop_requested()) return false;
        take(to);
        return true;
    }

    // Each pen's dots become as many as they should be over several of its own, at the cost of distances
    // among all. False if stopped.
    bool warp_each(const PenLabels& labels, const std::stop_token& stop) {
        Dots to = dots_;
        for_each_pens_step(labels, kWarp, stop, [&](std::size_t i, float dx, float dy) {
            to.x[i] += dx;
            to.y[i] += dy;
        });
        if (stop.stop_requested()) return false;
        take(to);
        return true;
    }

    // The same of all dots, whose distances it leaves.
    bool warp_all(const std::stop_token& stop) {
        take(stepped(dots_, *densities_.all, false, stop, kWarp));
        return !stop.stop_requested();
    }

 private:
    // Calls go(dot, across, down) for each dot, with what such a step among its own pen's dots is.
    template <class Go>
    void for_each_pens_step(const PenLabels& labels, const RelaxingStep& how, const std::stop_token& stop,
                            const Go& go) const {
        for (std::size_t pen = 0; pen < densities_.each.size(); ++pen) {
            Dots own;
            std::vector<std::size_t> numbers;
            for (std::size_t i = 0; i < dots_.size(); ++i) {
                if (labels[i] != pen) continue;
                own.x.push_back(dots_.x[i]);
                own.y.push_back(dots_.y[i]);
                numbers.push_back(i);
            }
            if (own.size() < 2) continue;
            const Dots moved = stepped(own, *densities_.each[pen], false, stop, how);
            if (stop.stop_requested()) return;
            for (std::size_t k = 0; k < numbers.size(); ++k)
                go(numbers[k], moved.x[k] - own.x[k], moved.y[k] - own.y[k]);
        }
    }

    void take(const Dots& to) {
        const double longer = densities_.all->longer_side();
        const auto right = static_cast<float>(densities_.all->width() / longer);
        const auto bottom = static_cast<float>(densities_.all->height() / longer);
        for (std::size_t i = 0; i < dots_.size(); ++i) {
            dots_.x[i] = std::clamp(to.x[i], 0.0f, std::nextafter(right, 0.0f));
            dots_.y[i] = std::clamp(to.y[i], 0.0f, std::nextafter(bottom, 0.0f));
        }
        look();
    }

    // The density of the ink: of dots of area 1 as many as have it.
    Density ink() const {
        Grid<float> sum(densities_.all->width(), densities_.all->height());
        for (std::size_t pen = 0; pen < densities_.each.size(); ++pen) {
            const std::vector<float>& densities = densities_.each[pen]->values().values;
            const auto area = static_cast<float>(request_.areas[pen]);
            for (std::size_t i = 0; i < densities.size(); ++i) sum.values[i] += area * densities[i];
        }
        return Density(std::move(sum));
    }

    // Each dot's radius becomes that of the disc that is its part of the paper, which goes by its area.
    void give_room(const PenLabels& labels) {
        const std::vector<double>& areas = request_.areas;
        dots_.radius.resize(dots_.size());
        for (std::size_t i = 0; i < dots_.size(); ++i) {
            const double mean = std::inner_product(areas.begin(), areas.end(), shares_[i].begin(), 0.0);
            dots_.radius[i] =
                static_cast<float>(std::sqrt(area_[i] * areas[labels[i]] / (mean * std::numbers::pi)));
        }
    }

    Dots stepped(const Dots& dots, const Density& density, bool by_radius, const std::stop_token& stop,
                 const RelaxingStep& how = {}) const {
        Relaxation relaxation(in_one_piece(dots), density,
                              {.scale = request_.scale, .threads = request_.threads, .by_radius = by_radius});
        relaxation.step(how, stop);
        return relaxation.dots_as_taken();
    }

    // What there is where the dots lie now.
    void look() {
        constexpr std::size_t kAtOnce = 4096;
        shares_.resize(dots_.size());
        area_.resize(dots_.size());
        const double full = kDotsPerScale * request_.scale;
        for_each_on_threads(
            (dots_.size() + kAtOnce - 1) / kAtOnce, threads_for(request_.threads), [&](std::size_t part) {
                const std::size_t last = std::min(dots_.size(), (part + 1) * kAtOnce);
                for (std::size_t i = part * kAtOnce; i < last; ++i) {
                    const glm::dvec2 place(dots_.x[i], dots_.y[i]);
                    shares_[i] = densities_.shares_at(place);
                    area_[i] = static_cast<float>(1 / (full * std::max(densities_.all->at(place), 1e-4)));
                }
            });
    }

    Dots& dots_;
    const PenDensities& densities_;
    const PenDotsRequest& request_;
    std::optional<Density> ink_;  // where dots differ in size
    std::vector<Shares> shares_;
    std::vector<float> area_;
};

}  // namespace

Shares PenDensities::shares_at(glm::dvec2 place) const {
    Shares shares{};
    double sum = 0;
    for (std::size_t pen = 0; pen < each.size(); ++pen) {
        const double density = each[pen]->at(place);
        shares[pen] = static_cast<float>(density);
        sum += density;
    }
    for (std::size_t pen = 0; pen < each.size(); ++pen)
        shares[pen] =
            sum > 0 ? static_cast<float>(shares[pen] / sum) : 1.0f / static_cast<float>(each.size());
    return shares;
}

// Exchanges pens and moves dots until each pen's own are even. False if stopped.
static bool even_out(Sharing& sharing, PenLabels& labels, const PenDotsRequest& request,
                     const std::stop_token& stop) {
    // Dots move by less than the distance between them, so that those near each other stay so.
    LabelExchange exchange(sharing.to_share(), request.threads);
    exchange.exchange(labels, kFirstSweeps);
    if (!request.move) return !stop.stop_requested();
    // Moves then bring dots of different pens apart again.
    if (!sharing.warp_each(labels, stop)) return false;
    for (int round = 0; round < kMovingRounds; ++round) {
        if (!sharing.move(labels, kForAll, stop)) return false;
        exchange.exchange(labels, kSweeps);
    }
    for (int i = 0; request.areas.empty() && i < kWarpsOfAll; ++i)
        if (!sharing.warp_all(stop)) return false;
    // Exchanging would undo it: it does not see sizes.
    for (int round = 0; !request.areas.empty() && round < kRoundsForSizes; ++round)
        if (!sharing.move(labels, kForAllSizes, stop)) return false;
    return !stop.stop_requested();
}

DotPieces pen_dots(const DotPieces& placed, const PenDensities& densities, const PenDotsRequest& request,
                   const std::stop_token& stop) {
    Dots dots = along_curve(placed);
    Sharing sharing(dots, densities, request);
    PenLabels labels = shared_out(sharing.to_share());
    if (!request.rough && !even_out(sharing, labels, request, stop)) return {};
    DotPieces pieces;
    pieces.pieces.resize(densities.each.size());
    for (std::size_t pen = 0; pen < pieces.pieces.size(); ++pen)
        pieces.pieces[pen].pen = static_cast<int>(pen);
    for (std::size_t i = 0; i < dots.size(); ++i) {
        Dots& piece = pieces.pieces[labels[i]];
        for (const auto column : kDotColumns)
            if (!(dots.*column).empty()) (piece.*column).push_back((dots.*column)[i]);
    }
    return pieces;
}

}  // namespace dapple
