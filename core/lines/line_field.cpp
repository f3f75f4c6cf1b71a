#include "core/lines/line_field.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/image/detail.h"
#include "core/image/tone.h"

namespace dapple {

namespace {

// In sigmas: how far the flow is smoothed, and over how much coherence and surroundings are taken.
constexpr float kFlowReach = 2.5f, kCoherenceReach = 4, kSurroundingReach = 9;
constexpr float kEvenShare = 0.88f;  // so that neither an edge nor a line has two maxima
constexpr float kInhibition = 1.5f;  // how often the surroundings' contrast is taken off
constexpr float kNoise = 0.012f;     // contrast that has no direction of its own
constexpr float kIncoherent = 0.15f, kCoherent = 0.5f;

// Means over blocks of pixels, those at the right and lower edge maybe smaller. `row(y, space)` is a row, and
// may be in that space.
template <class Row>
Grid<float> block_means(glm::ivec2 size, int side, Row row) {
    Grid<float> means((size.x + side - 1) / side, (size.y + side - 1) / side);
    tbb::parallel_for(0, means.height, [&](int block_row) {
        std::vector<float> space(static_cast<std::size_t>(size.x));
        float* const sums = means.row(block_row);
        const int top = block_row * side, bottom = std::min(top + side, size.y);
        for (int y = top; y < bottom; ++y) {
            const float* const values = row(y, space.data());
            for (int column = 0, x = 0; x < size.x; ++column)
                for (const int right = std::min(x + side, size.x); x < right; ++x) sums[column] += values[x];
        }
        for (int column = 0; column < means.width; ++column)
            sums[column] /= static_cast<float>(std::min(side, size.x - column * side) * (bottom - top));
    });
    return means;
}

Grid<float> block_means(const Grid<float>& grid, int side) {
    return block_means({grid.width, grid.height}, side, [&](int y, float*) { return grid.row(y); });
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
    ThreeRows(const Grid<float>& grid, int y)
        : up(grid.row(std::max(y - 1, 0))),
          here(grid.row(y)),
          down(grid.row(std::min(y + 1, grid.height - 1))) {}
    const float *up, *here, *down;
};

}  // namespace

Grid<float> reduced(const Grid<float>& picture) {
    return block_means(picture, reduction(picture));
}

Grid<float> encoded_lightness(const Grid<float>& light) {
    Grid<float> encoded = reduced(light);
    for (float& v : encoded.values) v = static_cast<float>(srgb_byte(v)) / 255;
    return encoded;
}

Grid<float> halved(const Grid<float>& picture) {
    return block_means(picture, 2);
}

float value_at(const Grid<float>& grid, glm::vec2 place) {
    const float x = std::clamp(place.x, 0.0f, static_cast<float>(grid.width - 1));
    const float y = std::clamp(place.y, 0.0f, static_cast<float>(grid.height - 1));
    const int left = static_cast<int>(x), top = static_cast<int>(y),
              right = std::min(left + 1, grid.width - 1);
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
    const Grid<float> smooth = blurred(encoded, static_cast<double>(sigma));
    const auto wide = [&](Grid<float> blocks, float sigmas) {
        return blurred(std::move(blocks), static_cast<double>(sigmas * sigma) / block_);
    };
    // The structure tensor: the doubled angle's two parts, and the trace.
    const auto part_of_tensor = [&](float reach, auto part) {
        return wide(block_means(size(), block_,
                                [&](int y, float* space) {
                                    const ThreeRows rows(smooth, y);
                                    along_row(smooth.width, [&](int x, int left, int right) {
                                        space[x] = part(rows.here[right] - rows.here[left],
                                                        rows.down[x] - rows.up[x]);
                                    });
                                    return space;
                                }),
                    reach);
    };
    cosine_ = part_of_tensor(kFlowReach, [](float dx, float dy) { return dx * dx - dy * dy; });
    sine_ = part_of_tensor(kFlowReach, [](float dx, float dy) { return 2 * dx * dy; });
    coherence_ = part_of_tensor(kCoherenceReach, [](float dx, float dy) { return dx * dx + dy * dy; });
    const float wider = std::sqrt(kCoherenceReach * kCoherenceReach - kFlowReach * kFlowReach);
    const Grid<float> wide_cosine = wide(cosine_, wider), wide_sine = wide(sine_, wider);
    const float noise = kNoise / sigma;
    const auto length = [](float x, float y) { return std::sqrt(x * x + y * y); };
    for (std::size_t i = 0; i < coherence_.values.size(); ++i) {
        const float trace = std::max(coherence_.values[i], 0.0f) + noise * noise;
        coherence_.values[i] = length(wide_cosine.values[i], wide_sine.values[i]) / trace;
        const float one = length(cosine_.values[i], sine_.values[i]) + 1e-12f;  // 0 where there is nothing
        cosine_.values[i] /= one;
        sine_.values[i] /= one;
    }

    // So that an edge's contrast is what comes out. A difference of neighbours is a Gaussian's derivative on
    // a box of two pixels, which widens it.
    constexpr float kRoot2Pi = 2.5066283f;
    const float variance = sigma * sigma + 1 / 3.0f;
    const float odd_gain = kRoot2Pi * kRoot2Pi * variance / 8,
                even_gain = kRoot2Pi * kEvenShare * variance / 2;
    tbb::parallel_for(0, smooth.height, [&](int y) {
        // The flow, between its blocks: along this row first, as the rest takes no time then.
        std::vector<float> cosines(static_cast<std::size_t>(cosine_.width)), sines(cosines.size());
        for (int i = 0; i < cosine_.width; ++i) {
            const glm::vec2 at(i, in_blocks({0, y}).y);
            cosines[i] = value_at(cosine_, at);
            sines[i] = value_at(sine_, at);
        }
        const ThreeRows rows(smooth, y);
        const float *const up = rows.up, *const here = rows.here, *const down = rows.down;
        float *const contrast = contrast_.row(y), *const phase = phase_.row(y);
        along_row(smooth.width, [&](int x, int left, int right) {
            const float place = std::clamp(in_blocks({x, 0}).x, 0.0f, static_cast<float>(cosine_.width - 1));
            const int i = static_cast<int>(place), j = std::min(i + 1, cosine_.width - 1);
            const float share = place - static_cast<float>(i);
            // Squares and products of the normal, along which derivatives are taken, are its doubled angle's.
            const float c = cosines[i] + (cosines[j] - cosines[i]) * share;
            const float s = sines[i] + (sines[j] - sines[i]) * share;
            const float dx = here[right] - here[left], dy = down[x] - up[x];
            const float dxx = here[left] - 2 * here[x] + here[right], dyy = up[x] - 2 * here[x] + down[x];
            const float dxy = 0.25f * (down[right] - down[left] - up[right] + up[left]);
            const float odd = odd_gain * (dx * dx + dy * dy + c * (dx * dx - dy * dy) + 2 * s * dx * dy);
            const float even = even_gain * (dxx + dyy + c * (dxx - dyy) + 2 * s * dxy);
            contrast[x] = std::sqrt(std::max(odd, 0.0f) + even * even);
            phase[x] = even / (contrast[x] + 1e-6f);
        });
    });
    surrounding_ = wide(block_means(contrast_, block_), kSurroundingReach);
}

bool LineField::inside(glm::vec2 place) const {
    return place.x >= 1 && place.y >= 1 && place.x <= static_cast<float>(contrast_.width - 2) &&
           place.y <= static_cast<float>(contrast_.height - 2);
}

glm::vec2 LineField::normal_at(glm::vec2 place) const {
    const float x = value_at(cosine_, in_blocks(place)), y = value_at(sine_, in_blocks(place));
    const float length = std::sqrt(x * x + y * y);
    if (!(length > 0)) return {1, 0};
    // Half the angle.
    const float cosine = std::sqrt(std::max(0.5f * (1 + x / length), 0.0f));
    const float sine = std::sqrt(std::max(0.5f * (1 - x / length), 0.0f));
    return {cosine, y < 0 ? -sine : sine};
}

float LineField::salience_at(glm::vec2 place) const {
    const glm::vec2 at = in_blocks(place);
    const float left_over = contrast_at(place) - kInhibition * value_at(surrounding_, at);
    if (!(left_over > 0)) return 0;
    const float share = (value_at(coherence_, at) - kIncoherent) / (kCoherent - kIncoherent);
    return left_over * std::clamp(share, 0.0f, 1.0f);
}

std::vector<LineField::Seed> LineField::seeds(float least_salience) const {
    std::vector<std::vector<Seed>> rows(static_cast<std::size_t>(contrast_.height));
    tbb::parallel_for(1, contrast_.height - 1, [&](int y) {
        const ThreeRows near(contrast_, y);
        for (int x = 1; x < contrast_.width - 1; ++x) {
            const float here = near.here[x];
            const bool most_across = near.here[x - 1] < here && near.here[x + 1] <= here;
            const bool most_down = near.up[x] < here && near.down[x] <= here;
            if (here < least_salience || !(most_across || most_down)) continue;
            const glm::vec2 place(x, y), normal = normal_at(place);
            if (contrast_at(place - normal) > here || contrast_at(place + normal) > here) continue;
            const float salience = salience_at(place);
            if (salience >= least_salience) rows[static_cast<std::size_t>(y)].push_back({salience, x, y});
        }
    });
    std::vector<Seed> all;
    for (const std::vector<Seed>& row : rows) all.insert(all.end(), row.begin(), row.end());
    std::ranges::stable_sort(all, [](const Seed& a, const Seed& b) { return a.salience > b.salience; });
    return all;
}

}  // namespace dapple
