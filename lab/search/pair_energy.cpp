#include "lab/search/pair_energy.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace dapple {

namespace {

// Eight sums side by side, the same on every processor.
using Lanes = float __attribute__((vector_size(32), aligned(4), may_alias));

constexpr float kFarAway = 1e6f;

const Lanes& lanes(const std::array<float, 8>& a) {
    return *reinterpret_cast<const Lanes*>(a.data());
}

}  // namespace

double pair_energy(const PairShape& shape, double squared_distance) {
    const double tone = std::max(0.0, 1 - squared_distance / (16 * shape.tone_width * shape.tone_width));
    const double close = std::max(0.0, 1 - squared_distance / (shape.close_radius * shape.close_radius));
    return shape.tone_weight * std::pow(tone, 8) + shape.close_weight * close * close;
}

int EnergyGrid::cells_a_side(std::size_t tile_points, const PairShape& shape) {
    const double reach = std::max(4 * shape.tone_width, shape.close_radius);
    return std::max(1, static_cast<int>(std::sqrt(static_cast<double>(tile_points)) / reach));
}

EnergyGrid::EnergyGrid(std::size_t tile_points, const std::vector<Neighbour>& neighbours,
                       const PairShape& shape, int capacity)
    : capacity_((capacity + kLanes - 1) / kLanes * kLanes) {
    const double tile_side = std::sqrt(static_cast<double>(tile_points));
    side_ = cells_a_side(tile_points, shape);
    half_ = static_cast<float>(tile_side / 2);
    cells_per_spacing_ = static_cast<float>(side_ / tile_side);
    tone_ = static_cast<float>(1 / (16 * shape.tone_width * shape.tone_width));
    close_ = static_cast<float>(1 / (shape.close_radius * shape.close_radius));
    tone_weight_ = static_cast<float>(shape.tone_weight);
    close_weight_ = static_cast<float>(shape.close_weight);

    for (const Neighbour& n : neighbours) {
        const glm::dvec2 x = apply(n.orientation, glm::dvec2(1, 0));
        const glm::dvec2 y = apply(n.orientation, glm::dvec2(0, 1));
        const glm::dvec2 shift = glm::dvec2(n.offset) * tile_side;
        const auto f = [](double v) { return static_cast<float>(v); };
        copies_.push_back(
            {{f(x.x), f(y.x), f(shift.x), f(x.y), f(y.y), f(shift.y)}, n.offset, f(n.probability)});
    }

    // A cell of the ring shows one cell of the tile in up to eight orientations.
    std::uint32_t blocks = 0;
    for (int cell = 0; cell < (side_ + 2) * (side_ + 2); ++cell) {
        cells_.push_back({blocks, 0});
        blocks += static_cast<std::uint32_t>(capacity_ / kLanes * (is_inner(cell) ? 1 : 8));
    }
    Block empty{};
    empty.x.fill(kFarAway);
    blocks_.assign(blocks, empty);
}

bool EnergyGrid::is_inner(int cell) const {
    const int x = cell % (side_ + 2), y = cell / (side_ + 2);
    return x >= 1 && x <= side_ && y >= 1 && y <= side_;
}

int EnergyGrid::cell_of(glm::vec2 p) const {
    const int x = std::clamp(static_cast<int>((p.x + half_) * cells_per_spacing_), 0, side_ - 1);
    const int y = std::clamp(static_cast<int>((p.y + half_) * cells_per_spacing_), 0, side_ - 1);
    return (y + 1) * (side_ + 2) + x + 1;
}

template <class Visit>
void EnergyGrid::for_copies(glm::vec2 p, Visit visit) const {
    // Only what stands in the tile's outermost cells is seen from a neighbour.
    const int cell = cell_of(p), width = side_ + 2;
    const int cx = cell % width - 1, cy = cell / width - 1;
    if (cx > 0 && cy > 0 && cx < side_ - 1 && cy < side_ - 1) return;
    for (const Copy& copy : copies_) {
        const auto& m = copy.matrix;
        const glm::vec2 image(m[0] * p.x + m[1] * p.y + m[2], m[3] * p.x + m[4] * p.y + m[5]);
        const auto cell_on_axis = [&](float v, int offset) {
            const int c = static_cast<int>(std::floor((v + half_) * cells_per_spacing_)) - offset * side_;
            return std::clamp(c, 0, side_ - 1) + offset * side_;
        };
        const int x = cell_on_axis(image.x, copy.offset.x), y = cell_on_axis(image.y, copy.offset.y);
        if (x < -1 || y < -1 || x > side_ || y > side_) continue;
        visit((y + 1) * width + x + 1, image, copy.weight);
    }
}

