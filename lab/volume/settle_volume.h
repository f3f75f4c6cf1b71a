#pragma once
// Dots in space move into better places: down the energy of Gaussian kernels that
// core/relaxing/energy_steps.h has in the plane (after Ahmed, Ren and Wonka 2022, "Gaussian Blue Noise"), in
// three dimensions.
//
// With rho the wanted dots per volume, as many in all as there are, a dot at x has a kernel of
// sigma = .45 rho^(-1/3), and moves against
//
//     F = sum over others of (x - y) s^-5 exp(-|x - y|^2 / (2 s^2))  +  (2 pi)^(3/2) grad(rho blurred by s),
//
// s^2 = 2 sigma^2. It never leaves the voxels that have a density.

#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "lab/volume/volume.h"

namespace dapple {

/// Told after each step; false ends it there.
using VolumeProgress = std::function<bool(int step)>;

/// Dots in voxels. The same for any number of threads.
void settle(std::vector<glm::dvec3>& dots, const Volume& volume, int steps,
            const VolumeProgress& progress = {});

}  // namespace dapple
