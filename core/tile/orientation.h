#pragma once
// The eight symmetries of the square, the group D4, acting about the square's centre.
//
// Index 0..3: rotations by 0, 90, 180, 270 degrees, (x, y) -> (-y, x) being 90. Index 4+i: first mirror x,
// then rotation i. Quadrants: 0 = (-,-), 1 = (+,-), 2 = (-,+), 3 = (+,+), that is, xbit + 2 ybit.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>

namespace dapple {

/// A position in the unit square as two binary fractions, x / 2^64 and y / 2^64, rounded down. The k-th bits
/// from the top name the quadrant at depth k, so subdividing is shifting, and nothing is lost on the way.
struct BinaryPoint {
    std::uint64_t x = 0, y = 0;
    bool operator==(const BinaryPoint&) const = default;
};

struct Orientation {
    std::uint8_t index = 0;  // 0..7
    bool operator==(const Orientation&) const = default;
};

/// An orientation taken apart: swap the axes or not, then negate each or not.
struct SwapAndSigns {
    bool swap, negate_x, negate_y;
};
SwapAndSigns steps_of(Orientation g);

/// Every orientation, the identity first.
std::array<Orientation, 8> all_orientations();

/// The orientation that applies `first`, then `second`.
Orientation compose(Orientation second, Orientation first);
Orientation inverse(Orientation g);

/// The quadrant on which g puts quadrant q.
int apply_to_quadrant(Orientation g, int q);

/// The vector g(v) of a vector v from the square's centre.
glm::dvec2 apply(Orientation g, glm::dvec2 v);

/// The point g(p) of a point p in the unit square, exact: mirroring a binary fraction is flipping its digits.
BinaryPoint apply(Orientation g, BinaryPoint p);

/// x and y in [0, 1).
glm::dvec2 to_unit_square(BinaryPoint p);

/// The quadrant p lies in, and p blown up from that quadrant to the unit square, f(p) = 2p mod 1.
int quadrant_of(BinaryPoint p);
BinaryPoint enlarge_quadrant(BinaryPoint p);

/// The half-scale map S_q of the unit square onto its quadrant q.
BinaryPoint shrink_to_quadrant(int q, BinaryPoint p);

}  // namespace dapple
