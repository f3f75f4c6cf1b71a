#pragma once
// An environment map as a number of small lights (Lagae & Dutré 2006, figure 7).
//
//      map -> density -> placer -> dots -> regions -> samples
//
// The placer puts n dots in proportion to luminance * sin theta. Each dot stands for a region: the texels'
// light is shared out among the dots (core/lights/settling.h, and regions below) so that none is lost or
// counted twice. The
// weights therefore sum to the map's flux for every n, every map and every seed: what a light list of fixed
// weights L / (n pdf) only does on average.

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/export.h"
#include "core/image/environment.h"
#include "core/placing/stipple.h"
#include "core/text/names.h"
#include "core/watch.h"

namespace dapple {

// The light of a map shared out among dots.
//
// Between the centres of four texels lies a patch; the density is bilinear there, as if each texel gave every
// one of its four patches a quarter of its light. A patch that holds dots is theirs, in equal parts. Another
// one is that of the nearest dot on the sphere, found by passing owners on from patch to patch, down the map
// and up again, around the sides. So the parts sum to the whole exactly, a sun of one texel is split
// among all dots that it got, and the cost is that of a few looks at each texel whatever the dots are.

struct LightRegion {
    glm::dvec3 flux{};       // linear RGB; over all regions, the map's total flux
    double solid_angle = 0;  // steradians; over all regions, 4 pi
    glm::dvec3 moment{};     // the integral of power * direction, directions as in OpenEXR
    glm::dvec2 drawn{};      // u, v of a place drawn at random in proportion to power
    double power = 0;        // 0: moment and drawn say nothing
};

/// One for each dot (u in [0, 1), v in [0, 1]). Dots at the same place share alike. `power` is what dots were
/// placed by, a texel's whole. Places are drawn if there is a seed. Nothing if stopped.
std::vector<LightRegion> share_light(const EnvironmentMap& map, const Grid<float>& power,
                                     std::span<const glm::dvec2> dots, std::optional<std::uint64_t> seed = {},
                                     const Watch& watch = {});

/// Where in its region a sample is. All three agree in weight.
enum class SamplePosition {
    settled,  // where the region's light has its centre of gravity, after steps towards such places on the
              // sphere (core/lights/settling.h): by far the least error, since any integrand that is linear
              // over the regions comes out exactly. A texel with more light than a sample's share has a
              // sample of its own
    dot,      // where the placer put the dot
    random,   // a texel drawn from the region's light: unbiased in luminance for any integrand, since a
              // region's flux times an integrand at a place drawn in proportion to its light has the region's
              // integral as its mean. Of compensated importance, only texels above the mean are drawn, and
              // the rest is left to the other samples of multiple importance sampling
};
constexpr auto names_of(SamplePosition) {
    return names("settled", "dot", "random");
}

/// What a sample's radiance and pdf say. Its weight is the same either way, and the sum of f * radiance / (n
/// pdf) estimates the integral of f times the map's light.
enum class SampleRadiance {
    mean,   // over its region, whose solid angle is 1 / (n pdf): weight = radiance / (n pdf) holds exactly
    point,  // the map's at (u, v), and the density with which it was drawn, near light_pdf()'s there: of
            // random positions only
};
constexpr auto names_of(SampleRadiance) {
    return names("mean", "point");
}

enum class LightOrder {
    priority,  // the most important first
    placed,    // suns with samples of their own, then as the placer has it
};
constexpr auto names_of(LightOrder) {
    return names("priority", "placed");
}

struct LightRequest {
    std::uint64_t count = 1024;  // exactly so many samples, 1 .. kMostLightSamples
    PlacerKind placer = PlacerKind::exact;
    LightImportance importance = LightImportance::light;
    SamplePosition position = SamplePosition::settled;
    SampleRadiance radiance = SampleRadiance::mean;
    LightOrder order = LightOrder::priority;
    std::uint64_t seed = 0;  // 0: the tile as it is; else it lies turned about the up axis by whole texels,
                             // each turn equally likely (Cranley-Patterson rotation), and random draws differ
    int threads = 1;         // the samples are the same for any number; 0: all cores

    bool operator==(const LightRequest&) const = default;
};

inline constexpr std::uint64_t kMostLightSamples = 10'000'000;

struct LightSample {
    glm::dvec2 uv{};        // on the map; core/lights/direction.h says which way that is
    glm::dvec3 weight{};    // flux of its region: irradiance on a surface that faces it, linear RGB
    glm::dvec3 radiance{};  // linear RGB
    double pdf = 0;         // samples per steradian there, over n
};

struct LightSamples {
    std::vector<LightSample> samples = {};  // in the order asked for
    SamplePosition position{};              // as asked for, like the next three
    SampleRadiance radiance{};
    LightOrder order{};
    std::uint64_t seed = 0;
    glm::dvec3 total_flux{};  // the map's
    double place_ms = 0;      // wall time of placing the dots
    double share_ms = 0;      // and of sharing out the light
};

/// Throws std::runtime_error if the count is out of range, if point radiance is asked for at places that are
/// not random, if the tile cannot be used by the placer asked for, or if Figure 8 does not find so many
/// places, as on a map whose light it loses. If stopped there are no samples.
DAPPLE_API LightSamples light_samples(const EnvironmentMap& map, RankedTile& tile,
                                      const LightRequest& request, const Watch& watch = {});

/// The dots of that request on the map: u and v. None if stopped.
std::vector<glm::dvec2> light_dots(const EnvironmentMap& map, RankedTile& tile, const LightRequest& request,
                                   const std::stop_token& stop = {});

/// Whether copies of a tile side by side, as they meet where u = 0 and 1, are one of its legal
/// neighbourhoods, so that dots keep their distance there too. Always so if its children are not turned.
bool meets_itself(const Tile& tile);

}  // namespace dapple
