#include "core/pens/pen_labels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/placing/pieces.h"
#include "core/placing/placer_memory.h"
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

// exp(-u / 2) + 3 exp(-2 u)
class Kernel {
 public:
    Kernel() {
        for (std::size_t i = 0; i < values_.size(); ++i) {
            const float u = static_cast<float>(i) * kStep;
            values_[i] = std::exp(-u / 2) + 3 * std::exp(-2 * u);
        }
    }
    float operator()(float u) const {
        const float at = u / kStep;
        const auto i = static_cast<std::size_t>(at);
        return values_[i] + (values_[i + 1] - values_[i]) * (at - static_cast<float>(i));
    }

 private:
    static constexpr float kStep = kFarthest / 1024;
    std::array<float, 1026> values_;
};

class Exchange {
 public:
    Exchange(const DotsToShare& dots, PenLabels& labels, int threads)
        : dots_(dots), labels_(labels), threads_(threads_for(threads)) {
        const std::size_t n = labels.size();
        near_ = std::clamp(kMostPairs / std::max<std::size_t>(n, 1), kPartners, kMostNear);
        near_ = std::min(near_, std::max<std::size_t>(n - 1, 1));
        others_ = near_dots(dots.dots.x, dots.dots.y, near_, threads);
        energy_.resize(n * dots.pens);
    }

    // The blocks of every second round lie half a block further.
    void round(bool shifted) {
        const std::size_t n = labels_.size();
        in_parts([&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) sum_up(i);
        });
        const std::size_t shift = shifted ? kBlock / 2 : 0;
        for_each_on_threads((n + shift + kBlock - 1) / kBlock, threads_, [&](std::size_t block) {
            const std::size_t from = block * kBlock;
            const std::size_t first = from > shift ? from - shift : 0;
            const std::size_t last = std::min(n, from + kBlock - shift);
            for (int sweep = 0; sweep < kSweepsInBlock; ++sweep) {
                bool changed = false;
                for (std::size_t i = first; i < last; ++i) changed |= improve(i, first, last);
                if (!changed) break;
            }
        });
    }

 private:
    template <class Work>
    void in_parts(const Work& work) {
        const std::size_t n = labels_.size();
        for_each_on_threads((n + kBlock - 1) / kBlock, threads_,
                            [&](std::size_t part) { work(part * kBlock, std::min(n, (part + 1) * kBlock)); });
    }

    // 1 over the square of the distance at which u is 1.
    float per_sigma2(std::size_t dot, std::size_t pen) const {
        return std::max(dots_.shares[dot][pen], kSmallestShare) / (kSigma2 * dots_.area[dot]);
    }

    // Of a pair, as dots of that pen; the same from both sides.
    float between(std::size_t a, std::size_t b, std::size_t pen) const {
        const float dx = dots_.dots.x[a] - dots_.dots.x[b], dy = dots_.dots.y[a] - dots_.dots.y[b];
        const float u = (dx * dx + dy * dy) * 0.5f * (per_sigma2(a, pen) + per_sigma2(b, pen));
        return u < kFarthest ? kernel_(u) : 0.0f;
    }

    // A dot's energy for each pen that it might have.
    void sum_up(std::size_t dot) {
        float* const energy = &energy_[dot * dots_.pens];
        std::fill_n(energy, dots_.pens, 0.0f);
        for (std::size_t k = 0; k < near_; ++k) {
            const std::size_t other = others_[dot * near_ + k];
            if (other == dot) continue;
            energy[labels_[other]] += between(dot, other, labels_[other]);
        }
    }

    // What changes for the dots around when a dot of the block gets another pen.
    void relabel(std::size_t dot, std::size_t pen, std::size_t first, std::size_t last) {
        const std::size_t old = labels_[dot];
        for (std::size_t k = 0; k < near_; ++k) {
            const std::size_t other = others_[dot * near_ + k];
            if (other < first || other >= last || other == dot) continue;
            energy_[other * dots_.pens + old] -= between(dot, other, old);
            energy_[other * dots_.pens + pen] += between(dot, other, pen);
        }
        labels_[dot] = static_cast<std::uint8_t>(pen);
    }

    bool fits(std::size_t dot, std::size_t pen, std::size_t from) const {
        return dots_.shares[dot][pen] >= kLeastOfShare * dots_.shares[from][pen] &&
               dots_.shares[dot][pen] > 0;
    }

    // Exchanges a dot's pen with the one near it that gains most.
    bool improve(std::size_t dot, std::size_t first, std::size_t last) {
        const std::size_t mine = labels_[dot];
        std::size_t best = dot;
        float most = 1e-4f;
        for (std::size_t k = 0; k < std::min(kPartners, near_); ++k) {
            const std::size_t other = others_[dot * near_ + k];
            if (other < first || other >= last) continue;
            const std::size_t its = labels_[other];
            if (its == mine || !fits(dot, its, other) || !fits(other, mine, dot)) continue;
            const float* const here = &energy_[dot * dots_.pens];
            const float* const there = &energy_[other * dots_.pens];
            // The other's new place does not see its old one.
            const float gain = here[mine] + there[its] - (here[its] - between(dot, other, its)) -
                               (there[mine] - between(dot, other, mine));
            if (gain > most) most = gain, best = other;
        }
        if (best == dot) return false;
        const std::size_t its = labels_[best];
        relabel(dot, its, first, last);
        relabel(best, mine, first, last);
        return true;
    }

    const DotsToShare& dots_;
    PenLabels& labels_;
    std::size_t threads_;
    std::size_t near_ = 1;
    std::vector<std::uint32_t> others_;
    std::vector<float> energy_;  // of each dot, pen after pen
    Kernel kernel_;
};

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

void exchange_labels(const DotsToShare& dots, PenLabels& labels, int sweeps, int threads) {
    if (dots.pens < 2 || labels.size() < 2) return;
    Exchange exchange(dots, labels, threads);
    for (int sweep = 0, round = 0; sweep < sweeps; sweep += kSweepsInBlock, ++round)
        exchange.round(round % 2 == 1);
}

}  // namespace dapple
