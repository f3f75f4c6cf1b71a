#include "assets/make/still_life.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace dapple::make {
namespace {

using glm::dmat3;
using glm::dvec2;
using glm::dvec3;
constexpr double pi = std::numbers::pi;

constexpr double hairline = 0.0024;  // radius: about one pixel wide in a picture of 1024

dmat3 turned_about_y(double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {dvec3(c, 0, -s), dvec3(0, 1, 0), dvec3(s, 0, c)};
}

Turned cylinder(double radius, double height, double rounding) {
    const double r = rounding;
    return {{{0, r}, {radius - r, r}, {radius - r, height - r}, {0, height - r}}, r};
}

Turned cone(double radius, double height, double rounding) {
    const double r = rounding;
    return {{{0, r}, {radius - r, r}, {0, height - r}}, r};
}

Solid wire(const dvec3& from, const dvec3& to, double radius) {
    return {Wire{glm::length(to - from), radius}, {.albedo = 0.02}, from, axes_with_y(to - from)};
}

// A line on the table that turns right and left by turns without a corner: (radius, angle) of each bend.
std::vector<Arc> winding(dvec2 centre, double angle, const std::vector<dvec2>& bends) {
    std::vector<Arc> arcs;
    for (size_t i = 0; i < bends.size(); ++i) {
        const auto [radius, turn] = std::pair(bends[i].x, bends[i].y);
        const double end = i % 2 == 0 ? angle + turn : angle - turn;
        arcs.push_back({centre, radius, std::min(angle, end), std::max(angle, end)});
        if (i + 1 < bends.size()) centre += (radius + bends[i + 1].x) * dvec2(std::cos(end), std::sin(end));
        angle = end + pi;
    }
    return arcs;
}

}  // namespace

Scene still_life() {
    Scene scene;
    auto add = [&](Shape shape, Material material, dvec3 position, dmat3 axes = dmat3(1)) {
        scene.solids.push_back({std::move(shape), material, position, axes});
    };
    const Material plaster{.albedo = 0.8};
    const Material ebony{.albedo = 0.006, .gloss = 0.04, .roughness = 0.03};

    add(Ball{0.98}, plaster, {-0.78, 0.98, -0.55});
    add(cone(0.78, 3.0, 0.015), {.albedo = 0.7}, {1.15, 0, -0.75});
    add(cylinder(0.42, 2.25, 0.03),
        {.albedo = 0.55, .gloss = 0.03, .roughness = 0.25, .texture = Texture::turned_wood},
        {0.20, 0, -1.35});
    add(Block{dvec3(0.46), 0.02}, {.albedo = 0.85, .texture = Texture::speckled}, {1.25, 0.46, 0.55},
        turned_about_y(-0.62));
    // Leans back against the block, its lowest point on the table.
    const dvec3 tilt = glm::normalize(dvec3(-0.60, 0.36, 0.72));
    add(Ring{0.5, 0.16}, {.albedo = 0.42, .gloss = 0.06, .roughness = 0.1},
        {0.36, 0.5 * std::sqrt(1 - tilt.y * tilt.y) + 0.16, 0.84}, axes_with_y(tilt));
    add(Ball{0.36}, ebony, {-1.5, 0.36, 0.75});
    add(Ball{0.21}, {.albedo = 0.8, .texture = Texture::woven}, {0.78, 0.21, 1.62},
        axes_with_y(dvec3(0.2, 0.9, -0.38)));

    // A reel of thread with a pin in it.
    const dvec3 reel(-0.45, 0, 1.25);
    add(cylinder(0.30, 0.09, 0.02), ebony, reel);
    add(cylinder(0.24, 0.52, 0.02), {.albedo = 0.75, .texture = Texture::wound_thread},
        reel + dvec3(0, 0.05, 0));
    add(cylinder(0.30, 0.09, 0.02), ebony, reel + dvec3(0, 0.53, 0));
    const dvec3 pin_head = reel + dvec3(0.66, 1.66, -0.35);
    scene.solids.push_back(wire(reel + dvec3(0.1, 0.5, 0), pin_head, 1.3 * hairline));
    add(Ball{0.035}, {.albedo = 0.85, .gloss = 0.04}, pin_head);
    // Its loose end leaves from under the reel.
    scene.thread = winding({-0.45, 1.75}, -0.5 * pi, {{0.26, 1.1 * pi}, {0.85, 0.38 * pi}, {0.16, 1.2 * pi}});
    scene.thread_width = 0.014;

    // A plumb bob.
    const dvec3 bob(-2.0, 2.12, -1.6);
    scene.solids.push_back(wire(bob, bob + dvec3(0, 3, 0), 1.15 * hairline));
    add(cone(0.135, 0.4, 0.01), ebony, bob + dvec3(0, 0.02, 0), axes_with_y(dvec3(0, -1, 0)));

    const dvec3 lamp(-5.4, 5.3, 2.5), facing = -glm::normalize(lamp);
    const dmat3 axes = axes_with_y(facing);
    scene.lamp = {lamp, 1.0 * axes[0], 1.0 * axes[2], facing, 1.0};
    scene.camera = {{0.0, 2.75, 9.5}, {0.0, 1.17, 0.0}, 0.247};
    return scene;
}

}  // namespace dapple::make
