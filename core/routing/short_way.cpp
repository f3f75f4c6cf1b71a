#include "core/routing/short_way.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <numeric>

#include "core/routing/greedy_way.h"
#include "core/routing/near_dots.h"
#include "core/routing/tour.h"
#include "core/routing/uncross.h"

namespace dapple {
namespace {

// Consecutive dots that are improved at once. Larger windows hinder fewer dots at their borders, but turning
// parts of them round costs more.
constexpr std::size_t kWindow = 10'000;
// Longest row of dots that is carried elsewhere.
constexpr int kLongestRow = 3;
// A chain of turns has at most so many, and tries so many ways on after none, one and two; then one.
constexpr std::size_t kLongestChain = 4;
constexpr std::array<std::size_t, 3> kBreadth{4, 2, 1};
// The share of all the time that windows take.
constexpr double kInWindows = 0.7;
// Guards against a search that never ends; how near real drawings come to it has not been measured.
constexpr std::size_t kLooksPerDot = 200;

// A closed tour through the dots of a window and one more stop, which joins the way's two ends and costs
// nothing, so that an open way's moves are a closed one's.
class Window {
 public:
    // An end that is held stays the end: there the rest of the way goes on.
    Window(std::span<const float> x, std::span<const float> y, bool holds_first, bool holds_last)
        : x_(x),
          y_(y),
          near_(near_dots(x_, y_)),
          stops_(x_.size() + 1),
          joint_(static_cast<std::uint32_t>(x_.size())),
          first_(holds_first ? 0 : joint_),
          last_(holds_last ? joint_ - 1 : joint_),
          tour_(joined(greedy_way(x_, y_, near_, holds_first, holds_last))),
          waits_(stops_) {
        near_length_.resize(near_.size());
        for (std::size_t i = 0; i < near_.size(); ++i)
            near_length_[i] = distance(static_cast<std::uint32_t>(i / kNearDots), near_[i]);
        // Gains below this are rounding.
        double length = 0;
        for (std::uint32_t i = 1; i < joint_; ++i) length += distance(i - 1, i);
        least_gain_ = 1e-9 * length;
        held_ = 10 * length + 1;
    }

    // Looks at all dots, and at whatever is around each move.
    void improve(const std::stop_token& stop) {
        for (const std::uint32_t dot : tour_.opened_at(joint_)) look_again(dot);
        std::size_t looks = 0;
        for (std::size_t next = 0; next < queue_.size() && looks < kLooksPerDot * stops_; ++next, ++looks) {
            if (looks % 1024 == 0 && stop.stop_requested()) return;
            const std::uint32_t dot = queue_[next];
            waits_[dot] = 0;
            while (carry_row_from(dot) || turn_part_at(dot) || chain_from(dot)) {
                if (++looks > kLooksPerDot * stops_) return;
            }
            if (next > stops_) {
                queue_.erase(queue_.begin(), queue_.begin() + static_cast<long>(next) + 1);
                next = static_cast<std::size_t>(-1);
            }
        }
    }

    // The dots from the first to the last.
    std::vector<std::uint32_t> way() const {
        std::vector<std::uint32_t> result = tour_.opened_at(joint_);
        // A window that was turned as a whole; with both ends free either way is as good.
        const bool turned =
            (first_ != joint_ && result.front() != first_) || (last_ != joint_ && result.back() != last_);
        if (turned) std::ranges::reverse(result);
        return result;
    }

 private:
    double distance(std::uint32_t a, std::uint32_t b) const {
        if (a == joint_ || b == joint_) {
            const std::uint32_t dot = a == joint_ ? b : a;
            return dot == first_ || dot == last_ ? -held_ : 0;
        }
        const double dx = double(x_[a]) - x_[b], dy = double(y_[a]) - y_[b];
        return std::sqrt(dx * dx + dy * dy);
    }

    void look_again(std::uint32_t dot) {
        if (waits_[dot] || dot == joint_) return;
        waits_[dot] = 1;
        queue_.push_back(dot);
    }

    bool turn_part_at(std::uint32_t a) {
        for (const bool forward : {true, false}) {
            const std::uint32_t b = tour_.beside(a, forward);
            const double a_b = distance(a, b);
            for (std::size_t k = 0; k < kNearDots; ++k) {
                const std::uint32_t c = near_[a * kNearDots + k];
                const double a_c = near_length_[a * kNearDots + k];
                if (a_c >= a_b) break;
                const std::uint32_t d = tour_.beside(c, forward);
                if (c == b || d == a) continue;
                if (a_b + distance(c, d) - a_c - distance(b, d) <= least_gain_) continue;
                tour_.exchange(a, b, c, d);
                for (const std::uint32_t dot : {a, b, c, d}) look_again(dot);
                return true;
            }
        }
        return false;
    }

