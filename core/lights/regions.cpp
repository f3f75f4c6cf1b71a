#include "core/lights/regions.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

#include "core/lights/direction.h"
#include "core/maths/portable_math.h"
#include "core/tile/random.h"

namespace dapple {

namespace {

constexpr std::int32_t kNobody = -1;
constexpr double kOwnersShare = 0.5;  // of the time that sharing takes

// A map's patches: column i lies between texel columns i - 1 and i, row j between texel rows j - 1 and j; the
// outermost rows are half as high.
struct PatchGrid {
    int width, texel_rows;

    int rows() const { return texel_rows + 1; }
    std::size_t size() const { return static_cast<std::size_t>(width) * rows(); }
    int left(int column) const { return column == 0 ? width - 1 : column - 1; }
    int right(int column) const { return column == width - 1 ? 0 : column + 1; }

    std::size_t index(int column, int row) const { return static_cast<std::size_t>(row) * width + column; }

    std::size_t patch_at(glm::dvec2 uv) const {
        const int column = static_cast<int>(uv.x * width + 0.5) % width;
        const int row = std::clamp(static_cast<int>(uv.y * texel_rows + 0.5), 0, texel_rows);
        return index(column, row);
    }
};

// The dots of each patch: those of patch p are order[start[p]] up to order[start[p + 1]].
struct DotsByPatch {
    std::vector<std::uint32_t> start, order;

    std::span<const std::uint32_t> of(std::size_t patch) const {
        return {order.data() + start[patch], start[patch + 1] - start[patch]};
    }

    DotsByPatch(const PatchGrid& grid, std::span<const glm::dvec2> dots)
        : start(grid.size() + 1), order(dots.size()) {
        std::vector<std::uint32_t> patch(dots.size());
        for (std::size_t i = 0; i < dots.size(); ++i) {
            patch[i] = static_cast<std::uint32_t>(grid.patch_at(dots[i]));
            ++start[patch[i] + 1];
        }
        for (std::size_t p = 1; p < start.size(); ++p) start[p] += start[p - 1];
        std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
        for (std::size_t i = 0; i < dots.size(); ++i) order[next[patch[i]]++] = static_cast<std::uint32_t>(i);
    }
};

// Cosines and sines along the axes: a direction is one of each.
struct Ring {
    std::vector<double> cosine, sine;

    Ring(int count, double first, double step) : cosine(count), sine(count) {
        for (int i = 0; i < count; ++i) {
            cosine[i] = portable::cos(first + i * step);
            sine[i] = portable::sin(first + i * step);
        }
    }
};

// OpenEXR: u = 1/2 is +Z and u = 1/4 is +X.
double azimuth(double u) {
    return 2 * std::numbers::pi * (0.5 - u);
}

// Hands owners on until every patch has one, or somebody who watches gives up.
class Owners {
 public:
    Owners(const PatchGrid& grid, std::span<const glm::dvec2> dots, const DotsByPatch& by_patch,
           const LightWatch& watch)
        : grid_(grid),
          owner_(grid.size(), kNobody),
          distance_(grid.size(), std::numeric_limits<float>::max()) {
        const Ring around(grid.width, azimuth(0), -2 * std::numbers::pi / grid.width);
        const Ring down(grid.rows(), 0, std::numbers::pi / grid.texel_rows);
        around_cosine_.assign(around.cosine.begin(), around.cosine.end());
        around_sine_.assign(around.sine.begin(), around.sine.end());
        down_cosine_.assign(down.cosine.begin(), down.cosine.end());
        down_sine_.assign(down.sine.begin(), down.sine.end());
        dot_direction_.reserve(dots.size());
        for (const glm::dvec2 uv : dots)
            dot_direction_.push_back(glm::vec3(direction_of(uv, SphereConvention::openexr)));
        for (std::size_t p = 0; p < owner_.size(); ++p) {
            if (by_patch.of(p).empty()) continue;
            owner_[p] = static_cast<std::int32_t>(by_patch.of(p).front());
            distance_[p] = -1;  // a patch with dots keeps them
        }
        const int last = grid.rows() - 1;
        const double a_row = kOwnersShare / (2 * grid.rows());
        spread_along(0);
        for (int row = 1; row <= last && watch.goes_on(row * a_row); ++row) spread_from(row - 1, row);
        spread_along(last);
        for (int row = last - 1; row >= 0 && watch.goes_on((2 * last - row) * a_row); --row)
            spread_from(row + 1, row);
    }

