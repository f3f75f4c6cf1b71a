#include "lab/related/growing_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dapple {
namespace {

constexpr std::uint32_t kNone = ~0u;
constexpr double kInfinite = std::numeric_limits<double>::infinity();

long whole_turns(long cell, long cells) {
    return cell >= 0 ? cell / cells : -((cells - 1 - cell) / cells);
}

}  // namespace

void GrowingGrid::divide(std::size_t cells) {
    const double side = std::sqrt(domain_.area() / double(cells));
    columns_ = std::max(1L, long(domain_.width / side));
    rows_ = std::max(1L, long(domain_.height / side));
    cell_ = {domain_.width / double(columns_), domain_.height / double(rows_)};
    first_.assign(std::size_t(columns_ * rows_), kNone);
    for (std::uint32_t i = 0; i < points_.size(); ++i) enter(i);
}

void GrowingGrid::enter(std::uint32_t index) {
    const glm::dvec2 point = points_[index];
    const long column = std::clamp(long(point.x / cell_.x), 0L, columns_ - 1);
    const long row = std::clamp(long(point.y / cell_.y), 0L, rows_ - 1);
    std::uint32_t& first = first_[std::size_t(row * columns_ + column)];
    next_[index] = first;
    first = index;
}

void GrowingGrid::add(glm::dvec2 point) {
    points_.push_back(point);
    next_.push_back(kNone);
    if (points_.size() > 4 * first_.size())
        divide(points_.size());
    else
        enter(std::uint32_t(points_.size() - 1));
}

// The cell may lie a turn beyond a torus.
double GrowingGrid::nearest2_in(long column, long row, glm::dvec2 place) const {
    const long turns_x = whole_turns(column, columns_), turns_y = whole_turns(row, rows_);
    if (domain_.topology == Topology::window && (turns_x != 0 || turns_y != 0)) return kInfinite;
    const glm::dvec2 from =
        place - glm::dvec2(double(turns_x) * domain_.width, double(turns_y) * domain_.height);
    const auto cell = std::size_t((row - turns_y * rows_) * columns_ + column - turns_x * columns_);
    double nearest = kInfinite;
    for (std::uint32_t i = first_[cell]; i != kNone; i = next_[i]) {
        const glm::dvec2 way = points_[i] - from;
        nearest = std::min(nearest, way.x * way.x + way.y * way.y);
    }
    return nearest;
}

double GrowingGrid::nearest2(glm::dvec2 place, double enough2) const {
    if (points_.empty()) return kInfinite;
    const long column = std::clamp(long(place.x / cell_.x), 0L, columns_ - 1);
    const long row = std::clamp(long(place.y / cell_.y), 0L, rows_ - 1);
    const double side = std::min(cell_.x, cell_.y);
    double nearest = nearest2_in(column, row, place);
    // Ring after ring of cells: what lies in the next one is at least ring - 1 cells away.
    const long last = std::max(columns_, rows_);
    for (long ring = 1; ring <= last; ++ring) {
        const double bare = double(ring - 1) * side;
        if (bare * bare > std::min(nearest, enough2)) break;
        for (long i = -ring; i <= ring; ++i) {
            nearest = std::min({nearest, nearest2_in(column + i, row - ring, place),
                                nearest2_in(column + i, row + ring, place)});
            if (i == -ring || i == ring) continue;
            nearest = std::min({nearest, nearest2_in(column - ring, row + i, place),
                                nearest2_in(column + ring, row + i, place)});
        }
    }
    return nearest;
}

}  // namespace dapple
