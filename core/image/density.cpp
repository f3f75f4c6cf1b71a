#include "core/image/density.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/maths/portable_math.h"

namespace dapple {

namespace {

// The pyramid's last level has squares of 1 to 2 times so many pixels; twice that for large pictures, to save
// memory.
constexpr double kPixelsPerBaseSquare = 1.5;
constexpr std::size_t kLargePicture = 16'000'000;  // pixels
constexpr double kPixelSlack = 1e-6;  // a placer's rounding never reaches a pixel further than this
constexpr double kRelativePixelSlack = 3e-7;
constexpr float kRelativeSlack = 1e-6f;  // nor a value further than this

// A conversion, where std::floor may be a call.
std::int64_t floor_of_pixel(double position) {
    const auto cut = static_cast<std::int64_t>(position);
    return cut - (position < static_cast<double>(cut));
}

void include(Bounds& bounds, float value) {
    bounds.min = std::min(bounds.min, value);
    bounds.max = std::max(bounds.max, value);
}

constexpr Bounds kNothing{std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest()};

// The index of a pixel, beyond the picture that of the nearest or, across a wrapping seam, of the other side.
int clamped(std::int64_t i, int count) {
    return static_cast<int>(std::clamp<std::int64_t>(i, 0, count - 1));
}
int across(std::int64_t i, int count, Sides sides) {
    return sides == Sides::wrap ? static_cast<int>((i % count + count) % count) : clamped(i, count);
}

}  // namespace

Density::Density(Grid<float> values, Sides sides, glm::dvec2 tile_corner, Reading reading)
    : values_(std::move(values)), sides_(sides), reading_(reading), tile_corner_(tile_corner) {
    if (values_.empty()) throw std::runtime_error("a density needs at least one pixel");
    if (values_.values.size() > std::numeric_limits<std::int32_t>::max()) {
        throw std::runtime_error("a density has at most 2,147 megapixels; make the picture smaller");
    }
    longer_ = std::max(values_.width, values_.height);
    for (int depth = 0; depth < static_cast<int>(side_.size()); ++depth)
        side_[depth] = std::ldexp(longer_, -depth);

    std::vector<double> sums(values_.height);
    tbb::parallel_for(0, values_.height, [&](int y) {
        const float* row = values_.row(y);
        double sum = 0;
        float lowest = 0;
        for (int x = 0; x < values_.width; ++x) {
            sum += row[x];
            lowest = std::min(lowest, row[x]);
        }
        sums[y] = lowest < 0 ? -std::numeric_limits<double>::infinity() : sum;
    });
    for (const double sum : sums) mean_ += sum;
    if (!std::isfinite(mean_)) throw std::runtime_error("a density must be finite and not negative");
    mean_ /= static_cast<double>(longer_) * longer_;
    build_pyramid();
}

double Density::at(glm::dvec2 p) const {
    const double u = p.x * longer_, v = p.y * longer_;
    if (!(u >= 0 && v >= 0 && u < values_.width && v < values_.height)) return 0;
    if (reading_ == Reading::by_cell) return values_.at(static_cast<int>(u), static_cast<int>(v));
    const double fx = std::floor(u - 0.5), fy = std::floor(v - 0.5);
    const double s = u - 0.5 - fx, t = v - 0.5 - fy;
    const auto ix = static_cast<std::int64_t>(fx), iy = static_cast<std::int64_t>(fy);
    const int x0 = across(ix, values_.width, sides_), x1 = across(ix + 1, values_.width, sides_);
    const float* row0 = values_.row(clamped(iy, values_.height));
    const float* row1 = values_.row(clamped(iy + 1, values_.height));
    const double upper = row0[x0] + (static_cast<double>(row0[x1]) - row0[x0]) * s;
    const double lower = row1[x0] + (static_cast<double>(row1[x1]) - row1[x0]) * s;
    return upper + (lower - upper) * t;
}

std::pair<std::int64_t, std::int64_t> Density::support(double from, double to) const {
    const double slack = kPixelSlack + kRelativePixelSlack * (to - from);
    const std::int64_t last = floor_of_pixel(to - middle() + slack);
    return {floor_of_pixel(from - middle() - slack), reading_ == Reading::bilinear ? last + 1 : last};
}

void Density::build_pyramid() {
    const double pixels_per_square = kPixelsPerBaseSquare * (values_.values.size() > kLargePicture ? 2 : 1);
    const int base_depth =
        std::max(0, static_cast<int>(std::floor(portable::log2(longer_ / pixels_per_square))));
    pyramid_.resize(base_depth + 1);
    const glm::dvec2 corner = corner_pixel();
    for (int depth = 0; depth <= base_depth; ++depth) {
        const double squares = std::ldexp(1.0, depth);
        Level& level = pyramid_[depth];
        level.left = static_cast<std::int64_t>(std::floor(-tile_corner_.x * squares));
        level.top = static_cast<std::int64_t>(std::floor(-tile_corner_.y * squares));
        const auto end = [&](int pixels, double begin) {
            return static_cast<std::int64_t>(std::ceil((pixels - begin) * squares / longer_));
        };
        level.width = end(values_.width, corner.x) - level.left;
        level.height = end(values_.height, corner.y) - level.top;
        level.squares.resize(static_cast<std::size_t>(level.width * level.height));
    }

    // The base: minimum and maximum down the columns of a row of squares, then along them.
    Level& base = pyramid_.back();
    const double side = std::ldexp(static_cast<double>(longer_), -base_depth);  // pixels
    // The columns that interpolation in squares can touch, from the first one's on, and where each square's
    // lie among them.
    struct Columns {
        std::size_t first, end;
        bool beyond;  // the picture's sides
    };
    std::vector<int> column_at;
    std::vector<Columns> columns;
    const std::int64_t begin = support(corner.x + static_cast<double>(base.left) * side, 0).first;
    for (std::int64_t x = base.left; x < base.left + base.width; ++x) {
        const double left = corner.x + static_cast<double>(x) * side;
        const auto [first, last] = support(left, left + side);
        while (begin + std::ssize(column_at) <= last)
            column_at.push_back(across(begin + std::ssize(column_at), values_.width, sides_));
        columns.push_back({static_cast<std::size_t>(first - begin),
                           static_cast<std::size_t>(last + 1 - begin),
                           left < 0 || left + side > values_.width});
    }
    tbb::parallel_for(std::int64_t{0}, base.height, [&](std::int64_t y) {
        const double top = corner.y + static_cast<double>(base.top + y) * side;
        const auto [first_row, last_row] = support(top, top + side);
        const float* first = values_.row(clamped(first_row, values_.height));
        std::vector<float> low(first, first + values_.width), high = low;
        for (int j = clamped(first_row, values_.height) + 1; j <= clamped(last_row, values_.height); ++j) {
            const float* row = values_.row(j);
            for (int x = 0; x < values_.width; ++x) {
                low[x] = std::min(low[x], row[x]);
                high[x] = std::max(high[x], row[x]);
            }
        }
        const bool beyond_rows = top < 0 || top + side > values_.height;
        Bounds* square = &base.squares[static_cast<std::size_t>(y * base.width)];
        for (const Columns& its : columns) {
            Bounds bounds = kNothing;
            for (std::size_t i = its.first; i < its.end; ++i) {
                bounds.min = std::min(bounds.min, low[column_at[i]]);
                bounds.max = std::max(bounds.max, high[column_at[i]]);
            }
            if (beyond_rows || its.beyond) bounds.min = 0;
            *square++ = {bounds.min * (1 - kRelativeSlack), bounds.max * (1 + kRelativeSlack)};
        }
    });

    for (int depth = base_depth - 1; depth >= 0; --depth) {
        Level& level = pyramid_[depth];
        const Level& finer = pyramid_[depth + 1];
        auto square = level.squares.begin();
        for (std::int64_t y = level.top; y < level.top + level.height; ++y) {
            for (std::int64_t x = level.left; x < level.left + level.width; ++x) {
                Bounds bounds = kNothing;
                for (int q = 0; q < 4; ++q) {
                    const Bounds child = finer.bounds(2 * x + (q & 1), 2 * y + (q >> 1));
                    include(bounds, child.min);
                    include(bounds, child.max);
                }
                *square++ = bounds;
            }
        }
    }
}

PixelRange Density::pixels_in(const QuadSquare& square) const {
    const double side = side_[square.depth];
    const glm::dvec2 corner = corner_pixel();
    const double left = corner.x + static_cast<double>(square.x) * side;
    const double top = corner.y + static_cast<double>(square.y) * side;
    const auto [first_column, last_column] = support(left, left + side);
    const auto [first_row, last_row] = support(top, top + side);
    return {first_column, last_column, first_row, last_row};
}

float Density::pixel(std::int64_t column, std::int64_t row) const {
    return values_.at(across(column, values_.width, sides_), clamped(row, values_.height));
}

SmallSquare Density::look(const QuadSquare& square) const {
    const double side = side_[square.depth];
    const glm::dvec2 corner = corner_pixel();
    const double left = corner.x + static_cast<double>(square.x) * side;
    const double top = corner.y + static_cast<double>(square.y) * side;
    const double right = left + side, bottom = top + side;
    SmallSquare look;
    if (right <= 0 || bottom <= 0 || left >= values_.width || top >= values_.height) return look;
    const bool inside = left >= 0 && top >= 0 && right <= values_.width && bottom <= values_.height;

    // A square that rounding puts across a centre line by a hair is a patch all the same: patches are
    // continuous. Cells are not.
    const bool smooth = reading_ == Reading::bilinear;
    const double slack = smooth ? kPixelSlack : 0;
    const std::int64_t column = floor_of_pixel(left - middle() + slack);
    const std::int64_t row = floor_of_pixel(top - middle() + slack);
    const auto first_column = static_cast<double>(column), first_row = static_cast<double>(row);
    if (inside && right - middle() <= first_column + 1 + slack &&
        bottom - middle() <= first_row + 1 + slack) {
        const int next = smooth ? 1 : 0;
        const double v00 = pixel(column, row), v10 = pixel(column + next, row);
        const double v01 = pixel(column, row + next), v11 = pixel(column + next, row + next);
        const double s = left + side / 2 - 0.5 - first_column, t = top + side / 2 - 0.5 - first_row;
        const double along = v10 - v00, down = v01 - v00, twist = v11 - v10 - down;
        look.is_patch = true;
        look.patch = {v00 + along * s + (down + twist * s) * t, (along + twist * t) * side / 2,
                      (down + twist * s) * side / 2, twist * side * side / 4};
        look.bounds = look.patch.bounds();
        return look;
    }

    const PixelRange p = look.pixels = pixels_in(square);
    Bounds bounds = kNothing;
    if (p.first_column >= 0 && p.first_row >= 0 && p.last_column < values_.width &&
        p.last_row < values_.height) {
        for (std::int64_t j = p.first_row; j <= p.last_row; ++j) {
            const float* pixels = values_.row(static_cast<int>(j));
            for (std::int64_t i = p.first_column; i <= p.last_column; ++i) include(bounds, pixels[i]);
        }
    } else {
        for (std::int64_t j = p.first_row; j <= p.last_row; ++j)
            for (std::int64_t i = p.first_column; i <= p.last_column; ++i) include(bounds, pixel(i, j));
    }
    if (!inside) bounds.min = 0;
    look.bounds = {bounds.min * (1 - kRelativeSlack), bounds.max * (1 + kRelativeSlack)};
    return look;
}

BilinearPatch BilinearPatch::quadrant(int q) const {
    const double s = q & 1 ? 0.5 : -0.5, t = q & 2 ? 0.5 : -0.5;
    return {c + x * s + y * t + xy * s * t, 0.5 * (x + xy * t), 0.5 * (y + xy * s), 0.25 * xy};
}

Bounds BilinearPatch::bounds() const {
    const double low = std::min(std::min(-x - y + xy, x - y - xy), std::min(-x + y - xy, x + y + xy));
    const double high = std::max(std::max(-x - y + xy, x - y - xy), std::max(-x + y - xy, x + y + xy));
    const double slack = kRelativeSlack * (std::abs(c) + std::abs(x) + std::abs(y) + std::abs(xy));
    return {static_cast<float>(std::max(0.0, c + low - slack)), static_cast<float>(c + high + slack)};
}

}  // namespace dapple
