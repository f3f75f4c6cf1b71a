#include "lab/volume/resample_cloud.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <queue>
#include <stdexcept>
#include <utility>

#include "lab/volume/space_cells.h"

namespace dapple {
namespace {

constexpr int kSweeps = 6;

double squared(const glm::dvec3& way) {
    return glm::dot(way, way);
}

// The points chosen of a cloud, and how far each point is from the nearest of them.
class Chosen {
 public:
    explicit Chosen(std::span<const glm::dvec3> cloud)
        : cloud_(cloud), box_(box_around(cloud)), cells_(cloud, box_, side_of(box_, cloud.size())) {
        far_.assign(cloud.size(), squared(box_.high - box_.low) + 1);
        nearest_.resize(cloud.size());
        is_chosen_.resize(cloud.size());
        for (std::size_t i = 0; i < cloud.size(); ++i) queue_.emplace(far_[i], i);
    }

    /// The point that is furthest from all that are chosen, and how far, squared.
    std::pair<double, std::uint32_t> furthest() {
        while (true) {
            const auto [was, point] = queue_.top();
            if (was == far_[point]) return {was, point};
            queue_.pop();
            // Where it is further than it was, it was entered again.
            if (was > far_[point]) queue_.emplace(far_[point], point);
        }
    }

    void add(std::uint32_t point) {
        is_chosen_[point] = true;
        if (side_ > 0) chosen_[cell_of(cloud_[point])].push_back(point);
        cells_.near(cloud_[point], std::sqrt(far_[point]), [&](std::uint32_t i) {
            const double far = squared(cloud_[i] - cloud_[point]);
            if (far >= far_[i]) return;
            far_[i] = far;
            nearest_[i] = point;
        });
    }

    /// What was chosen is to be moved: it is kept by cells that are `reach` wide.
    void prepare(std::span<const std::uint32_t> points, double reach) {
        side_ = std::max(reach, 1e-300);
        for (const std::uint32_t point : points) chosen_[cell_of(cloud_[point])].push_back(point);
    }

    /// Takes one away again; no point is further than `reach` from its nearest.
    void remove(std::uint32_t point, double reach) {
        is_chosen_[point] = false;
        std::erase(chosen_[cell_of(cloud_[point])], point);
        cells_.near(cloud_[point], reach, [&](std::uint32_t i) {
            if (nearest_[i] != point) return;
            nearest_[i] = nearest_chosen(cloud_[i]);
            far_[i] = squared(cloud_[i] - cloud_[nearest_[i]]);
            queue_.emplace(far_[i], i);
        });
    }

 private:
    using Cell = std::array<int, 3>;
    Cell cell_of(const glm::dvec3& place) const {
        const glm::dvec3 cell = glm::floor((place - box_.low) / side_);
        return {static_cast<int>(cell.x), static_cast<int>(cell.y), static_cast<int>(cell.z)};
    }

    // Nearly always within two cells; a part of the cloud that is apart from the rest may be further off.
    std::uint32_t nearest_chosen(const glm::dvec3& place) const {
        const Cell middle = cell_of(place);
        double least = 4 * side_ * side_;
        std::optional<std::uint32_t> best;
        for (int z = -2; z <= 2; ++z)
            for (int y = -2; y <= 2; ++y)
                for (int x = -2; x <= 2; ++x) {
                    const auto there = chosen_.find({middle[0] + x, middle[1] + y, middle[2] + z});
                    if (there == chosen_.end()) continue;
                    for (const std::uint32_t point : there->second) {
                        const double far = squared(cloud_[point] - place);
                        if (far > least || (best && far == least && point > *best)) continue;
                        least = far;
                        best = point;
                    }
                }
        if (best) return *best;
        return static_cast<std::uint32_t>(
            cells_.nearest(place, [&](std::size_t other) { return is_chosen_[other]; }));
    }

    static double side_of(const Box& box, std::size_t count) {
        const glm::dvec3 extent = box.high - box.low;
        return std::max({extent.x, extent.y, extent.z, 1e-300}) / std::cbrt(static_cast<double>(count));
    }

    std::span<const glm::dvec3> cloud_;
    Box box_;
    SpaceCells cells_;
    std::vector<double> far_;  // squared
    std::vector<std::uint32_t> nearest_;
    std::vector<char> is_chosen_;
    double side_ = 0;  // of the cells of what is chosen; 0: not prepared yet
    std::map<Cell, std::vector<std::uint32_t>> chosen_;
    // By how far they were; equal ones the first.
    struct Later {
        bool operator()(const std::pair<double, std::uint32_t>& a,
                        const std::pair<double, std::uint32_t>& b) const {
            return a.first != b.first ? a.first < b.first : a.second > b.second;
        }
    };
    std::priority_queue<std::pair<double, std::uint32_t>, std::vector<std::pair<double, std::uint32_t>>,
                        Later>
        queue_;
};

}  // namespace

std::vector<std::size_t> even_subset(std::span<const glm::dvec3> cloud, std::size_t count) {
    if (count == 0) throw std::runtime_error("0 points; give 1 or more");
    if (cloud.size() < count)
        throw std::runtime_error(
            fmt::format("{} points of a cloud that has {}; give that many or fewer", count, cloud.size()));
    Chosen chosen(cloud);
    std::vector<std::uint32_t> points;
    double reach = 0;
    while (points.size() < count) {
        const auto [far, point] = chosen.furthest();
        if (far == 0)
            throw std::runtime_error(
                fmt::format("{} points of a cloud that has {} distinct ones; give that many or fewer", count,
                            points.size()));
        reach = std::sqrt(far);
        chosen.add(point);
        points.push_back(point);
    }
    chosen.prepare(points, reach);
    for (int sweep = 0; sweep < kSweeps && count > 1; ++sweep)
        for (std::uint32_t& point : points) {
            chosen.remove(point, reach);
            point = chosen.furthest().second;
            chosen.add(point);
        }
    std::ranges::sort(points);
    return {points.begin(), points.end()};
}

}  // namespace dapple