    std::int32_t at(int column, int row) const { return owner_[grid_.index(column, row)]; }

 private:
    // Whether the patch is the candidate's now and was not before.
    bool offer(std::int32_t candidate, std::size_t patch, int column, int row) {
        if (candidate == owner_[patch] || candidate == kNobody || distance_[patch] < 0) return false;
        const glm::vec3 here(down_sine_[row] * around_sine_[column], down_cosine_[row],
                             down_sine_[row] * around_cosine_[column]);
        const glm::vec3 d = dot_direction_[candidate] - here;
        const float distance = d.x * d.x + d.y * d.y + d.z * d.z;
        if (distance >= distance_[patch]) return false;
        distance_[patch] = distance;
        owner_[patch] = candidate;
        return true;
    }

    void spread_from(int source, int row) {
        for (int x = 0; x < grid_.width; ++x) {
            const std::size_t patch = grid_.index(x, row);
            offer(owner_[grid_.index(grid_.left(x), source)], patch, x, row);
            offer(owner_[grid_.index(x, source)], patch, x, row);
            offer(owner_[grid_.index(grid_.right(x), source)], patch, x, row);
        }
        spread_along(row);
    }

    // Around each way, and on across the seam as long as that brings something.
    void spread_along(int row) {
        for (int x = 0; x < grid_.width; ++x) pass(grid_.left(x), x, row);
        for (int x = 0; x < grid_.width && pass(grid_.left(x), x, row);) ++x;
        for (int x = grid_.width - 1; x >= 0; --x) pass(grid_.right(x), x, row);
        for (int x = grid_.width - 1; x >= 0 && pass(grid_.right(x), x, row);) --x;
    }

    bool pass(int from, int to, int row) {
        const std::size_t patch = grid_.index(to, row);
        return offer(owner_[grid_.index(from, row)], patch, to, row);
    }

    PatchGrid grid_;
    std::vector<float> around_cosine_, around_sine_, down_cosine_, down_sine_;
    std::vector<glm::vec3> dot_direction_;
    std::vector<std::int32_t> owner_;
    std::vector<float> distance_;  // squared, along the chord
};

// What the two texels of one row give to the patch between them, the same to the patch above as to the one
// below: a quarter each. Within its quarter of a patch a texel's light has its centre of gravity a third of a
// texel from the texel's centre.
struct Pair {
    glm::dvec3 flux;
    double power;
    double x, z;  // of the moment, but for the height's sine
};

class TexelPairs {
 public:
    TexelPairs(const EnvironmentMap& map, const Grid<float>& power)
        : map_(map),
          power_(power),
          before_(map.width(), azimuth((0.5 - kThird) / map.width()), -2 * std::numbers::pi / map.width()),
          after_(map.width(), azimuth((0.5 + kThird) / map.width()), -2 * std::numbers::pi / map.width()) {}

    // Pair i is that of columns i - 1 and i.
    void of_row(int row, std::vector<Pair>& pairs) const {
        const glm::vec3* const radiance = map_.radiance().row(row);
        const double share = map_.solid_angle(row) / 4;
        const int width = map_.width();
        glm::dvec3 left = share * glm::dvec3(radiance[width - 1]);
        double left_power = power_.at(width - 1, row) / 4.0;
        for (int i = 0; i < width; ++i) {
            const int l = i == 0 ? width - 1 : i - 1;
            const glm::dvec3 right = share * glm::dvec3(radiance[i]);
            const double right_power = power_.at(i, row) / 4.0;
            pairs[i] = {left + right, left_power + right_power,
                        left_power * after_.sine[l] + right_power * before_.sine[i],
                        left_power * after_.cosine[l] + right_power * before_.cosine[i]};
            left = right;
            left_power = right_power;
        }
    }

 private:
    static constexpr double kThird = 1.0 / 3;

