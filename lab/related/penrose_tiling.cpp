#include "lab/related/penrose_tiling.h"

#include <cmath>
#include <initializer_list>

namespace dapple {
namespace {

using enum PenroseKind;

// How many of all triangles that are divided into one are of which kind: in a large tiling there are as many
// times more obtuse than acute ones as the golden ratio says, and every share is a power of it.
constexpr double kPhi = kGolden;
constexpr double kPhi1 = 1 / kPhi, kPhi2 = kPhi1 * kPhi1, kPhi3 = kPhi2 * kPhi1;

// Part of 0..1, from `first` on.
struct Interval {
    double first = 0, length = 0;
    double at(double share) const { return first + length * share; }
};

using Intervals = std::array<Interval, kPenroseKinds>;

struct Weighted {
    PenroseKind kind;
    double weight;
};

constexpr Intervals one_after_the_other(std::initializer_list<Weighted> parts) {
    Intervals intervals{};
    double total = 0, from = 0;
    for (const Weighted& part : parts) total += part.weight;
    for (const Weighted& part : parts) {
        intervals[std::size_t(part.kind)] = {from / total, part.weight / total};
        from += part.weight;
    }
    return intervals;
}

// The shares of a triangle's kind, by the kind of its parent. Any order keeps shares even; these, found by
// trial, keep vertices of near shares farthest apart.
constexpr std::array<Intervals, kPenroseKinds> kShares{
    one_after_the_other({{acute, kPhi2},
                         {obtuse_inner, kPhi1* kPhi2},
                         {obtuse_left, kPhi1* kPhi3},
                         {obtuse_outer, kPhi1* kPhi2}}),
    one_after_the_other({{acute, 1}}),
    one_after_the_other({{obtuse_outer, kPhi2}, {obtuse_inner, kPhi2}, {obtuse_left, kPhi3}}),
    one_after_the_other({{obtuse_outer, kPhi2}, {obtuse_inner, kPhi2}, {obtuse_left, kPhi3}}),
};

// The shares of new vertices: first those on the base, which one of the two halves of a thick rhomb brings,
// and then those on a leg, which only one of two mirrored triangles along a longest side brings.
constexpr Intervals kOnBase =
    one_after_the_other({{obtuse_inner, kPhi2}, {obtuse_left, kPhi3}, {obtuse_outer, kPhi2}});
constexpr Intervals kOnLeg =
    one_after_the_other({{obtuse_inner, kPhi2}, {obtuse_left, kPhi3}, {obtuse_outer, 0.5 * kPhi2}});
constexpr double kBases = 0.5 * (2 * kPhi2 + kPhi3), kLegs = 1.5 * kPhi2 + kPhi3;
constexpr Interval kAllOnBase{0, kBases / (kBases + kLegs)},
    kAllOnLeg{kBases / (kBases + kLegs), kLegs / (kBases + kLegs)};

double cross(glm::dvec2 a, glm::dvec2 b) {
    return a.x * b.y - a.y * b.x;
}

}  // namespace

DividedTriangle divide(const PenroseTriangle& triangle) {
    const PenroseKind kind = triangle.kind;
    const double share = triangle.share;
    const glm::dvec2 a = triangle.apex, b = triangle.left, c = triangle.right;
    DividedTriangle result;
    const auto older = std::uint8_t((triangle.ancestors << 2 | int(kind)) & 63);
    const auto add = [&](PenroseKind child, glm::dvec2 apex, glm::dvec2 left, glm::dvec2 right) {
        const double of_kind = kShares[std::size_t(child)][std::size_t(kind)].at(share);
        result.triangles[std::size_t(result.triangle_count++)] = {child, older, apex, left, right, of_kind};
    };
    if (kind == acute) {
        const glm::dvec2 p = a + (b - a) / kGolden;  // comes with the obtuse triangle beyond this leg
        add(acute, c, p, b);
        add(obtuse_left, p, c, a);
        return result;
    }
    const glm::dvec2 q = b + (a - b) / kGolden, r = b + (c - b) / kGolden;
    add(obtuse_outer, r, c, a);
    add(obtuse_inner, q, r, b);
    add(acute, r, q, a);
    const bool mirrored = cross(b - a, c - a) < 0;
    const auto bear = [&](glm::dvec2 place, bool base) {
        const double of_all = base ? kAllOnBase.at(kOnBase[std::size_t(kind)].at(share))
                                   : kAllOnLeg.at(kOnLeg[std::size_t(kind)].at(share));
        const int type = ((base ? 3 : 0) + int(kind) - 1) * 64 + int(triangle.ancestors);
        result.vertices[std::size_t(result.vertex_count++)] = {place, of_all, std::uint16_t(type),
                                                               (a - b) / kGolden, mirrored};
    };
    // Beyond the leg of an outer triangle lies its mirror image; beyond those of the others an acute one.
    if (kind != obtuse_outer || !mirrored) bear(q, false);
    if (!mirrored) bear(r, true);
    return result;
}

double penrose_vertices(double side) {
    // As many vertices as rhombs, kPhi times as many thick as thin ones.
    const double thin = std::sin(std::numbers::pi / 5), thick = std::sin(std::numbers::pi * 3 / 5);
    return (1 + kGolden) / (side * side * (thin + kGolden * thick));
}

}  // namespace dapple
