#include "core/image/brush.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace dapple {

namespace {

// The level that a brush paints towards, if it changes the levels.
std::uint8_t level_of(BrushKind kind) {
    switch (kind) {
        case BrushKind::more:
            return 255;
        case BrushKind::fewer:
            return kNeutralLevel / 2;
        case BrushKind::none:
            return 0;
        case BrushKind::finer:
        case BrushKind::erase:
            break;
    }
    return kNeutralLevel;
}

}  // namespace

double brush_cover(double radii, double softness) {
    if (radii >= 1) return 0;
    if (radii <= 1 - softness) return 1;
    const double t = (1 - radii) / softness;
    return t * t * (3 - 2 * t);
}

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

}  // namespace dapple
