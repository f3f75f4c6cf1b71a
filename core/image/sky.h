#pragma once
// A sky of our own, for trials and pictures that depend on nobody's photographs.

#include "core/image/environment.h"

namespace dapple {

struct Sky {
    int height = 512;           // texels; twice as wide
    double sun_elevation = 35;  // degrees over the horizon, -90..90
    double sun_u = 0.32;        // where it stands, 0..1
    double sun_radius = 0.27;   // degrees
    double sun_radiance = 2e4;  // the sky's own is about 1
    double clouds = 1;          // 0: none
};

/// A blue vault, paler and warmer towards the horizon, brighter around the sun; thin clouds; a sun with a
/// sharp edge, its texels covered in part where it cuts them; brown ground lit by it all. The formulas are
/// made to look like a sky and measured nowhere. Throws std::runtime_error as EnvironmentMap does.
EnvironmentMap sky_map(const Sky& sky = {});

}  // namespace dapple
