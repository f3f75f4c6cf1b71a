#pragma once
// Penrose's rhombs, divided again and again: V. Ostromoukhov, C. Donohue & P.-M. Jodoin, "Fast Hierarchical
// Importance Sampling with Blue Noise Properties" (2004). Their vertices stay where they are when
// the rhombs are divided, and come by a factor of the golden ratio squared, 2.618, from level to level.
//
// Halves of the rhombs are divided, Robinson's triangles. What differs from the paper: its tiles of six kinds
// carry the numbers of their points in the Fibonacci system, whose leading digits are those of the last
// division. Here a triangle carries the share of such numbers that are smaller: the same order, without a
// largest number of digits.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <numbers>
#include <span>
#include <vector>

namespace dapple {

/// What a triangle came from says who else has its vertices.
enum class PenroseKind : std::uint8_t {
    acute,         // half of a thin rhomb, 36 degrees at its apex
    obtuse_left,   // half of a thick rhomb, 108 degrees: of an acute triangle
    obtuse_outer,  // of an obtuse one, along its longest side
    obtuse_inner,  // of an obtuse one, within it
};
inline constexpr int kPenroseKinds = 4;

/// The apex and the two ends of the base, in any frame.
struct PenroseTriangle {
    PenroseKind kind = PenroseKind::acute;
    std::uint8_t ancestors =
        0;  // the kinds of the last three that it came from, the last one in bits 0 and 1
    glm::dvec2 apex{}, left{}, right{};
    double share = 0.5;  // of all triangles of its kind that have smaller numbers, 0..1

    bool operator==(const PenroseTriangle&) const = default;
};

/// A vertex that is new when a triangle is divided.
struct PenroseVertex {
    glm::dvec2 place{};
    double share = 0;        // of all new vertices of its level that have smaller numbers, 0..1
    std::uint16_t type = 0;  // of kPenroseTypes: its surroundings, but for how they are turned
    glm::dvec2 along{};      // how they are turned, and as long as a new rhomb's side
    bool mirrored = false;   // they are seen in a mirror
};
inline constexpr int kPenroseTypes = 384;  // of which a third occurs

/// What a triangle is divided into, and the vertices that come with it. Each vertex of the tiling comes with
/// one triangle alone, though it lies on the edges of two.
struct DividedTriangle {
    std::array<PenroseTriangle, 3> triangles;
    std::array<PenroseVertex, 2> vertices;
    int triangle_count = 0, vertex_count = 0;

    std::span<const PenroseTriangle> parts() const { return {triangles.data(), std::size_t(triangle_count)}; }
    std::span<const PenroseVertex> born() const { return {vertices.data(), std::size_t(vertex_count)}; }
};

DividedTriangle divide(const PenroseTriangle& triangle);

/// A new rhomb's side is that of the old one over this.
inline constexpr double kGolden = std::numbers::phi;

/// Vertices for each unit of area of a tiling whose rhombs have that side: 1.23 / side^2.
double penrose_vertices(double side);

}  // namespace dapple
