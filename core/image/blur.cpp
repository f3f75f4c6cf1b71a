#include "core/image/blur.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace dapple {

namespace {

constexpr int kPasses = 3;

// A running mean of 2 * radius + 1 values, plus a share of the next one on each side so that any variance can
// be met: (2 r + 1 + 2 share) values of which the outermost two count for `share`.
struct Box {
    int radius;
    double share;
};

Box box_of_variance(double variance) {
    const int radius = static_cast<int>((std::sqrt(12 * variance + 1) - 1) / 2);
    const double r = radius, n = 2 * r + 1;
    // variance = (sum of k^2 for |k| <= r, + 2 share (r+1)^2) / (n + 2 share), solved for the share
    const double inner = r * (r + 1) * n / 3;
    const double share = (variance * n - inner) / (2 * ((r + 1) * (r + 1) - variance));
    return {radius, std::clamp(share, 0.0, 1.0)};
}

void mean_along(const std::vector<float>& from, std::vector<float>& to, Box box) {
    const int n = static_cast<int>(from.size());
    const auto value = [&](int i) { return static_cast<double>(from[std::clamp(i, 0, n - 1)]); };
    double sum = 0;
    for (int k = -box.radius; k <= box.radius; ++k) sum += value(k);
    const double weight = 1 / (2 * box.radius + 1 + 2 * box.share);
    for (int i = 0; i < n; ++i) {
        const double ends = value(i - box.radius - 1) + value(i + box.radius + 1);
        to[i] = static_cast<float>((sum + box.share * ends) * weight);
        sum += value(i + box.radius + 1) - value(i - box.radius);
    }
}

void blur_lines(Grid<float>& grid, int count, int length, std::size_t step, std::size_t line_step, Box box) {
    tbb::parallel_for(tbb::blocked_range<int>(0, count), [&](const tbb::blocked_range<int>& lines) {
        std::vector<float> a(length), b(length);
        for (int line = lines.begin(); line != lines.end(); ++line) {
            float* const start = grid.values.data() + line * line_step;
            for (int i = 0; i < length; ++i) a[i] = start[i * step];
            for (int pass = 0; pass < kPasses; ++pass) {
                mean_along(a, b, box);
                a.swap(b);
            }
            for (int i = 0; i < length; ++i) start[i * step] = a[i];
        }
    });
}

}  // namespace

Grid<float> blurred(Grid<float> grid, double sigma) {
    if (sigma <= 0) return grid;
    const Box box = box_of_variance(sigma * sigma / kPasses);
    const auto row = static_cast<std::size_t>(grid.width);
    blur_lines(grid, grid.height, grid.width, 1, row, box);
    blur_lines(grid, grid.width, grid.height, row, 1, box);
    return grid;
}

}  // namespace dapple
