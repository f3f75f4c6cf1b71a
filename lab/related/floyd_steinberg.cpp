#include "lab/related/floyd_steinberg.h"

#include <algorithm>
#include <cmath>

namespace dapple {

Grid<std::uint8_t> error_diffused(Grid<float> values) {
    Grid<std::uint8_t> result(values.width, values.height);
    for (int y = 0; y < values.height; ++y) {
        for (int x = 0; x < values.width; ++x) {
            const float value = values.at(x, y);
            const bool dot = value > 0.5f;
            result.at(x, y) = dot;
            const float error = (value - (dot ? 1.0f : 0.0f)) / 16;
            const bool right = x + 1 < values.width, below = y + 1 < values.height;
            if (right) values.at(x + 1, y) += 7 * error;
            if (below && x > 0) values.at(x - 1, y + 1) += 3 * error;
            if (below) values.at(x, y + 1) += 5 * error;
            if (below && right) values.at(x + 1, y + 1) += error;
        }
    }
    return result;
}

PlainDots floyd_steinberg(const DotsWanted& wanted) {
    const glm::dvec2 page = page_of(wanted);
    // Dots per page unit squared where the density is 1, and the side of a pixel.
    const double full = double(wanted.count) / (wanted.density ? wanted.density->mean() : 1.0);
    const double side = 1 / std::sqrt(kPixelsPerBlackDot * full);
    const int columns = std::max(1, int(std::lround(page.x / side)));
    const int rows = std::max(1, int(std::lround(page.y / side)));
    const glm::dvec2 pixel{page.x / columns, page.y / rows};
    Grid<float> values(columns, rows);
    for (int y = 0; y < rows; ++y) {
        if (wanted.stop.stop_requested()) return {};
        for (int x = 0; x < columns; ++x) {
            const glm::dvec2 middle{(x + 0.5) * pixel.x, (y + 0.5) * pixel.y};
            const double density = wanted.density ? wanted.density->at(middle) : 1.0;
            values.at(x, y) = float(density * full * pixel.x * pixel.y);
        }
    }
    const Grid<std::uint8_t> set = error_diffused(std::move(values));
    PlainDots dots;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x)
            if (set.at(x, y) != 0) dots.emplace_back((x + 0.5) * pixel.x, (y + 0.5) * pixel.y);
    return dots;
}

}  // namespace dapple
