#include "core/analysis/report.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/failure.h"

namespace dapple {

namespace {

// Counts over ascending places that are raised from some place to the end, and their greatest deviation from
// a line: the inner part of the sweep for the star discrepancy.

/// Counts c_k at places y_k, all 0 at first, and the greatest of sign * (c_k - slope y_k) over all k.
///
/// In blocks of about sqrt(n) / 2: raising the counts from k on changes one block and a number for each later
/// one. The greatest of a block is on its convex hull, further along for a greater slope. Slopes never
/// decrease, so the search of each block goes on where it stopped; hulls are made anew only when they are
/// asked.
class RaisedCounts {
 public:
    /// `places` ascend; sign is +1 (how far counts are above the line) or -1 (below).
    RaisedCounts(std::vector<double> places, int sign);

    /// Adds 1 to c_k, c_{k+1}, ...; nothing if k is beyond the last place.
    void raise_from(std::size_t k);

    /// The greatest deviation. `slope` is not smaller than in earlier calls.
    double greatest(double slope);

 private:
    struct Block {
        std::vector<std::uint32_t> hull;  // in the order that growing slopes visit
        std::size_t at = 0;
        bool changed = true;
    };

    void rebuild(std::size_t block);
    void stand_at(std::size_t block, std::size_t at);

