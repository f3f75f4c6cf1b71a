#include "app/reproduce/printed_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/analysis/distances.h"
#include "core/placing/figure8.h"
#include "core/tile/exhaustive_search.h"
#include "core/tile/identity_word.h"
#include "core/tile/ranking.h"
#include "core/tile/tile.h"

namespace dapple {
namespace {

// What should come out, with its source: the only place where it stands.
struct PaperTile {
    std::uint64_t a = 14217, b = 2895;  // Appendix A
    int points = 16;
    std::string_view radius = "0.652788";
};

struct BalancedShare {
    int length;
    std::string_view share;
};
// To a tenth of a per cent: the last is 13.995 exactly, which a second rounding makes 14.00 as well as 13.99.
constexpr std::array kBalancedShares{BalancedShare{16, "19.6 %"}, BalancedShare{20, "17.6 %"},
                                     BalancedShare{24, "16.1 %"}, BalancedShare{32, "14.0 %"}};

constexpr std::array<std::string_view, 4> kBestOf16{"0.696594", "0.652788", "0.640257", "0.638781"};
constexpr std::array<std::string_view, 5> kBestOf20{"0.832358", "0.714068", "0.671330", "0.658781",
                                                    "0.649963"};

// Constant density 1 at scale 2500: complete levels 0..5 and half of level 6, see compare_figure8_counts().
constexpr double kFigure8Scale = 2500;
constexpr std::string_view kFigure8Emitted = "54608";
constexpr std::string_view kFigure8Distinct = "40960";

constexpr std::string_view kBestOf24 = "0.782220";
constexpr std::string_view kBestOf28 = "0.914419";

constexpr const char* kSection4 = "paper, section 4";
constexpr const char* kAppendixA = "paper, Appendix A";

std::string six_digits(double value) {
    return fmt::format("{:.6f}", value);
}

// The relative radii of the best tiles of so many points, each once: distinct tiles can share one.
std::vector<FoundTile> best_tiles(int points, std::size_t different_radii) {
    for (int top = static_cast<int>(different_radii);; top *= 2) {
        SearchState state = start_exhaustive_search(points, top);
        while (!state.finished) state = continue_exhaustive_search(std::move(state));
        std::vector<FoundTile> tiles = state.found;
        const auto same = [](const FoundTile& a, const FoundTile& b) {
            return six_digits(a.relative_radius) == six_digits(b.relative_radius);
        };
        tiles.erase(std::unique(tiles.begin(), tiles.end(), same), tiles.end());
        const bool more_exist = state.found.size() == static_cast<std::size_t>(top);
        if (tiles.size() < different_radii && more_exist) continue;
        tiles.resize(std::min(tiles.size(), different_radii));
        return tiles;
    }
}

template <std::size_t N>
std::vector<FoundTile> add_radii(std::vector<ComparedNumber>& rows, int points,
                                 const std::array<std::string_view, N>& printed, const char* source) {
    const std::vector<FoundTile> found = best_tiles(points, N);
    for (std::size_t i = 0; i < N; ++i)
        rows.push_back({fmt::format("relative radius, best tile number {} of {} points", i + 1, points),
                        std::string(printed[i]),
                        i < found.size() ? six_digits(found[i].relative_radius) : "none", source});
    return found;
}

// Squared toroidal distance in units of 1 / (2^N - 1), exactly.
std::uint64_t squared_distance(std::array<std::uint64_t, 2> a, std::array<std::uint64_t, 2> b,
                               std::uint64_t period) {
    std::uint64_t sum = 0;
    for (int axis = 0; axis < 2; ++axis) {
        const std::uint64_t apart = a[axis] > b[axis] ? a[axis] - b[axis] : b[axis] - a[axis];
        const std::uint64_t round = std::min(apart, period - apart);
        sum += round * round;
    }
    return sum;
}

// How many of the ranks are where greedy choice puts them: the farthest from all points before. Worked out
// here from the paper's integers alone.
int ranks_by_farthest_point(const PaperTile& paper, const std::vector<int>& ranks) {
    const std::uint64_t period = (std::uint64_t{1} << paper.points) - 1;
    std::vector<std::array<std::uint64_t, 2>> points{{paper.a, paper.b}};
    while (static_cast<int>(points.size()) < paper.points)
        points.push_back({points.back()[0] * 2 % period, points.back()[1] * 2 % period});

    std::vector<std::size_t> order(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) order[static_cast<std::size_t>(ranks[i])] = i;
    int right = order[0] == 0 ? 1 : 0;
    std::vector<std::uint64_t> nearest(points.size(), ~std::uint64_t{0});
    for (std::size_t k = 1; k < order.size(); ++k) {
        for (std::size_t i = 0; i < points.size(); ++i)
            nearest[i] = std::min(nearest[i], squared_distance(points[i], points[order[k - 1]], period));
        if (nearest[order[k]] == *std::ranges::max_element(nearest)) ++right;
    }
    return right;
}

int coinciding_points(const Tile& tile) {
    int found = 0;
    for (std::size_t i = 0; i < tile.size(); ++i) {
        const int quadrant = quadrant_of(tile.points[i]);
        const bool covered = std::ranges::any_of(tile.points, [&](const BinaryPoint& p) {
            const glm::dvec2 copy = to_unit_square(shrink_to_quadrant(quadrant, p));
            const glm::dvec2 own = to_unit_square(tile.points[i]);
            return std::hypot(copy.x - own.x, copy.y - own.y) < 1e-12;
        });
        if (covered) ++found;
    }
    return found;
}

}  // namespace

std::vector<ComparedNumber> compare_printed_numbers() {
    std::vector<ComparedNumber> rows;
    for (const BalancedShare& row : kBalancedShares)
        rows.push_back({fmt::format("balanced sequences of {} bits", row.length), std::string(row.share),
                        fmt::format("{:.1f} %", 100 * balanced_share(row.length)), kSection4});

    const std::vector<FoundTile> best16 = add_radii(rows, 16, kBestOf16, kSection4);
    add_radii(rows, 20, kBestOf20, kSection4);

    const PaperTile paper;
    const Tile tile = make_tile(paper.a, paper.b, paper.points);
    std::vector<glm::dvec2> points;
    for (const BinaryPoint& p : tile.points) points.push_back(to_unit_square(p));
    const std::string name = fmt::format("the tile ({}, {})", paper.a, paper.b);
    rows.push_back({name + ", relative radius", std::string(paper.radius),
                    six_digits(nearest_summary(points, Domain{}).minimum), kAppendixA});
    std::size_t place = 0;
    while (place < best16.size() && best16[place].word != smallest_symmetric_word(tile.words[0])) ++place;
    rows.push_back(
        {name + ", place among all tiles of 16 points", "2", fmt::format("{}", place + 1), kSection4});
    rows.push_back({name + ", points that the half-size copies cover", "16",
                    fmt::format("{}", coinciding_points(tile)), "paper, figure 1"});
    rows.push_back({name + ", ranks in farthest-point order", "16",
                    fmt::format("{}", ranks_by_farthest_point(paper, farthest_point_ranks(tile))),
                    kAppendixA});
    return rows;
}

std::vector<ComparedNumber> compare_figure8_counts() {
    // Every rank of levels 0 to 5 needs less than 2500, and level 6 needs 1024 + 192 (r + 1/2), which is less
    // for r = 0..7: 16 (1 + 4 + ... + 4^5) + 8 * 4^6 dots. Different ones are the 16 * 4^5 of level 5 and
    // what level 6 adds. Each of the 16 points is inherited by one of four siblings and newborn in three, so
    // of the 8 * 4 dots in four siblings 8 are there already: 24 * 4^5 more.
    const char* source = "counted by hand from Figure 8 as printed: constant density 1, scale 2500";
    const PaperTile paper;
    const Tile tile = make_tile(paper.a, paper.b, paper.points);
    const Figure8Result run =
        place_figure8(Density(Grid<float>(1, 1, 1.0f)), tile, farthest_point_ranks(tile), kFigure8Scale);
    return {{"dots emitted", std::string(kFigure8Emitted), fmt::format("{}", run.dots.size()), source},
            {"different ones among them", std::string(kFigure8Distinct),
             fmt::format("{}", run.dots.size() - run.duplicates), source}};
}

std::vector<ComparedNumber> compare_larger_tiles() {
    std::vector<ComparedNumber> rows;
    const char* source = "this program's first search: the paper stops at 20 points";
    add_radii(rows, 24, std::array{kBestOf24}, source);
    add_radii(rows, 28, std::array{kBestOf28}, source);
    return rows;
}

}  // namespace dapple
