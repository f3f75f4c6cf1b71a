#include "lab/search/coherent_peaks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dapple {

CoherentPeaks::CoherentPeaks(std::size_t points, double weight, double limit)
    : weight_(weight),
      limit_(limit),
      side_(std::sqrt(static_cast<double>(points))),
      per_point_(16 / static_cast<double>(points)),
      highest_frequency_(static_cast<int>(2 * side_)) {
    if (empty()) return;
    for (int x = 0; x <= highest_frequency_; ++x) {
        for (int y = std::max(x, 1); y <= highest_frequency_; ++y) {
            if (x * x + y * y <= 4 * static_cast<int>(points)) frequencies_.push_back({x, y});
        }
    }
    cos_x_.resize(static_cast<std::size_t>(highest_frequency_) + 1);
    cos_y_.resize(cos_x_.size());
}

// The cosines of all multiples of an angle, by the recurrence of Chebyshev's polynomials.
void CoherentPeaks::fill_cosines(glm::dvec2 p) {
    const double step_x = 2 * std::cos(2 * std::numbers::pi * p.x / side_);
    const double step_y = 2 * std::cos(2 * std::numbers::pi * p.y / side_);
    double x = 1, x_before = step_x / 2, y = 1, y_before = step_y / 2;
    for (std::size_t k = 0; k < cos_x_.size(); ++k) {
        cos_x_[k] = static_cast<float>(x);
        cos_y_[k] = static_cast<float>(y);
        const double x_next = step_x * x - x_before, y_next = step_y * y - y_before;
        x_before = x;
        y_before = y;
        x = x_next;
        y = y_next;
    }
}

double CoherentPeaks::wave(Frequency k) const {
    return 0.5 * static_cast<double>(cos_x_[k.x] * cos_y_[k.y] + cos_x_[k.y] * cos_y_[k.x]);
}

double CoherentPeaks::penalty_of(double sum) const {
    const double above = std::max(0.0, per_point_ * sum * sum - limit_);
    return weight_ * above * above;
}

void CoherentPeaks::reset(std::span<const glm::dvec2> positions) {
    if (empty()) return;
    std::vector<double> all(frequencies_.size(), 0.0);
    for (const glm::dvec2 p : positions) {
        fill_cosines(p);
        for (std::size_t k = 0; k < all.size(); ++k) all[k] += wave(frequencies_[k]);
    }
    watched_.clear();
    sums_.clear();
    penalty_ = highest_ = 0;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const double height = per_point_ * all[k] * all[k];
        highest_ = std::max(highest_, height);
        penalty_ += penalty_of(all[k]);
        if (height < limit_ / 3) continue;
        watched_.push_back(frequencies_[k]);
        sums_.push_back(all[k]);
    }
}

double CoherentPeaks::try_moves(std::span<const Move> moves) {
    tried_ = sums_;
    for (const Move& move : moves) {
        fill_cosines(move.from);
        for (std::size_t k = 0; k < watched_.size(); ++k) tried_[k] -= wave(watched_[k]);
        fill_cosines(move.to);
        for (std::size_t k = 0; k < watched_.size(); ++k) tried_[k] += wave(watched_[k]);
    }
    tried_penalty_ = 0;
    for (const double sum : tried_) tried_penalty_ += penalty_of(sum);
    return tried_penalty_ - penalty_;
}

void CoherentPeaks::take() {
    sums_.swap(tried_);
    penalty_ = tried_penalty_;
}

}  // namespace dapple
