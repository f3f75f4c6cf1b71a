#pragma once
// A latitude-longitude environment map: the light that comes from every direction, by u and v.
//
//      u  0 .. 1  left to right, once around; the sides meet
//      v  0 .. 1  from straight up to straight down, theta = pi v
//
// Texel (x, y) covers u in [x, x + 1) / width and v in [y, y + 1) / height; its centre is half a texel
// further. Which way in space a texel lies is a matter of convention: core/lights/direction.h.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "core/export.h"
#include "core/image/density.h"
#include "core/image/grid.h"

namespace dapple {

/// Rec. 709 luminance of linear RGB.
double luminance(const glm::dvec3& light);

class EnvironmentMap {
 public:
    /// Linear RGB radiance. Throws std::runtime_error saying what is wrong if the grid is not twice as wide
    /// as high (one pixel is an even sky), if a value is NaN, infinite or negative, or if all is black.
    DAPPLE_API explicit EnvironmentMap(Grid<glm::vec3> radiance);

    int width() const { return radiance_.width; }
    int height() const { return radiance_.height; }
    const Grid<glm::vec3>& radiance() const { return radiance_; }

    /// The solid angle of each texel in a row, in steradians, exactly: (2 pi / width) (cos theta_top - cos
    /// theta_bottom). All texels sum to 4 pi.
    double solid_angle(int row) const;

    /// The integral of radiance over the sphere, by texels: sum of radiance * solid angle.
    glm::dvec3 total_flux() const { return total_flux_; }

    /// Bilinear between the texels' centres, around the sides; beyond the outermost rows' centres constant.
    glm::dvec3 at(glm::dvec2 uv) const;

 private:
    Grid<glm::vec3> radiance_;
    glm::dvec3 total_flux_{};
};

/// What samples are drawn in proportion to.
enum class LightImportance {
    light,        // luminance
    compensated,  // luminance above the sphere's mean: for multiple importance sampling with the surface's
                  // reflection, which finds the rest (Karlik et al. 2019, "MIS compensation")
};

/// Luminance * sin theta (Lagae & Dutré 2006, figure 7), at most 1, for placing: the map is the upper half
/// of the root square and its sides meet (Sides::wrap). `first_column` is the map's column that comes to lie
/// at the left. sin theta is the mean over the texel's row, so that a texel's value is its flux up to one
/// common factor. A map that is even everywhere has nothing to compensate and is sampled by its luminance.
Density light_density(const EnvironmentMap& map, LightImportance importance = LightImportance::light,
                      int first_column = 0);

/// The density by which samples are placed, as probability per steradian, constant over each texel: times the
/// texels' solid angles it sums to 1. What a renderer weighs samples by that it draws otherwise.
Grid<float> light_pdf(const EnvironmentMap& map, LightImportance importance = LightImportance::light);

// A sky of our own, for trials and pictures that depend on nobody's photographs.

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
