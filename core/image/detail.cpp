#include "core/image/detail.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "core/image/tone.h"
#include "core/maths/portable_math.h"

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

constexpr float kGain = 1.5f, kEdge = 0.1f, kMost = 0.15f;

// sRGB's curve and its inverse, straight between points so close that it makes no difference: the curve
// itself takes longer than all the rest.
class SrgbTables {
 public:
    SrgbTables() : encoded_(kSteps + 2), light_(kSteps + 2) {
        for (int i = 0; i < kSteps + 2; ++i) {
            const float value = static_cast<float>(i) / kSteps;
            encoded_[static_cast<std::size_t>(i)] = linear_to_srgb(value);
            light_[static_cast<std::size_t>(i)] = srgb_to_linear(value);
        }
        encoded_[kSteps] = light_[kSteps] = 1;  // white stays white, to the bit
    }

    // Both take 0..1.
    float encoded(float light) const { return between(encoded_, light); }
    float light(float encoded) const { return between(light_, encoded); }

 private:
    static constexpr int kSteps = 1 << 14;

    static float between(const std::vector<float>& values, float at) {
        const float scaled = at * kSteps;
        const auto step = static_cast<std::size_t>(scaled);
        return values[step] + (values[step + 1] - values[step]) * (scaled - static_cast<float>(step));
    }

    std::vector<float> encoded_, light_;
};

// A wide Gaussian's means, worked out on a picture with fewer pixels: between them they hardly change.
class WideMean {
 public:
    template <class Value>
    WideMean(const Grid<float>& picture, double sigma_px, Value value)
        : side_(std::max(1, static_cast<int>(sigma_px / kPixelsPerSigma))),
          means_((picture.width + side_ - 1) / side_, (picture.height + side_ - 1) / side_) {
        tbb::parallel_for(0, means_.height, [&](int y) {
            for (int x = 0; x < means_.width; ++x) means_.at(x, y) = mean_of_block(picture, x, y, value);
        });
        means_ = widened(blurred(std::move(means_), sigma_px / side_), picture.width);
    }

    // The means at the pixels of a row of the picture.
    void row(int y, std::vector<float>& values) const {
        const auto [above, below, share] = neighbours(y, means_.height);
        const float *const upper = means_.row(above), *const lower = means_.row(below);
        for (std::size_t x = 0; x < values.size(); ++x) values[x] = mixed(upper[x], lower[x], share);
    }

 private:
    static constexpr double kPixelsPerSigma = 3;

    struct Neighbours {
        int first, second;
        float share;
    };

    template <class Value>
    float mean_of_block(const Grid<float>& picture, int block_x, int block_y, Value value) const {
        const int left = block_x * side_, right = std::min(left + side_, picture.width);
        const int top = block_y * side_, bottom = std::min(top + side_, picture.height);
        float sum = 0;
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) sum += value(picture.at(x, y));
        return sum / static_cast<float>((right - left) * (bottom - top));
    }

    // Rows of blocks as long as the picture's: each is read for all rows of its pixels.
    Grid<float> widened(const Grid<float>& blocks, int width) const {
        Grid<float> wide(width, blocks.height);
        std::vector<Neighbours> columns;
        for (int x = 0; x < width; ++x) columns.push_back(neighbours(x, blocks.width));
        tbb::parallel_for(0, blocks.height, [&](int y) {
            const float* const from = blocks.row(y);
            float* to = wide.row(y);
            for (const auto& [left, right, share] : columns) *to++ = mixed(from[left], from[right], share);
        });
        return wide;
    }

    // The blocks whose middles lie before and behind a pixel's.
    Neighbours neighbours(int pixel, int blocks) const {
        const float at = (static_cast<float>(pixel) + 0.5f) / static_cast<float>(side_) - 0.5f;
        const int first = at < 0 ? 0 : static_cast<int>(at);
        return {first, std::min(first + 1, blocks - 1), std::max(at - static_cast<float>(first), 0.0f)};
    }

    static float mixed(float a, float b, float share) { return a + (b - a) * share; }

    int side_;           // of a block that becomes one pixel
    Grid<float> means_;  // a row for each row of blocks
};

float limited(float change) {
    return change / (1 + std::abs(change) / kMost);
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

Refinement::Refinement(const Mask& mask, const Framing& framing, glm::ivec2 picture) {
    if (!mask.has_finer()) return;
    mask_ = mask;
    const Grid<std::uint8_t>& fineness = mask.fineness();
    const glm::dvec2 share(double(fineness.width) / picture.x, double(fineness.height) / picture.y);
    const double unit = std::max(framing.size().x, framing.size().y);
    const auto in_mask = [&](glm::dvec2 framed) { return opened_pixel(framing, framed) * share; };
    corner_ = in_mask({0, 0});
    across_ = in_mask({unit, 0}) - corner_;
    down_ = in_mask({0, unit}) - corner_;
    const auto [least, most] = std::ranges::minmax(fineness.values);
    least_times_ = times_finer(least);
    most_times_ = times_finer(most);
}

double detail_sigma(double pixels, double dots) {
    const double sigma = 4 * std::sqrt(pixels / std::max(dots, 1.0));
    return portable::exp2(std::round(2 * portable::log2(sigma)) / 2);
}

Grid<float> with_detail(Grid<float> light, double amount, double sigma_px) {
    if (amount == 0 || light.empty()) return light;
    static const SrgbTables srgb;
    tbb::parallel_for(0, light.height, [&](int y) {
        for (float& v : std::span(light.row(y), static_cast<std::size_t>(light.width)))
            v = srgb.encoded(v < 1 ? (v > 0 ? v : 0.0f) : 1.0f);  // in this order NaN becomes white
    });
    const WideMean mean(light, sigma_px, [](float v) { return v; });
    const WideMean mean_square(light, sigma_px, [](float v) { return v * v; });
    const auto strength = static_cast<float>(amount);
    tbb::parallel_for(0, light.height, [&](int y) {
        float* const row = light.row(y);
        std::vector<float> means(static_cast<std::size_t>(light.width)), squares(means.size());
        mean.row(y, means);
        mean_square.row(y, squares);
        // No step is a branch, so that they are taken for several pixels at once.
        for (std::size_t x = 0; x < means.size(); ++x) {
            const float variance = squares[x] - means[x] * means[x];
            const float spread = 0.5f * (variance + std::abs(variance));  // 0 where rounding made it less
            const float change = kGain * (row[x] - means[x]) * (kEdge * kEdge / (spread + kEdge * kEdge));
            row[x] += strength * limited(change);
        }
        for (std::size_t x = 0; x < means.size(); ++x) row[x] = srgb.light(std::clamp(row[x], 0.0f, 1.0f));
    });
    return light;
}

}  // namespace dapple
