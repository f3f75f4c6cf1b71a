#include "lab/related/wang_tiles.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

#include "core/analysis/distances.h"
#include "core/tile/random.h"
#include "lab/related/growing_grid.h"
#include "lab/related/plain_lloyd.h"
#include "lab/related/plain_voronoi.h"
#include "lab/related/white_noise.h"

namespace dapple {
namespace {

constexpr double kSpacing = 1.0 / 32;  // of kWangPoints
static_assert(kSpacing * kSpacing * kWangPoints == 1);
// Along an edge, to each side: filled anew for another colour; kept in all tiles with that colour. Around the
// corners all colours are alike, so that any four tiles fit (the corner problem).
constexpr double kFilled = 3.5 * kSpacing, kKept = 2 * kSpacing, kCorner = 2.5 * kSpacing;
constexpr int kSteps = 20;  // of Lloyd's method
constexpr int kCandidates = 20;
constexpr int kChildren = kWangDivision * kWangDivision;
constexpr std::uint32_t kUnmet = std::numeric_limits<std::uint32_t>::max();
constexpr int kDeepestLevel = 14;  // levels: finer than a double can tell apart is not far

using Region = std::function<bool(glm::dvec2)>;

double from_edge(double x) {
    return std::abs(x - std::round(x));
}

// New points on a page, among others that stay: best candidates, then steps of Lloyd's method that do not
// leave the region.
void fill(std::vector<glm::dvec2>& points, std::size_t count, const Region& region, const Domain& page,
          Random& random) {
    const std::size_t fixed = points.size();
    const bool torus = page.topology == Topology::torus;
    GrowingGrid grid(page);
    for (const glm::dvec2 p : points) grid.add(p);
    while (points.size() < fixed + count) {
        glm::dvec2 best{};
        double farthest = -1;
        for (int i = 0; i < kCandidates;) {
            const glm::dvec2 candidate(random.unit() * page.width, random.unit() * page.height);
            if (!region(candidate)) continue;
            ++i;
            const double nearest2 = grid.nearest2(candidate, std::numeric_limits<double>::infinity());
            if (nearest2 > farthest) {
                farthest = nearest2;
                best = candidate;
            }
        }
        points.push_back(best);
        grid.add(best);
    }
    for (int step = 0; step < kSteps; ++step) {
        const std::vector<CellMoments> cells = plain_cells(points, page);
        for (std::size_t i = fixed; i < points.size(); ++i) {
            if (!(cells[i].weight > 0)) continue;
            glm::dvec2 to = points[i] + cells[i].first / cells[i].weight;
            if (torus) to = on_unit_torus(to);
            if (region(to)) points[i] = to;
        }
    }
}

// The points along edges of each colour: a torus of which the strip around the edge y = 0, or x = 0, is kept.
struct EdgePoints {
    std::array<std::vector<glm::dvec2>, 2> horizontal, vertical;
};

EdgePoints make_edges(const std::vector<glm::dvec2>& torus, Random& random) {
    const auto other = [&](const Region& strip) {
        std::vector<glm::dvec2> points;
        for (const glm::dvec2 p : torus)
            if (!strip(p)) points.push_back(p);
        fill(points, torus.size() - points.size(), strip, Domain{}, random);
        return points;
    };
    const auto strip = [](double along, double across) {
        return from_edge(across) < kFilled && !(from_edge(along) < kCorner && from_edge(across) < kCorner);
    };
    EdgePoints edges;
    edges.horizontal = {torus, other([&](glm::dvec2 p) { return strip(p.x, p.y); })};
    edges.vertical = {torus, other([&](glm::dvec2 p) { return strip(p.y, p.x); })};
    return edges;
}

std::vector<glm::dvec2> points_of_tile(int tile, const EdgePoints& edges, Random& random) {
    const auto& top = edges.horizontal[std::size_t(tile & 1)];
    const auto& right = edges.vertical[std::size_t(tile >> 1 & 1)];
    const auto& bottom = edges.horizontal[std::size_t(tile >> 2 & 1)];
    const auto& left = edges.vertical[std::size_t(tile >> 3 & 1)];
    // On a page that is larger by what is kept beyond the edges. Corners are alike in all.
    const double side = 1 + 2 * kKept;
    std::vector<glm::dvec2> fixed;
    std::size_t inside = 0;
    const auto keep = [&](const std::vector<glm::dvec2>& points, const Region& wanted) {
        for (const glm::dvec2 p : points) {
            for (int turn_y = -1; turn_y <= 1; ++turn_y) {
                for (int turn_x = -1; turn_x <= 1; ++turn_x) {
                    const glm::dvec2 q = p + glm::dvec2(turn_x, turn_y), on_page = q + glm::dvec2(kKept);
                    if (on_page.x < 0 || on_page.y < 0 || on_page.x >= side || on_page.y >= side ||
                        !wanted(q))
                        continue;
                    fixed.push_back(on_page);
                    if (q.x >= 0 && q.y >= 0 && q.x < 1 && q.y < 1) ++inside;
                }
            }
        }
    };
    const auto beside = [](double x) { return from_edge(x) < kKept; };
    keep(top, [&](glm::dvec2 q) { return q.y < kKept; });
    keep(bottom, [&](glm::dvec2 q) { return q.y >= 1 - kKept; });
    keep(left, [&](glm::dvec2 q) { return q.x < kKept && !beside(q.y); });
    keep(right, [&](glm::dvec2 q) { return q.x >= 1 - kKept && !beside(q.y); });

    std::vector<glm::dvec2> all = fixed;
    const Region middle = [&](glm::dvec2 p) {
        return p.x >= 2 * kKept && p.y >= 2 * kKept && p.x < 1 && p.y < 1;
    };
    fill(all, kWangPoints - inside, middle, {side, side, Topology::window}, random);
    std::vector<glm::dvec2> points;
    for (const glm::dvec2 p : all) {
        const glm::dvec2 q = p - glm::dvec2(kKept);
        if (q.x >= 0 && q.y >= 0 && q.x < 1 && q.y < 1) points.push_back(q);
    }
    return points;
}

// By farthest point, given others before them, the tile being its own neighbour.
void rank(std::vector<glm::dvec2>& points, const std::vector<glm::dvec2>& before) {
    constexpr double kEverywhere = 0.75;  // no two places of the torus are as far apart
    const PointGrid grid(points, Domain{});
    std::vector<double> nearest2(points.size(), std::numeric_limits<double>::infinity());
    // The farthest first; some are out of date.
    std::priority_queue<std::pair<double, std::uint32_t>> farthest;
    const auto note = [&](glm::dvec2 chosen, double within) {
        grid.for_each_within(chosen, within, [&](std::uint32_t i, glm::dvec2 way) {
            const double squared = way.x * way.x + way.y * way.y;
            if (!(squared < nearest2[i])) return;
            nearest2[i] = squared;
            farthest.push({squared, i});
        });
    };
    for (std::uint32_t i = 0; i < points.size(); ++i) farthest.push({nearest2[i], i});
    for (const glm::dvec2 p : before) note(p, std::min(kEverywhere, 4 * kSpacing));
    std::vector<glm::dvec2> ranked;
    while (ranked.size() < points.size()) {
        const auto [squared, i] = farthest.top();
        farthest.pop();
        if (squared != nearest2[i]) continue;
        ranked.push_back(points[i]);
        nearest2[i] = -1;
        note(points[i], std::min(kEverywhere, std::sqrt(squared)));
    }
    points = std::move(ranked);
}

// An edge of a colour is divided into edges of these: the same for every tile, so that neighbours fit.
int part_of_edge(int colour, int part) {
    constexpr std::array<int, 4> kParts{0, 1, 1, 0};
    return kParts[std::size_t(part)] ^ colour;
}

void divide(int tile, WangTile& result, Random& random) {
    constexpr std::size_t n = kWangDivision;
    std::array<std::array<int, n>, n + 1> across{}, down{};  // colours of edges: by line, then along it
    for (std::size_t line = 0; line <= n; ++line) {
        for (std::size_t part = 0; part < n; ++part) {
            const auto colour = [&](int first, int last) {
                if (line == 0) return part_of_edge(tile >> first & 1, int(part));
                if (line == n) return part_of_edge(tile >> last & 1, int(part));
                return int(random.below(2));
            };
            across[line][part] = colour(0, 2);
            down[line][part] = colour(3, 1);
        }
    }
    for (std::size_t y = 0; y < n; ++y)
        for (std::size_t x = 0; x < n; ++x)
            result.children[y * n + x] =
                std::uint8_t(across[y][x] | down[x + 1][y] << 1 | across[y + 1][x] << 2 | down[x][y] << 3);
}

// The points of a tile's children, where they lie on the tile, one child after the other.
std::vector<glm::dvec2> points_of_children(const WangTiles& tiles, const WangTile& tile) {
    std::vector<glm::dvec2> all;
    for (int child = 0; child < kChildren; ++child) {
        const glm::dvec2 corner(child % kWangDivision, child / kWangDivision);
        for (const glm::dvec2 p : tiles[tile.children[std::size_t(child)]].first)
            all.push_back((corner + p) / double(kWangDivision));
    }
    return all;
}

// For each of a tile's points the one of its children's that is nearest, the closest pairs first, none twice.
std::vector<std::uint32_t> met_by(const std::vector<glm::dvec2>& own,
                                  const std::vector<glm::dvec2>& children) {
    struct Pair {
        double squared;
        std::uint32_t own, other;
    };
    const PointGrid grid(children, {1, 1, Topology::window});
    std::vector<Pair> pairs;
    for (std::uint32_t i = 0; i < own.size(); ++i) {
        grid.for_each_within(own[i], kSpacing, [&](std::uint32_t other, glm::dvec2 way) {
            pairs.push_back({way.x * way.x + way.y * way.y, i, other});
        });
    }
    std::ranges::sort(pairs, {},
                      [](const Pair& pair) { return std::tie(pair.squared, pair.own, pair.other); });
    std::vector<std::uint32_t> met(own.size(), kUnmet);
    std::vector<char> taken(children.size());
    for (const Pair& pair : pairs) {
        if (met[pair.own] != kUnmet || taken[pair.other] != 0) continue;
        met[pair.own] = pair.other;
        taken[pair.other] = 1;
    }
    return met;
}

// Moves the points that no edge keeps onto those of the children that they meet, which move likewise: four
// times less with each round.
void settle(WangTiles& tiles) {
    constexpr int kRounds = 12;
    std::vector<std::vector<std::uint32_t>> met;
    for (const WangTile& tile : tiles) met.push_back(met_by(tile.first, points_of_children(tiles, tile)));
    const auto kept = [](glm::dvec2 p) { return std::min(from_edge(p.x), from_edge(p.y)) < kKept; };
    for (int round = 0; round < kRounds; ++round) {
        const WangTiles before = tiles;
        for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
            const std::vector<glm::dvec2> children = points_of_children(before, before[tile]);
            for (std::size_t i = 0; i < met[tile].size(); ++i) {
                glm::dvec2& own = tiles[tile].first[i];
                if (met[tile][i] == kUnmet || kept(own) || kept(children[met[tile][i]])) continue;
                own = children[met[tile][i]];
            }
        }
    }
}

// What of the children's points is new.
std::vector<glm::dvec2> points_to_come(const WangTiles& tiles, const WangTile& tile) {
    const std::vector<glm::dvec2> all = points_of_children(tiles, tile);
    std::vector<char> met(all.size());
    for (const std::uint32_t other : met_by(tile.first, all))
        if (other != kUnmet) met[other] = 1;
    std::vector<glm::dvec2> rest;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (met[i] == 0) rest.push_back(all[i]);
    return rest;
}

WangTiles make_wang_tiles(std::uint64_t seed) {
    Random random(seed);
    std::vector<glm::dvec2> torus = white_noise({.count = kWangPoints, .seed = seed});
    for (int step = 0; step < kSteps; ++step) plain_lloyd_step(torus);
    const EdgePoints edges = make_edges(torus, random);
    WangTiles tiles(16);
    for (int tile = 0; tile < 16; ++tile) {
        WangTile& one = tiles[std::size_t(tile)];
        one.first = points_of_tile(tile, edges, random);
        divide(tile, one, random);
    }
    settle(tiles);
    for (WangTile& tile : tiles) rank(tile.first, {});
    for (WangTile& tile : tiles) {
        tile.later = points_to_come(tiles, tile);
        rank(tile.later, tile.first);
    }
    return tiles;
}

struct RankedDot {
    double critical;  // dots per page unit squared of density 1 from which on it is there
    glm::dvec2 place;
};

// All dots whose critical number is below `full`.
class WangPlacer {
 public:
    WangPlacer(const DotsWanted& wanted, double full) : tiles_(wang_tiles()), wanted_(wanted), full_(full) {
        add(tiles_[0].first, {0, 0, 1}, 0);
        place(0, {0, 0, 1}, 0);
    }

