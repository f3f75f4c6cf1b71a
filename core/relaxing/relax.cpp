#include "core/relaxing/relax.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "core/placing/pieces.h"
#include "core/placing/placer_memory.h"
#include "core/relaxing/stir.h"
#include "core/relaxing/voronoi_cell.h"
#include "core/relaxing/weighted_centroid.h"

namespace dapple {

namespace {

// A cell reaches so many rows at most, so that a dot depends on its surroundings only. In light areas where
// dots are further apart (below a hundredth of black) cells are cut off there.
constexpr float kCellReach = 8;
// Dots further away than twice a corner's distance are no neighbours.
constexpr int kFarthestRow = 23;
static_assert(kFarthestRow > 2 * std::numbers::sqrt2 * kCellReach);

constexpr int kMostNearRows = 8;

constexpr float kOvershoot = 1.8f;
// Where cells end along the page's edges, in distances between dots beyond them. In black a little beyond,
// since on the edges they would draw dots half a distance inwards, and leave bare paper between the discs. In
// lighter tones in waves of two lengths that hardly ever meet again: dots lean on where their cells end, and
// would be seen to line up along a straight edge, while a page should look cut out of a larger one. Farther
// in, waves would leave bare bites, and farther out draw dots off the page.
constexpr float kBeyondInBlack = 0.2f, kLightest = 0.85f,
                kBlackest = 0.98f;  // densities, between which both are mixed
constexpr float kBeyondEdge = 0.05f, kLeastBeyond = -0.4f, kMostBeyond = 0.35f;
// Farther in than this nothing has to be known of an edge: most dots lie there.
constexpr float kFarFromEdge = 0.5f;
static_assert(-kFarFromEdge < kLeastBeyond && kLeastBeyond < kBeyondInBlack);
constexpr float kWaveHeight = 0.45f, kWaveLengths[] = {3.7f, 5.9f};
// A dot stays where the ink is: it does not go where there is less than this share of the density that it
// comes from.
constexpr float kLeastShare = 0.25f;
constexpr int kShorterTries = 3;

constexpr std::size_t kDotsAtOnce = 2048;  // on a thread, about

// A triangle wave, -1..1, of length 1, from 0 up. A sine's last bit would not be the same everywhere.
float wave(float t) {
    return 1 - 4 * std::abs(t - 0.25f - std::floor(t + 0.25f));
}

// 0, -1, 1, -2, 2, ...
constexpr auto kOutwards = [] {
    std::array<int, 2 * kFarthestRow + 1> rows{};
    for (int i = 0; i <= 2 * kFarthestRow; ++i)
        rows[static_cast<std::size_t>(i)] = i % 2 == 0 ? i / 2 : -(i + 1) / 2;
    return rows;
}();

// Rows about as high as dots on black are apart.
int depth_for(double scale) {
    return std::max(0, static_cast<int>(std::lround(std::log2(kDotsPerScale * std::max(scale, 1e-12)) / 2)));
}

// Moves the dots of some rows. Its unit is a row's height.
class RowsMover {
 public:
    RowsMover(const DotRows& rows, const Density& density, double scale, int depth)
        : rows_(rows),
          width_(static_cast<float>(
              std::ldexp(density.width() / static_cast<double>(density.longer_side()), depth))),
          height_(static_cast<float>(
              std::ldexp(density.height() / static_cast<double>(density.longer_side()), depth))),
          spacing_(static_cast<float>(std::ldexp(1.0, depth) / std::sqrt(kDotsPerScale * scale))),
          centroid_(density, std::ldexp(1.0, -depth)) {}

    void move_row(std::int64_t row, DotRows::Positions& to_x, DotRows::Positions& to_y) {
        first_near_ = std::max<std::int64_t>(row - kFarthestRow, 0);
        const std::int64_t end_near = std::min<std::int64_t>(row + kFarthestRow + 1, rows_.rows());
        for (std::int64_t near = first_near_; near < end_near; ++near)
            cursors_[static_cast<std::size_t>(near - first_near_)] = rows_.begin(near);
        for (std::size_t i = rows_.begin(row); i < rows_.end(row); ++i) move_dot(row, i, to_x[i], to_y[i]);
    }

