#include "core/image/blur.h"

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

// Lines side by side, value by value: line l has its i-th value at i * Lanes + l.
template <int Lanes>
void mean_along(const std::vector<float>& from, std::vector<float>& to, int length, Box box) {
    const auto values = [&](int i) { return from.data() + std::clamp(i, 0, length - 1) * Lanes; };
    double sum[Lanes] = {};
    for (int k = -box.radius; k <= box.radius; ++k)
        for (int l = 0; l < Lanes; ++l) sum[l] += static_cast<double>(values(k)[l]);
    const double weight = 1 / (2 * box.radius + 1 + 2 * box.share);
    for (int i = 0; i < length; ++i) {
        const float *before = values(i - box.radius - 1), *first = values(i - box.radius),
                    *next = values(i + box.radius + 1);
        float* const mean = to.data() + i * Lanes;
        for (int l = 0; l < Lanes; ++l) {
            const double ends = static_cast<double>(before[l]) + static_cast<double>(next[l]);
            mean[l] = static_cast<float>((sum[l] + box.share * ends) * weight);
            sum[l] += static_cast<double>(next[l]) - static_cast<double>(first[l]);
        }
    }
}

// Lines from `first` on: values a step apart, lines a line's step.
template <int Lanes>
void blur_lines(float* first, int length, std::size_t step, std::size_t line_step, Box box) {
    const auto size = static_cast<std::size_t>(length) * Lanes;
    std::vector<float> a(size), b(size);
    for (int i = 0; i < length; ++i)
        for (int l = 0; l < Lanes; ++l) a[i * Lanes + l] = first[i * step + l * line_step];
    for (int pass = 0; pass < kPasses; ++pass) {
        mean_along<Lanes>(a, b, length, box);
        a.swap(b);
    }
    for (int i = 0; i < length; ++i)
        for (int l = 0; l < Lanes; ++l) first[i * step + l * line_step] = a[i * Lanes + l];
}

// As many lines at once as fill a cache line, which columns have in common.
void blur_all(Grid<float>& grid, int count, int length, std::size_t step, std::size_t line_step, Box box) {
    constexpr int kLanes = 16;
    tbb::parallel_for(0, (count + kLanes - 1) / kLanes, [&](int group) {
        const int begin = group * kLanes, end = std::min(begin + kLanes, count);
        float* const first = grid.values.data() + begin * line_step;
        if (end - begin == kLanes) {
            blur_lines<kLanes>(first, length, step, line_step, box);
        } else {
            for (int line = 0; line < end - begin; ++line)
                blur_lines<1>(first + line * line_step, length, step, line_step, box);
        }
    });
}

}  // namespace

Grid<float> blurred(Grid<float> grid, double sigma) {
    if (sigma <= 0) return grid;
    const Box box = box_of_variance(sigma * sigma / kPasses);
    const auto row = static_cast<std::size_t>(grid.width);
    blur_all(grid, grid.height, grid.width, 1, row, box);
    blur_all(grid, grid.width, grid.height, row, 1, box);
    return grid;
}

}  // namespace dapple
