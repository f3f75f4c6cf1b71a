#include "lab/reproduce/printed_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/analysis/distances.h"
#include "core/placing/stipple.h"
#include "core/tile/ranking.h"
#include "core/tile/tile.h"
#include "lab/search/cycle_search.h"
#include "lab/search/exhaustive_search.h"
#include "lab/search/identity_word.h"
#include "lab/search/symmetry.h"

namespace dapple {
namespace {

// What should come out, with its source: the only place where it stands.
struct PaperTile {
    std::uint64_t a = 14217, b = 2895;  // Appendix A
    int points = 16;
};

struct BalancedShare {
    int length;
    std::string_view share;
    std::string_view known{};
};
constexpr std::array kBalancedShares{
    BalancedShare{16, "19.64 %"}, BalancedShare{20, "17.62 %"}, BalancedShare{24, "16.12 %"},
    BalancedShare{
        32, "14.00 %",
        "it is 13.99499 %: 13.99 % to two decimals, and 14.00 % only if 13.995 % is rounded again"}};

// The paper gives radii to four digits.
constexpr std::array<std::string_view, 2> kBestOf16{"0.6966", "0.6528"};
constexpr std::array<std::string_view, 4> kBestOf20{"0.8324", "0.7141", "0.6713", "0.6588"};

// Recorded when this program first found them.
constexpr std::array<std::string_view, 4> kOwnBestOf16{"0.696594", "0.652788", "0.640257", "0.638781"};
constexpr std::array<std::string_view, 5> kOwnBestOf20{"0.832358", "0.714068", "0.671330", "0.658781",
                                                       "0.649963"};
// How many points the turn or mirror that does best takes to others, counted by another program.
constexpr std::array<std::string_view, 2> kSymmetricOf16{"16", "6"};
constexpr std::array<std::string_view, 4> kSymmetricOf20{"20", "20", "14", "8"};
constexpr std::string_view kBestTileOf16 = "11730,8925/16";
constexpr std::string_view kBestOf24 = "0.782220";
constexpr std::string_view kBestOf28 = "0.914419";
constexpr std::string_view kBestTileOf32 = "794048332,154885773/32", kBestOf32 = "0.715878";
constexpr std::string_view kBestOf36 = "0.917943";
// The best of four, five and six cycles of 4 points.
constexpr std::array<std::string_view, 3> kBestOfCycles{"0.744484", "0.832358", "0.679618"};

// Appendix A in the order of the ranks: x and y as whole numbers of 1/65535, and as the eight digits beside.
constexpr std::array<std::string_view, 16> kTable1{
    "14217, 2895 = 0.21693751, 0.04417487",  "39876, 34215 = 0.60846876, 0.52208743",
    "4719, 40470 = 0.07200732, 0.61753262",  "37752, 61620 = 0.57605859, 0.94026093",
    "56868, 11580 = 0.86775006, 0.17669947", "57933, 54210 = 0.88400092, 0.82719158",
    "19938, 49875 = 0.30423438, 0.76104372", "18876, 30810 = 0.28802930, 0.47013046",
    "61734, 27105 = 0.94200046, 0.41359579", "35127, 20235 = 0.53600366, 0.30876631",
    "50331, 42885 = 0.76800183, 0.65438315", "28434, 5790 = 0.43387503, 0.08834974",
    "48201, 23160 = 0.73550011, 0.35339895", "9438, 15405 = 0.14401465, 0.23506523",
    "9969, 57705 = 0.15211719, 0.88052186",  "30867, 46320 = 0.47100023, 0.70679789"};

// Constant density 1 at scale 2500: complete levels 0..5 and half of level 6, see compare_figure8_counts().
constexpr double kFigure8Scale = 2500;
constexpr std::string_view kFigure8Emitted = "54608";
constexpr std::string_view kFigure8Distinct = "40960";

constexpr const char* kSection5 = "section 5";
constexpr const char* kOwnSearch = "this program's first search";

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

// As many digits after the point as the expected ones have.
template <std::size_t N>
std::vector<FoundTile> add_radii(std::vector<ComparedNumber>& rows, int points,
                                 const std::array<std::string_view, N>& expected, const char* source,
                                 Origin origin) {
    const std::vector<FoundTile> found = best_tiles(points, N);
    const std::size_t digits = expected[0].size() - 2;
    for (std::size_t i = 0; i < N; ++i)
        rows.push_back(
            {.what = fmt::format("relative radius, best tile number {} of {} points", i + 1, points),
             .expected = std::string(expected[i]),
             .ours = i < found.size() ? fmt::format("{:.{}f}", found[i].relative_radius, digits) : "none",
             .source = source,
             .origin = origin});
    return found;
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

int symmetric_points(const std::string& word) {
    std::array<double, 8> shares = symmetry_shares(make_tile(Rule{}, {word}));
    shares[0] = 0;  // a move alone
    return static_cast<int>(std::lround(std::ranges::max(shares) * static_cast<double>(word.size())));
}

}  // namespace

std::vector<ComparedNumber> compare_printed_numbers() {
    std::vector<ComparedNumber> rows;
    for (const BalancedShare& row : kBalancedShares)
        rows.push_back({.what = fmt::format("balanced sequences of {} bits", row.length),
                        .expected = std::string(row.share),
                        .ours = fmt::format("{:.2f} %", 100 * balanced_share(row.length)),
                        .source = kSection5,
                        .known = std::string(row.known)});
    add_radii(rows, 16, kBestOf16, kSection5, Origin::printed);
    add_radii(rows, 20, kBestOf20, kSection5, Origin::printed);
    return rows;
}

std::vector<ComparedNumber> compare_table1() {
    const PaperTile paper;
    const Tile tile = make_tile(paper.a, paper.b, paper.points);
    const std::vector<int> ranks = farthest_point_ranks(tile);
    std::vector<std::string> ours(tile.size());
    for (std::size_t i = 0; i < tile.size(); ++i) {
        const glm::dvec2 p = to_unit_square(tile.points[i]), whole = p * 65535.0;
        ours[static_cast<std::size_t>(ranks[i])] =
            fmt::format("{:.0f}, {:.0f} = {:.8f}, {:.8f}", whole.x, whole.y, p.x, p.y);
    }
    std::vector<ComparedNumber> rows;
    for (std::size_t rank = 0; rank < kTable1.size(); ++rank)
        rows.push_back({.what = fmt::format("{}", rank),
                        .expected = std::string(kTable1[rank]),
                        .ours = ours[rank],
                        .source = "Appendix A"});
    return rows;
}

std::vector<ComparedNumber> compare_own_numbers() {
    std::vector<ComparedNumber> rows;
    const std::vector<FoundTile> best = add_radii(rows, 16, kOwnBestOf16, kOwnSearch, Origin::ours);
    const std::vector<FoundTile> best20 = add_radii(rows, 20, kOwnBestOf20, kOwnSearch, Origin::ours);
    const auto add = [&](std::string what, std::string_view expected, std::string ours, const char* source) {
        rows.push_back({std::move(what), std::string(expected), std::move(ours), source, Origin::ours});
    };
    const TileIntegers of_best = best.empty() ? TileIntegers{} : integers_of(best[0].word);
    add("the best tile of 16 points", kBestTileOf16, fmt::format("{},{}/16", of_best.a, of_best.b),
        kOwnSearch);

    const PaperTile paper;
    const Tile tile = make_tile(paper.a, paper.b, paper.points);
    const std::string name = fmt::format("Appendix A's tile, {},{}/16", paper.a, paper.b);
    std::size_t place = 0;
    while (place < best.size() && best[place].word != smallest_symmetric_word(tile.words[0])) ++place;
    add(name + ": its place by radius among all of 16 points", "2", fmt::format("{}", place + 1), kOwnSearch);
    std::vector<glm::dvec2> points;
    for (const BinaryPoint& p : tile.points) points.push_back(to_unit_square(p));
    add(name + ": relative radius", kOwnBestOf16[1], six_digits(nearest_summary(points, Domain{}).minimum),
        "its place, from the points themselves");
    add(name + ": points that its half-size copies cover", "16", fmt::format("{}", coinciding_points(tile)),
        "all, by the definition of a self-similar tile");
    const auto add_symmetry = [&](const std::vector<FoundTile>& tiles,
                                  std::span<const std::string_view> expected) {
        for (std::size_t i = 0; i < expected.size(); ++i)
            add(fmt::format("best tile number {} of {} points: points that a turn or mirror takes to points",
                            i + 1, tiles[i].word.size()),
                expected[i], fmt::format("{}", symmetric_points(tiles[i].word)),
                "counted by another program");
    };
    add_symmetry(best, kSymmetricOf16);
    add_symmetry(best20, kSymmetricOf20);
    return rows;
}

std::vector<ComparedNumber> compare_figure8_counts() {
    // Every rank of levels 0 to 5 needs less than 2500, and level 6 needs 1024 + 192 (r + 1/2), which is less
    // for r = 0..7: 16 (1 + 4 + ... + 4^5) + 8 * 4^6 dots. Different ones are the 16 * 4^5 of level 5 and
    // what level 6 adds. Each of the 16 points is inherited by one of four siblings and newborn in three, so
    // of the 8 * 4 dots in four siblings 8 are there already: 24 * 4^5 more.
    const char* source = "counted by hand: constant density 1, scale 2500";
    const PaperTile paper;
    const Tile tile = make_tile(paper.a, paper.b, paper.points);
    const Figure8Result run =
        place_figure8(Density(Grid<float>(1, 1, 1.0f)), tile, farthest_point_ranks(tile), kFigure8Scale);
    return {{"dots emitted", std::string(kFigure8Emitted), fmt::format("{}", run.dots.size()), source,
             Origin::ours},
            {"different ones among them", std::string(kFigure8Distinct),
             fmt::format("{}", run.dots.size() - run.duplicates), source, Origin::ours}};
}

std::vector<ComparedNumber> compare_larger_tiles() {
    std::vector<ComparedNumber> rows;
    const char* source = "this program's first search: the paper stops at 20 points";
    add_radii(rows, 24, std::array{kBestOf24}, source, Origin::ours);
    add_radii(rows, 28, std::array{kBestOf28}, source, Origin::ours);
    // Searched for, it takes longer than all else together.
    rows.push_back({.what = fmt::format("relative radius, best tile of 32 points, {}", kBestTileOf32),
                    .expected = std::string(kBestOf32),
                    .ours = six_digits(relative_radius(parse_tile_integers(kBestTileOf32).words.at(0))),
                    .source = "dapple-lab tile search --points 32 --top 1",
                    .origin = Origin::ours});
    add_radii(rows, 36, std::array{kBestOf36}, source, Origin::ours);
    for (std::size_t i = 0; i < kBestOfCycles.size(); ++i) {
        const std::size_t cycles = 4 + i;
        const std::vector<FoundCycles> best = search_cycles(std::vector<int>(cycles, 4), 1).best;
        rows.push_back({.what = fmt::format("relative radius, best tile of {} points in {} cycles of 4",
                                            4 * cycles, cycles),
                        .expected = std::string(kBestOfCycles[i]),
                        .ours = best.empty() ? "none" : six_digits(best[0].relative_radius),
                        .source = "another program, all sets of cycles",
                        .origin = Origin::ours});
    }
    return rows;
}

}  // namespace dapple
