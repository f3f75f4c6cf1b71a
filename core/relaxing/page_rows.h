#pragma once
// The page in the rows that dots are relaxed in: their height is the unit.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>

#include "core/image/density.h"
#include "core/maths/portable_math.h"

namespace dapple {

struct PageRows {
    int depth;            // a row is 2^-depth page units high, about as dots on black are apart
    float width, height;  // of the page
    float spacing;        // of dots on black, 0.7 to 1.5; up to a million where there are hardly any
    double pixels;        // of the density, a row's height

    PageRows(const Density& density, double scale)
        : depth(depth_for(scale)),
          width(rows(density.width(), density)),
          height(rows(density.height(), density)),
          spacing(
              static_cast<float>(std::min(std::ldexp(1.0, depth) / std::sqrt(kDotsPerScale * scale), kMost))),
          pixels(std::ldexp(static_cast<double>(density.longer_side()), -depth)) {}

    /// On the page, of a place in rows.
    glm::dvec2 place(float x, float y) const {
        const double units = std::ldexp(1.0, -depth);
        return {x * units, y * units};
    }

    static int depth_for(double scale) {
        return std::max(
            0, static_cast<int>(std::lround(portable::log2(kDotsPerScale * std::max(scale, 1e-12)) / 2)));
    }

 private:
    static constexpr double kMost = 1e6;

    float rows(int length, const Density& density) const {
        return static_cast<float>(std::ldexp(length / static_cast<double>(density.longer_side()), depth));
    }
};

/// How a dot is to move, in rows.
struct DotStep {
    float x = 0, y = 0;
};

// Where relaxing ends along a page's edges.

// Relaxed dots lean on where what they share out ends. On the edges themselves, dots would line up along
// them, and in black they would lie half a distance inwards and leave bare paper between the discs. So it
// ends in waves of two lengths that hardly ever meet again, which makes a page look cut out of a larger one:
// farther in, waves would leave bare bites, and farther out draw dots off the page. In black it ends a little
// beyond.
inline constexpr float kBeyondInBlack = 0.2f, kLightest = 0.85f,
                       kBlackest = 0.98f;  // densities, between which both are mixed
inline constexpr float kLeastBeyond = -0.4f, kMostBeyond = 0.35f;
inline constexpr float kWaveLengths[] = {3.7f, 5.9f};
static_assert(kLeastBeyond < kBeyondInBlack && kBeyondInBlack < kMostBeyond);

// Waves, in distances between dots.
struct EdgeWaves {
    float beyond;  // the edge, their middle
    float height;  // of each
};
inline constexpr EdgeWaves kWavesOfCells{0.05f, 0.45f};
// Lower ones keep more of the tone along the edges, and are enough for dots that go down an energy.
inline constexpr EdgeWaves kWavesOfDensity{0.09f, 0.36f};

// A triangle wave, -1..1, of length 1, from 0 up. A sine's last bit would not be the same everywhere.
inline float triangle_wave(float t) {
    return 1 - 4 * std::abs(t - 0.25f - std::floor(t + 0.25f));
}

/// How far beyond the edge, in distances between dots, by where along the edge, in distances from its middle:
/// a picture on its side has the same dots. kLeastBeyond..kMostBeyond.
inline float beyond_edge(EdgeWaves waves, float from_middle, float density) {
    const float t = std::abs(from_middle);
    const float light = std::clamp((kBlackest - density) / (kBlackest - kLightest), 0.0f, 1.0f);
    const float wave = triangle_wave(t / kWaveLengths[0]) + triangle_wave(t / kWaveLengths[1]);
    const float waving = std::clamp(waves.beyond + waves.height * wave, kLeastBeyond, kMostBeyond);
    return kBeyondInBlack + light * (waving - kBeyondInBlack);
}

}  // namespace dapple
