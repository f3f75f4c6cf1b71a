#include "core/analysis/point_grid.h"

#include <numeric>

namespace dapple {

PointGrid::PointGrid(std::span<const glm::dvec2> points, const Domain& domain) : domain_(domain) {
    const double side = std::sqrt(2 * domain.area() / double(std::max<std::size_t>(points.size(), 1)));
    // A domain much longer than wide gets no more than 2^24 cells.
    columns_ = std::clamp(long(domain.width / side), 1L, 4096L);
    rows_ = std::clamp(long(domain.height / side), 1L, 4096L);
    cell_ = {domain.width / double(columns_), domain.height / double(rows_)};

    std::vector<std::uint32_t> cell_of(points.size());
    start_.assign(std::size_t(columns_ * rows_) + 1, 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const long column = std::clamp(long(std::floor(points[i].x / cell_.x)), 0L, columns_ - 1);
        const long row = std::clamp(long(std::floor(points[i].y / cell_.y)), 0L, rows_ - 1);
        cell_of[i] = std::uint32_t(row * columns_ + column);
        ++start_[cell_of[i] + 1];
    }
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    sorted_.resize(points.size());
    std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
    for (std::size_t i = 0; i < points.size(); ++i)
        sorted_[next[cell_of[i]]++] = {points[i], std::uint32_t(i)};
}

}  // namespace dapple
