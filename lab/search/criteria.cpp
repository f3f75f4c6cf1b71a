#include "lab/search/criteria.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/tile/ranking.h"

namespace dapple {

namespace {

std::vector<glm::dvec2> places_of(const Tile& tile) {
    std::vector<glm::dvec2> places;
    for (const BinaryPoint p : tile.points) places.push_back(to_unit_square(p));
    return places;
}

// 2 r_max: the smallest distance in the densest packing of so many points.
double widest_spacing(double count) {
    return std::sqrt(2 / (std::numbers::sqrt3 * count));
}

// For each point the squared distance to the nearest of the points before it, its own copies included; `far`
// squared if there is none as near as that.
std::vector<double> nearest_before(const std::vector<glm::dvec2>& places,
                                   const std::vector<std::size_t>& kinds, const Tile& tile, double far) {
    const auto copies = copies_of_kinds(tile);
    const GridOfKinds grid(places, kinds, tile.kinds());
    std::vector<double> nearest(places.size(), far * far);
    for (std::uint32_t i = 0; i < places.size(); ++i) {
        const auto visit = [&](glm::dvec2 copy, double, std::size_t of) {
            const bool is_itself = copy == places[i];
            grid.for_each_near(of, copy, far, [&](std::uint32_t j, double squared) {
                if (j == i && is_itself) return;
                const std::uint32_t later = std::max(i, j);
                nearest[later] = std::min(nearest[later], squared);
            });
        };
        for_copies(places[i], kinds[i], copies[kinds[i]], far, visit);
    }
    return nearest;
}

std::vector<std::size_t> kinds_of(const Tile& tile) {
    std::vector<std::size_t> kinds;
    for (std::size_t i = 0; i < tile.points.size(); ++i) kinds.push_back(tile.kind_of(i));
    return kinds;
}

// e^(-2 pi i k v) for k = 0, step, 2 step ... `count` of them.
std::vector<std::complex<double>> waves(double v, double step, int count) {
    std::vector<std::complex<double>> result;
    for (int k = 0; k < count; ++k) result.push_back(std::polar(1.0, -2 * std::numbers::pi * k * step * v));
    return result;
}

// F(k) of one kind of the unturned tile at the multiples of a step with |kx|, |ky| <= reach steps.
class Amplitudes {
 public:
    Amplitudes(const Tile& tile, std::size_t kind, double step, int reach) : reach_(reach) {
        const auto width = static_cast<std::size_t>(2 * reach + 1);
        values_.resize(static_cast<std::size_t>(reach + 1) * width);
        const std::size_t first = kind * tile.size();
        for (std::size_t i = first; i < first + tile.size(); ++i) {
            const glm::dvec2 p = to_unit_square(tile.points[i]);
            const auto x = waves(p.x - 0.5, step, reach + 1), y = waves(p.y - 0.5, step, reach + 1);
            for (std::size_t column = 0; column < x.size(); ++column) {
                std::complex<double>* row = &values_[column * width + static_cast<std::size_t>(reach)];
                for (int j = 0; j <= reach; ++j) {
                    const double a = x[column].real() * y[j].real(), b = x[column].imag() * y[j].imag();
                    const double c = x[column].real() * y[j].imag(), d = x[column].imag() * y[j].real();
                    row[j] += std::complex(a - b, c + d);
                    if (j > 0) row[-j] += std::complex(a + b, d - c);
                }
            }
        }
    }
    std::complex<double> at(int x, int y) const {
        if (x < 0) return std::conj(at(-x, -y));
        return values_[static_cast<std::size_t>(x * (2 * reach_ + 1) + y + reach_)];
    }