    // The row begins with the dot and goes on forward or back; its beginning comes beside a near dot.
    bool carry_row_from(std::uint32_t a) {
        for (const bool forward : {true, false}) {
            std::uint32_t end = a;
            const std::uint32_t left = tour_.beside(a, !forward);
            const double left_a = distance(left, a);
            for (int length = 1; length <= kLongestRow; ++length) {
                if (length > 1) end = tour_.beside(end, forward);
                if (end == joint_) break;
                const std::uint32_t right = tour_.beside(end, forward);
                if (right == left || end == left) break;
                const double saved = left_a + distance(end, right) - distance(left, right);
                if (saved <= least_gain_) continue;
                if (carry(a, end, length, left, right, forward, saved)) return true;
            }
        }
        return false;
    }

    bool is_in_row(std::uint32_t dot, std::uint32_t a, int length, bool forward) const {
        for (std::uint32_t row = a; length > 0; --length, row = tour_.beside(row, forward)) {
            if (row == dot) return true;
        }
        return false;
    }

    bool carry(std::uint32_t a, std::uint32_t end, int length, std::uint32_t left, std::uint32_t right,
               bool forward, double saved) {
        for (std::size_t k = 0; k < kNearDots; ++k) {
            const std::uint32_t c = near_[a * kNearDots + k];
            const double a_c = near_length_[a * kNearDots + k];
            if (a_c >= saved) return false;
            if (c == a || is_in_row(c, a, length, forward)) continue;
            for (const bool on : {true, false}) {
                // Between c and d; seen in the row's direction, d follows c or goes before it.
                const std::uint32_t d = tour_.beside(c, on == forward);
                if (is_in_row(d, a, length, forward)) continue;
                if (saved - a_c - distance(end, d) + distance(c, d) <= least_gain_) continue;
                const std::uint32_t u = on ? c : d, v = on ? d : c;
                // left [a..end] right .. u v: first the row turned between u and v, as in
                // left right .. u [end..a] v.
                tour_.exchange(left, a, u, v);
                tour_.exchange(left, u, right, end);
                if (on) tour_.exchange(u, end, a, v);
                for (const std::uint32_t dot : {a, end, left, right, c, d}) look_again(dot);
                return true;
            }
        }
        return false;
    }

    // Turns in a chain, each of which may make the way longer as long as the chain does not (Lin and
    // Kernighan 1973): all have their first dot in common. Most chains come to nothing, so that turns are
    // only thought of, as stretches of places, until one is worth it.
    bool chain_from(std::uint32_t a) {
        for (const bool forward : {true, false}) {
            const std::uint32_t b = tour_.beside(a, forward);
            if (a == joint_ || b == joint_) continue;
            turns_.clear();
            if (!lengthen_chain(a, b, distance(a, b))) continue;
            for (const Turn& turn : turns_) {
                tour_.exchange(a, turn.b, turn.c, turn.d);
                for (const std::uint32_t dot : {turn.b, turn.c, turn.d}) look_again(dot);
            }
            look_again(a);
            return true;
        }
        return false;
    }

    // The edge a-b is to go; `freed` is by how much the edges that went are longer than those that came.
    bool lengthen_chain(std::uint32_t a, std::uint32_t b, double freed) {
        struct Choice {
            double freed;
            std::uint32_t c, d;
        };
        std::array<Choice, kNearDots> choices;
        std::size_t count = 0;
        const bool follows = thought_beside(a, true) == b;
        for (std::size_t k = 0; k < kNearDots; ++k) {
            const std::uint32_t d = near_[b * kNearDots + k];
            const double left = freed - near_length_[b * kNearDots + k];
            if (left <= least_gain_) break;
            // tour_.exchange() asks that b follows a as d follows c, and turns change which way that is.
            const std::uint32_t c = thought_beside(d, !follows);
            if (d == a || c == b || c == joint_) continue;
            const Choice choice{left + distance(c, d), c, d};
            std::size_t place = count++;
            for (; place > 0 && choices[place - 1].freed < choice.freed; --place)
                choices[place] = choices[place - 1];
            choices[place] = choice;
        }
        const std::size_t depth = turns_.size();
        const std::size_t most = depth < kBreadth.size() ? kBreadth[depth] : 1;
        for (std::size_t i = 0; i < std::min(count, most); ++i) {
            const auto [left, c, d] = choices[i];
            const bool gains = left - distance(a, c) > least_gain_;
            if (!gains && depth + 1 == kLongestChain) continue;
            const std::uint32_t from = thought_place(follows ? b : a), to = thought_place(follows ? c : d);
            turns_.push_back({b, c, d, from, length_between(from, to)});
            if (gains || lengthen_chain(a, c, left)) return true;
            turns_.pop_back();
        }
        return false;
    }

