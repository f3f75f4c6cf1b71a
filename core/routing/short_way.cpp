#include "core/routing/short_way.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <limits>
#include <mutex>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "core/routing/near_dots.h"

namespace dapple {

namespace {

// A closed way through stops, kept as an array of them: a move turns a stretch of it round.

/// An open way's stops, and one more that joins its ends.
inline std::vector<std::uint32_t> joined(std::vector<std::uint32_t> way) {
    way.push_back(static_cast<std::uint32_t>(way.size()));
    return way;
}

/// Through the stops 0, 1, .. in any order. An open way is one of one more stop, which joins its two ends
/// and is no distance from them.
class Tour {
 public:
    explicit Tour(std::vector<std::uint32_t> stops) : stops_(std::move(stops)), place_(stops_.size()) {
        for (std::uint32_t place = 0; place < size(); ++place) place_[stops_[place]] = place;
    }

    std::uint32_t size() const { return static_cast<std::uint32_t>(stops_.size()); }
    std::uint32_t at(std::uint32_t place) const { return stops_[place]; }
    std::uint32_t place(std::uint32_t stop) const { return place_[stop]; }

    std::uint32_t after(std::uint32_t stop) const {
        const std::uint32_t place = place_[stop] + 1;
        return stops_[place == size() ? 0 : place];
    }
    std::uint32_t before(std::uint32_t stop) const {
        const std::uint32_t place = place_[stop];
        return stops_[place == 0 ? size() - 1 : place - 1];
    }
    std::uint32_t beside(std::uint32_t stop, bool forward) const {
        return forward ? after(stop) : before(stop);
    }

    /// In place of a-b and c-d there will be a-c and b-d; b follows a as d follows c, on either way round.
    void exchange(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        if (after(a) == b)
            turn(place_[b], place_[c]);
        else
            turn(place_[a], place_[d]);
    }

    /// The stops from the one after that to the one before it, which leaves out this one itself.
    std::vector<std::uint32_t> opened_at(std::uint32_t stop) const {
        std::vector<std::uint32_t> way;
        way.reserve(size() - 1);
        for (std::uint32_t next = after(stop); next != stop; next = after(next)) way.push_back(next);
        return way;
    }

 private:
    // Turns the stops at these places round, or all the others, which is the same tour.
    void turn(std::uint32_t from, std::uint32_t to) {
        const std::uint32_t count = size();
        std::uint32_t length = (to + count - from) % count + 1;
        if (2 * length > count) {
            std::swap(from, to);
            from = from + 1 == count ? 0 : from + 1;
            to = to == 0 ? count - 1 : to - 1;
            length = count - length;
        }
        for (std::uint32_t swaps = length / 2; swaps > 0; --swaps) {
            std::swap(stops_[from], stops_[to]);
            place_[stops_[from]] = from;
            place_[stops_[to]] = to;
            from = from + 1 == count ? 0 : from + 1;
            to = to == 0 ? count - 1 : to - 1;
        }
    }

    std::vector<std::uint32_t> stops_, place_;
};

constexpr std::uint32_t kNone = ~std::uint32_t{0};

// Pieces of the way, of one dot or more, that become one.
class RoutePieces {
 public:
    // A dot that is held is linked with what lies beyond the way.
    RoutePieces(std::uint32_t dots, bool holds_first, bool holds_last)
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

// A way through dots whose links do not cross.

constexpr std::uint32_t kFan = 4;  // links in a box, boxes in one of the next level
constexpr int kLongestRow = 3;     // of dots that are carried into a link
// How much further off than a link is long the others are that it sees, over their own length.
constexpr double kAround = 0.1;
// A gain below this share of a usual link's length is rounding, or not worth a move.
constexpr double kLeastGain = 1e-6;
// Links that one thread looks at before another may.
constexpr std::size_t kAtOnce = 1024;
// Each move makes the way shorter, so that they end; this guards against rounding alone.
constexpr std::size_t kLooksPerLink = 200;

// What is around some links. Empty: further from everything than anything.
struct Box {
    float left = std::numeric_limits<float>::infinity(), top = left, right = -left, bottom = -left;
    double longest = 0;  // of the links

