#include "core/routing/uncross.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>

#include "core/routing/tour.h"

namespace dapple {
namespace {

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

}  // namespace

void uncross(std::span<const float> x, std::span<const float> y, std::vector<std::uint32_t>& way,
             const RoutingWatch& watch) {
    if (way.size() < 4) return;
    LinkedTour tour(x, y, way);
    double length = 0;
    for (std::uint32_t link = 0; link < tour.size(); ++link) length += tour.length(link);
    const double least_gain = kLeastGain * length / tour.size();
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
            for (const std::uint32_t changed : tour.links_of(stop)) {
                if (!std::exchange(waits[changed], char{1})) queue.push_back(changed);
            }
        }
    }
    way = tour.tour().opened_at(tour.joint());
}

}  // namespace dapple
