#include "core/placing/square_emitter.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dapple {

namespace {

constexpr std::size_t kFirstCapacity = 1024;
constexpr float kCloseBounds = 0.95f;

// Columns are used to their full capacity while dots are appended.
void resize_all(Dots& dots, std::size_t count, bool critical) {
    dots.x.resize(count);
    dots.y.resize(count);
    dots.threshold.resize(count);
    dots.critical.resize(critical ? count : 0);
}

}  // namespace

SquareEmitter::SquareEmitter(const Traversal& traversal, Dots& dots, EmitterMemory& memory)
    : traversal_(traversal), dots_(dots), memory_(memory), kernels_(best_kernels()) {
    capacity_ = std::max(kFirstCapacity, dots.x.capacity());
    resize_all(dots_, capacity_, traversal_.request().critical);
    if (traversal_.early_share()) memory_.late.resize(std::max(kFirstCapacity, memory_.late.capacity()));
}

SquareEmitter::~SquareEmitter() {
    resize_all(dots_, count_, traversal_.request().critical);
    memory_.late.resize(late_);
}

void SquareEmitter::emit(const Visit& visit) {
    if (traversal_.level(visit) < 0) return;
    const Cell& cell = traversal_.table().cells[visit.cell];
    emit_points(visit, traversal_.level(visit) == 0 ? cell.all : cell.newborn);
}

void SquareEmitter::emit_points(const Visit& visit, const CellPoints& points) {
    const DepthScale& scale = traversal_.at_depth(visit.square.depth);
    const Bounds& bounds = visit.density.bounds;
    const double reached = scale.births_per_density * bounds.max;
    const SwapAndSigns steps = steps_of(visit.orientation);
    const glm::dvec2 centre = traversal_.corner_in_window(visit.square) + scale.half;
    KernelSquare square;
    square.points = points.blocks();
    square.swap = steps.swap;
    square.sign_x = steps.negate_x ? -1.0f : 1.0f;
    square.sign_y = steps.negate_y ? -1.0f : 1.0f;
    square.centre_x = static_cast<float>(centre.x);
    square.centre_y = static_cast<float>(centre.y);
    square.half_x = square.sign_x * static_cast<float>(scale.half);
    square.half_y = square.sign_y * static_cast<float>(scale.half);
    square.births_per_density = static_cast<float>(scale.births_per_density);
    square.none_from = static_cast<float>(reached);
    double sure_per_density = scale.births_per_density;
    if (const auto early = traversal_.early_share()) {
        sure_per_density *= *early;
        square.early_per_density = static_cast<float>(sure_per_density);
    }
    square.sure_below = static_cast<float>(sure_per_density * bounds.min);
    square.threshold_per_birth = scale.threshold_per_birth;
    // Where the window or the picture ends within the square, only some of the points take part.
    const Density& density = traversal_.density();
    const bool in_picture = static_cast<double>(visit.square.x + 1) * scale.side_pixels <= density.width() &&
                            static_cast<double>(visit.square.y + 1) * scale.side_pixels <= density.height();
    std::size_t most = points.size();
    if (!visit.in_window || !in_picture) {
        const CellPoints& taken = filtered(visit, points, square);
        most = taken.size();
        square.points = taken.blocks();
        square.swap = false;
    }
    const KernelOutput output = room_for(most + kKernelPadding);
    PlacedCount placed;
    if (!bounds_may_decide(square) || !kernels_.place_sure(square, output, placed)) {
        const bool across_seam = set_density(visit, square);
        placed = across_seam ? emit_across_seam(square, output) : kernels_.place(square, output);
    }
    count_ += placed.dots;
    late_ += placed.late;
}

// Whether trying without the density is worth it: the bounds are close, or beyond the last birth.
bool SquareEmitter::bounds_may_decide(const KernelSquare& square) const {
    if (traversal_.request().critical) return false;
    return square.sure_below > kCloseBounds * square.none_from ||
           square.sure_below > 4 * static_cast<float>(traversal_.table().tile_size);
}

// Says how the kernel finds the density. True if it can't: a large square at the seam of a map that wraps
// round.
bool SquareEmitter::set_density(const Visit& visit, KernelSquare& square) const {
    if (visit.density.is_patch) {
        square.source = KernelSquare::Source::patch;
        square.c0 = static_cast<float>(visit.density.patch.c);
        square.cx = static_cast<float>(visit.density.patch.x);
        square.cy = static_cast<float>(visit.density.patch.y);
        square.cxy = static_cast<float>(visit.density.patch.xy);
        return false;
    }
    const Density& density = traversal_.density();
    const bool small = visit.square.depth >= density.small_depth();
    const PixelRange range = small ? visit.density.pixels : density.pixels_in(visit.square);
    const double side = traversal_.at_depth(visit.square.depth).side_pixels;
    const auto from_first = [&](std::int64_t corner, std::int64_t first) {
        return static_cast<float>((static_cast<double>(corner) + 0.5) * side - 0.5 -
                                  static_cast<double>(first));
    };
    square.pixel_half_x = square.sign_x * static_cast<float>(side / 2);
    square.pixel_half_y = square.sign_y * static_cast<float>(side / 2);
    square.pixel_centre_x = from_first(visit.square.x, range.first_column);
    square.pixel_centre_y = from_first(visit.square.y, range.first_row);
    square.picture = density.values().values.data();
    square.width = density.width();
    square.height = density.height();
    square.first_column = static_cast<int>(range.first_column);
    square.first_row = static_cast<int>(range.first_row);

    // One pixel to spare: a rounded position may lie on the last column, whose right neighbour is then read.
    const bool in_picture = range.first_column >= 0 && range.first_row >= 0 &&
                            range.last_column + 1 < density.width() && range.last_row + 1 < density.height();
    if (range.last_column - range.first_column < 4 && range.last_row - range.first_row < 4) {
        square.source = KernelSquare::Source::block;
        for (std::int64_t j = range.first_row; j <= range.last_row; ++j) {
            float* const row = square.block + 4 * (j - range.first_row);
            for (std::int64_t i = range.first_column; i <= range.last_column; ++i) {
                row[i - range.first_column] =
                    in_picture ? density.values().row(static_cast<int>(j))[i] : density.pixel(i, j);
            }
        }
        return false;
    }
    square.source = in_picture ? KernelSquare::Source::picture : KernelSquare::Source::clamped;
    return !in_picture && density.seam() == Seam::wrap;
}

