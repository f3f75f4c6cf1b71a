#pragma once
// Where a point set lives: a rectangle whose lower corner is the origin, and what lies beyond its edges.
//
// Lengths are in the caller's unit. All results of the analysis are free of it: distances are over r_max or
// in units of the mean spacing sqrt(area / n), frequencies in units of sqrt(n / area).

#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/export.h"
#include "core/text/names.h"

namespace dapple {

enum class Topology {
    torus,   // opposite edges meet: the set repeats in both directions
    window,  // a cut-out: nothing is known beyond the edges
};
constexpr auto names_of(Topology) {
    return names("torus", "window");
}

struct Domain {
    double width = 1;
    double height = 1;
    Topology topology = Topology::torus;

    double area() const { return width * height; }
    bool operator==(const Domain&) const = default;
};

/// The disc radius of `count` points in the densest packing, the hexagonal lattice:
/// sqrt(area / (2 sqrt(3) count)) (Lagae & Dutré 2006, section 5). Its spacing is twice that. count >= 1.
DAPPLE_API double largest_radius(const Domain& domain, std::size_t count);

/// The points as every function of the analysis expects them: 0 <= x < width, 0 <= y < height on a torus,
/// where others are moved by whole periods; 0 <= x <= width, 0 <= y <= height in a window.
/// Throws std::runtime_error if a side of the domain or a coordinate is not a finite number, if a side is not
/// positive, or if a point lies outside a window. `name` says in the message what the points are.
DAPPLE_API std::vector<glm::dvec2> points_inside(std::span<const glm::dvec2> points, const Domain& domain,
                                                 const std::string& name = "points");

/// Leaves one point at each place: of those within `near` of another, on both axes, the one with the smallest
/// x.
void drop_duplicates(std::vector<glm::dvec2>& points, double near);

}  // namespace dapple
