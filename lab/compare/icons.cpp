#include "lab/compare/icons.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace dapple {
namespace {

constexpr double kSoft = 0.06, kHard = 2.0 / kIconSide;  // widths of edges, of which a side has 2

// 1 where a distance lies inside, that is below 0, and 0 where it lies outside.
double inside(double distance, double edge) {
    return std::clamp(0.5 - distance / edge, 0.0, 1.0);
}
double disc(glm::dvec2 p, glm::dvec2 middle, double radius) {
    return glm::length(p - middle) - radius;
}
double box(glm::dvec2 p, glm::dvec2 middle, glm::dvec2 half) {
    const glm::dvec2 beyond = glm::abs(p - middle) - half;
    return std::max(beyond.x, beyond.y);
}

// The ink at a place of -1..1, y down.
double star(glm::dvec2 p) {
    constexpr double kSector = std::numbers::pi / 5, kTip = 0.9, kNotch = 0.4;
    const double angle = std::atan2(p.x, -p.y), turns = std::round(angle / (2 * kSector));
    const double from_tip = std::abs(angle - turns * 2 * kSector), r = glm::length(p);
    const glm::dvec2 place(r * std::cos(from_tip), r * std::sin(from_tip));
    const glm::dvec2 side(kNotch * std::cos(kSector) - kTip, kNotch * std::sin(kSector));
    return 0.9 * inside(((place.x - kTip) * side.y - place.y * side.x) / glm::length(side), kHard);
}

double leaf(glm::dvec2 p) {
    const double blade = std::max(disc(p, {-0.5, 0}, 0.9), disc(p, {0.5, 0}, 0.9));
    const double vein = inside(std::abs(p.x) - 0.025, kHard);
    return inside(blade, kHard) * (0.25 + 0.5 * std::abs(p.x) / 0.4 + 0.2 * (p.y + 1) / 2) * (1 - 0.9 * vein);
}

double cup(glm::dvec2 p) {
    const double wall = inside(box(p, {-0.1, 0}, {0.5 - 0.15 * p.y, 0.5}), kHard);
    const double handle = inside(std::abs(disc(p, {0.5, -0.05}, 0.25)) - 0.06, kHard) * (1 - wall);
    const double shadow = inside(std::abs(p.y - 0.58) - 0.03, 2 * kSoft) * inside(std::abs(p.x) - 0.7, 0.3);
    return std::max({wall * (0.35 + 0.5 * (p.x + 0.6)), 0.7 * handle, 0.5 * shadow});
}

double moon(glm::dvec2 p) {
    return inside(disc(p, {0, 0}, 0.8), kHard) * (0.08 + 0.84 * std::clamp((p.x + 0.5) / 1.1, 0.0, 1.0));
}

double ball(glm::dvec2 p) {
    const double shade = 0.12 + 0.6 * std::min(1.0, glm::dot(p + 0.3, p + 0.3));
    const double eyes = inside(disc({std::abs(p.x), p.y}, {0.28, -0.2}, 0.1), kHard);
    const double mouth = inside(std::abs(disc(p, {0, 0.05}, 0.42)) - 0.04, kSoft) * inside(0.2 - p.y, kSoft);
    return std::max({inside(disc(p, {0, 0}, 0.85), kSoft) * shade, 0.95 * eyes, 0.9 * mouth});
}

ComparedPicture icon(const char* name, double (*ink)(glm::dvec2)) {
    ComparedPicture picture{.name = name, .light = Grid<float>(kIconSide, kIconSide)};
    for (int y = 0; y < kIconSide; ++y)
        for (int x = 0; x < kIconSide; ++x)
            picture.light.at(x, y) =
                float(1 - std::clamp(ink(glm::dvec2(x + 0.5, y + 0.5) * (2.0 / kIconSide) - 1.0), 0.0, 1.0));
    return picture;
}

}  // namespace

std::vector<ComparedPicture> icons() {
    return {icon("star", star), icon("leaf", leaf), icon("cup", cup), icon("moon", moon), icon("ball", ball)};
}

}  // namespace dapple
