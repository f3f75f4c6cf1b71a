#include "assets/make/icon.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

namespace dapple::make {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double pi = std::numbers::pi;
constexpr double ball = 0.96;  // radius; the picture is [-1, 1]^2, y down

// How dark the ball is at p: lit from the upper left, a little light back at the lower right rim.
double darkness(const dvec2& p) {
    const dvec2 q = p / ball;
    const dvec3 normal(q, std::sqrt(std::max(0.0, 1 - glm::dot(q, q))));
    const double lit = std::max(0.0, glm::dot(normal, glm::normalize(dvec3(-0.55, -0.62, 0.56))));
    return std::clamp(0.9 - 1.0 * lit, 0.07, 0.7);
}

// Dots that each stand for the same amount of dark: every dot moves again and again to the middle of the part
// of the ball that is nearest to it. The middle is weighed by the square of the darkness, which in the plane
// makes the number of dots follow the darkness itself.
std::vector<dvec2> stipple(int count, double edge) {
    constexpr int grid = 128, rounds = 120;
    std::vector<dvec2> dots;
    for (int i = 0; i < count; ++i) {
        // A sunflower: even to begin with.
        const double radius = edge * std::sqrt((i + 0.5) / count), angle = i * pi * (3 - std::sqrt(5.0));
        dots.push_back(radius * dvec2(std::cos(angle), std::sin(angle)));
    }
    for (int round = 0; round < rounds; ++round) {
        std::vector<dvec3> sums(count, dvec3(0));
        for (int i = 0; i < grid * grid; ++i) {
            const dvec2 at = (dvec2(i % grid, i / grid) + 0.5) * (2.0 / grid) - 1.0;
            if (glm::length(at) > edge) continue;
            const auto near =
                std::ranges::min_element(dots, {}, [&](dvec2 d) { return glm::dot(d - at, d - at); });
            const double dark = darkness(at);
            sums[near - dots.begin()] += dark * dark * dvec3(at, 1);
        }
        for (int i = 0; i < count; ++i) dots[i] = dvec2(sums[i]) / sums[i].z;
    }
    return dots;
}

}  // namespace

std::vector<std::uint8_t> icon(int size) {
    const dvec3 paper(250, 247, 240), ink(28, 30, 38);
    const int count = size <= 16 ? 9 : size <= 32 ? 25 : 60;
    const double dot = (size <= 16 ? 1.1 : size <= 32 ? 1.55 : 2.3) * 2 / size;
    const double rim = std::max(1.0, size / 40.0) * 2 / size;
    const std::vector<dvec2> dots = stipple(count, ball - rim);

    std::vector<std::uint8_t> pixels;
    constexpr int fine = 8;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            dvec3 colour(0);
            int covered = 0;
            for (int i = 0; i < fine * fine; ++i) {
                const dvec2 sub = (dvec2(i % fine, i / fine) + 0.5) / double(fine);
                const dvec2 p = (dvec2(x, y) + sub) * (2.0 / size) - 1.0;
                const double from_centre = glm::length(p);
                if (from_centre > ball) continue;
                ++covered;
                const bool inked =
                    from_centre > ball - rim ||
                    std::any_of(dots.begin(), dots.end(), [&](dvec2 d) { return glm::length(p - d) < dot; });
                colour += inked ? ink : paper;
            }
            if (covered) colour /= covered;
            for (int c = 0; c < 3; ++c) pixels.push_back(static_cast<std::uint8_t>(std::lround(colour[c])));
            pixels.push_back(static_cast<std::uint8_t>(std::lround(255.0 * covered / (fine * fine))));
        }
    }
    return pixels;
}

}  // namespace dapple::make
