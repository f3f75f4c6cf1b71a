#pragma once
// Places in space by cubes, so that those near a place are found.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

namespace dapple {

struct Box {
    glm::dvec3 low{0}, high{0};

    bool operator==(const Box&) const = default;
};

/// The smallest box around all places; of none, empty at 0.
inline Box box_around(std::span<const glm::dvec3> places) {
    if (places.empty()) return {};
    Box box{places[0], places[0]};
    for (const glm::dvec3& place : places) box = {glm::min(box.low, place), glm::max(box.high, place)};
    return box;
}

class SpaceCells {
 public:
    /// Keeps the places by reference. Those beyond the box count as in its outermost cubes. Cubes are larger
    /// than asked for where they would be more than a few for each place.
    SpaceCells(std::span<const glm::dvec3> places, const Box& box, double side)
        : places_(places), low_(box.low) {
        const glm::dvec3 size = glm::max(box.high - box.low, 1e-300);
        const double most = 8.0 * static_cast<double>(places.size()) + 64;
        while ((size.x / side + 1) * (size.y / side + 1) * (size.z / side + 1) > most) side *= 1.3;
        side_ = side;
        count_ = glm::ivec3(glm::floor(size / side)) + 1;
        begin_.resize(static_cast<std::size_t>(count_.x) * count_.y * count_.z + 1);
        for (const glm::dvec3& place : places) ++begin_[index(cell_of(place)) + 1];
        std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
        std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
        ordered_.resize(places.size());
        for (std::size_t i = 0; i < places.size(); ++i)
            ordered_[next[index(cell_of(places[i]))]++] = static_cast<std::uint32_t>(i);
    }

    /// Calls `visit` with the number of each place within the radius, and of some beyond it.
    template <class Visit>
    void near(const glm::dvec3& place, double radius, const Visit& visit) const {
        const glm::ivec3 low = cell_of(place - radius), high = cell_of(place + radius);
        for (int z = low.z; z <= high.z; ++z)
            for (int y = low.y; y <= high.y; ++y) {
                const std::size_t row = index({0, y, z});
                for (std::uint32_t k = begin_[row + low.x]; k < begin_[row + high.x + 1]; ++k)
                    visit(ordered_[k]);
            }
    }

    /// The number of the place nearest to one, of those that `may_be` lets be; of equally near ones the
    /// first. places.size() if there is none.
    template <class MayBe>
    std::size_t nearest(const glm::dvec3& place, const MayBe& may_be) const {
        const double furthest = glm::length(
            glm::max(glm::abs(place - low_), glm::abs(low_ + glm::dvec3(count_) * side_ - place)));
        for (double radius = side_;; radius *= 2) {
            std::size_t best = places_.size();
            double least = std::numeric_limits<double>::infinity();
            near(place, radius, [&](std::uint32_t i) {
                const glm::dvec3 apart = places_[i] - place;
                const double far = glm::dot(apart, apart);
                if (far > least || (far == least && i > best) || !may_be(i)) return;
                least = far;
                best = i;
            });
            if (least <= radius * radius || radius > furthest) return best;
        }
    }

 private:
    glm::ivec3 cell_of(const glm::dvec3& place) const {
        return glm::ivec3(
            glm::clamp(glm::floor((place - low_) / side_), glm::dvec3(0), glm::dvec3(count_ - 1)));
    }
    std::size_t index(const glm::ivec3& cell) const {
        return (static_cast<std::size_t>(cell.z) * count_.y + cell.y) * count_.x + cell.x;
    }

    std::span<const glm::dvec3> places_;
    glm::dvec3 low_;
    double side_ = 1;
    glm::ivec3 count_;
    std::vector<std::uint32_t> begin_, ordered_;
};

}  // namespace dapple
