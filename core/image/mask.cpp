#include "core/image/mask.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "core/image/detail.h"
#include "core/image/tone.h"
#include "core/maths/portable_math.h"

namespace dapple {

namespace {

template <class T>
Grid<T> framed_pixels(const Grid<T>& picture, const Framing& framing) {
    const glm::ivec2 size = framing.size();
    const auto pixel_at = [&](int x, int y) { return glm::ivec2(opened_pixel(framing, {x + 0.5, y + 0.5})); };
    const glm::ivec2 corner = pixel_at(0, 0), along = pixel_at(1, 0) - corner, down = pixel_at(0, 1) - corner;
    Grid<T> result(size.x, size.y);
    for (int y = 0; y < size.y; ++y) {
        T* const row = result.row(y);
        for (int x = 0; x < size.x; ++x) {
            const glm::ivec2 from = corner + x * along + y * down;
            row[x] = picture.at(from.x, from.y);
        }
    }
    return result;
}

}  // namespace

glm::dvec2 opened_pixel(const Framing& framing, glm::dvec2 framed) {
    const glm::dvec2 low(framing.pixels.low), high(framing.pixels.high);
    if (framing.mirrored) framed.x = framing.size().x - framed.x;
    switch (framing.quarter_turns) {
        case 1:
            return {low.x + framed.y, high.y - framed.x};
        case 2:
            return high - framed;
        case 3:
            return {high.x - framed.y, low.y + framed.x};
        default:
            return low + framed;
    }
}

Grid<float> framed(const Grid<float>& picture, const Framing& framing) {
    return framed_pixels(picture, framing);
}

Grid<glm::u16vec3> framed(const Grid<glm::u16vec3>& picture, const Framing& framing) {
    return framed_pixels(picture, framing);
}

namespace {

// The level that a brush paints towards, if it changes the levels.
std::uint8_t level_of(BrushKind kind) {
    return kind == BrushKind::more    ? 255
           : kind == BrushKind::fewer ? kNeutralLevel / 2
           : kind == BrushKind::none  ? 0
                                      : kNeutralLevel;
}

// How much of the brush is at a distance from the stroke, in radii: 1 up to 1 - softness, then falling as
// 3t^2 - 2t^3 does to 0 at 1.
double brush_cover(double radii, double softness) {
    if (radii >= 1) return 0;
    if (radii <= 1 - softness) return 1;
    const double t = (1 - radii) / softness;
    return t * t * (3 - 2 * t);
}

}  // namespace

BrushStroke::BrushStroke(const Mask& mask, glm::ivec2 picture, const Brush& brush) : brush_(brush) {
    const glm::ivec2 size = mask_size(picture);
    // One that was made for a picture of another shape stays as it is, and so does its number of pixels.
    levels_ = mask.empty() ? Grid<std::uint8_t>(size.x, size.y, kNeutralLevel) : mask.levels();
    fineness_ = mask.has_finer() ? mask.fineness() : Grid<std::uint8_t>(levels_.width, levels_.height);
    cover_ = Grid<float>(levels_.width, levels_.height);
    const double longer = std::max(picture.x, picture.y);
    pixels_per_unit_ = {levels_.width * longer / picture.x, levels_.height * longer / picture.y};
}

void BrushStroke::go_to(glm::dvec2 point) {
    const glm::dvec2 from = last_.value_or(point), way = point - from;
    last_ = point;
    const double length_squared = glm::dot(way, way), radius = brush_.radius;
    const auto first = [&](double low, double per_unit) {
        return static_cast<int>(std::floor(std::max((low - radius) * per_unit - 1, 0.0)));
    };
    const auto end = [&](double high, double per_unit, int side) {
        return static_cast<int>(std::clamp((high + radius) * per_unit + 1, 0.0, double(side)));
    };
    const auto [across, down] = std::pair(pixels_per_unit_.x, pixels_per_unit_.y);
    const int right = end(std::max(from.x, point.x), across, cover_.width);
    const int bottom = end(std::max(from.y, point.y), down, cover_.height);
    for (int y = std::min(first(std::min(from.y, point.y), down), bottom); y < bottom; ++y) {
        for (int x = std::min(first(std::min(from.x, point.x), across), right); x < right; ++x) {
            const glm::dvec2 to = glm::dvec2(x + 0.5, y + 0.5) / pixels_per_unit_ - from;
            const double along =
                length_squared > 0 ? std::clamp(glm::dot(to, way) / length_squared, 0.0, 1.0) : 0;
            const double distance = glm::length(to - along * way);
            const auto cover = static_cast<float>(brush_cover(distance / radius, brush_.softness));
            cover_.at(x, y) = std::max(cover_.at(x, y), cover);
        }
    }
}

Mask BrushStroke::mask() const {
    Grid<std::uint8_t> levels = levels_, fineness = fineness_;
    const auto paint = [&](Grid<std::uint8_t>& grid, double target) {
        for (std::size_t i = 0; i < grid.values.size(); ++i) {
            const double before = grid.values[i];
            grid.values[i] = static_cast<std::uint8_t>(
                std::lround(before + (target - before) * brush_.strength * double(cover_.values[i])));
        }
    };
    if (brush_.kind != BrushKind::finer) paint(levels, level_of(brush_.kind));
    if (brush_.kind == BrushKind::finer) paint(fineness, 255);
    if (brush_.kind == BrushKind::erase) paint(fineness, 0);
    return Mask(std::move(levels), std::move(fineness));
}

namespace {

// 2^2: of white, above neutral.
constexpr float kMostStopsOfMask = 2;

// The levels that a picture of linear light has as a mask: means of the encoded values, or the values of
// the pixels there, where it has fewer.
Grid<std::uint8_t> levels_of(const Grid<float>& light, glm::ivec2 size) {
    Grid<std::uint8_t> levels(size.x, size.y);
    struct Span {
        int first, end;
    };
    // The pixels whose centres lie in one of the mask's, or the one that it lies in.
    const auto pixels_of = [](int i, int pixels, int all) {
        const auto begin = [&](int at) { return static_cast<int>(std::int64_t{at} * pixels / all); };
        return Span{begin(i), std::max(begin(i + 1), begin(i) + 1)};
    };
    tbb::parallel_for(0, size.y, [&](int y) {
        const Span down = pixels_of(y, light.height, size.y);
        for (int x = 0; x < size.x; ++x) {
            const Span across = pixels_of(x, light.width, size.x);
            double sum = 0;
            for (int row = down.first; row < down.end; ++row)
                for (int column = across.first; column < across.end; ++column)
                    sum += linear_to_srgb(std::clamp(light.at(column, row), 0.0f, 1.0f));
            const double mean = sum / (double(down.end - down.first) * (across.end - across.first));
            levels.at(x, y) = static_cast<std::uint8_t>(std::lround(255 * mean));
        }
    });
    return levels;
}

bool same(const Grid<std::uint8_t>& a, const Grid<std::uint8_t>& b) {
    return a.width == b.width && a.values == b.values;
}

}  // namespace

float level_at(const Grid<std::uint8_t>& levels, glm::dvec2 place) {
    // In this order of arguments what is no number becomes 0.
    const double column = std::min(std::max(0.0, place.x - 0.5), levels.width - 1.0);
    const double row = std::min(std::max(0.0, place.y - 0.5), levels.height - 1.0);
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

Mask::Mask(Grid<std::uint8_t> levels, Grid<std::uint8_t> fineness) {
    assert(fineness.empty() || (fineness.width == levels.width && fineness.height == levels.height));
    if (std::ranges::none_of(fineness.values, [](std::uint8_t fine) { return fine > 0; })) fineness = {};
    const auto neutral = [](std::uint8_t level) { return level == kNeutralLevel; };
    if (fineness.empty() && std::ranges::all_of(levels.values, neutral)) return;
    layers_ = std::make_shared<const Layers>(Layers{std::move(levels), std::move(fineness)});
}

bool Mask::operator==(const Mask& other) const {
    if (layers_ == other.layers_) return true;
    if (!layers_ || !other.layers_) return false;
    return same(levels(), other.levels()) && same(fineness(), other.fineness());
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
    return Mask(levels_of(light, mask_size({light.width, light.height})));
}

Mask with_fineness(const Mask& mask, const Grid<float>& light) {
    const glm::ivec2 size = mask.empty() ? mask_size({light.width, light.height})
                                         : glm::ivec2(mask.levels().width, mask.levels().height);
    return Mask(mask.empty() ? Grid<std::uint8_t>(size.x, size.y, kNeutralLevel) : mask.levels(),
                levels_of(light, size));
}

float mask_factor(float level) {
    constexpr float kNeutral = kNeutralLevel;
    if (level <= kNeutral) return level / kNeutral;
    return portable::exp2(kMostStopsOfMask * (level - kNeutral) / (255 - kNeutral));
}

Grid<float> masked(Grid<float> density, const Mask& mask, const Framing& framing, glm::ivec2 picture) {
    if (mask.empty()) return density;
    const Grid<std::uint8_t>& levels = mask.levels();
    const Refinement finer(mask, framing, picture);
    const double longer = std::max(density.width, density.height);
    const glm::dvec2 share(double(levels.width) / picture.x, double(levels.height) / picture.y);
    tbb::parallel_for(0, density.height, [&](int y) {
        float* const row = density.row(y);
        for (int x = 0; x < density.width; ++x) {
            const glm::dvec2 at = opened_pixel(framing, {x + 0.5, y + 0.5}) * share;
            const float level = level_at(levels, at);
            if (level != kNeutralLevel)  // else to the bit what it was
                row[x] = std::min(row[x] * mask_factor(level), std::max(row[x], 1.0f));
            row[x] *= finer.times_at(glm::dvec2(x + 0.5, y + 0.5) / longer);
        }
    });
    return density;
}

}  // namespace dapple