    std::vector<RankedDot> dots;

 private:
    struct Square {
        double x, y, side;
    };

    double density_at(glm::dvec2 p) const { return wanted_.density ? wanted_.density->at(p) : 1; }

    void add(const std::vector<glm::dvec2>& points, const Square& square, double before) {
        const double area = square.side * square.side;
        for (std::size_t rank = 0; rank < points.size(); ++rank) {
            const double threshold = (before + double(rank) + 0.5) / area;
            const glm::dvec2 p{square.x + points[rank].x * square.side,
                               square.y + points[rank].y * square.side};
            const double density = density_at(p);
            if (full_ * density > threshold) dots.push_back({threshold / density, p});
        }
    }

    void place(int tile, const Square& square, int level) {
        if (wanted_.stop.stop_requested() || level == kDeepestLevel) return;
        const double highest = wanted_.density ? highest_in(square, level) : 1;
        if (full_ * highest * square.side * square.side <= kWangPoints) return;
        add(tiles_[std::size_t(tile)].later, square, kWangPoints);
        const double side = square.side / kWangDivision;
        for (int child = 0; child < kChildren; ++child)
            place(tiles_[std::size_t(tile)].children[std::size_t(child)],
                  {square.x + child % kWangDivision * side, square.y + child / kWangDivision * side, side},
                  level + 1);
    }

