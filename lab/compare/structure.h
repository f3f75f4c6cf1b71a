#pragma once
// How well a drawing keeps a photograph's structure, shapes and edges, whatever its tone.

#include <array>

#include "core/image/grid.h"

namespace dapple {

/// The correlation of two pictures' gradients: the sum over all pixels of their dot products, over the root
/// of the product of the sums of their squares. 1 for equal pictures, also where one has more contrast or is
/// lighter; -1 for a picture and its negative; between two ramps the cosine of the angle between them.
/// Differences are central, one-sided at the edges. 0 if a picture has no gradient; equal sizes.
double gradient_correlation(const Grid<float>& a, const Grid<float>& b);

struct Structure {
    double ssim = 0;
    double gradients = 0;
    /// SSIM where the photograph is darkest, a quarter of its pixels, and so on to where it is lightest.
    std::array<double, 4> ssim_by_light{};
};

/// SSIM and gradient correlation of two pictures of linear light (0 black, 1 paper; cut off there) as they
/// are seen: light is blurred by a Gaussian of sigma pixels (>= 0) and then sRGB-encoded, whose steps are
/// about alike to the eye. SSIM's window is a Gaussian of 1.5 sigma, at least 1.5 pixels. Equal sizes.
Structure structure(const Grid<float>& drawing, const Grid<float>& photograph, double sigma_px);

}  // namespace dapple
