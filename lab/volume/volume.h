#pragma once
// A density in space, as a block of voxels.

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "lab/volume/cyclic_tile.h"

namespace dapple {

inline constexpr std::size_t kMostVoxels = std::size_t{1} << 28;

/// Voxels, x running fastest, then y. Each is a cube of one density.
struct Volume {
    glm::ivec3 size{0};
    std::vector<float> density;   // 0 or more, at least one above
    glm::dvec3 spacing{1, 1, 1};  // how large a voxel is, in whatever unit; for what is written
    glm::dvec3 corner{0, 0, 0};   // where the first voxel begins, in the same unit

    float at(const glm::ivec3& voxel) const {
        return density[(static_cast<std::size_t>(voxel.z) * size.y + voxel.y) * size.x + voxel.x];
    }
    /// At a place in voxels; 0 beyond the block.
    float at(const glm::dvec3& place) const;
};

/// Throws std::runtime_error if there are no voxels or over kMostVoxels, one is below 0 or not a number, or
/// none is above 0.
void check_volume(const Volume& volume);

/// So many by as many by as many voxels: an even cube, a ball that is denser towards its middle, and a
/// gyroid's sheet.
Volume cube_volume(int side = 64);
Volume ball_volume(int side = 64);
Volume gyroid_volume(int side = 64);

/// Exactly `count` dots, those of the lowest critical scale, in voxels. Throws std::runtime_error as
/// check_volume() does, or if there are none to place.
std::vector<glm::dvec3> place_in_volume(const CyclicTile<2, 3>& tile, const Volume& volume,
                                        std::size_t count);

/// The tile that volumes are filled with: 64 points, the largest smallest distance of many words.
CyclicTile<2, 3> volume_tile();

}  // namespace dapple
