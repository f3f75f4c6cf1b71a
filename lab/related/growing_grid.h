#pragma once
// Points that come one by one, and the nearest of them to a place.

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "core/analysis/domain.h"

namespace dapple {

/// Square cells of about two points each on average: they are made anew, smaller, as points come.
class GrowingGrid {
 public:
    explicit GrowingGrid(const Domain& domain) : domain_(domain) { divide(1); }

    /// A point of the domain.
    void add(glm::dvec2 point);

    /// The square of the distance from a place of the domain to the nearest point, or any number over
    /// enough2 where none is within the root of that; infinity for no points. On a torus images count too.
    double nearest2(glm::dvec2 place, double enough2) const;

    const std::vector<glm::dvec2>& points() const { return points_; }

 private:
    void divide(std::size_t cells);
    void enter(std::uint32_t index);
    double nearest2_in(long column, long row, glm::dvec2 place) const;

    Domain domain_;
    long columns_ = 1, rows_ = 1;
    glm::dvec2 cell_{1, 1};
    std::vector<glm::dvec2> points_;
    std::vector<std::uint32_t> first_, next_;  // lists of the points in each cell; kNone ends them
};

}  // namespace dapple
