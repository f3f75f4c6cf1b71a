#include "core/analysis/raised_counts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dapple {

RaisedCounts::RaisedCounts(std::vector<double> places, int sign)
    : y_(std::move(places)),
      sign_(sign),
      count_(y_.size()),
      block_size_(std::max<std::size_t>(8, std::size_t(std::sqrt(double(y_.size())) / 2))),
      blocks_((y_.size() + block_size_ - 1) / block_size_),
      raised_(blocks_.size()),
      best_y_(blocks_.size()),
      best_count_(blocks_.size()),
      next_slope_(blocks_.size()) {}

void RaisedCounts::raise_from(std::size_t k) {
    if (k >= y_.size()) return;
    const std::size_t block = k / block_size_;
    const std::size_t end = std::min(y_.size(), (block + 1) * block_size_);
    for (std::size_t i = k; i < end; ++i) count_[i] += 1;
    blocks_[block].changed = true;
    for (std::size_t b = block + 1; b < blocks_.size(); ++b) raised_[b] += 1;
}

double RaisedCounts::greatest(double slope) {
    double best = -std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
        if (blocks_[b].changed) rebuild(b);
        while (slope > next_slope_[b]) stand_at(b, blocks_[b].at + 1);
        best = std::max(best, sign_ * (best_count_[b] + raised_[b] - slope * best_y_[b]));
    }
    return best;
}

void RaisedCounts::stand_at(std::size_t block, std::size_t at) {
    const std::vector<std::uint32_t>& hull = blocks_[block].hull;
    blocks_[block].at = at;
    best_y_[block] = y_[hull[at]];
    best_count_[block] = count_[hull[at]];
    next_slope_[block] = at + 1 == hull.size()
                             ? std::numeric_limits<double>::infinity()
                             : (count_[hull[at + 1]] - count_[hull[at]]) / (y_[hull[at + 1]] - y_[hull[at]]);
}

// With sign +1 the upper hull, walked towards smaller y; with sign -1 the lower hull, towards greater y. Both
// turn left all the way.
void RaisedCounts::rebuild(std::size_t block) {
    const std::size_t first = block * block_size_;
    const std::size_t size = std::min(y_.size(), first + block_size_) - first;
    const auto turns_left = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        return (y_[b] - y_[a]) * (count_[c] - count_[b]) > (y_[c] - y_[b]) * (count_[b] - count_[a]);
    };
    std::vector<std::uint32_t>& hull = blocks_[block].hull;
    hull.clear();
    for (std::size_t s = 0; s < size; ++s) {
        const std::uint32_t k = std::uint32_t(sign_ > 0 ? first + size - 1 - s : first + s);
        while (hull.size() > 1 && !turns_left(hull[hull.size() - 2], hull.back(), k)) hull.pop_back();
        hull.push_back(k);
    }
    blocks_[block].changed = false;
    stand_at(block, 0);
}

}  // namespace dapple
