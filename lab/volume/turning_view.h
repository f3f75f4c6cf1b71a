#pragma once
// Dots in space seen from around them: a picture for each moment of one turn.

#include <cstddef>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "core/image/grid.h"
#include "lab/volume/space_cells.h"

namespace dapple {

/// A ball to be seen.
struct Ball {
    glm::dvec3 place{0};
    double radius = 0;
    glm::vec3 ink{0};  // roots of light: as good as sRGB-encoded 0..1
};

/// A radius of which so many balls that fill a box hide few of each other: a quarter of their distance.
double ball_radius(const Box& box, std::size_t balls);

/// Where they are seen from: from afar.
struct TurnedView {
    Box box{};           // all of it is in the picture wherever it is seen from
    double turn = 0;     // 0..1: how far round the z axis, which points up, it has turned
    double down = 0.35;  // radians by which one looks down on it
    int side = 400;      // pixels

    bool operator==(const TurnedView&) const = default;
};

/// A square picture, sRGB, on white paper, of balls in the box. Nearer ones are darker and hide others. None
/// is drawn smaller than a pixel or so, nor larger than a thirtieth of the picture.
Grid<glm::u8vec3> turned_view(std::span<const Ball> balls, const TurnedView& view);

/// The same of black ones of equal size, in the box around them.
Grid<glm::u8vec3> turned_view(std::span<const glm::dvec3> dots, double turn, int side);

}  // namespace dapple
