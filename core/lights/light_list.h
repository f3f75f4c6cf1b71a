#pragma once
// Light samples as files that renderers and programs read.
//
// A sample is a distant light: its direction points towards the light, its weight is the irradiance on a
// surface that faces it.

#include <string_view>

#include "core/lights/direction.h"
#include "core/lights/light_samples.h"
#include "core/text/text_lines.h"

namespace dapple {

struct LightListStyle {
    SphereConvention convention = SphereConvention::openexr;
    double rotation_degrees = 0;  // the map turned about the up axis, see turned_about_up()
    std::string_view source{};    // the map's name
};

/// The unit vector towards a sample's light.
glm::dvec3 direction_of(const LightSample& sample, const LightListStyle& style);

/// {"convention": ..., "rotation_degrees": ..., "source": ..., "position": ..., "radiance": ..., "order":
/// ...,
///  "seed": ...,
///  "count": n, "total_flux": [r, g, b],
///  "samples": [{"direction": [x, y, z], "u": ..., "v": ..., "radiance": [r, g, b], "pdf": ...,
///               "weight": [r, g, b], "angular_radius": ...}, ...]}
/// Bytes of the source that are not ASCII become '?', since JSON must be UTF-8 and file names need not.
void write_light_json(TextBuffer& text, const LightSamples& lights, const LightListStyle& style);

/// The lines "# convention: openexr", "# rotation_degrees: 0", "# source: sky.exr", "# position: settled",
/// "# radiance: mean", "# order: priority", "# seed: 0", "# count: n" and "# total_flux: r g b", then
/// x,y,z,u,v,radiance_r,radiance_g,radiance_b,pdf,weight_r,weight_g,weight_b,angular_radius and a line a
/// sample.
void write_light_csv(TextBuffer& text, const LightSamples& lights, const LightListStyle& style);

/// How far from its direction a sample's region reaches, in degrees, if it were round.
double angular_radius(const LightSample& sample, std::size_t samples);

/// Distant lights for a pbrt-v4 scene, to be included after WorldBegin. pbrt's "L" is the irradiance, and the
/// light comes from "from".
void write_light_pbrt(TextBuffer& text, const LightSamples& lights, const LightListStyle& style);

/// A scene for Mitsuba 3 with nothing but directional emitters, to be included by another. Mitsuba's
/// direction is the one in which the light travels.
void write_light_mitsuba(TextBuffer& text, const LightSamples& lights, const LightListStyle& style);

/// A USD layer with a DistantLight for each, as wide as its region, under a prim "Lights": its intensity is
/// normalized, so that color is the irradiance.
void write_light_usd(TextBuffer& text, const LightSamples& lights, const LightListStyle& style);

/// A glTF 2.0 scene with directional lights (KHR_lights_punctual); color times intensity is the irradiance,
/// in the map's unit, which glTF takes for lux.
void write_light_gltf(TextBuffer& text, const LightSamples& lights, const LightListStyle& style);

/// A Python script for Blender that adds a sun for each, as wide as its region, in a collection of their own.
void write_light_blender(TextBuffer& text, const LightSamples& lights, const LightListStyle& style);

}  // namespace dapple