 private:
    // Dots of a row: those before `left` and from `right` on are still to be looked at.
    struct Stretch {
        std::size_t begin, end, left, right;
    };

    void move_dot(std::int64_t row, std::size_t dot, float& to_x, float& to_y) {
        const float x = rows_.x[dot], y = rows_.y[dot];
        const PixelAnchor anchor = centroid_.anchor(x, y);
        const float density = centroid_.density_at(anchor, 0, 0);
        const VoronoiCell cell = cell_of(row, dot, density);
        const Centroid centroid = centroid_.of(cell, anchor);
        to_x = x;
        to_y = y;
        if (!centroid.has_ink) return;
        float step_x = kOvershoot * centroid.x, step_y = kOvershoot * centroid.y;
        const float length2 = step_x * step_x + step_y * step_y;
        if (length2 > kCellReach * kCellReach) {
            const float shorter = kCellReach / std::sqrt(length2);
            step_x *= shorter;
            step_y *= shorter;
        }
        for (int i = 0; i < kShorterTries; ++i) {
            if (centroid_.density_at(anchor, step_x, step_y) > kLeastShare * density) {
                to_x = std::clamp(x + step_x, 0.0f, last_x_);
                to_y = std::clamp(y + step_y, 0.0f, last_y_);
                return;
            }
            step_x *= 0.5f;
            step_y *= 0.5f;
        }
    }