    bool operator==(const Box&) const = default;

    void add(float x, float y) {
        left = std::min(left, x);
        right = std::max(right, x);
        top = std::min(top, y);
        bottom = std::max(bottom, y);
    }
    void add(const Box& box) {
        left = std::min(left, box.left);
        right = std::max(right, box.right);
        top = std::min(top, box.top);
        bottom = std::max(bottom, box.bottom);
        longest = std::max(longest, box.longest);
    }
    double distance(double x, double y) const {
        const double across = std::max({left - x, x - right, 0.0}),
                     down = std::max({top - y, y - bottom, 0.0});
        return std::sqrt(across * across + down * down);
    }
};

// A tour through dots and the joint of the way's two ends, with its links. Each link keeps its number until
// it goes; a new one takes the number of one that went.
class LinkedTour {
 public:
    struct Link {
        std::uint32_t a, b;
    };

    LinkedTour(std::span<const float> x, std::span<const float> y, std::vector<std::uint32_t> way)
        : x_(x), y_(y), joint_(static_cast<std::uint32_t>(way.size())), tour_(joined(std::move(way))) {
        links_.resize(tour_.size());
        length_.resize(tour_.size());
        of_stop_.resize(tour_.size());
        for (std::uint32_t i = 0; i < tour_.size(); ++i) {
            set(i, tour_.at(i), tour_.after(tour_.at(i)));
            of_stop_[links_[i].a][1] = i;
            of_stop_[links_[i].b][0] = i;
        }
        for (std::size_t below = links_.size(); below > 1;) {
            below = (below + kFan - 1) / kFan;
            levels_.emplace_back(below);
        }
        for (std::size_t level = 0; level < levels_.size(); ++level)
            for (std::uint32_t i = 0; i < levels_[level].size(); ++i) levels_[level][i] = around(level, i);
    }

    const Tour& tour() const { return tour_; }
    std::uint32_t joint() const { return joint_; }
    std::uint32_t size() const { return tour_.size(); }
    const std::array<std::uint32_t, 2>& links_of(std::uint32_t stop) const { return of_stop_[stop]; }

    // With the tour's direction.
    Link link(std::uint32_t number) const {
        const Link& link = links_[number];
        return tour_.after(link.a) == link.b ? link : Link{link.b, link.a};
    }

    double length(std::uint32_t number) const { return length_[number]; }
    double distance(std::uint32_t a, std::uint32_t b) const {
        if (a == joint_ || b == joint_) return 0;
        const double across = double(x_[a]) - x_[b], down = double(y_[a]) - y_[b];
        return std::sqrt(across * across + down * down);
    }

    // Whether two links cross, in one point that is inside both. Differences of floats that are not tiny are
    // exact, and rounding does not make products change places: whatever is said to cross does.
    bool cross(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
        return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
    }

    // As Tour::exchange().
    void exchange(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        if (b == c || a == d) return;
        const std::uint32_t one = number_of(a, b), other = number_of(c, d);
        tour_.exchange(a, b, c, d);
        set(one, a, c);
        set(other, b, d);
        std::ranges::replace(of_stop_[b], one, other);
        std::ranges::replace(of_stop_[c], other, one);
        fit(one);
        fit(other);
    }

    // Calls visit(other) for each link that crosses this one, a-b, and for most that it may be exchanged
    // with, or from whose ends a row of dots may come into it, so that the way is shorter: those in boxes
    // that reach as near to a and b as a-b is long, and for rounding's sake a little more.
    template <class Visit>
    void for_each_link_near(std::uint32_t number, const Visit& visit) const {
        const auto [a, b] = links_[number];
        search(levels_.size() - 1, 0, a, b, length_[number], visit);
    }