    std::vector<double> y_;
    double sign_;
    std::vector<double> count_;  // without what is in raised_
    std::size_t block_size_;
    std::vector<Block> blocks_;
    // For each block, side by side for speed:
    std::vector<double> raised_;  // added to all its counts
    std::vector<double> best_y_;  // of the hull's corner where the search stands
    std::vector<double> best_count_;
    std::vector<double> next_slope_;  // from which on the hull's next corner is better
};

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

// The points in the unit square, by ascending x.
std::vector<glm::dvec2> unit_points_by_x(std::span<const glm::dvec2> points, const Domain& domain) {
    std::vector<glm::dvec2> unit(points.begin(), points.end());
    for (glm::dvec2& p : unit) p /= glm::dvec2(domain.width, domain.height);
    std::sort(unit.begin(), unit.end(),
              [](glm::dvec2 a, glm::dvec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    return unit;
}

std::vector<double> distinct_y(const std::vector<glm::dvec2>& points) {
    std::vector<double> y;
    for (const glm::dvec2 p : points) y.push_back(p.y);
    std::sort(y.begin(), y.end());
    y.erase(std::unique(y.begin(), y.end()), y.end());
    return y;
}

std::size_t place_of(const std::vector<double>& sorted, double value) {
    return std::size_t(std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin());
}

// The greatest excess of points in closed boxes [0, x] x [0, y]: corners at the points' own x and y.
double greatest_excess(const std::vector<glm::dvec2>& by_x, const std::vector<double>& y,
                       std::stop_token stop) {
    const double n = double(by_x.size());
    RaisedCounts counts(y, +1);
    double greatest = 0;
    double possible = 0;  // a bound for the excess here: each point adds 1 at most
    for (std::size_t i = 0; i < by_x.size() && !stop.stop_requested();) {
        const double x = by_x[i].x;
        for (; i < by_x.size() && by_x[i].x == x; ++i) {
            counts.raise_from(place_of(y, by_x[i].y));
            possible += 1;
        }
        if (possible <= greatest) continue;
        possible = counts.greatest(n * x);
        greatest = std::max(greatest, possible);
    }
    return greatest / n;
}

// The greatest lack of points in open boxes [0, x) x [0, y): corners at the points' own x and y, and at 1.
double greatest_lack(const std::vector<glm::dvec2>& by_x, std::vector<double> y, std::stop_token stop) {
    const double n = double(by_x.size());
    if (y.back() < 1) y.push_back(1);
    RaisedCounts counts(y, -1);
    double greatest = 0;
    double last_x = 0, last_lack = 0;  // since then the lack has grown by n (x - last_x) at most
    const auto ask_at = [&](double x) {
        if (last_lack + n * (x - last_x) <= greatest) return;
        last_x = x;
        last_lack = counts.greatest(n * x);
        greatest = std::max(greatest, last_lack);
    };
    for (std::size_t i = 0; i < by_x.size() && !stop.stop_requested();) {
        const double x = by_x[i].x;
        ask_at(x);
        for (; i < by_x.size() && by_x[i].x == x; ++i) counts.raise_from(place_of(y, by_x[i].y) + 1);
    }
    if (by_x.back().x < 1) ask_at(1);
    return greatest / n;
}

StarDiscrepancy bracket(const std::vector<glm::dvec2>& points) {
    constexpr std::size_t kSide = 1024;
    constexpr std::size_t kStride = kSide + 1;
    // Points below and left of each corner of the grid; points on the upper edges count with the last cells.
    std::vector<double> share(kStride * kStride);
    for (const glm::dvec2 p : points) {
        const std::size_t x = std::min(kSide - 1, std::size_t(p.x * kSide));
        const std::size_t y = std::min(kSide - 1, std::size_t(p.y * kSide));
        share[(y + 1) * kStride + x + 1] += 1;
    }
    for (std::size_t y = 1; y <= kSide; ++y)
        for (std::size_t x = 1; x <= kSide; ++x)
            share[y * kStride + x] +=
                share[(y - 1) * kStride + x] + share[y * kStride + x - 1] - share[(y - 1) * kStride + x - 1];
    const double n = double(points.size());
    const auto area = [](std::size_t x, std::size_t y) { return double(x * y) / double(kSide * kSide); };
    StarDiscrepancy result;
    for (std::size_t y = 1; y <= kSide; ++y)
        for (std::size_t x = 1; x <= kSide; ++x) {
            const double outer = share[y * kStride + x] / n;
            const double inner = share[(y - 1) * kStride + x - 1] / n;
            // The corner (1, 1) holds all points whatever their place on the edge.
            result.lower = std::max(result.lower, std::abs(outer - area(x, y)));
            result.upper = std::max({result.upper, outer - area(x - 1, y - 1), area(x, y) - inner});
        }
    return result;
}

}  // namespace

double l2_star_discrepancy(std::span<const glm::dvec2> points, const Domain& domain) {
    if (points.empty()) return 0;
    const std::vector<glm::dvec2> by_x = unit_points_by_x(points, domain);
    const std::vector<double> y = distinct_y(by_x);
    const double n = double(by_x.size());

    // For each point those before it, of smaller or equal x: sum of 1 - max(y, y'), from two Fenwick trees
    // over the places of y.
    std::vector<double> number(y.size() + 1), height(y.size() + 1);  // of the points; of 1 - y
    double all_heights = 0;
    double single = 0, pairs = 0;
    for (const glm::dvec2 p : by_x) {
        const std::size_t place = place_of(y, p.y) + 1;
        double below = 0, heights_below = 0;
        for (std::size_t k = place; k > 0; k &= k - 1) {
            below += number[k];
            heights_below += height[k];
        }
        const double before = below * (1 - p.y) + (all_heights - heights_below);
        single += (1 - p.x * p.x) * (1 - p.y * p.y);
        pairs += (1 - p.x) * (2 * before + (1 - p.y));
        for (std::size_t k = place; k <= y.size(); k += k & (~k + 1)) {
            number[k] += 1;
            height[k] += 1 - p.y;
        }
        all_heights += 1 - p.y;
    }
    return std::sqrt(std::max(0.0, 1.0 / 9 - single / (2 * n) + pairs / (n * n)));
}

StarDiscrepancy star_discrepancy(std::span<const glm::dvec2> points, const Domain& domain,
                                 std::size_t exact_up_to, std::stop_token stop) {
    if (points.empty()) return {};
    const std::vector<glm::dvec2> by_x = unit_points_by_x(points, domain);
    if (by_x.size() > exact_up_to) return bracket(by_x);
    const std::vector<double> y = distinct_y(by_x);
    double excess = 0, lack = 0;
    tbb::parallel_invoke([&] { excess = greatest_excess(by_x, y, stop); },
                         [&] { lack = greatest_lack(by_x, y, stop); });
    return {std::max(excess, lack), std::max(excess, lack)};
}

namespace {

void check_period(const ReportOptions& options) {
    if (!options.period) return;
    const glm::dvec2 period = *options.period;
    if (!(period.x > 0 && period.y > 0 && std::isfinite(period.x) && std::isfinite(period.y)))
        throw failure("{}: a period of {} x {} cannot repeat; give two positive lengths", options.name,
                      period.x, period.y);
}

}  // namespace

std::optional<PointReport> analyse(std::span<const glm::dvec2> given, const Domain& domain,
                                   const ReportOptions& options, std::stop_token stop) {
    check_period(options);
    const std::vector<glm::dvec2> points = points_inside(given, domain, options.name);

    PointReport report{.domain = domain, .count = points.size()};
    report.density = double(points.size()) / domain.area();
    if (!points.empty()) report.largest_radius = largest_radius(domain, points.size());
    report.local_density = local_density(points, domain);
    report.nearest = nearest_summary(points, domain, stop);
    report.relative_radius = report.nearest.minimum;
    if (stop.stop_requested()) return std::nullopt;

    report.spectrum = periodogram(points, domain, options.spectrum, stop);
    if (stop.stop_requested()) return std::nullopt;
    report.radial_power = radial_power(report.spectrum);
    report.power_below_03 = low_frequency_power(report.spectrum, 0.3);
    report.power_below_05 = low_frequency_power(report.spectrum, 0.5);
    report.peaks = spectral_peaks(report.spectrum);
    report.effective_nyquist = effective_nyquist(report.radial_power, options.nyquist_threshold);
    if (stop.stop_requested()) return std::nullopt;

    report.pair_correlation = pair_correlation(points, domain, options.pairs, stop);
    if (options.period)
        report.periodicity = periodicity(points, domain, *options.period, options.periodicity, stop);
    if (stop.stop_requested()) return std::nullopt;

    report.l2_star_discrepancy = l2_star_discrepancy(points, domain);
    report.star_discrepancy = star_discrepancy(points, domain, options.exact_star_discrepancy_up_to, stop);
    if (stop.stop_requested()) return std::nullopt;
    return report;
}

}  // namespace dapple
