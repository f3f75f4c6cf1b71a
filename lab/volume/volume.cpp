#include "lab/volume/volume.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <stdexcept>

namespace dapple {
namespace {

// The densest voxel of ever larger cubes of voxels, twice as wide each: what no place of a cell exceeds.
class Densest {
 public:
    /// A cell of level 0 is a cube of so many voxels, a power of two.
    Densest(const Volume& volume, int side) {
        const int levels = std::countr_zero(static_cast<unsigned>(side)) + 1;
        levels_.resize(static_cast<std::size_t>(levels));
        Volume* finest = &levels_.back();
        finest->size = volume.size;
        finest->density = volume.density;
        for (std::size_t level = levels_.size() - 1; level > 0; --level)
            halve(levels_[level], levels_[level - 1]);
    }

    double most(const SubdivisionCell<3>& cell) const {
        const int finest = static_cast<int>(levels_.size()) - 1, level = std::min(cell.level, finest);
        const glm::ivec3 place(cell.place >> std::int64_t{cell.level - level});
        const Volume& densest = levels_[static_cast<std::size_t>(level)];
        for (int axis = 0; axis < 3; ++axis)
            if (place[axis] >= densest.size[axis]) return 0;
        return densest.at(place);
    }

 private:
    static void halve(const Volume& fine, Volume& coarse) {
        coarse.size = (fine.size + 1) / 2;
        coarse.density.assign(static_cast<std::size_t>(coarse.size.x) * coarse.size.y * coarse.size.z, 0);
        std::size_t i = 0;
        for (int z = 0; z < fine.size.z; ++z)
            for (int y = 0; y < fine.size.y; ++y)
                for (int x = 0; x < fine.size.x; ++x, ++i) {
                    float& most = coarse.density[(static_cast<std::size_t>(z / 2) * coarse.size.y + y / 2) *
                                                     coarse.size.x +
                                                 x / 2];
                    most = std::max(most, fine.density[i]);
                }
    }

    std::vector<Volume> levels_;
};

template <class Density>
Volume volume_of(int side, const Density& density) {
    Volume volume{.size = glm::ivec3(side), .density = {}};
    for (int z = 0; z < side; ++z)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                volume.density.push_back(
                    static_cast<float>(density((glm::dvec3(x, y, z) + 0.5) / double(side))));
    return volume;
}

}  // namespace

float Volume::at(const glm::dvec3& place) const {
    const glm::ivec3 voxel(glm::floor(place));
    for (int axis = 0; axis < 3; ++axis)
        if (voxel[axis] < 0 || voxel[axis] >= size[axis]) return 0;
    return at(voxel);
}

void check_volume(const Volume& volume) {
    const auto voxels = static_cast<double>(volume.size.x) * volume.size.y * volume.size.z;
    if (volume.size.x < 1 || volume.size.y < 1 || volume.size.z < 1)
        throw std::runtime_error("a volume without voxels");
    if (voxels > static_cast<double>(kMostVoxels))
        throw std::runtime_error(fmt::format("{} x {} x {} voxels; there may be {} in all", volume.size.x,
                                             volume.size.y, volume.size.z, kMostVoxels));
    bool any = false;
    for (const float density : volume.density) {
        if (!(density >= 0 && std::isfinite(density)))
            throw std::runtime_error(
                fmt::format("a density of {:g}; it has to be a number, 0 or more", density));
        any |= density > 0;
    }
    if (!any) throw std::runtime_error("all voxels are 0, so there is nowhere to place a dot");
}

Volume cube_volume(int side) {
    return volume_of(side, [](const glm::dvec3&) { return 1; });
}

Volume ball_volume(int side) {
    return volume_of(side, [](const glm::dvec3& place) {
        const double radius = 2 * glm::length(place - 0.5);
        return radius < 1 ? 1.2 - radius : 0;
    });
}

Volume gyroid_volume(int side) {
    return volume_of(side, [](const glm::dvec3& place) {
        const glm::dvec3 at = place * (4 * std::numbers::pi), sine = glm::sin(at), cosine = glm::cos(at);
        return std::abs(sine.x * cosine.y + sine.y * cosine.z + sine.z * cosine.x) < 0.25 ? 1 : 0;
    });
}

std::vector<glm::dvec3> place_in_volume(const CyclicTile<2, 3>& tile, const Volume& volume,
                                        std::size_t count) {
    check_volume(volume);
    if (count == 0) throw std::runtime_error("0 dots; give 1 or more");
    const int longest = std::max({volume.size.x, volume.size.y, volume.size.z});
    const auto side = static_cast<double>(std::bit_ceil(static_cast<unsigned>(longest)));
    const Densest densest(volume, static_cast<int>(side));
    double sum = 0;
    for (const float density : volume.density) sum += density;
    const auto wanted = static_cast<double>(count);
    std::vector<CriticalDot<3>> dots;
    // Estimated, and then as much more as are missing.
    for (double scale = wanted * std::pow(side, 3) / sum; dots.size() < count;
         scale *= std::clamp(1.1 * wanted / (static_cast<double>(dots.size()) + 1), 1.02, 2.0))
        dots = subdivided(
            tile, scale, [&](const SubdivisionCell<3>& cell) { return densest.most(cell); },
            [&](const glm::dvec3& place) { return static_cast<double>(volume.at(place * side)); });
    // Those of equal critical scale in the order of the subdivision.
    std::vector<std::size_t> first(dots.size());
    for (std::size_t i = 0; i < first.size(); ++i) first[i] = i;
    const auto earlier = [&](std::size_t a, std::size_t b) {
        return dots[a].critical != dots[b].critical ? dots[a].critical < dots[b].critical : a < b;
    };
    std::nth_element(first.begin(), first.begin() + static_cast<std::ptrdiff_t>(count - 1), first.end(),
                     earlier);
    first.resize(count);
    std::ranges::sort(first);
    std::vector<glm::dvec3> places;
    for (const std::size_t i : first) places.push_back(dots[i].place * side);
    return places;
}

CyclicTile<2, 3> volume_tile() {
    return make_cyclic_tile<2, 3>(
        letters_of("4325775302242455003047651206051661174132141064674620375561732373"));
}

}  // namespace dapple