    double highest_in(const Square& square, int level) const {
        const double per_side = std::ldexp(1.0, 2 * level);
        return double(wanted_.density
                          ->bounds({2 * level, std::int64_t(square.x * per_side + 0.5),
                                    std::int64_t(square.y * per_side + 0.5)})
                          .max);
    }

    const WangTiles& tiles_;
    const DotsWanted& wanted_;
    double full_;
};

}  // namespace

const WangTiles& wang_tiles() {
    static const WangTiles tiles = make_wang_tiles(1);
    return tiles;
}

PlainDots recursive_wang_tiles(const DotsWanted& wanted) {
    // About so many, and some more; of these the ones that come first.
    double full = 1.02 * double(wanted.count) / (wanted.density ? wanted.density->mean() : 1) + 16;
    while (true) {
        WangPlacer placer(wanted, full);
        if (wanted.stop.stop_requested()) return {};
        if (placer.dots.size() < wanted.count) {
            full *= 1.1;
            continue;
        }
        std::vector<RankedDot>& dots = placer.dots;
        std::ranges::sort(dots, [](const RankedDot& a, const RankedDot& b) {
            return std::tie(a.critical, a.place.y, a.place.x) < std::tie(b.critical, b.place.y, b.place.x);
        });
        PlainDots result;
        result.reserve(wanted.count);
        for (std::size_t i = 0; i < wanted.count; ++i) result.push_back(dots[i].place);
        return result;
    }
}

}  // namespace dapple
