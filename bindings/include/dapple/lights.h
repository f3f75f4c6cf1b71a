#pragma once
// An environment map as a number of small lights, for renderers (Lagae & Dutré 2006, figure 7).

#include <cstdint>
#include <span>
#include <vector>

#include "dapple/export.h"

namespace dapple {

struct LightSampling {
    std::uint64_t count = 1024;  // exactly so many, 1 .. 10,000,000
    std::uint64_t seed = 0;      // 0: the tile as it lies; else it is turned about the up axis
    int threads = 0;             // up to 1024; the samples are the same for any number; 0: one for each core
};

/// A distant light that stands for a region of the map.
struct SampledLight {
    double direction[3] = {};  // towards the light, of length 1: y is up, the middle of the map is at +z
    double u = 0, v = 0;       // on the map, 0..1, from its left and from its top
    double weight[3] = {};     // irradiance on a surface that faces it, linear red, green and blue
    double pdf = 0;            // samples per steradian there, over their number
};

/// `radiance`: linear red, green and blue, width * height of them, row after row from straight up to straight
/// down. The weights sum to the map's flux. The most important come first: the first n are a set of their own
/// once the weight of each of the others goes to the nearest of them. Throws std::runtime_error if the map is
/// not twice as wide as high, or has a value that is negative or not finite, or no light, or
/// if count or threads is none that is named here.
DAPPLE_API std::vector<SampledLight> sample_lights(std::span<const float> radiance, int width, int height,
                                                   const LightSampling& sampling = {});

}  // namespace dapple
