#include "core/relaxing/blurred_density.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/image/detail.h"

namespace dapple {

namespace {

// In a level's own pixels squared: of the spline through one pixel, and of two halves' mean.
constexpr double kSplineVariance = 0.25, kHalvingVariance = 0.25;
constexpr int kBefore = 1, kAfter = 2;  // pixels around, that are read

// Half as many pixels, the odd one kept, that cover the same length: each the mean of what it covers.
struct Halving {
    std::vector<int> first;
    std::vector<std::array<float, 3>> shares;

    explicit Halving(int length) {
        const int half = (length + 1) / 2;
        const double side = static_cast<double>(length) / half;  // 1 to 2
        for (int i = 0; i < half; ++i) {
            const double begin = i * side, end = begin + side;
            first.push_back(std::min(static_cast<int>(begin), std::max(length - 3, 0)));
            std::array<float, 3>& share = shares.emplace_back();
            for (int k = 0; k < 3; ++k) {
                const double pixel = first.back() + k;
                share[static_cast<std::size_t>(k)] = static_cast<float>(
                    std::max(std::min(end, pixel + 1) - std::max(begin, pixel), 0.0) / side);
            }
        }
    }

    template <class At>
    float mean(std::size_t i, const At& at) const {
        return shares[i][0] * at(first[i]) + shares[i][1] * at(first[i] + 1) +
               shares[i][2] * at(first[i] + 2);
    }
};

Grid<float> halved(const Grid<float>& grid) {
    const Halving across(grid.width), down(grid.height);
    Grid<float> half(static_cast<int>(across.first.size()), static_cast<int>(down.first.size()));
    std::vector<float> line(static_cast<std::size_t>(grid.width));
    for (int y = 0; y < half.height; ++y) {
        for (int x = 0; x < grid.width; ++x)
            line[static_cast<std::size_t>(x)] = down.mean(static_cast<std::size_t>(y), [&](int row) {
                return grid.row(std::min(row, grid.height - 1))[x];
            });
        for (int x = 0; x < half.width; ++x)
            half.at(x, y) = across.mean(static_cast<std::size_t>(x), [&](int column) {
                return line[static_cast<std::size_t>(std::min(column, grid.width - 1))];
            });
    }
    return half;
}

// The pixel that stands at place i where the picture and its mirror images follow one another.
int mirrored(int i, int length) {
    const int period = 2 * length, in = ((i % period) + period) % period;
    return std::min(in, period - 1 - in);
}

Grid<float> with_pixels_around(const Grid<float>& grid, int before, int after) {
    Grid<float> wider(grid.width + before + after, grid.height + before + after);
    for (int y = 0; y < wider.height; ++y) {
        const float* const from = grid.row(mirrored(y - before, grid.height));
        float* const to = wider.row(y);
        std::copy_n(from, grid.width, to + before);
        for (int x = 0; x < before; ++x) to[x] = from[mirrored(x - before, grid.width)];
        for (int x = before + grid.width; x < wider.width; ++x)
            to[x] = from[mirrored(x - before, grid.width)];
    }
    return wider;
}

Grid<float> blurred_in_mirrors(Grid<float> grid, double sigma) {
    const int around = static_cast<int>(4 * sigma) + 1;
    const Grid<float> wide = blurred(with_pixels_around(grid, around, around), sigma);
    for (int y = 0; y < grid.height; ++y) std::copy_n(wide.row(y + around) + around, grid.width, grid.row(y));
    return grid;
}

// A quadratic spline's weights of the three nearest pixels, and how they change.
struct Weights {
    int first;  // of the wider grid
    float value[3], slope[3];

    explicit Weights(double position) {
        const int nearest = static_cast<int>(position);
        const float t = static_cast<float>(position - nearest) - 0.5f;
        first = nearest - 1 + kBefore;
        const float before = 0.5f - t, after = 0.5f + t;
        value[0] = 0.5f * before * before;
        value[1] = 0.75f - t * t;
        value[2] = 0.5f * after * after;
        slope[0] = -before;
        slope[1] = -2 * t;
        slope[2] = after;
    }
};

float weighed(const float (&weights)[3], float a, float b, float c) {
    return weights[0] * a + weights[1] * b + weights[2] * c;
}

}  // namespace

BlurredDensity::BlurredDensity(Grid<float> grid, double least_variance, double most_variance,
                               const BlurQuality& quality) {
    double ratio = 2;
    for (int i = 1; i < quality.octave; i *= 2) ratio = std::sqrt(ratio);
    ratio_ = static_cast<float>(ratio);
    const double width = grid.width, height = grid.height;
    double variance = kSplineVariance, side = 1;  // of the level to come
    while (2 * variance <= least_variance) variance *= 2;
    first_variance_ = static_cast<float>(variance);
    double held = 0;  // by the grid, without the spline's
    while (true) {
        while (std::sqrt(variance) / side > quality.most_pixels) {
            grid = halved(grid);
            held += kHalvingVariance * side * side;
            side *= 2;
        }
        const double lacks = variance - kSplineVariance * side * side - held;
        if (lacks > 1e-9) grid = blurred_in_mirrors(std::move(grid), std::sqrt(lacks) / side);
        held += lacks;
        levels_.push_back(
            {with_pixels_around(grid, kBefore, kAfter), grid.width / width, grid.height / height});
        if (variance >= most_variance) return;
        variance *= ratio;
    }
}

BlurredDensity::Slope BlurredDensity::on(const Level& level, double x, double y) {
    const Weights across(x * level.across), down(y * level.down);
    float value[3], slope[3];
    for (int i = 0; i < 3; ++i) {
        const float* const row = level.values.row(down.first + i) + across.first;
        value[i] = weighed(across.value, row[0], row[1], row[2]);
        slope[i] = weighed(across.slope, row[0], row[1], row[2]);
    }
    return {weighed(down.value, value[0], value[1], value[2]),
            weighed(down.value, slope[0], slope[1], slope[2]) * static_cast<float>(level.across),
            weighed(down.slope, value[0], value[1], value[2]) * static_cast<float>(level.down)};
}

BlurredDensity::Slope BlurredDensity::at(double x, double y, float variance) const {
    float over = variance / first_variance_;
    std::size_t level = 0;
    for (; over >= ratio_ && level + 2 < levels_.size(); ++level) over /= ratio_;
    const Slope narrow = on(levels_[level], x, y);
    const float share = std::clamp((over - 1) / (ratio_ - 1), 0.0f, 1.0f);
    if (share == 0 || level + 1 == levels_.size()) return narrow;
    const Slope wide = on(levels_[level + 1], x, y);
    return {narrow.value + share * (wide.value - narrow.value), narrow.x + share * (wide.x - narrow.x),
            narrow.y + share * (wide.y - narrow.y)};
}

float BlurredDensity::sharpest(double x, double y) const {
    return on(levels_.front(), x, y).value;
}

}  // namespace dapple