 private:
    int side(std::uint32_t a, std::uint32_t b, std::uint32_t p) const {
        const double one = (double(x_[b]) - x_[a]) * (double(y_[p]) - y_[a]),
                     other = (double(y_[b]) - y_[a]) * (double(x_[p]) - x_[a]);
        return (one > other) - (one < other);
    }

    void set(std::uint32_t number, std::uint32_t a, std::uint32_t b) {
        links_[number] = {a, b};
        length_[number] = distance(a, b);
    }

    std::uint32_t number_of(std::uint32_t a, std::uint32_t b) const {
        const std::uint32_t first = of_stop_[a][0];
        const Link& link = links_[first];
        return link.a == b || link.b == b ? first : of_stop_[a][1];
    }

    Box around(std::size_t level, std::uint32_t i) const {
        Box box;
        if (level > 0) {
            const std::vector<Box>& below = levels_[level - 1];
            const auto last = std::min<std::size_t>(below.size(), (i + 1) * kFan);
            for (std::size_t k = i * kFan; k < last; ++k) box.add(below[k]);
            return box;
        }
        const auto last = std::min<std::size_t>(links_.size(), (i + 1) * kFan);
        for (std::size_t k = i * kFan; k < last; ++k) {
            const auto [a, b] = links_[k];
            if (a != joint_) box.add(x_[a], y_[a]);
            if (b != joint_) box.add(x_[b], y_[b]);
            box.longest = std::max(box.longest, length_[k]);
        }
        return box;
    }

    void fit(std::uint32_t link) {
        std::uint32_t i = link;
        for (std::size_t level = 0; level < levels_.size(); ++level) {
            i /= kFan;
            const Box box = around(level, i);
            if (box == levels_[level][i]) return;
            levels_[level][i] = box;
        }
    }

    template <class Visit>
    void search(std::size_t level, std::uint32_t i, std::uint32_t a, std::uint32_t b, double reach,
                const Visit& visit) const {
        const Box& box = levels_[level][i];
        if (box.distance(x_[a], y_[a]) + box.distance(x_[b], y_[b]) >= reach + kAround * box.longest) return;
        const std::size_t below = level == 0 ? links_.size() : levels_[level - 1].size();
        const auto last = static_cast<std::uint32_t>(std::min<std::size_t>(below, (i + 1) * kFan));
        for (std::uint32_t k = i * kFan; k < last; ++k)
            level == 0 ? visit(k) : search(level - 1, k, a, b, reach, visit);
    }

    std::span<const float> x_, y_;
    std::uint32_t joint_;
    Tour tour_;
    std::vector<Link> links_;
    std::vector<double> length_;
    std::vector<std::array<std::uint32_t, 2>> of_stop_;
    std::vector<std::vector<Box>> levels_;
};

// Two links that are exchanged, a-b and c-d as in Tour::exchange(); or a row of dots that is carried between
// a and b: from `c` to `end`, following each other in that direction, with c beside a or beside b.
struct Move {
    double gain = 0;
    std::uint32_t a = 0, b = 0, c = 0, d = 0;
    bool carries = false, forward = true;
    std::uint32_t end = 0;
};

// The move that gains most of those that put something else in the place of a link.
class BestMove {
 public:
    BestMove(const LinkedTour& tour, std::uint32_t number, double least_gain)
        : tour_(tour), number_(number), least_gain_(least_gain) {
        const auto [a, b] = tour.link(number);
        if (a == tour.joint() || b == tour.joint()) return;
        best_ = {.gain = least_gain, .a = a, .b = b};
        for (const std::uint32_t at_end : tour.links_of(tour.joint())) look_at(at_end);
        tour.for_each_link_near(number, [&](std::uint32_t other) { look_at(other); });
    }

    const std::optional<Move>& found() const { return found_; }

