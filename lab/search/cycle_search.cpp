#include "lab/search/cycle_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "lab/search/identity_word.h"

namespace dapple {
namespace {

constexpr double kFirstFloor = 0.9, kFloorStep = 0.1;

// Places are whole numbers of 1 / period, so that distances are exact.
using Place = std::array<std::int64_t, 2>;

struct Cycle {
    std::string word;
    std::vector<Place> points{};
    std::array<int, 4> letters{};  // how often each comes
};

std::string smallest_rotation(std::string word) {
    std::string smallest = word;
    for (std::size_t i = 1; i < word.size(); ++i) {
        std::rotate(word.begin(), word.begin() + 1, word.end());
        smallest = std::min(smallest, word);
    }
    return smallest;
}

// All that do not repeat within themselves, each once.
std::vector<Cycle> cycles_of(int length, std::int64_t period) {
    std::vector<Cycle> cycles;
    for (int code = 0; code < 1 << (2 * length); ++code) {
        std::string word;
        for (int i = length; i-- > 0;) word += static_cast<char>('0' + (code >> (2 * i) & 3));
        // The smallest of its rotations, and of them alone.
        if (smallest_rotation(word) != word || (word + word).find(word, 1) != word.size()) continue;
        Cycle cycle{.word = word};
        const TileIntegers integers = integers_of(word);
        const std::int64_t unit = period / ((std::int64_t{1} << length) - 1);
        Place place{static_cast<std::int64_t>(integers.a) * unit,
                    static_cast<std::int64_t>(integers.b) * unit};
        for (const char letter : word) {
            cycle.points.push_back(place);
            ++cycle.letters[static_cast<std::size_t>(letter - '0')];
            for (std::int64_t& x : place) x = 2 * x % period;
        }
        cycles.push_back(std::move(cycle));
    }
    return cycles;
}

// Squared, between a point of the one and another point of the other.
std::int64_t nearest(const Cycle& one, const Cycle& other, std::int64_t period) {
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (const Place& p : one.points)
        for (const Place& q : other.points) {
            if (&p == &q) continue;
            std::int64_t sum = 0;
            for (std::size_t axis = 0; axis < 2; ++axis) {
                const std::int64_t apart = std::abs(p[axis] - q[axis]);
                const std::int64_t round = std::min(apart, period - apart);
                sum += round * round;
            }
            least = std::min(least, sum);
        }
    return least;
}

class Search {
 public:
    Search(std::vector<int> lengths, std::size_t top, const std::stop_token& stop)
        : lengths_(std::move(lengths)), top_(top), stop_(stop) {
        for (const int length : lengths_) {
            points_ += length;
            period_ = std::lcm(period_, (std::int64_t{1} << length) - 1);
        }
        int listed = 0;
        for (const int length : lengths_) {
            if (length != listed) {
                first_ = cycles_.size();
                for (Cycle& cycle : cycles_of(length, period_)) cycles_.push_back(std::move(cycle));
            }
            listed = length;
            ranges_.push_back({first_, cycles_.size()});
        }
        for (const Cycle& one : cycles_)
            for (const Cycle& other : cycles_) nearest_.push_back(nearest(one, other, period_));
    }

    CycleSearchResult run() {
        for (double floor = kFirstFloor; !stop_.stop_requested(); floor -= kFloorStep) {
            found_.clear();
            const double distance = std::max(floor, 0.0) * densest() * 2 * static_cast<double>(period_);
            limit_ = std::max<std::int64_t>(1, std::llround(std::floor(distance * distance)));
            extend(0, std::numeric_limits<std::int64_t>::max());
            if (!stop_.stop_requested() && (found_.size() == top_ || floor <= 0)) return {results(), true};
        }
        return {results(), false};
    }

 private:
    struct Found {
        std::int64_t nearest;
        std::vector<std::string> words;
        auto operator<=>(const Found&) const = default;
    };

    double densest() const { return std::sqrt(1 / (2 * std::numbers::sqrt3 * points_)); }

    // Puts the next cycle to those chosen, whose smallest squared distance is given.
    void extend(std::size_t slot, std::int64_t smallest) {
        if (slot == lengths_.size()) {
            offer(smallest);
            return;
        }
        auto [i, end] = ranges_[slot];
        if (slot > 0 && lengths_[slot] == lengths_[slot - 1]) i = chosen_.back() + 1;
        for (; i < end && !stop_.stop_requested(); ++i) {
            bool fits = true;
            for (std::size_t q = 0; q < 4; ++q)
                fits = fits && letters_[q] + cycles_[i].letters[q] <= points_ / 4;
            if (!fits) continue;
            std::int64_t now = std::min(smallest, nearest_[i * cycles_.size() + i]);
            for (const std::size_t other : chosen_) now = std::min(now, nearest_[i * cycles_.size() + other]);
            if (now < limit_) continue;
            chosen_.push_back(i);
            for (std::size_t q = 0; q < 4; ++q) letters_[q] += cycles_[i].letters[q];
            extend(slot + 1, now);
            for (std::size_t q = 0; q < 4; ++q) letters_[q] -= cycles_[i].letters[q];
            chosen_.pop_back();
        }
    }

    void offer(std::int64_t smallest) {
        std::array<std::vector<std::string>, 8> images;
        for (const std::size_t i : chosen_) {
            const std::array<std::string, 8> words = symmetric_words(cycles_[i].word);
            for (std::size_t g = 0; g < 8; ++g) images[g].push_back(smallest_rotation(words[g]));
        }
        for (std::vector<std::string>& image : images) std::ranges::sort(image);
        const Found tile{-smallest, *std::ranges::min_element(images)};
        const auto at = std::ranges::lower_bound(found_, tile);
        if (at != found_.end() && *at == tile) return;
        found_.insert(at, tile);
        if (found_.size() > top_) found_.pop_back();
        if (found_.size() == top_) limit_ = std::max(limit_, -found_.back().nearest);
    }

    std::vector<FoundCycles> results() const {
        std::vector<FoundCycles> results;
        for (const Found& found : found_)
            results.push_back({found.words, std::sqrt(static_cast<double>(-found.nearest)) /
                                                static_cast<double>(period_) / 2 / densest()});
        return results;
    }

    std::vector<int> lengths_;
    std::size_t top_;
    std::stop_token stop_;
    int points_ = 0;
    std::int64_t period_ = 1;
    std::size_t first_ = 0;
    std::vector<Cycle> cycles_;
    std::vector<std::array<std::size_t, 2>> ranges_;  // per slot: from which cycle to which
    std::vector<std::int64_t> nearest_;               // of each two cycles
    std::int64_t limit_ = 1;                          // squared: what is closer is of no interest
    std::vector<std::size_t> chosen_;
    std::array<int, 4> letters_{};
    std::vector<Found> found_;  // the distance negated, so that the best come first
};

}  // namespace

CycleSearchResult search_cycles(std::vector<int> lengths, std::size_t top, const std::stop_token& stop) {
    std::ranges::sort(lengths);
    if (lengths.empty() || lengths.front() < 1 || lengths.back() > kMostCycleLength)
        throw std::runtime_error(fmt::format("cycles can have 1 to {} points", kMostCycleLength));
    const int points = std::accumulate(lengths.begin(), lengths.end(), 0);
    if (points % 4 != 0)
        throw std::runtime_error(
            fmt::format("cycles of {} points together; give lengths whose sum is a multiple of 4", points));
    return Search(std::move(lengths), top, stop).run();
}

}  // namespace dapple
