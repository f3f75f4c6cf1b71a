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

}  // namespace dapple