bool EnergyGrid::fits(glm::vec2 p) const {
    return cells_[cell_of(p)].count < capacity_;
}

void EnergyGrid::add(int cell, glm::vec2 p, float weight, std::uint32_t name) {
    Cell& c = cells_[cell];
    assert(c.count < (is_inner(cell) ? capacity_ : 8 * capacity_));
    Block& block = blocks_[c.first_block + c.count / kLanes];
    const int lane = c.count++ % kLanes;
    block.x[lane] = p.x;
    block.y[lane] = p.y;
    block.weight[lane] = weight;
    block.name[lane] = name;
}

void EnergyGrid::take(int cell, glm::vec2 p, std::uint32_t name) {
    Cell& c = cells_[cell];
    for (int i = 0; i < c.count; ++i) {
        Block& block = blocks_[c.first_block + i / kLanes];
        const int lane = i % kLanes;
        if (block.name[lane] != name || block.x[lane] != p.x || block.y[lane] != p.y) continue;
        const int last = --c.count;
        Block& end = blocks_[c.first_block + last / kLanes];
        block.x[lane] = end.x[last % kLanes];
        block.y[lane] = end.y[last % kLanes];
        block.weight[lane] = end.weight[last % kLanes];
        block.name[lane] = end.name[last % kLanes];
        end.x[last % kLanes] = kFarAway;
        return;
    }
    assert(false && "the point is not in the grid");
}

void EnergyGrid::insert(glm::vec2 p, std::uint32_t name) {
    add(cell_of(p), p, 1, name);
    for_copies(p, [&](int cell, glm::vec2 image, float weight) { add(cell, image, weight, name); });
}

void EnergyGrid::remove(glm::vec2 p, std::uint32_t name) {
    take(cell_of(p), p, name);
    for_copies(p, [&](int cell, glm::vec2 image, float) { take(cell, image, name); });
}

void EnergyGrid::find_near(glm::vec2 p, float radius, std::vector<std::uint32_t>& names) const {
    names.clear();
    const int width = side_ + 2, centre = cell_of(p);
    for (int row = centre - width; row <= centre + width; row += width) {
        for (int cell = row - 1; cell <= row + 1; ++cell) {
            if (!is_inner(cell)) continue;
            const Cell& c = cells_[cell];
            for (int i = 0; i < c.count; ++i) {
                const Block& block = blocks_[c.first_block + i / kLanes];
                const float dx = block.x[i % kLanes] - p.x, dy = block.y[i % kLanes] - p.y;
                if (dx * dx + dy * dy <= radius * radius) names.push_back(block.name[i % kLanes]);
            }
        }
    }
}

double EnergyGrid::energy(glm::vec2 p) const {
    const int width = side_ + 2, centre = cell_of(p);
    const Lanes zero{};
    Lanes tone_sum{}, close_sum{};
    for (int row = centre - width; row <= centre + width; row += width) {
        for (int cell = row - 1; cell <= row + 1; ++cell) {
            const Cell& c = cells_[cell];
            const Block* block = &blocks_[c.first_block];
            for (int i = 0; i < c.count; i += kLanes, ++block) {
                const Lanes dx = lanes(block->x) - p.x, dy = lanes(block->y) - p.y;
                const Lanes d2 = dx * dx + dy * dy;
                const Lanes weight = lanes(block->weight);
                Lanes t = 1.0f - d2 * tone_;
                t = t > zero ? t : zero;
                t = t * t;
                t = t * t;
                Lanes s = 1.0f - d2 * close_;
                s = s > zero ? s : zero;
                tone_sum += weight * (t * t);
                close_sum += weight * (s * s);
            }
        }
    }
    const Lanes sum = tone_weight_ * tone_sum + close_weight_ * close_sum;
    return static_cast<double>(((sum[0] + sum[1]) + (sum[2] + sum[3])) +
                               ((sum[4] + sum[5]) + (sum[6] + sum[7])));
}

double EnergyGrid::energy_with_itself(glm::vec2 p) const {
    float sum = 0;
    for_copies(p, [&](int, glm::vec2 image, float weight) {
        const float d2 = (image.x - p.x) * (image.x - p.x) + (image.y - p.y) * (image.y - p.y);
        const float t = std::max(0.0f, 1 - d2 * tone_), s = std::max(0.0f, 1 - d2 * close_);
        const float t4 = (t * t) * (t * t);
        sum += weight * (tone_weight_ * (t4 * t4) + close_weight_ * (s * s));
    });
    return 0.5 * static_cast<double>(sum);
}

}  // namespace dapple