    // Other dots come in an order that follows from positions alone: first the nearest on either side in each
    // of the rows around, as many as dots of this density are apart, which make most cells small; then all
    // that reach it.
    VoronoiCell cell_of(std::int64_t row, std::size_t dot, float density) {
        const float x = rows_.x[dot], y = rows_.y[dot];
        const float apart_here = spacing_ / std::sqrt(std::max(density, 1e-6f));
        const float light = std::clamp((kBlackest - density) / (kBlackest - kLightest), 0.0f, 1.0f);
        // To where the cell ends at an edge so far away, at that place along it. Alike on all edges from
        // their middles on: a picture on its side has the same dots.
        const auto to_edge = [&](float away, float from_middle) {
            if (away - kFarFromEdge * apart_here > kCellReach) return kCellReach;
            const float t = std::abs(from_middle) / apart_here;
            const float waves = wave(t / kWaveLengths[0]) + wave(t / kWaveLengths[1]);
            const float waving = std::clamp(kBeyondEdge + kWaveHeight * waves, kLeastBeyond, kMostBeyond);
            const float beyond = kBeyondInBlack + light * (waving - kBeyondInBlack);
            return std::clamp(away + beyond * apart_here, 0.0f, kCellReach);
        };
        const float across = x - width_ / 2, down = y - height_ / 2;
        VoronoiCell cell(-to_edge(x, down), -to_edge(y, across), to_edge(width_ - x, down),
                         to_edge(height_ - y, across));
        const float* const xs = rows_.x.data();
        const float* const ys = rows_.y.data();
        const auto cut = [&](std::size_t other) {
            const float dx = xs[other] - x, dy = ys[other] - y;
            const float distance2 = dx * dx + dy * dy;
            if (distance2 < cell.reach2() && distance2 > 0) cell.cut(dx, dy);
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
    Stretch stretch_around(std::int64_t row, float x) {
        std::size_t& cursor = cursors_[static_cast<std::size_t>(row - first_near_)];
        const std::size_t end = rows_.end(row);
        const float* const xs = rows_.x.data();
        std::size_t at = cursor;
        while (at < end && xs[at] < x) ++at;
        cursor = at;
        return {rows_.begin(row), end, at, at};
    }

    const DotRows& rows_;
    const float width_, height_;  // of the page
    // The last places on it: on its right and lower edges there is no density any more.
    const float last_x_ = std::nextafter(width_, 0.0f), last_y_ = std::nextafter(height_, 0.0f);
    const float spacing_;  // of dots on black
    WeightedCentroid centroid_;
    std::int64_t first_near_ = 0;
    std::array<std::size_t, 2 * kFarthestRow + 1> cursors_{};
};

}  // namespace

double relaxing_rim(double scale, int steps) {
    // A step looks as far as dots cut cells, and the dots it finds came from a step's length further away;
    // the first from where they were stirred.
    const double step = std::ldexp(double{kCellReach} + kFarthestRow + 1, -depth_for(scale));
    return steps * step + farthest_stirred(scale);
}

double relaxing_row(double scale) {
    return std::ldexp(1.0, -depth_for(scale));
}

Relaxation::Relaxation(DotPieces dots, const Density& density, const RelaxingRequest& request)
    : density_(density), request_(request), depth_(depth_for(request.scale)), placed_(std::move(dots)) {
    rows_.assign(placed_, depth_, request.threads);
}

bool Relaxation::step(const std::stop_token& stop) {
    next_x_.resize(rows_.size());
    next_y_.resize(rows_.size());
    // Stretches of rows, as many dots in each.
    std::vector<std::int64_t> ends;
    std::size_t begun = 0;
    for (std::int64_t row = 0; row < rows_.rows(); ++row) {
        if (rows_.end(row) - begun < kDotsAtOnce && row + 1 < rows_.rows()) continue;
        ends.push_back(row + 1);
        begun = rows_.end(row);
    }
    for_each_on_threads(ends.size(), threads_for(request_.threads), [&](std::size_t i) {
        if (stop.stop_requested()) return;
        RowsMover mover(rows_, density_, request_.scale, depth_);
        for (std::int64_t row = i == 0 ? 0 : ends[i - 1]; row < ends[i]; ++row)
            mover.move_row(row, next_x_, next_y_);
    });
    if (stop.stop_requested()) return false;
    rows_.move(next_x_, next_y_, request_.threads);
    return true;
}

DotPieces Relaxation::dots() const {
    Dots all;
    all.x = rows_.x;
    all.y = rows_.y;
    const auto to_page = static_cast<float>(std::ldexp(1.0, -depth_));
    for (FloatBuffer* column : {&all.x, &all.y})
        for (float& position : *column) position *= to_page;
    for (FloatBuffer Dots::*column : {&Dots::threshold, &Dots::critical, &Dots::radius}) {
        FloatBuffer values;
        for (const Dots& piece : placed_.pieces)
            values.insert(values.end(), (piece.*column).begin(), (piece.*column).end());
        if (values.empty()) continue;
        (all.*column).resize(values.size());
        for (std::size_t i = 0; i < values.size(); ++i) (all.*column)[i] = values[rows_.numbers[i]];
    }
    return in_one_piece(std::move(all));
}

Dots Relaxation::dots_as_taken() const {
    Dots all;
    all.resize(rows_.size(), false);
    const auto to_page = static_cast<float>(std::ldexp(1.0, -depth_));
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        all.x[rows_.numbers[i]] = rows_.x[i] * to_page;
        all.y[rows_.numbers[i]] = rows_.y[i] * to_page;
    }
    return all;
}

bool relax(DotPieces& dots, const Density& density, int steps, const RelaxingRequest& request,
           const std::stop_token& stop) {
    if (steps == 0 || dots.size() == 0) return !stop.stop_requested();
    DotPieces stirred = dots;
    stir(stirred, density, request);
    Relaxation relaxation(std::move(stirred), density, request);
    for (int i = 0; i < steps; ++i)
        if (!relaxation.step(stop)) return false;
    dots = relaxation.dots();
    return true;
}

}  // namespace dapple
