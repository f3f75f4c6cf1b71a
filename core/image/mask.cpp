#include "core/image/mask.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/image/tone.h"

namespace dapple {
namespace {

// 2^2: of white, above neutral.
constexpr float kMostStopsOfMask = 2;

// Bilinear, at a place whose pixels' centres are at halves.
float level_at(const Grid<std::uint8_t>& levels, double x, double y) {
    const double column = std::clamp(x - 0.5, 0.0, levels.width - 1.0);
    const double row = std::clamp(y - 0.5, 0.0, levels.height - 1.0);
    const int left = static_cast<int>(column), top = static_cast<int>(row);
    const int right = std::min(left + 1, levels.width - 1), bottom = std::min(top + 1, levels.height - 1);
    const auto across = static_cast<float>(column - left), down = static_cast<float>(row - top);
    const auto between = [&](int y_of_row) {
        const float a = levels.at(left, y_of_row), b = levels.at(right, y_of_row);
        return a + (b - a) * across;
    };
    const float upper = between(top), lower = between(bottom);
    return upper + (lower - upper) * down;
}

}  // namespace

Mask::Mask(Grid<std::uint8_t> levels) {
    if (std::ranges::any_of(levels.values, [](std::uint8_t level) { return level != kNeutralLevel; }))
        levels_ = std::make_shared<const Grid<std::uint8_t>>(std::move(levels));
}

bool Mask::operator==(const Mask& other) const {
    if (levels_ == other.levels_) return true;
    if (!levels_ || !other.levels_) return false;
    return levels_->width == other.levels_->width && levels_->values == other.levels_->values;
}

glm::ivec2 mask_size(glm::ivec2 picture) {
    const int longer = std::max(picture.x, picture.y);
    if (longer <= kMostMaskSide) return picture;
    const auto side = [&](int pixels) {
        return std::max(1, static_cast<int>(std::lround(double(pixels) * kMostMaskSide / longer)));
    };
    return {side(picture.x), side(picture.y)};
}

Mask mask_of(const Grid<float>& light) {
    const glm::ivec2 size = mask_size({light.width, light.height});
    Grid<std::uint8_t> levels(size.x, size.y);
    // The pixels whose centres lie in one of the mask's; there is at least one.
    const auto begin = [](int i, int pixels, int all) {
        return static_cast<int>(static_cast<std::int64_t>(i) * pixels / all);
    };
    tbb::parallel_for(0, size.y, [&](int y) {
        const int top = begin(y, light.height, size.y), bottom = begin(y + 1, light.height, size.y);
        for (int x = 0; x < size.x; ++x) {
            const int left = begin(x, light.width, size.x), right = begin(x + 1, light.width, size.x);
            double sum = 0;
            for (int row = top; row < bottom; ++row)
                for (int column = left; column < right; ++column)
                    sum += linear_to_srgb(std::clamp(light.at(column, row), 0.0f, 1.0f));
            const double mean = sum / (double(bottom - top) * (right - left));
            levels.at(x, y) = static_cast<std::uint8_t>(std::lround(255 * mean));
        }
    });
    return Mask(std::move(levels));
}

float mask_factor(float level) {
    constexpr float kNeutral = kNeutralLevel;
    if (level <= kNeutral) return level / kNeutral;
    return std::exp2(kMostStopsOfMask * (level - kNeutral) / (255 - kNeutral));
}

Grid<float> masked(Grid<float> density, const Mask& mask, const Framing& framing, glm::ivec2 picture) {
    if (mask.empty()) return density;
    const Grid<std::uint8_t>& levels = mask.levels();
    const glm::dvec2 share(double(levels.width) / picture.x, double(levels.height) / picture.y);
    tbb::parallel_for(0, density.height, [&](int y) {
        float* const row = density.row(y);
        for (int x = 0; x < density.width; ++x) {
            const glm::dvec2 at = opened_pixel(framing, {x + 0.5, y + 0.5}) * share;
            const float level = level_at(levels, at.x, at.y);
            if (level == kNeutralLevel) continue;  // to the bit what it was
            row[x] = std::min(row[x] * mask_factor(level), std::max(row[x], 1.0f));
        }
    });
    return density;
}

}  // namespace dapple
