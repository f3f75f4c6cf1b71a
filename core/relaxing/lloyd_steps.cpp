#include "core/relaxing/lloyd_steps.h"

#include <algorithm>
#include <cmath>

#include "core/relaxing/dot_rows.h"

namespace dapple {

namespace {

constexpr float kFewPixels = 8;  // high or wide: points in triangles then lie a pixel or two apart

// Rounded down and up, for numbers that fit into an integer: conversions, where std::floor is a call.
int floor_of(float value) {
    const int whole = static_cast<int>(value);
    return whole - (static_cast<float>(whole) > value);
}
int ceiling_of(float value) {
    const int whole = static_cast<int>(value);
    return whole + (static_cast<float>(whole) < value);
}

float squared(float value) {
    return value * value;
}

}  // namespace

WeightedCentroid::WeightedCentroid(const Density& density, double unit)
    : values_(density.values()),
      pixels_per_unit_(unit * density.longer_side()),
      pixels_(static_cast<float>(pixels_per_unit_)) {}

PixelAnchor WeightedCentroid::anchor(float x, float y) const {
    const double u = x * pixels_per_unit_ - 0.5, v = y * pixels_per_unit_ - 0.5;
    const double column = std::floor(u), row = std::floor(v);
    return {static_cast<int>(column), static_cast<int>(row), static_cast<float>(u - column),
            static_cast<float>(v - row)};
}

WeightedCentroid::PixelLine WeightedCentroid::line_at(const PixelAnchor& anchor, float y) const {
    const float v = anchor.y + y * pixels_;
    const int whole = floor_of(v), row = anchor.row + whole, last = values_.height - 1;
    return {values_.row(std::clamp(row, 0, last)), values_.row(std::clamp(row + 1, 0, last)),
            v - static_cast<float>(whole)};
}

float WeightedCentroid::density_at(const PixelAnchor& anchor, float x, float y) const {
    const PixelLine line = line_at(anchor, y);
    const float u = anchor.x + x * pixels_;
    const int whole = floor_of(u), last = values_.width - 1;
    const int first = std::clamp(anchor.column + whole, 0, last);
    const int second = std::clamp(anchor.column + whole + 1, 0, last);
    const float share = u - static_cast<float>(whole);
    const float above = line.upper[first] + (line.upper[second] - line.upper[first]) * share;
    const float below = line.lower[first] + (line.lower[second] - line.lower[first]) * share;
    return above + (below - above) * line.share;
}

Centroid WeightedCentroid::of(const VoronoiCell& cell, const PixelAnchor& anchor) {
    float left = cell[0].x, right = left, top = cell[0].y, bottom = top;
    for (int i = 1; i < cell.size(); ++i) {
        left = std::min(left, cell[i].x);
        right = std::max(right, cell[i].x);
        top = std::min(top, cell[i].y);
        bottom = std::max(bottom, cell[i].y);
    }
    if (!(bottom > top)) return {};
    if (std::max(right - left, bottom - top) * pixels_ > kFewPixels)
        return by_lines(cell, anchor, top, bottom);
    const bool inside = anchor.column + floor_of(left * pixels_) >= 0 &&
                        anchor.row + floor_of(top * pixels_) >= 0 &&
                        anchor.column + floor_of(right * pixels_) + 3 < values_.width &&
                        anchor.row + floor_of(bottom * pixels_) + 3 < values_.height;
    return by_triangles(cell, anchor, inside);
}

Centroid WeightedCentroid::by_triangles(const VoronoiCell& cell, const PixelAnchor& anchor,
                                        bool inside) const {
    // Far enough to the upper left that nothing is negative, where conversions round down.
    constexpr int kBack = 16;
    static_assert(kBack > kFewPixels);
    const float back_x = anchor.x + kBack, back_y = anchor.y + kBack;
    const std::ptrdiff_t width = values_.width;
    const float* const origin =
        inside ? values_.values.data() + (anchor.row - kBack) * width + (anchor.column - kBack) : nullptr;
    const auto density = [&](float x, float y) {
        if (!inside) return density_at(anchor, x, y);
        const float u = back_x + x * pixels_, v = back_y + y * pixels_;
        const int column = static_cast<int>(u), row = static_cast<int>(v);
        const float share_x = u - static_cast<float>(column), share_y = v - static_cast<float>(row);
        const float* const upper = origin + row * width + column;
        const float* const lower = upper + width;
        const float above = upper[0] + (upper[1] - upper[0]) * share_x;
        const float below = lower[0] + (lower[1] - lower[0]) * share_x;
        return above + (below - above) * share_y;
    };
    float weight = 0, weight_x = 0, weight_y = 0;
    // The points are the middles of the triangles' sides; two triangles share the one on the way to a corner.
    VoronoiCell::Corner a = cell[cell.size() - 1];
    float to_a = squared(density(0.5f * a.x, 0.5f * a.y));
    for (int i = 0; i < cell.size(); ++i) {
        const VoronoiCell::Corner b = cell[i];
        const float middle_x = 0.5f * (a.x + b.x), middle_y = 0.5f * (a.y + b.y);
        const float to_b = squared(density(0.5f * b.x, 0.5f * b.y));
        const float between = squared(density(middle_x, middle_y));
        const float area = a.x * b.y - a.y * b.x;
        weight += area * (to_a + to_b + between);
        weight_x += area * (0.5f * (to_a * a.x + to_b * b.x) + between * middle_x);
        weight_y += area * (0.5f * (to_a * a.y + to_b * b.y) + between * middle_y);
        a = b;
        to_a = to_b;
    }
    if (!(weight > 0)) return {};
    return {weight_x / weight, weight_y / weight, true};
}

// Where the lines enter and leave the cell.
void WeightedCentroid::find_lines(const VoronoiCell& cell, float top, float bottom, int lines) {
    const float line_height = (bottom - top) / static_cast<float>(lines);
    if (static_cast<int>(left_.size()) < lines) {
        left_.resize(static_cast<std::size_t>(lines));
        right_.resize(static_cast<std::size_t>(lines));
    }
    // Where rounding leaves a line without a beginning or an end it is empty.
    for (int i = 0; i < lines; ++i) left_[i] = right_[i] = 0;
    for (int i = 0; i < cell.size(); ++i) {
        const VoronoiCell::Corner a = cell[i], b = cell[i + 1 == cell.size() ? 0 : i + 1];
        // With the corners in their order, an edge that goes down the page is on the right.
        const bool down = b.y > a.y;
        const VoronoiCell::Corner &upper = down ? a : b, &lower = down ? b : a;
        const float rise = lower.y - upper.y;
        if (!(rise > 0)) continue;
        const float slope = (lower.x - upper.x) / rise;
        const int first = std::max(ceiling_of((upper.y - top) / line_height - 0.5f), 0);
        const int last = std::min(floor_of((lower.y - top) / line_height - 0.5f), lines - 1);
        float* const side = (down ? right_ : left_).data();
        for (int line = first; line <= last; ++line)
            side[line] = upper.x + (top + (static_cast<float>(line) + 0.5f) * line_height - upper.y) * slope;
    }
}

Centroid WeightedCentroid::by_lines(const VoronoiCell& cell, const PixelAnchor& anchor, float top,
                                    float bottom) {
    const int lines = std::max(ceiling_of((bottom - top) * pixels_), 1), last_column = values_.width - 1;
    const float line_height = (bottom - top) / static_cast<float>(lines);
    find_lines(cell, top, bottom, lines);
    double weight = 0, weight_x = 0, weight_y = 0;
    for (int i = 0; i < lines; ++i) {
        const float width = right_[i] - left_[i];
        if (!(width > 0)) continue;
        const float y = top + (static_cast<float>(i) + 0.5f) * line_height;
        const PixelLine line = line_at(anchor, y);
        const int points = ceiling_of(width * pixels_);
        const float step = width / static_cast<float>(points), pixel_step = step * pixels_;
        float u = anchor.x + (left_[i] + 0.5f * step) * pixels_;
        const int first_whole = floor_of(u), first_column = anchor.column + first_whole;
        u -= static_cast<float>(first_whole);
        float sum = 0, sum_x = 0;  // of points numbered from 0
        for (int k = 0; k < points; ++k) {
            const float number = static_cast<float>(k), at = u + number * pixel_step;
            const int whole = static_cast<int>(at);
            const int left = std::clamp(first_column + whole, 0, last_column);
            const int right = std::clamp(first_column + whole + 1, 0, last_column);
            const float first = line.upper[left] + (line.lower[left] - line.upper[left]) * line.share;
            const float second = line.upper[right] + (line.lower[right] - line.upper[right]) * line.share;
            const float density = first + (second - first) * (at - static_cast<float>(whole));
            sum += density * density;
            sum_x += density * density * number;
        }
        weight += sum * step;
        weight_x += (sum * (left_[i] + 0.5f * step) + sum_x * step) * step;
        weight_y += sum * step * y;
    }
    if (!(weight > 0)) return {};
    return {static_cast<float>(weight_x / weight), static_cast<float>(weight_y / weight), true};
}

namespace {

constexpr int kMostNearRows = 8;

// Farther in than this nothing has to be known of an edge: most dots lie there.
constexpr float kFarFromEdge = 0.5f;
static_assert(-kFarFromEdge < kLeastBeyond);

// 0, -1, 1, -2, 2, ...
constexpr auto kOutwards = [] {
    std::array<int, 2 * LloydSteps::kFarthestRow + 1> rows{};
    for (int i = 0; i <= 2 * LloydSteps::kFarthestRow; ++i)
        rows[static_cast<std::size_t>(i)] = i % 2 == 0 ? i / 2 : -(i + 1) / 2;
    return rows;
}();

}  // namespace

DotStep LloydSteps::step(std::size_t dot, float stride) {
    const PixelAnchor anchor = centroid_.anchor(rows_.x[dot], rows_.y[dot]);
    const VoronoiCell cell = cell_of(row_, dot, centroid_.density_at(anchor, 0, 0));
    const Centroid centroid = centroid_.of(cell, anchor);
    if (!centroid.has_ink) return {};
    DotStep step{stride * centroid.x, stride * centroid.y};
    const float length2 = step.x * step.x + step.y * step.y;
    if (length2 > kCellReach * kCellReach) {
        const float shorter = kCellReach / std::sqrt(length2);
        step.x *= shorter;
        step.y *= shorter;
    }
    return step;
}

// Other dots come in an order that follows from positions alone: first the nearest on either side in each
// of the rows around, as many as dots of this density are apart, which make most cells small; then all
// that reach it.
VoronoiCell LloydSteps::cell_of(std::int64_t row, std::size_t dot, float density) {
    const float x = rows_.x[dot], y = rows_.y[dot];
    const float* const radii2 = rows_.radii2.empty() ? nullptr : rows_.radii2.data();
    const float own = radii2 ? radii2[dot] : 0;
    const float apart_here = radii2 ? std::sqrt(std::numbers::pi_v<float> * own)
                                    : page_.spacing / std::sqrt(std::max(density, 1e-6f));
    // To where the cell ends at an edge so far away, at that place along it.
    const auto to_edge = [&](float away, float from_middle) {
        if (away - kFarFromEdge * apart_here > kCellReach) return kCellReach;
        const float beyond = beyond_edge(kWavesOfCells, from_middle / apart_here, density);
        return std::clamp(away + beyond * apart_here, 0.0f, kCellReach);
    };
    const float across = x - page_.width / 2, down = y - page_.height / 2;
    VoronoiCell cell(-to_edge(x, down), -to_edge(y, across), to_edge(page_.width - x, down),
                     to_edge(page_.height - y, across), rows_.most_radius2 - own);
    const float* const xs = rows_.x.data();
    const float* const ys = rows_.y.data();
    const auto cut = [&](std::size_t other) {
        const float dx = xs[other] - x, dy = ys[other] - y;
        const float distance2 = dx * dx + dy * dy;
        if (distance2 < cell.reach2() && distance2 > 0) cell.cut(dx, dy, radii2 ? radii2[other] - own : 0);
    };
    const int near_rows = std::min(static_cast<int>(apart_here) + 1, kMostNearRows);
    Stretch near[2 * kMostNearRows + 1];
    for (int i = 0; i <= 2 * near_rows; ++i) {
        const std::int64_t at = row + kOutwards[i];
        if (at < 0 || at >= rows_.rows()) continue;
        near[i] = stretch_around(at, x);
        if (i == 0) near[i].left = dot, near[i].right = dot + 1;
        if (near[i].right < near[i].end) cut(near[i].right++);
        if (near[i].left > near[i].begin) cut(--near[i].left);
    }
    const float in_row = y - static_cast<float>(rows_.first_row() + row);
    for (int i = 0; i <= 2 * kFarthestRow; ++i) {
        const int away = kOutwards[i];
        const float apart = away == 0  ? 0
                            : away < 0 ? in_row - static_cast<float>(away + 1)
                                       : static_cast<float>(away) - in_row;
        const float apart2 = apart * apart;
        const std::int64_t at = row + away;
        if (apart2 >= cell.reach2()) {
            // The row on the other side may still be near enough.
            if (away > 0 && static_cast<float>(away * away) >= cell.reach2()) break;
            continue;
        }
        if (at < 0 || at >= rows_.rows()) continue;
        Stretch stretch = i <= 2 * near_rows ? near[i] : stretch_around(at, x);
        for (; stretch.right < stretch.end; ++stretch.right) {
            const float dx = xs[stretch.right] - x;
            if (dx * dx + apart2 >= cell.reach2()) break;
            cut(stretch.right);
        }
        for (; stretch.left > stretch.begin; --stretch.left) {
            const float dx = xs[stretch.left - 1] - x;
            if (dx * dx + apart2 >= cell.reach2()) break;
            cut(stretch.left - 1);
        }
    }
    return cell;
}

// Dots come from the left to the right, so the place in each row near them moves on with them.
LloydSteps::Stretch LloydSteps::stretch_around(std::int64_t row, float x) {
    std::size_t& cursor = cursors_.at(row);
    const std::size_t end = rows_.end(row);
    const float* const xs = rows_.x.data();
    std::size_t at = cursor;
    while (at < end && xs[at] < x) ++at;
    cursor = at;
    return {rows_.begin(row), end, at, at};
}

}  // namespace dapple
