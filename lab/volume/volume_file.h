#pragma once
// Volumes and point clouds in files.
//
//     .nrrd             a block of voxels: NRRD, raw and in the same file, of 8- and 16-bit whole numbers or
//                       floats (teem.sourceforge.net/nrrd/format.html); what says where voxels lie is
//                       followed or refused: the block may be moved and stretched along its axes, but not
//                       turned
//     pictures          a slice each, from the lowest z on, all of one size; light is dense
//     .ply              points: ASCII or binary; of each vertex x, y and z count, in double precision
//                       (Turk 1994)

#include <filesystem>
#include <functional>
#include <glm/vec3.hpp>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "lab/volume/volume.h"

namespace dapple {

/// All throw std::runtime_error naming the file and what is wrong with it.
Volume read_nrrd(const std::filesystem::path& file);
/// What is transparent is empty. `tell` is called with what people should know of how a picture was read.
using TellRemark = std::function<void(const std::filesystem::path&, const std::string&)>;
Volume read_slices(std::span<const std::filesystem::path> pictures, const TellRemark& tell = {});
std::vector<glm::dvec3> read_ply(const std::filesystem::path& file);

/// Binary, little-endian: floats where all numbers are just such, as those of a density are, else doubles.
void write_ply(std::ostream& out, std::span<const glm::dvec3> points);
/// x,y,z and a line for each, with as many digits as tell a number from others of its kind, float or double.
void write_points_csv(std::ostream& out, std::span<const glm::dvec3> points);

}  // namespace dapple
