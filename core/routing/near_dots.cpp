#include "core/routing/near_dots.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/placing/pieces.h"

namespace dapple {
namespace {

constexpr std::size_t kLeaf = 8;

// Dots in the order of the tree's leaves: a node is a range of them, split in its middle. Ties go by the
// dots' numbers, or which of the dots as far away is found would be another with another C++ library.
class DotTree {
 public:
    DotTree(std::span<const float> x, std::span<const float> y) : x_(x), y_(y), sorted_(x.size()) {
        std::iota(sorted_.begin(), sorted_.end(), 0u);
        across_.resize(x.size());
        border_.resize(x.size());
        if (!x.empty()) split(0, x.size());
    }

    std::size_t size() const { return sorted_.size(); }

 private:
    friend class NearSearch;

    void split(std::size_t first, std::size_t last) {
        const auto begin = sorted_.begin();
        if (last - first <= kLeaf) return std::sort(begin + long(first), begin + long(last));
        float left = x_[sorted_[first]], right = left, top = y_[sorted_[first]], bottom = top;
        for (std::size_t i = first + 1; i < last; ++i) {
            left = std::min(left, x_[sorted_[i]]);
            right = std::max(right, x_[sorted_[i]]);
            top = std::min(top, y_[sorted_[i]]);
            bottom = std::max(bottom, y_[sorted_[i]]);
        }
        const std::size_t middle = (first + last) / 2;
        across_[middle] = right - left > bottom - top;
        const std::span<const float> key = across_[middle] ? x_ : y_;
        const auto before = [&](std::uint32_t a, std::uint32_t b) {
            return key[a] < key[b] || (key[a] == key[b] && a < b);
        };
        std::nth_element(begin + long(first), begin + long(middle), begin + long(last), before);
        border_[middle] = key[sorted_[middle]];
        split(first, middle);
        split(middle, last);
    }

    std::span<const float> x_, y_;
    std::vector<std::uint32_t> sorted_;
    std::vector<char> across_;   // of the node with that middle: split from left to right
    std::vector<float> border_;  // of the node with that middle: between its halves
};

// One at a time; several may search the same tree.
class NearSearch {
 public:
    NearSearch(const DotTree& tree, std::size_t count) : tree_(tree), distance_(count) {}

    void nearest(std::uint32_t dot, std::uint32_t* found) {
        self_ = dot;
        std::ranges::fill(distance_, std::numeric_limits<float>::infinity());
        found_ = found;
        count_ = 0;
        search(0, tree_.size());
        for (std::size_t k = count_; k < distance_.size(); ++k)
            found[k] = count_ > 0 ? found[count_ - 1] : dot;
    }

 private:
    void search(std::size_t first, std::size_t last) {
        if (last - first <= kLeaf) {
            for (std::size_t i = first; i < last; ++i) look_at(tree_.sorted_[i]);
            return;
        }
        const std::size_t middle = (first + last) / 2;
        const std::span<const float> key = tree_.across_[middle] ? tree_.x_ : tree_.y_;
        const float beyond = key[self_] - tree_.border_[middle];
        const bool lower = beyond < 0;
        lower ? search(first, middle) : search(middle, last);
        if (beyond * beyond < distance_.back()) lower ? search(middle, last) : search(first, middle);
    }

    void look_at(std::uint32_t dot) {
        const float dx = tree_.x_[dot] - tree_.x_[self_], dy = tree_.y_[dot] - tree_.y_[self_];
        const float distance = dx * dx + dy * dy;
        if (dot == self_ || distance >= distance_.back()) return;
        std::size_t place = std::min(count_, distance_.size() - 1);
        for (; place > 0 && distance_[place - 1] > distance; --place) {
            distance_[place] = distance_[place - 1];
            found_[place] = found_[place - 1];
        }
        distance_[place] = distance;
        found_[place] = dot;
        count_ = std::min(count_ + 1, distance_.size());
    }

    const DotTree& tree_;
    std::uint32_t self_ = 0;
    std::uint32_t* found_ = nullptr;
    std::size_t count_ = 0;
    std::vector<float> distance_;  // squared
};

}  // namespace

std::vector<std::uint32_t> near_dots(std::span<const float> x, std::span<const float> y) {
    return near_dots(x, y, kNearDots, 1);
}

std::vector<std::uint32_t> near_dots(std::span<const float> x, std::span<const float> y, std::size_t count,
                                     int threads) {
    constexpr std::size_t kAtOnce = 4096;
    std::vector<std::uint32_t> found(x.size() * count);
    const DotTree tree(x, y);
    for_each_on_threads((x.size() + kAtOnce - 1) / kAtOnce, threads_for(threads), [&](std::size_t part) {
        NearSearch search(tree, count);
        for (std::size_t i = part * kAtOnce; i < std::min(x.size(), (part + 1) * kAtOnce); ++i)
            search.nearest(static_cast<std::uint32_t>(i), &found[i * count]);
    });
    return found;
}

}  // namespace dapple
