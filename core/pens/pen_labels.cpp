#include "core/pens/pen_labels.h"

#include <algorithm>

#include "core/maths/portable_math.h"
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

}  // namespace dapple
