#include "core/lines/line_field.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/image/blur.h"
#include "core/image/tone.h"

namespace dapple {

namespace {

constexpr float kRoot2Pi = 2.5066283f;

// In sigmas: how far the flow is smoothed, and over how much coherence and surroundings are taken.
constexpr float kFlowReach = 2.5f, kCoherenceReach = 4, kSurroundingReach = 9;
constexpr float kEvenShare = 0.88f;  // so that neither an edge nor a line has two maxima
constexpr float kInhibition = 1.5f;  // how often the surroundings' contrast is taken off
constexpr float kNoise = 0.012f;     // contrast that has no direction of its own
constexpr float kIncoherent = 0.15f, kCoherent = 0.5f;

float smooth_step(float from, float to, float x) {
    const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

// sRGB's curve at equal steps of the square root, along which it is nearly straight.
float quickly_encoded(float light) {
    static const auto values = [] {
        std::array<float, 1026> table{};
        for (std::size_t i = 0; i < table.size(); ++i) {
            const float root = std::min(static_cast<float>(i) / 1024, 1.0f);
            table[i] = linear_to_srgb(root * root);
        }
        return table;
    }();
    const float at = std::sqrt(light > 0 ? std::min(light, 1.0f) : 0.0f) * 1024;
    const auto i = static_cast<std::size_t>(at);
    return values[i] + (values[i + 1] - values[i]) * (at - static_cast<float>(i));
}

// Means over blocks of pixels, those at the right and lower edge maybe smaller. `fill` has a row's values.
template <class Fill>
Grid<float> block_means(int width, int height, int side, Fill fill) {
    Grid<float> means((width + side - 1) / side, (height + side - 1) / side);
    tbb::parallel_for(0, means.height, [&](int row) {
        std::vector<float> values(static_cast<std::size_t>(width));
        float* const sums = means.row(row);
        const int top = row * side, bottom = std::min(top + side, height);
        for (int y = top; y < bottom; ++y) {
            fill(y, values.data());
            for (int column = 0, x = 0; x < width; ++column)
                for (const int right = std::min(x + side, width); x < right; ++x) sums[column] += values[x];
        }
        for (int column = 0; column < means.width; ++column)
            sums[column] /=
                static_cast<float>((std::min((column + 1) * side, width) - column * side) * (bottom - top));
    });
    return means;
}

Grid<float> block_means(const Grid<float>& grid, int side) {
    return block_means(grid.width, grid.height, side,
                       [&](int y, float* values) { std::copy_n(grid.row(y), grid.width, values); });
}

// Calls `at(x, left, right)` for the pixels of a row, with its neighbours, those of the outermost themselves.
template <class At>
void along_row(int width, At at) {
    at(0, 0, std::min(1, width - 1));
    for (int x = 1; x < width - 1; ++x) at(x, x - 1, x + 1);
    if (width > 1) at(width - 1, width - 2, width - 1);
}

// A row and its neighbours.
struct ThreeRows {
    const float *upper, *here, *lower;
    ThreeRows(const Grid<float>& grid, int y)
        : upper(grid.row(std::max(y - 1, 0))),
          here(grid.row(y)),
          lower(grid.row(std::min(y + 1, grid.height - 1))) {}
};

// The row of a picture between the rows of means over blocks.
std::vector<float> row_of(const Grid<float>& means, int side, int y, int width) {
    std::vector<float> row(static_cast<std::size_t>(width));
    const auto in_blocks = [side](int pixel) {
        return (static_cast<float>(pixel) + 0.5f) / static_cast<float>(side) - 0.5f;
    };
    const float at = std::clamp(in_blocks(y), 0.0f, static_cast<float>(means.height - 1));
    const float *const upper = means.row(static_cast<int>(at)), *const lower = means.row(
                                                                    std::min(static_cast<int>(at) + 1,
                                                                             means.height - 1));
    std::vector<float> mixed(static_cast<std::size_t>(means.width));
    const float share = at - std::floor(at);
    for (int i = 0; i < means.width; ++i) mixed[i] = upper[i] + (lower[i] - upper[i]) * share;
    for (int x = 0; x < width; ++x) {
        const float place = std::clamp(in_blocks(x), 0.0f, static_cast<float>(means.width - 1));
        const int i = static_cast<int>(place);
        row[x] =
            mixed[i] + (mixed[std::min(i + 1, means.width - 1)] - mixed[i]) * (place - static_cast<float>(i));
    }
    return row;
}

// Half the angle of a vector.
glm::vec2 halved_angle(float x, float y) {
    const float length = std::sqrt(x * x + y * y);
    if (!(length > 0)) return {1, 0};
    const float cosine = std::sqrt(std::max(0.5f * (1 + x / length), 0.0f));
    const float sine = std::sqrt(std::max(0.5f * (1 - x / length), 0.0f));
    return {cosine, y < 0 ? -sine : sine};
}

}  // namespace

Grid<float> encoded_lightness(const Grid<float>& light, int longest) {
    const int side = std::max(1, (std::max(light.width, light.height) + longest - 1) / longest);
    Grid<float> encoded = block_means(light.width, light.height, side, [&](int y, float* values) {
        const float* const row = light.row(y);
        for (int x = 0; x < light.width; ++x) values[x] = row[x] > 0 ? std::min(row[x], 1.0f) : 0.0f;
    });
    for (float& v : encoded.values) v = quickly_encoded(v);
    return encoded;
}

Grid<float> halved(const Grid<float>& picture) {
    return block_means(picture, 2);
}

float value_at(const Grid<float>& grid, glm::vec2 place) {
    const float x = std::clamp(place.x, 0.0f, static_cast<float>(grid.width - 1));
    const float y = std::clamp(place.y, 0.0f, static_cast<float>(grid.height - 1));
    const int left = static_cast<int>(x), top = static_cast<int>(y);
    const int right = std::min(left + 1, grid.width - 1);
    const float *const upper = grid.row(top), *const lower = grid.row(std::min(top + 1, grid.height - 1));
    const float u = x - static_cast<float>(left), v = y - static_cast<float>(top);
    const float above = upper[left] + (upper[right] - upper[left]) * u;
    const float below = lower[left] + (lower[right] - lower[left]) * u;
    return above + (below - above) * v;
}

LineField::LineField(const Grid<float>& encoded, float sigma)
    : block_(std::max(1, static_cast<int>(sigma))),
      contrast_(encoded.width, encoded.height),
      phase_(encoded.width, encoded.height) {
    const int width = encoded.width, height = encoded.height;
    const Grid<float> smooth = blurred(encoded, static_cast<double>(sigma));

    const auto wide = [&](Grid<float> blocks, float sigmas) {
        return blurred(std::move(blocks), static_cast<double>(sigmas * sigma) / block_);
    };
    // The structure tensor: the doubled angle's two parts, and the trace.
    const auto part_of_tensor = [&](float reach, auto part) {
        const auto fill = [&](int y, float* values) {
            const ThreeRows rows(smooth, y);
            along_row(width, [&](int x, int left, int right) {
                values[x] = part(rows.here[right] - rows.here[left], rows.lower[x] - rows.upper[x]);
            });
        };
        return wide(block_means(width, height, block_, fill), reach);
    };
    cosine_ = part_of_tensor(kFlowReach, [](float dx, float dy) { return dx * dx - dy * dy; });
    sine_ = part_of_tensor(kFlowReach, [](float dx, float dy) { return 2 * dx * dy; });
    coherence_ = part_of_tensor(kCoherenceReach, [](float dx, float dy) { return dx * dx + dy * dy; });
    const float wider = std::sqrt(kCoherenceReach * kCoherenceReach - kFlowReach * kFlowReach);
    const Grid<float> wide_cosine = wide(cosine_, wider), wide_sine = wide(sine_, wider);
    const float noise = 2 * kNoise / (kRoot2Pi * sigma);
    for (std::size_t i = 0; i < coherence_.values.size(); ++i) {
        const float c = wide_cosine.values[i], s = wide_sine.values[i];
        coherence_.values[i] =
            std::sqrt(c * c + s * s) / (std::max(coherence_.values[i], 0.0f) + noise * noise);
        // Of length 1, but where there is nothing.
        const float length =
            std::sqrt(cosine_.values[i] * cosine_.values[i] + sine_.values[i] * sine_.values[i]);
        cosine_.values[i] /= length + 1e-12f;
        sine_.values[i] /= length + 1e-12f;
    }

    // A difference of neighbours is a Gaussian's derivative on a box of two pixels, which widens it.
    const float odd_gain = kRoot2Pi * std::sqrt(sigma * sigma + 1 / 3.0f);
    const float even_gain = kRoot2Pi * kEvenShare * (sigma * sigma + 1 / 3.0f);
    tbb::parallel_for(0, height, [&](int y) {
        const ThreeRows rows(smooth, y);
        float *const contrast = contrast_.row(y), *const phase = phase_.row(y);
        const std::vector<float> cosines = row_of(cosine_, block_, y, width),
                                 sines = row_of(sine_, block_, y, width);
        along_row(width, [&](int x, int left, int right) {
            const float *const up = rows.upper, *const here = rows.here, *const down = rows.lower;
            const float dx = 0.5f * (here[right] - here[left]), dy = 0.5f * (down[x] - up[x]);
            const float dxx = here[left] - 2 * here[x] + here[right], dyy = up[x] - 2 * here[x] + down[x];
            const float dxy = 0.25f * (down[right] - down[left] - up[right] + up[left]);
            // Along the normal, whose squares and product are the doubled angle's cosine and sine.
            const float c = cosines[x], s = sines[x];
            const float odd = dx * dx + dy * dy + c * (dx * dx - dy * dy) + 2 * s * dx * dy;
            const float even = even_gain * 0.5f * (dxx + dyy + c * (dxx - dyy) + 2 * s * dxy);
            contrast[x] = std::sqrt(std::max(odd_gain * odd_gain * 0.5f * odd, 0.0f) + even * even);
            phase[x] = even / (contrast[x] + 1e-6f);
        });
    });
    surrounding_ = wide(block_means(contrast_, block_), kSurroundingReach);
}

glm::vec2 LineField::in_blocks(glm::vec2 place) const {
    const auto side = static_cast<float>(block_);
    return {(place.x + 0.5f) / side - 0.5f, (place.y + 0.5f) / side - 0.5f};
}

glm::vec2 LineField::normal_at(glm::vec2 place) const {
    const glm::vec2 at = in_blocks(place);
    return halved_angle(value_at(cosine_, at), value_at(sine_, at));
}

float LineField::salience_at(glm::vec2 place) const {
    const glm::vec2 at = in_blocks(place);
    const float left_over = contrast_at(place) - kInhibition * value_at(surrounding_, at);
    if (!(left_over > 0)) return 0;
    return left_over * smooth_step(kIncoherent, kCoherent, value_at(coherence_, at));
}

std::vector<LineField::Seed> LineField::seeds(float least_salience) const {
    std::vector<std::vector<Seed>> rows(static_cast<std::size_t>(contrast_.height));
    tbb::parallel_for(0, contrast_.height, [&](int y) {
        const ThreeRows near(contrast_, y);
        along_row(contrast_.width, [&](int x, int left, int right) {
            const float here = near.here[x];
            const bool most_across = near.here[left] < here && near.here[right] <= here;
            const bool most_down = near.upper[x] < here && near.lower[x] <= here;
            if (here < least_salience || !(most_across || most_down) || !inside({x, y})) return;
            const glm::vec2 place(x, y), normal = normal_at(place);
            if (contrast_at(place - normal) > here || contrast_at(place + normal) > here) return;
            const float salience = salience_at(place);
            if (salience >= least_salience) rows[static_cast<std::size_t>(y)].push_back({salience, x, y});
        });
    });
    std::vector<Seed> all;
    for (const std::vector<Seed>& row : rows) all.insert(all.end(), row.begin(), row.end());
    std::ranges::stable_sort(all, [](const Seed& a, const Seed& b) { return a.salience > b.salience; });
    return all;
}

}  // namespace dapple
