#pragma once
// Light samples as files that renderers and programs read.
//
// A sample is a distant light: its direction points towards the light, its weight is the irradiance on a
// surface that faces it.

#include <ostream>
#include <string_view>

#include "core/lights/direction.h"
#include "core/lights/light_samples.h"

namespace dapple {

struct LightListStyle {
    SphereConvention convention = SphereConvention::openexr;
    double rotation_degrees = 0;  // the map turned about the up axis, see turned_about_up()
    std::string_view source{};    // the map's name
};

/// The unit vector towards a sample's light.
glm::dvec3 direction_of(const LightSample& sample, const LightListStyle& style);

/// {"convention": ..., "rotation_degrees": ..., "source": ..., "position": ..., "radiance": ..., "seed": ...,
///  "count": n, "total_flux": [r, g, b],
///  "samples": [{"direction": [x, y, z], "u": ..., "v": ..., "radiance": [r, g, b], "pdf": ...,
///               "weight": [r, g, b]}, ...]}
/// Bytes of the source that are not ASCII become '?', since JSON must be UTF-8 and file names need not.
void write_light_json(std::ostream& out, const LightSamples& lights, const LightListStyle& style);

/// The lines "# convention: openexr", "# rotation_degrees: 0", "# source: sky.exr", "# position: settled",
/// "# radiance: mean", "# seed: 0", "# count: n" and "# total_flux: r g b", then
/// x,y,z,u,v,radiance_r,radiance_g,radiance_b,pdf,weight_r,weight_g,weight_b and a line a sample.
void write_light_csv(std::ostream& out, const LightSamples& lights, const LightListStyle& style);

/// Distant lights for a pbrt-v4 scene, to be included after WorldBegin. pbrt's "L" is the irradiance, and the
/// light comes from "from".
void write_light_pbrt(std::ostream& out, const LightSamples& lights, const LightListStyle& style);

/// A scene for Mitsuba 3 with nothing but directional emitters, to be included by another. Mitsuba's
/// direction is the one in which the light travels.
void write_light_mitsuba(std::ostream& out, const LightSamples& lights, const LightListStyle& style);

}  // namespace dapple