 private:
    void look_at(std::uint32_t other) {
        if (other == number_) return;
        const auto [a, b] = std::pair(best_.a, best_.b);
        const auto [c, d] = tour_.link(other);
        if (c == b || d == a) return;
        const double a_b = tour_.length(number_), c_d = tour_.length(other);
        const double a_c = tour_.distance(a, c), b_d = tour_.distance(b, d);
        const double gain = a_b + c_d - a_c - b_d;
        // Those that cross gain, however little.
        const bool crosses = !found_ && std::abs(gain) <= least_gain_ && c != tour_.joint() &&
                             d != tour_.joint() && tour_.cross(a, b, c, d);
        if (gain > best_.gain || crosses) {
            found_ = best_;
            found_->gain = gain;
            found_->c = c;
            found_->d = d;
            best_.gain = std::max(gain, best_.gain);
        }
        // A dot that is carried away saves no more than twice the way to either of those beside it.
        const double most = a_b + 2 * c_d - best_.gain;
        const double b_c = tour_.distance(b, c), a_d = tour_.distance(a, d);
        if (a_c + b_c < most) carry_row(c, d, false, a_b + c_d, a_c, b_c);
        if (a_d + b_d < most) carry_row(d, c, true, a_b + c_d, a_d, b_d);
    }

    // One that begins with c and goes on from d away.
    void carry_row(std::uint32_t c, std::uint32_t d, bool forward, double freed, double a_c, double b_c) {
        const auto [a, b] = std::pair(best_.a, best_.b);
        std::uint32_t end = c;
        for (int length = 1; length <= kLongestRow; ++length) {
            if (end == tour_.joint()) return;
            const std::uint32_t next = tour_.tour().beside(end, forward);
            if (next == d || (end == a && next == b) || (end == b && next == a)) return;
            const double beside_a = a_c + tour_.distance(end, b), beside_b = b_c + tour_.distance(end, a);
            const double gain =
                freed + tour_.distance(end, next) - tour_.distance(d, next) - std::min(beside_a, beside_b);
            if (gain > best_.gain) {
                best_.gain = gain;
                found_ = Move{.gain = gain,
                              .a = beside_a <= beside_b ? a : b,
                              .b = beside_a <= beside_b ? b : a,
                              .c = c,
                              .d = d,
                              .carries = true,
                              .forward = forward,
                              .end = end};
            }
            end = next;
        }
    }

