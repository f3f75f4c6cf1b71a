#include "core/analysis/autocorrelation.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/analysis/distances.h"

namespace dapple {

namespace {

constexpr Domain kOnePeriod{1, 1, Topology::torus};

// floor() may leave 1 for a number a hair below a whole one.
double fraction(double x) {
    const double rest = x - std::floor(x);
    return rest < 1 ? rest : 0;
}

int wrapped(int i, int side) {
    return ((i % side) + side) % side;
}

}  // namespace

Folding folded(std::span<const glm::dvec2> points, glm::dvec2 corner, double period, int k) {
    assert(period > 0 && k >= 1);
    Folding folding;
    folding.layers = k * k;
    for (const glm::dvec2 p : points) {
        const glm::dvec2 at = (p - corner) / period;
        if (!(at.x >= 0 && at.y >= 0 && at.x < k && at.y < k)) continue;
        folding.points.emplace_back(fraction(at.x), fraction(at.y));
    }
    return folding;
}

double repetition(const Folding& folding, double tolerance) {
    const auto n = static_cast<double>(folding.points.size());
    if (folding.layers < 2 || n < 2) return 0;
    const double radius = tolerance * std::sqrt(folding.layers / n);
    const double chance = (n - 1) * std::numbers::pi * radius * radius;
    const double room = folding.layers - 1 - chance;
    if (room <= 0) return 0;
    const PointGrid grid(folding.points, kOnePeriod);
    std::uint64_t met = 0;
    for (const PointGrid::Entry& entry : grid.entries())
        grid.for_each_within(entry.position, radius,
                             [&](std::uint32_t other, glm::dvec2) { met += other != entry.index; });
    return (static_cast<double>(met) / n - chance) / room;
}

Grid<float> mean_of_layers(const Folding& folding, double radius, int side) {
    Grid<float> mean(side, side);
    const double reach = radius * side;
    const float share = 1 / static_cast<float>(folding.layers);
    for (const glm::dvec2 p : folding.points) {
        // The pixel centres x + 1/2 at most `reach` away, row by row.
        const glm::dvec2 at = p * static_cast<double>(side) - 0.5;
        for (int y = static_cast<int>(std::ceil(at.y - reach)); y <= at.y + reach; ++y) {
            const double half = std::sqrt(std::max(0.0, reach * reach - (y - at.y) * (y - at.y)));
            for (int x = static_cast<int>(std::ceil(at.x - half)); x <= at.x + half; ++x)
                mean.at(wrapped(x, side), wrapped(y, side)) += share;
        }
    }
    for (float& value : mean.values) value = std::min(value, 1.0f);
    return mean;
}

PairCorrelation pair_correlation(std::span<const glm::dvec2> points, const Domain& domain,
                                 const PairCorrelationOptions& options, std::stop_token stop) {
    const std::size_t bins = std::size_t(std::ceil(options.highest_distance / options.bin_width - 1e-9));
    PairCorrelation result{options.bin_width, std::vector<double>(bins)};
    if (points.size() < 2) return result;

    const double n = double(points.size());
    const double width = options.bin_width * std::sqrt(domain.area() / n);  // of a bin, in the domain's unit
    const PointGrid grid(points, domain);
    const std::span<const PointGrid::Entry> entries = grid.entries();

    // A fixed cut into parts, added up in order, so that the sums don't depend on the threads.
    constexpr std::size_t kPart = 8192;
    std::vector<std::vector<double>> parts((entries.size() + kPart - 1) / kPart);
    tbb::parallel_for(std::size_t(0), parts.size(), [&](std::size_t part) {
        std::vector<double>& sum = parts[part];
        sum.resize(bins);
        const std::size_t end = std::min(entries.size(), (part + 1) * kPart);
        for (std::size_t i = part * kPart; i < end && !stop.stop_requested(); ++i)
            grid.for_each_within(
                entries[i].position, double(bins) * width, [&](std::uint32_t index, glm::dvec2 offset) {
                    if (index == entries[i].index) return;
                    const std::size_t bin =
                        std::size_t(std::sqrt(offset.x * offset.x + offset.y * offset.y) / width);
                    if (bin >= bins) return;
                    sum[bin] += domain.topology == Topology::torus
                                    ? 1
                                    : domain.area() / ((domain.width - std::abs(offset.x)) *
                                                       (domain.height - std::abs(offset.y)));
                });
    });
    for (std::size_t bin = 0; bin < bins; ++bin) {
        double sum = 0;
        for (const std::vector<double>& part : parts) sum += part[bin];
        const double ring = std::numbers::pi * width * width * (2 * double(bin) + 1);
        result.g[bin] = sum * domain.area() / (n * (n - 1) * ring);
    }
    return result;
}

namespace {

bool in_window(glm::dvec2 p, const Domain& domain) {
    return p.x >= 0 && p.y >= 0 && p.x <= domain.width && p.y <= domain.height;
}

struct Meetings {
    std::size_t asked = 0;  // points whose place after the lag is inside the domain
    std::size_t met = 0;
};

Meetings count_meetings(const PointGrid& grid, std::span<const glm::dvec2> points, glm::dvec2 lag,
                        double tolerance) {
    const Domain& domain = grid.domain();
    const double radius = tolerance * std::sqrt(domain.area() / double(grid.entries().size()));
    Meetings meetings;
    for (const glm::dvec2 p : points) {
        const glm::dvec2 place = p + lag;
        if (domain.topology == Topology::window && !in_window(place, domain)) continue;
        bool found = false;
        grid.for_each_within(place, radius, [&](std::uint32_t, glm::dvec2) { found = true; });
        ++meetings.asked;
        meetings.met += found;
    }
    return meetings;
}

double correlation(const Meetings& meetings, double tolerance) {
    if (meetings.asked == 0) return 0;
    const double chance = 1 - std::exp(-std::numbers::pi * tolerance * tolerance);
    return (double(meetings.met) / double(meetings.asked) - chance) / (1 - chance);
}

// Evenly spread over the list by the golden ratio: any fixed step could meet the order that a tile's points
// have in it and ask the same point of every tile.
std::vector<glm::dvec2> evenly_chosen(std::span<const glm::dvec2> points, std::size_t count) {
    if (points.size() <= count) return {points.begin(), points.end()};
    std::vector<glm::dvec2> chosen(count);
    double place = 0;
    for (glm::dvec2& p : chosen) {
        place += std::numbers::phi - 1;
        place -= std::floor(place);
        p = points[std::size_t(place * double(points.size()))];
    }
    return chosen;
}

// The distance from a lag to the nearest one that changes nothing.
double distance_from_rest(glm::dvec2 lag, const Domain& domain) {
    if (domain.topology == Topology::torus) {
        lag.x -= domain.width * std::round(lag.x / domain.width);
        lag.y -= domain.height * std::round(lag.y / domain.height);
    }
    return std::hypot(lag.x, lag.y);
}

}  // namespace

double autocorrelation(std::span<const glm::dvec2> points, const Domain& domain, glm::dvec2 lag,
                       double tolerance) {
    return correlation(count_meetings(PointGrid(points, domain), points, lag, tolerance), tolerance);
}

Periodicity periodicity(std::span<const glm::dvec2> points, const Domain& domain, glm::dvec2 period,
                        const PeriodicityOptions& options, std::stop_token stop) {
    if (points.empty()) return {};
    const PointGrid grid(points, domain);
    const std::vector<glm::dvec2> asked = evenly_chosen(points, options.sample);
    const double spacing = std::sqrt(domain.area() / double(points.size()));

    // One of each pair lag, -lag.
    struct Lag {
        int x, y;
        Meetings meetings;
    };
    std::vector<Lag> lags;
    for (int y = 0; y <= options.furthest; ++y)
        for (int x = y == 0 ? 1 : -options.furthest; x <= options.furthest; ++x)
            if (distance_from_rest({x * period.x, y * period.y}, domain) > options.tolerance * spacing)
                lags.push_back({x, y, {}});
    tbb::parallel_for(std::size_t(0), lags.size(), [&](std::size_t i) {
        if (stop.stop_requested()) return;
        lags[i].meetings =
            count_meetings(grid, asked, {lags[i].x * period.x, lags[i].y * period.y}, options.tolerance);
    });
    Periodicity highest;
    for (const Lag& lag : lags) {
        if (4 * lag.meetings.asked < asked.size()) continue;
        const double value = correlation(lag.meetings, options.tolerance);
        if ((highest.lag_x == 0 && highest.lag_y == 0) || value > highest.value)
            highest = {value, lag.x, lag.y};
    }
    return highest;
}

double tile_period(double tiles) {
    return std::exp2(-std::floor(std::log2(tiles) / 2 + 1e-9));
}

}  // namespace dapple
