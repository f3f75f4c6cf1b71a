#include "core/routing/greedy_way.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "core/routing/near_dots.h"

namespace dapple {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};

// Pieces of the way, of one dot or more, that become one.
class Pieces {
 public:
    // A dot that is held is linked with what lies beyond the way.
    Pieces(std::uint32_t dots, bool holds_first, bool holds_last)
        : beyond_(dots), links_(dots, {kNone, kNone}), other_end_(dots + 1), count_(dots) {
        std::iota(other_end_.begin(), other_end_.end(), 0u);
        if (holds_first) links_.front()[0] = beyond_;
        if (holds_last) links_.back()[0] = beyond_;
        if (holds_first && holds_last) --count_;
        const std::uint32_t one = holds_first ? 0 : beyond_, other = holds_last ? dots - 1 : beyond_;
        other_end_[one] = other;
        other_end_[other] = one;
    }

    std::uint32_t count() const { return count_; }

    std::vector<std::uint32_t> ends() const {
        std::vector<std::uint32_t> ends;
        for (std::uint32_t dot = 0; dot < beyond_; ++dot)
            if (is_end(dot)) ends.push_back(dot);
        return ends;
    }

    void link(std::uint32_t a, std::uint32_t b) {
        if (a == b || !is_end(a) || !is_end(b) || other_end_[a] == b) return;
        add(a, b);
        const std::uint32_t left = other_end_[a], right = other_end_[b];
        other_end_[left] = right;
        other_end_[right] = left;
        --count_;
    }

    // Once there is one piece. Held at both ends it has two others, in its middle.
    std::vector<std::uint32_t> way() {
        const std::vector<std::uint32_t> ends = this->ends();
        const bool holds_first = links_.front()[0] == beyond_, holds_last = links_.back()[0] == beyond_;
        if (holds_first && holds_last) add(ends.front(), ends.back());
        std::uint32_t dot = holds_first ? 0 : holds_last ? beyond_ - 1 : ends.front();
        std::uint32_t before = holds_first || holds_last ? beyond_ : kNone;
        std::vector<std::uint32_t> way{dot};
        while (way.size() < beyond_) {
            const std::array<std::uint32_t, 2>& links = links_[dot];
            before = std::exchange(dot, links[0] == before ? links[1] : links[0]);
            way.push_back(dot);
        }
        if (holds_last && !holds_first) std::ranges::reverse(way);
        return way;
    }

 private:
    bool is_end(std::uint32_t dot) const { return links_[dot][1] == kNone; }
    void add(std::uint32_t a, std::uint32_t b) {
        links_[a][links_[a][0] == kNone ? 0 : 1] = b;
        links_[b][links_[b][0] == kNone ? 0 : 1] = a;
    }

    std::uint32_t beyond_;
    std::vector<std::array<std::uint32_t, 2>> links_;
    std::vector<std::uint32_t> other_end_;  // of a piece that ends with a dot
    std::uint32_t count_;
};

}  // namespace

std::vector<std::uint32_t> greedy_way(std::span<const float> x, std::span<const float> y,
                                      std::span<const std::uint32_t> near, bool holds_first,
                                      bool holds_last) {
    struct Link {
        float squared;
        std::uint32_t a, b;
        auto operator<=>(const Link&) const = default;
    };
    Pieces pieces(static_cast<std::uint32_t>(x.size()), holds_first, holds_last);
    std::vector<std::uint32_t> ends = pieces.ends(), near_ends;
    while (pieces.count() > 1) {
        std::vector<Link> links;
        for (std::size_t i = 0; i < ends.size(); ++i) {
            for (std::size_t k = 0; k < kNearDots; ++k) {
                const std::uint32_t a = ends[i], b = ends[near[i * kNearDots + k]];
                const float across = x[a] - x[b], down = y[a] - y[b];
                links.push_back({across * across + down * down, std::min(a, b), std::max(a, b)});
            }
        }
        std::ranges::sort(links);
        for (const Link& link : links) pieces.link(link.a, link.b);
        if (pieces.count() == 1) break;
        ends = pieces.ends();
        std::vector<float> across, down;
        for (const std::uint32_t end : ends) {
            across.push_back(x[end]);
            down.push_back(y[end]);
        }
        near_ends = near_dots(across, down);
        near = near_ends;
    }
    return pieces.way();
}

}  // namespace dapple
