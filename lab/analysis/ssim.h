#pragma once
// Structural similarity of two pictures.

#include "core/image/grid.h"

namespace dapple {

/// The structural similarity index about each pixel (Wang, Bovik, Sheikh & Simoncelli 2004, "Image Quality
/// Assessment", equation 13, with K1 = 0.01, K2 = 0.03 and a peak of 1): 1 where pictures are equal, -1 at
/// least. The window is a Gaussian of standard deviation sigma pixels (>= 0; 1.5 there). Values 0..1, encoded
/// or linear, are the caller's choice. Equal sizes.
Grid<float> ssim_map(const Grid<float>& a, const Grid<float>& b, double sigma);

/// Its mean over all pixels. 0 for pictures without pixels.
double mean_ssim(const Grid<float>& a, const Grid<float>& b, double sigma);

}  // namespace dapple