// The points of a square that lie in the window and in the picture, decided on exact positions: the
// neighbouring window decides the same, so that sheets join without a lost or doubled dot.
const CellPoints& SquareEmitter::filtered(const Visit& visit, const CellPoints& points,
                                          const KernelSquare& square) {
    const Traversal::Box& box = traversal_.window();
    const Density& density = traversal_.density();
    const int shift = 61 - visit.square.depth;  // half the side is 2^shift units
    const double half = std::ldexp(1.0, shift), pixels_per_unit = std::ldexp(density.longer_side(), -62);
    const std::int64_t centre_x = (2 * visit.square.x + 1) << shift, centre_y = (2 * visit.square.y + 1)
                                                                                << shift;

    CellPoints& kept = memory_.edge;
    kept.clear();
    for (std::size_t i = 0; i < points.size(); ++i) {
        CellPoint point = points[i];
        if (square.swap) std::swap(point.x, point.y);
        const std::int64_t x = centre_x + std::llround(half * (square.sign_x * point.x));
        const std::int64_t y = centre_y + std::llround(half * (square.sign_y * point.y));
        if (x < box.low_x || y < box.low_y || x >= box.high_x || y >= box.high_y) continue;
        if (static_cast<double>(x) * pixels_per_unit >= density.width()) continue;
        if (static_cast<double>(y) * pixels_per_unit >= density.height()) continue;
        kept.add(point);
    }
    return kept;
}

// As the kernels do it, but the pixels beyond the left and right edges are those of the other side.
PlacedCount SquareEmitter::emit_across_seam(const KernelSquare& s, const KernelOutput& output) const {
    const Density& density = traversal_.density();
    PlacedCount placed;
    for (std::size_t i = 0;; ++i) {
        const PointBlock& points = s.points[i / kBlockPoints];
        const std::size_t at = i % kBlockPoints;
        const float x = points.at[s.swap][at], y = points.at[!s.swap][at], birth = points.birth[at];
        if (!(birth < s.none_from)) return placed;
        const float u = s.pixel_centre_x + s.pixel_half_x * x, v = s.pixel_centre_y + s.pixel_half_y * y;
        const float left = std::floor(u), top = std::floor(v), fx = u - left, fy = v - top;
        const std::int64_t column = s.first_column + static_cast<std::int64_t>(left);
        const std::int64_t row = s.first_row + static_cast<std::int64_t>(top);
        const float v00 = density.pixel(column, row), v10 = density.pixel(column + 1, row);
        const float v01 = density.pixel(column, row + 1), v11 = density.pixel(column + 1, row + 1);
        const float upper = v00 + (v10 - v00) * fx, lower = v01 + (v11 - v01) * fx;
        const float d = upper + (lower - upper) * fy;
        if (!(d * s.births_per_density > birth)) continue;
        output.x[placed.dots] = s.centre_x + s.half_x * x;
        output.y[placed.dots] = s.centre_y + s.half_y * y;
        const float threshold = birth * s.threshold_per_birth;
        output.threshold[placed.dots] = threshold;
        if (output.critical) output.critical[placed.dots] = threshold / d;
        if (output.late && !(d * s.early_per_density > birth))
            output.late[placed.late++] = {output.first_index + placed.dots, threshold / d};
        ++placed.dots;
    }
}

KernelOutput SquareEmitter::room_for(std::size_t count) {
    const bool critical = traversal_.request().critical;
    if (count_ + count > capacity_) {
        capacity_ = std::max(count_ + count, capacity_ + capacity_ / 2);
        resize_all(dots_, capacity_, critical);
    }
    const bool late = traversal_.early_share().has_value();
    if (late && late_ + count > memory_.late.size()) {
        memory_.late.resize(std::max(late_ + count, late_ + late_ / 2));
    }
    return {dots_.x.data() + count_,
            dots_.y.data() + count_,
            dots_.threshold.data() + count_,
            critical ? dots_.critical.data() + count_ : nullptr,
            late ? memory_.late.data() + late_ : nullptr,
            count_};
}

}  // namespace dapple