    const EnvironmentMap& map_;
    const Grid<float>& power_;
    Ring before_, after_;  // by column: a third of a texel to the left and to the right of its centre
};

// The height of a texel row's light within the patches above or below it, and its solid angle in one.
struct RowPart {
    double sine = 0, cosine = 0, solid_angle = 0;
};

enum class Side { above, below };

RowPart part_of_row(const EnvironmentMap& map, int row, Side side) {
    const int height = map.height();
    double centre = side == Side::above ? row + 0.5 - 1.0 / 3 : row + 0.5 + 1.0 / 3;
    // The outermost half rows are even.
    if (side == Side::above && row == 0) centre = 0.25;
    if (side == Side::below && row == height - 1) centre = height - 0.25;
    const double theta = std::numbers::pi * centre / height;
    return {portable::sin(theta), portable::cos(theta), map.solid_angle(row) / 2};
}

void add(LightRegion& whole, const Pair& pair, const RowPart& part) {
    whole.flux += pair.flux;
    whole.power += pair.power;
    whole.solid_angle += part.solid_angle;
    whole.moment += glm::dvec3(part.sine * pair.x, part.cosine * pair.power, part.sine * pair.z);
}

void add(LightRegion& region, const LightRegion& patch, double share, const glm::dvec3& moved) {
    region.flux += share * patch.flux;
    region.power += share * patch.power;
    region.solid_angle += share * patch.solid_angle;
    region.moment += share * (patch.moment + patch.power * moved);
}

// A texel drawn for each region: every quarter of a patch replaces what was drawn before with its share of
// the power so far.
void draw_places(const Grid<float>& power, const PatchGrid& grid, const DotsByPatch& by_patch,
                 const Owners& owners, Random random, std::vector<LightRegion>& regions) {
    std::vector<double> so_far(regions.size());
    const auto offer = [&](std::size_t dot, int column, int row, double part) {
        so_far[dot] += part;
        if (!(part > 0) || random.unit() * so_far[dot] >= part) return;
        regions[dot].drawn = {(column + 0.5) / power.width, (row + 0.5) / power.height};
    };
    for (int j = 0; j < grid.rows(); ++j) {
        for (const int row : {j - 1, j}) {
            if (row < 0 || row >= power.height) continue;
            for (int i = 0; i < grid.width; ++i) {
                const std::span own = by_patch.of(grid.index(i, j));
                for (const int column : {grid.left(i), i}) {
                    const double quarter = power.at(column, row) / 4.0;
                    if (own.size() < 2) {
                        offer(owners.at(i, j), column, row, quarter);
                        continue;
                    }
                    const double share = quarter / static_cast<double>(own.size());
                    for (const std::uint32_t dot : own) offer(dot, column, row, share);
                }
            }
        }
    }
}

}  // namespace

std::vector<LightRegion> share_light(const EnvironmentMap& map, const Grid<float>& power,
                                     std::span<const glm::dvec2> dots, std::optional<std::uint64_t> seed,
                                     const LightWatch& watch) {
    const PatchGrid grid{map.width(), map.height()};
    const DotsByPatch by_patch(grid, dots);
    const Owners owners(grid, dots, by_patch, watch);
    const TexelPairs pairs(map, power);

    std::vector<LightRegion> regions(dots.size());
    std::vector<Pair> above(grid.width), below(grid.width);
    for (int j = 0; j < grid.rows(); ++j) {
        if (!watch.goes_on(kOwnersShare + (1 - kOwnersShare) * j / grid.rows())) return {};
        RowPart upper, lower;
        std::swap(above, below);
        if (j > 0) {
            upper = part_of_row(map, j - 1, Side::below);
        } else {
            std::ranges::fill(above, Pair{});
        }
        if (j < map.height()) {
            lower = part_of_row(map, j, Side::above);
            pairs.of_row(j, below);
        } else {
            std::ranges::fill(below, Pair{});
        }
        for (int i = 0; i < grid.width; ++i) {
            LightRegion patch;
            add(patch, above[i], upper);
            add(patch, below[i], lower);
            const std::span own = by_patch.of(grid.index(i, j));
            if (own.size() < 2) {
                add(regions[owners.at(i, j)], patch, 1, {});
                continue;
            }
            // Dots that share a patch keep their places about its centre of gravity.
            const double share = 1.0 / static_cast<double>(own.size());
            glm::dvec3 middle{};
            for (const std::uint32_t dot : own)
                middle += share * direction_of(dots[dot], SphereConvention::openexr);
            for (const std::uint32_t dot : own) {
                add(regions[dot], patch, share, direction_of(dots[dot], SphereConvention::openexr) - middle);
            }
        }
    }
    if (seed) draw_places(power, grid, by_patch, owners, Random(*seed), regions);
    return regions;
}

}  // namespace dapple