    const LinkedTour& tour_;
    std::uint32_t number_;
    double least_gain_;
    Move best_;
    std::optional<Move> found_;
};

// The stops whose links changed.
std::vector<std::uint32_t> make_move(LinkedTour& tour, const Move& move) {
    const auto [gain, a, b, c, d, carries, forward, end] = move;
    if (!carries) {
        tour.exchange(a, b, c, d);
        return {a, b, c, d};
    }
    // In the row's direction, d [c..end] next .. u v: the row goes between u and v and is turned there, as in
    // d next .. u [end..c] v.
    const std::uint32_t next = tour.tour().beside(end, forward);
    const bool a_first = tour.tour().beside(a, forward) == b;
    const std::uint32_t u = a_first ? a : b, v = a_first ? b : a;
    tour.exchange(d, c, u, v);
    tour.exchange(d, u, next, end);
    if (u == a) tour.exchange(u, end, c, v);
    return {a, b, c, d, end, next};
}

// Improves an open way, the dots' indices, until no two of its links cross: where two do, the part between
// them is turned round, which is always shorter (Flood 1956). Unlike moves between near dots it sees what a
// long link leads past: each link looks, in a tree of boxes around links, for those that cross it or lie
// about it, with which it could be exchanged for two shorter ones (2-opt), and for rows of one to three dots
// that are on its way (Or-opt). The way is never longer than it was. All links are looked at side by side in
// threads, and those that gain are moved in one: the result depends on the dots and the way alone. When
// stopped, what was reached is left.
void uncross(std::span<const float> x, std::span<const float> y, std::vector<std::uint32_t>& way,
             const Watch& watch) {
    if (way.size() < 4) return;
    LinkedTour tour(x, y, way);
    const double least_gain = kLeastGain * way_length(x, y, way) / tour.size();
    std::vector<char> waits(tour.size());
    std::size_t looked_at = 0;
    std::mutex telling;
    tbb::parallel_for(std::size_t{0}, (waits.size() + kAtOnce - 1) / kAtOnce, [&](std::size_t part) {
        if (watch.stop.stop_requested()) return;
        const std::size_t first = part * kAtOnce, last = std::min(waits.size(), first + kAtOnce);
        for (std::size_t link = first; link < last; ++link)
            waits[link] = BestMove(tour, static_cast<std::uint32_t>(link), least_gain).found().has_value();
        const std::scoped_lock lock(telling);
        looked_at += last - first;
        if (watch.progress) watch.progress(double(looked_at) / double(waits.size()));
    });
    std::deque<std::uint32_t> queue;
    for (std::uint32_t link = 0; link < tour.size(); ++link)
        if (waits[link]) queue.push_back(link);
    const std::size_t most_looks = kLooksPerLink * waits.size();
    for (std::size_t looks = 0; !queue.empty() && looks < most_looks; ++looks) {
        if (watch.stop.stop_requested()) break;
        const std::uint32_t link = queue.front();
        queue.pop_front();
        waits[link] = 0;
        const std::optional<Move> move = BestMove(tour, link, least_gain).found();
        if (!move) continue;
        for (const std::uint32_t stop : make_move(tour, *move)) {
            for (const std::uint32_t changed : tour.links_of(stop))
                if (!std::exchange(waits[changed], char{1})) queue.push_back(changed);
        }
    }
    way = tour.tour().opened_at(tour.joint());
}

// Consecutive dots that are improved at once. Larger windows hinder fewer dots at their borders, but turning
// parts of them round costs more.
constexpr std::size_t kWindow = 10'000;
// A chain of turns has at most so many, and tries so many ways to begin.
constexpr std::size_t kLongestChain = 4, kBeginnings = 3;
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
        const double length = way_length(x_, y_);
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
            while (carry_row_from(dot) || turn_part_at(dot) || chain_from(dot))
                if (++looks > kLooksPerDot * stops_) return;
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
        for (std::uint32_t row = a; length > 0; --length, row = tour_.beside(row, forward))
            if (row == dot) return true;
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
        for (std::size_t i = 0; i < std::min(count, depth == 0 ? kBeginnings : 1); ++i) {
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

std::vector<std::uint32_t> greedy_way(std::span<const float> x, std::span<const float> y,
                                      std::span<const std::uint32_t> near, bool holds_first,
                                      bool holds_last) {
    struct Link {
        float squared;
        std::uint32_t a, b;
        auto operator<=>(const Link&) const = default;
    };
    RoutePieces pieces(static_cast<std::uint32_t>(x.size()), holds_first, holds_last);
    std::vector<std::uint32_t> ends = pieces.ends(), near_ends;
    while (pieces.count() > 1) {
        std::vector<Link> links;
        for (std::uint32_t i = 0; i < ends.size(); ++i) {
            for (const std::uint32_t other : near.subspan(i * kNearDots, kNearDots)) {
                // Two that are near each other are one link.
                if (other < i && std::ranges::count(near.subspan(other * kNearDots, kNearDots), i) > 0)
                    continue;
                const std::uint32_t a = ends[std::min(i, other)], b = ends[std::max(i, other)];
                const float across = x[a] - x[b], down = y[a] - y[b];
                links.push_back({across * across + down * down, a, b});
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

std::vector<std::uint32_t> short_way(std::span<const float> x, std::span<const float> y, const Watch& watch) {
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

void shorten_way(Dots& dots, const Watch& watch) {
    const std::vector<std::uint32_t> order = short_way(dots.x, dots.y, watch);
    for (const auto column : kDotColumns) {
        if ((dots.*column).empty()) continue;
        FloatBuffer sorted((dots.*column).size());
        for (std::size_t i = 0; i < order.size(); ++i) sorted[i] = (dots.*column)[order[i]];
        dots.*column = std::move(sorted);
    }
}

}  // namespace dapple
