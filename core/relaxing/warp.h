#pragma once
// One smooth displacement of all dots, for what is wrong over several of them.
//
// A step moves a dot by what is around it, and what is too dark or too light over many dots stays so. A warp
// compares what all dots come to with what they should, both blurred by a mean spacing, and lets the excess r
// flow off: where laplace(phi) = r, and rho is what there should be, the displacement u = grad(phi) / rho has
// div(rho u) = r. It is optimal transport's to the first order (Villani 2003, "Topics in Optimal
// Transportation", section 4.1.2): dots that lie near each other move alike, and stay as even as they were.
//
// Dots of a picture are compared by the light that they leave, drawn as large as its tone asks for; others as
// they are counted, by area where these differ.

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <utility>
#include <vector>

#include "core/image/density.h"
#include "core/image/dot_areas.h"
#include "core/image/grid.h"
#include "core/image/ink.h"
#include "core/relaxing/dot_rows.h"
#include "core/relaxing/page_rows.h"

namespace dapple {

/// How far what lies at a place is carried, in rows' heights; see PageRows.
class Displacement {
 public:
    /// Nothing anywhere.
    Displacement() = default;
    /// Through the left and right sides of cells of that size, and through the upper and lower ones: a column
    /// and a row more than there are cells.
    Displacement(Grid<float> across, Grid<float> down, glm::vec2 cell)
        : across_(std::move(across)), down_(std::move(down)), cell_(cell) {}

    glm::vec2 at(float x, float y) const;

 private:
    Grid<float> across_, down_;
    glm::vec2 cell_{1};
};

/// No dot is carried farther, in rows' heights.
inline constexpr float kFarthestWarped = 4;

/// What is to be known of the dots to be warped.
struct WarpRequest {
    double scale = 0;  // that they were placed at
    double dots = 0;   // so many, about
    DotAreas areas = {};
    std::shared_ptr<const InkCurve> ink = {};  // from density to light; none: they are counted
    /// The page ends at the picture's edges, which cut dots off: what is lost of them is made up for. Else
    /// dots that lie within a mean spacing of an edge stay more and more as they are.
    bool cut_off = false;
};

/// What a page's dots are warped towards, in cells of which three lie side by side in a mean spacing, and at
/// most some 2048 along a side.
class Warp {
 public:
    Warp(const Density& density, const WarpRequest& request);

    /// Of dots in rows, with their areas if these differ.
    Displacement displacement(const DotRows& dots) const;

    /// The same of dots that come one by one and are counted. The warp has to outlive it.
    class Count {
     public:
        explicit Count(const Warp& warp);
        /// At a place in rows' heights; of such an area over the largest's.
        void add(float x, float y, float area = 1);
        Displacement displacement() const;

     private:
        const Warp& warp_;
        std::vector<std::uint32_t> sums_;
    };

 private:
    Grid<float> wanted(const Density& density, const DotAreas& areas) const;
    Grid<float> light_of(const DotRows& dots) const;
    void take_loads(Grid<float>& light) const;
    Displacement displacement_for(Grid<float> present) const;

    PageRows page_;
    std::shared_ptr<const InkCurve> ink_;
    std::vector<float> loads_;  // that leave so much light, at equal steps of it
    int width_ = 0, height_ = 0;
    glm::vec2 cell_{1};  // rows' heights
    float spacing_ = 1;  // likewise, of dots on the mean
    float radius_ = 0;   // likewise, of the largest
    bool cut_off_ = false;
    Grid<float> wanted_;  // load in each cell, or dots
    Grid<float> most_;    // that one warp takes off, of the first
};

}  // namespace dapple