 private:
    int reach_;
    std::vector<std::complex<double>> values_;
};

// The orientations that occur in a subdivision: all products of the rule's.
std::vector<Orientation> orientations_made(const Rule& rule) {
    std::vector<Orientation> made{Orientation{}};
    for (std::size_t i = 0; i < made.size(); ++i) {
        for (const Orientation h : rule.child) {
            const Orientation g = compose(made[i], h);
            if (std::find(made.begin(), made.end(), g) == made.end()) made.push_back(g);
        }
    }
    return made;
}

}  // namespace

std::array<int, 4> letter_counts(const Tile& tile) {
    std::array<int, 4> counts{};
    for (const BinaryPoint p : tile.points) ++counts[quadrant_of(p)];
    return counts;
}

double relative_radius(const Tile& tile) {
    const double widest = widest_spacing(static_cast<double>(tile.size()));
    const auto nearest = nearest_before(places_of(tile), kinds_of(tile), tile, 1.01 * widest);
    return std::sqrt(*std::min_element(nearest.begin(), nearest.end())) / widest;
}

double worst_relative_radius(const Tile& tile, const Ranking& ranking) {
    struct RankedPoint {
        float rank;
        std::size_t kind;
        glm::dvec2 place;
    };
    std::vector<RankedPoint> points;
    for (std::size_t i = 0; i < tile.points.size(); ++i)
        points.push_back({0, tile.kind_of(i), to_unit_square(tile.points[i])});
    const auto newborns = newborns_of(tile);
    for (std::size_t i = 0; i < newborns.size(); ++i)
        points.push_back({ranking.newborn[i], i / (3 * tile.size()), to_unit_square(newborns[i].position)});
    std::stable_sort(points.begin(), points.end(),
                     [](const RankedPoint& a, const RankedPoint& b) { return a.rank < b.rank; });
    std::vector<glm::dvec2> places;
    std::vector<std::size_t> kinds;
    for (const RankedPoint& point : points) {
        places.push_back(point.place);
        kinds.push_back(point.kind);
    }

    const double far = 1.01 * widest_spacing(static_cast<double>(tile.size()));
    const auto nearest = nearest_before(places, kinds, tile, far);
    double smallest = far * far, worst = 1;
    for (std::size_t i = 0; i < points.size(); ++i) {
        smallest = std::min(smallest, nearest[i]);
        if (i + 1 < points.size() && points[i + 1].rank == points[i].rank) continue;
        worst = std::min(worst, std::sqrt(smallest) / widest_spacing(static_cast<double>(i + 1) /
                                                                     static_cast<double>(tile.kinds())));
    }
    return worst;
}

double coherent_share(const Tile& tile) {
    const auto turns = orientations_made(tile.rule);
    const auto copies = static_cast<double>(turns.size() * tile.kinds());
    const double limit = 4 * static_cast<double>(tile.size());
    const int reach = static_cast<int>(std::sqrt(limit));
    std::vector<Amplitudes> kinds;
    for (std::size_t k = 0; k < tile.kinds(); ++k) kinds.emplace_back(tile, k, 1, reach);
    double together = 0, apart = 0;
    for (int x = -reach; x <= reach; ++x) {
        for (int y = 0; y <= reach; ++y) {
            if (x * x + y * y == 0 || x * x + y * y > limit) continue;
            std::complex<double> sum = 0;
            double squares = 0;
            for (const Orientation g : turns) {
                // k . g(p) = g^-1(k) . p
                const glm::dvec2 k = apply(inverse(g), glm::dvec2(x, y));
                for (const Amplitudes& amplitudes : kinds) {
                    const auto f = amplitudes.at(static_cast<int>(k.x), static_cast<int>(k.y));
                    sum += f;
                    squares += std::norm(f);
                }
            }
            together += std::norm(sum / copies);
            apart += squares / copies;
        }
    }
    return together / apart;
}

double low_frequency_power(const Tile& tile) {
    const auto count = static_cast<double>(tile.size());
    const int reach = static_cast<int>(std::sqrt(count));  // in halves
    const auto sinc = [](double t) {
        return t == 0 ? 1.0 : std::sin(std::numbers::pi * t) / (std::numbers::pi * t);
    };
    double sum = 0;
    int frequencies = 0;
    for (std::size_t k = 0; k < tile.kinds(); ++k) {
        const Amplitudes amplitudes(tile, k, 0.5, reach);
        for (int x = -reach; x <= reach; ++x) {
            for (int y = -reach; y <= reach; ++y) {
                if (x * x + y * y == 0 || x * x + y * y > count) continue;
                sum += std::norm(amplitudes.at(x, y) - count * sinc(0.5 * x) * sinc(0.5 * y)) / count;
                ++frequencies;
            }
        }
    }
    return sum / frequencies;
}

double lattice_share(const Tile& tile) {
    constexpr double kLongest = 3, kShortest = 0.5, kTolerance = 0.15;  // in spacings
    constexpr int kSteps = 20;                                          // of the shifts tried, to a spacing
    constexpr int kSide = static_cast<int>(2 * (kLongest + 1) * kSteps) + 1;
    const double spacing = 1 / std::sqrt(static_cast<double>(tile.size()));
    const auto places = places_of(tile);
    const auto kinds = kinds_of(tile);
    const auto copies = copies_of_kinds(tile);
    const GridOfKinds grid(places, kinds, tile.kinds());

    // hits[v]: the points p with another one about p + v.
    std::vector<double> hits(static_cast<std::size_t>(kSide) * kSide, 0.0);
    const double reach = (kLongest + kTolerance) * spacing;
    for (std::uint32_t i = 0; i < places.size(); ++i) {
        const auto visit = [&](glm::dvec2 copy, double probability, std::size_t of) {
            grid.for_each_near(of, copy, reach, [&](std::uint32_t j, double) {
                const glm::dvec2 shift = (copy - places[j]) / spacing;
                const int x0 = static_cast<int>(std::ceil((shift.x + kLongest + 1 - kTolerance) * kSteps));
                const int y0 = static_cast<int>(std::ceil((shift.y + kLongest + 1 - kTolerance) * kSteps));
                for (int y = y0; y <= y0 + 2 * kTolerance * kSteps; ++y) {
                    for (int x = x0; x <= x0 + 2 * kTolerance * kSteps; ++x) {
                        const double dx = static_cast<double>(x) / kSteps - kLongest - 1 - shift.x;
                        const double dy = static_cast<double>(y) / kSteps - kLongest - 1 - shift.y;
                        if (dx * dx + dy * dy <= kTolerance * kTolerance)
                            hits[static_cast<std::size_t>(y * kSide + x)] += probability;
                    }
                }
            });
        };
        for_copies(places[i], kinds[i], copies[kinds[i]], reach, visit);
    }
    double most = 0;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const double length = std::hypot(static_cast<double>(x) / kSteps - kLongest - 1,
                                             static_cast<double>(y) / kSteps - kLongest - 1);
            if (length < kShortest || length > kLongest) continue;
            most = std::max(most, hits[static_cast<std::size_t>(y * kSide + x)]);
        }
    }
    return std::min(1.0, most / static_cast<double>(tile.points.size()));
}

}  // namespace dapple
