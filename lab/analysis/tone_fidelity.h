#pragma once
// How close a drawing comes to its photograph, seen from some way off: both are blurred and compared in
// linear light, 0 black to 1 paper.

#include "core/image/grid.h"

namespace dapple {

/// The eye's blur: a Gaussian whose standard deviation is one minute of arc, what normal sight (20/20, 1.0)
/// just resolves. In degrees.
inline constexpr double kEyeBlurDegrees = 1.0 / 60.0;

/// How far away a page is whose light the eye blurs by so much on the page, in the unit of `sigma`: 1 mm of
/// blur is 3.4 m of distance.
double viewing_distance(double sigma);

struct ToneFidelity {
    double sigma_px = 0;    // standard deviation of the blur, pixels
    double mean_error = 0;  // mean of drawing - photograph: above 0 the drawing is too light
    double rms_error = 0;   // root of the mean square of the difference
    double psnr_db = 0;     // -20 log10(rms_error), 200 at most: white is the peak, 1
    /// Structural similarity (lab/analysis/ssim.h) of linear light. Its window is a Gaussian of 1.5 pixels,
    /// and of 1.5 sigma where the blur is over a pixel, since what the eye can tell apart then is as far
    /// apart as that.
    double ssim = 0;
};

/// Compares two pictures of linear light after blurring both with sigma pixels (>= 0). The photograph's light
/// is cut off at black and paper first, which no drawing can pass. All 0 for pictures without pixels. Throws
/// std::runtime_error if the sizes differ.
ToneFidelity tone_fidelity(const Grid<float>& drawing, const Grid<float>& photograph, double sigma_px);

}  // namespace dapple
