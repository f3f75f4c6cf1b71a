#include "core/relaxing/lloyd_steps.h"

#include <algorithm>
#include <cmath>

#include "core/relaxing/page_edge.h"

namespace dapple {

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
