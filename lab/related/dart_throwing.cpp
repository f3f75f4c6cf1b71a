#include "lab/related/dart_throwing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/tile/random.h"
#include "lab/related/bent_square.h"
#include "lab/related/growing_grid.h"

namespace dapple {
namespace {

constexpr double kRandomPacking = 0.547;  // of the plane, covered by discs of half the radius
constexpr int kDeepest = 40;              // halvings of a cell: smaller ones are rounding
// McCool and Fiume's: so many misses in a row shrink the radius by so much.
constexpr int kMisses = 200;
constexpr double kShrink = 0.97;

// Cells so small that each holds one dot at most.
class DartBoard {
 public:
    explicit DartBoard(double radius)
        : squared_(radius * radius),
          cells_(std::max(1L, long(std::ceil(std::numbers::sqrt2 / radius)))),
          dot_of_(std::size_t(cells_ * cells_), kNone) {}

    long cells() const { return cells_; }
    bool taken(long x, long y) const { return dot_of_[index(x, y)] != kNone; }
    const PlainDots& dots() const { return dots_; }

    bool free(glm::dvec2 place) const {
        bool free = true;
        for_each_near(place,
                      [&](glm::dvec2 way) { free = free && way.x * way.x + way.y * way.y >= squared_; });
        return free;
    }

    void add(glm::dvec2 place) {
        dot_of_[index(long(place.x * double(cells_)), long(place.y * double(cells_)))] =
            std::uint32_t(dots_.size());
        dots_.push_back(place);
    }

    // Whether one dot's disc covers all of the square about `middle`.
    bool covered(glm::dvec2 middle, double half) const {
        bool covered = false;
        for_each_near(middle, [&](glm::dvec2 way) {
            const double x = std::abs(way.x) + half, y = std::abs(way.y) + half;
            covered = covered || x * x + y * y < squared_;
        });
        return covered;
    }

 private:
    static constexpr std::uint32_t kNone = ~0u;

    std::size_t index(long x, long y) const {
        return std::size_t(std::clamp(y, 0L, cells_ - 1) * cells_ + std::clamp(x, 0L, cells_ - 1));
    }

    // A radius is two cells at most.
    template <class Visit>
    void for_each_near(glm::dvec2 place, const Visit& visit) const {
        const long column = long(place.x * double(cells_)), row = long(place.y * double(cells_));
        for (long y = row - 2; y <= row + 2; ++y) {
            for (long x = column - 2; x <= column + 2; ++x) {
                const long wrapped_x = (x % cells_ + cells_) % cells_;
                const long wrapped_y = (y % cells_ + cells_) % cells_;
                const std::uint32_t dot = dot_of_[std::size_t(wrapped_y * cells_ + wrapped_x)];
                if (dot == kNone) continue;
                const glm::dvec2 way = dots_[dot] - place;
                visit(glm::dvec2(way.x - std::round(way.x), way.y - std::round(way.y)));
            }
        }
    }

    double squared_;
    long cells_;
    std::vector<std::uint32_t> dot_of_;
    PlainDots dots_;
};

struct OpenCell {
    std::uint64_t x, y;  // in cells of the depth
};

PlainDots darts_of_picture(const DotsWanted& wanted) {
    const BentSquare warp(wanted.density);
    const glm::dvec2 page = page_of(wanted);
    GrowingGrid grid({page.x, page.y, Topology::window});
    Random random(wanted.seed);
    double radius2 = page.x * page.y;  // at density 1
    int misses = 0;
    while (grid.points().size() < wanted.count) {
        if (wanted.stop.stop_requested()) return {};
        const double x = random.unit(), y = random.unit();
        const glm::dvec2 place = warp({x, y});
        const double density = std::max(wanted.density->at(place), 1e-6);
        const double free2 = radius2 / density;
        if (grid.nearest2(place, free2) >= free2) {
            grid.add(place);
            misses = 0;
        } else if (++misses == kMisses) {
            radius2 *= kShrink * kShrink;
            misses = 0;
        }
    }
    return grid.points();
}

}  // namespace

double dart_radius(std::size_t count) {
    return std::sqrt(4 * kRandomPacking / (std::numbers::pi * double(std::max<std::size_t>(count, 1))));
}

PlainDots maximal_darts(double radius, std::uint64_t seed, const std::stop_token& stop) {
    DartBoard board(radius);
    Random random(seed);
    std::vector<OpenCell> open;
    open.reserve(std::size_t(board.cells() * board.cells()));
    for (long y = 0; y < board.cells(); ++y)
        for (long x = 0; x < board.cells(); ++x) open.push_back({std::uint64_t(x), std::uint64_t(y)});

    for (int depth = 0; !open.empty() && depth <= kDeepest; ++depth) {
        const double side = std::ldexp(1.0 / double(board.cells()), -depth);
        const auto root = [&](std::uint64_t cell) { return long(cell >> depth); };
        for (std::size_t dart = 0; dart < open.size(); ++dart) {
            if ((dart & 0xfff) == 0 && stop.stop_requested()) return {};
            const OpenCell cell = open[random.below(open.size())];
            if (board.taken(root(cell.x), root(cell.y))) continue;
            const double u = random.unit(), v = random.unit();
            const glm::dvec2 place{(double(cell.x) + u) * side, (double(cell.y) + v) * side};
            if (board.free(place)) board.add(place);
        }
        std::vector<OpenCell> divided;
        for (const OpenCell cell : open) {
            if (board.taken(root(cell.x), root(cell.y))) continue;
            for (std::uint64_t quadrant = 0; quadrant < 4; ++quadrant) {
                const OpenCell part{2 * cell.x + (quadrant & 1), 2 * cell.y + (quadrant >> 1)};
                const glm::dvec2 middle{(double(part.x) + 0.5) * side / 2, (double(part.y) + 0.5) * side / 2};
                if (!board.covered(middle, side / 4)) divided.push_back(part);
            }
        }
        open = std::move(divided);
    }
    return board.dots();
}

PlainDots dart_throwing(const DotsWanted& wanted) {
    if (wanted.density) return darts_of_picture(wanted);
    return maximal_darts(std::min(dart_radius(wanted.count), 0.49), wanted.seed, wanted.stop);
}

}  // namespace dapple
