#include "core/relaxing/weighted_centroid.h"

#include <algorithm>
#include <cmath>

namespace dapple {

namespace {

constexpr int kFewestLines = 5;

// Rounded down and up, for numbers that fit into an integer: conversions, where std::floor is a call.
int floor_of(float value) {
    const int whole = static_cast<int>(value);
    return whole - (static_cast<float>(whole) > value);
}
int ceiling_of(float value) {
    const int whole = static_cast<int>(value);
    return whole + (static_cast<float>(whole) < value);
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

// How many lines there are, and where they enter and leave the cell.
int WeightedCentroid::find_lines(const VoronoiCell& cell, float top, float height) {
    const int lines = std::max(ceiling_of(height * pixels_), kFewestLines);
    const float line_height = height / static_cast<float>(lines);
    const float lines_per_unit = static_cast<float>(lines) / height;
    if (static_cast<int>(left_.size()) < lines) {
        left_.resize(static_cast<std::size_t>(lines));
        right_.resize(static_cast<std::size_t>(lines));
    }
    // Where rounding leaves a line without a beginning or an end it is empty.
    for (int i = 0; i < lines; ++i) left_[i] = right_[i] = 0;
    for (int i = 0; i < cell.size(); ++i) {
        const int j = i + 1 == cell.size() ? 0 : i + 1;
        // With the corners in their order, an edge that goes down the page is on the right.
        const bool down = cell.y(j) > cell.y(i);
        const int upper = down ? i : j, lower = down ? j : i;
        const float rise = cell.y(lower) - cell.y(upper);
        if (!(rise > 0)) continue;
        const float slope = (cell.x(lower) - cell.x(upper)) / rise;
        const int first = std::max(ceiling_of((cell.y(upper) - top) * lines_per_unit - 0.5f), 0);
        const int last = std::min(floor_of((cell.y(lower) - top) * lines_per_unit - 0.5f), lines - 1);
        float* const side = (down ? right_ : left_).data();
        float at = cell.x(upper) + (top + (static_cast<float>(first) + 0.5f) * line_height - cell.y(upper)) * slope;
        for (int line = first; line <= last; ++line, at += slope * line_height) side[line] = at;
    }
    return lines;
}

Centroid WeightedCentroid::of(const VoronoiCell& cell, const PixelAnchor& anchor) {
    float top = cell.y(0), bottom = top;
    for (int i = 1; i < cell.size(); ++i) {
        top = std::min(top, cell.y(i));
        bottom = std::max(bottom, cell.y(i));
    }
    const float height = bottom - top;
    if (!(height > 0)) return {};
    const int lines = find_lines(cell, top, height);
    const float line_height = height / static_cast<float>(lines);
    const float points_per_unit = std::max(pixels_, 1 / line_height);
    const int last_column = values_.width - 1;

    double weight = 0, weight_x = 0, weight_y = 0;
    for (int i = 0; i < lines; ++i) {
        const float width = right_[i] - left_[i];
        if (!(width > 0)) continue;
        const float y = top + (static_cast<float>(i) + 0.5f) * line_height;
        const PixelLine line = line_at(anchor, y);
        const int points = ceiling_of(width * points_per_unit);
        const float step = width / static_cast<float>(points), pixel_step = step * pixels_;
        float sum = 0, sum_x = 0;  // of points numbered from 0
        float u = anchor.x + (left_[i] + 0.5f * step) * pixels_;
        const int first_whole = floor_of(u);
        u -= static_cast<float>(first_whole);
        const int first_column = anchor.column + first_whole;
        const bool inside = first_column >= 0 &&
                            first_column + static_cast<int>(u + static_cast<float>(points) * pixel_step) + 1 <= last_column;
        const auto add = [&](int at, int next, float share, float number) {
            const float first = line.upper[at] + (line.lower[at] - line.upper[at]) * line.share;
            const float second = line.upper[next] + (line.lower[next] - line.upper[next]) * line.share;
            const float density = first + (second - first) * share;
            sum += density * density;
            sum_x += density * density * number;
        };
        for (int k = 0; k < points; ++k) {
            const float number = static_cast<float>(k), at = u + number * pixel_step;
            const int whole = static_cast<int>(at), column = first_column + whole;
            const float share = at - static_cast<float>(whole);
            if (inside)
                add(column, column + 1, share, number);
            else
                add(std::clamp(column, 0, last_column), std::clamp(column + 1, 0, last_column), share, number);
        }
        weight += sum * step;
        weight_x += (sum * (left_[i] + 0.5f * step) + sum_x * step) * step;
        weight_y += sum * step * y;
    }
    if (!(weight > 0)) return {};
    return {static_cast<float>(weight_x / weight), static_cast<float>(weight_y / weight), true};
}

}  // namespace dapple
