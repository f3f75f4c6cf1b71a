#pragma once
// How even dots in space are, and whether they repeat.

#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace dapple {

/// The power spectrum |sum w exp(-2 pi i k x)|^2 / sum w^2 of dots in a cube of side 1, at all whole k from 3
/// up to `most` times the cube root of n: white noise has 1 on the mean, a pattern that repeats has peaks. w
/// is a window, the product of sin^2(pi x) of the axes, by which the cube's faces do not count; what it is
/// itself of the spectrum ends before 3.
struct VolumeSpectrum {
    struct Shell {
        double frequency = 0;  // over the cube root of n
        double power = 0;      // the mean
    };
    std::vector<Shell> shells;
    double highest = 0;           // of all k
    double power_below_half = 0;  // the mean up to half of the cube root of n
};
VolumeSpectrum volume_spectrum(std::span<const glm::dvec3> dots, double most = 2);

/// Each dot's distance to its nearest neighbour over the largest that all could have, as spheres are packed
/// closest: the mean, and the smallest. `volume` is what the dots fill.
struct VolumeDistances {
    double mean = 0, least = 0;
};
VolumeDistances volume_distances(std::span<const glm::dvec3> dots, double volume);

}  // namespace dapple