    // One turn of a chain: a-c and b-d take the place of a-b and c-d, by turning `length` places from `from`
    // on.
    struct Turn {
        std::uint32_t b, c, d;
        std::uint32_t from, length;

        std::uint32_t moved(std::uint32_t place, std::uint32_t stops) const {
            const std::uint32_t offset = place - from + (place < from ? stops : 0);
            if (offset >= length) return place;
            const std::uint32_t to = from + length - 1 - offset;
            return to >= stops ? to - stops : to;
        }
    };

    std::uint32_t length_between(std::uint32_t from, std::uint32_t to) const {
        return to - from + 1 + (to < from ? static_cast<std::uint32_t>(stops_) : 0);
    }
    // Where a dot is, and which is beside it, after the chain's turns.
    std::uint32_t thought_place(std::uint32_t dot) const {
        std::uint32_t place = tour_.place(dot);
        for (const Turn& turn : turns_) place = turn.moved(place, static_cast<std::uint32_t>(stops_));
        return place;
    }
    std::uint32_t thought_beside(std::uint32_t dot, bool forward) const {
        const auto stops = static_cast<std::uint32_t>(stops_);
        std::uint32_t place = thought_place(dot);
        if (forward)
            place = place + 1 == stops ? 0 : place + 1;
        else
            place = (place == 0 ? stops : place) - 1;
        for (auto turn = turns_.rbegin(); turn != turns_.rend(); ++turn) place = turn->moved(place, stops);
        return tour_.at(place);
    }

    std::span<const float> x_, y_;
    std::vector<std::uint32_t> near_;
    std::vector<double> near_length_;  // to each of them
    std::vector<Turn> turns_;          // of the chain being tried
    std::size_t stops_;
    std::uint32_t joint_, first_, last_;  // the ends that are held, or the joint
    Tour tour_;
    std::vector<char> waits_;  // in the queue
    std::vector<std::uint32_t> queue_;
    double least_gain_ = 0, held_ = 0;
};

}  // namespace

double way_length(std::span<const float> x, std::span<const float> y) {
    double length = 0;
    for (std::size_t i = 1; i < x.size(); ++i)
        length += std::hypot(double(x[i]) - x[i - 1], double(y[i]) - y[i - 1]);
    return length;
}

double way_length(std::span<const float> x, std::span<const float> y, std::span<const std::uint32_t> order) {
    double length = 0;
    for (std::size_t i = 1; i < order.size(); ++i)
        length += std::hypot(double(x[order[i]]) - x[order[i - 1]], double(y[order[i]]) - y[order[i - 1]]);
    return length;
}

std::vector<std::uint32_t> short_way(std::span<const float> x, std::span<const float> y,
                                     const RoutingWatch& watch) {
    std::vector<std::uint32_t> order(x.size());
    std::iota(order.begin(), order.end(), 0u);
    if (order.size() < 3) return order;
    const std::size_t count = (order.size() + kWindow - 1) / kWindow;
    // In whole numbers that do not overflow where addresses have 32 bits.
    const auto border = [&](std::uint64_t window) {
        return static_cast<std::size_t>(window * order.size() / count);
    };
    std::size_t done = 0;  // dots
    std::mutex telling;
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t index) {
        if (watch.stop.stop_requested()) return;
        const std::size_t first = border(index), last = border(index + 1);
        const auto across = x.subspan(first, last - first), down = y.subspan(first, last - first);
        Window window(across, down, first > 0, last < order.size());
        window.improve(watch.stop);
        const std::vector<std::uint32_t> way = window.way();
        if (way_length(across, down, way) <= way_length(across, down))
            for (std::size_t i = 0; i < way.size(); ++i)
                order[first + i] = static_cast<std::uint32_t>(first) + way[i];
        const std::scoped_lock lock(telling);
        done += way.size();
        if (watch.progress) watch.progress(kInWindows * double(done) / double(order.size()));
    });
    if (watch.stop.stop_requested()) return order;
    uncross(x, y, order, {.stop = watch.stop, .progress = [&](double share) {
                              if (watch.progress) watch.progress(kInWindows + (1 - kInWindows) * share);
                          }});
    return order;
}

void shorten_way(Dots& dots, const RoutingWatch& watch) {
    const std::vector<std::uint32_t> order = short_way(dots.x, dots.y, watch);
    for (FloatBuffer* column : {&dots.x, &dots.y, &dots.threshold, &dots.critical, &dots.radius}) {
        if (column->empty()) continue;
        FloatBuffer sorted(column->size());
        for (std::size_t i = 0; i < order.size(); ++i) sorted[i] = (*column)[order[i]];
        *column = std::move(sorted);
    }
}

}  // namespace dapple
