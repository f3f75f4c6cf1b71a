#pragma once
// A density as seen through Gaussians of many widths: how strong it is and which way it rises.

#include <vector>

#include "core/image/grid.h"

namespace dapple {

/// How near to Gaussians the blurs are.
struct BlurQuality {
    int octave = 1;  // so many to a doubling of the variance: 1, 2, 4, 8
    double most_pixels =
        2.5;  // a level's pixels are twice as wide as those before once its Gaussian is wider
};

/// A density blurred by Gaussians whose variances are a factor of two apart, or less, the wider ones on
/// coarser pixels. In between, it is interpolated by the variance, as heat spreads. Between pixels it is a
/// quadratic spline, so that its slope is continuous. Beyond the picture's edges lie its mirror images.
class BlurredDensity {
 public:
    /// For variances from one to the other, in the picture's pixels squared. What is narrower than a pixel's
    /// own (0.25) is not told apart. Both finite. The density, a value a pixel, has to have pixels.
    BlurredDensity(Grid<float> density, double least_variance, double most_variance,
                   const BlurQuality& quality = {});

    struct Slope {
        float value = 0, x = 0, y = 0;  // x and y a pixel of the picture
    };

    /// At a place in the picture's pixels from its corner; on the picture.
    Slope at(double x, double y, float variance) const;

    /// The value at the least variance.
    float sharpest(double x, double y) const;

 private:
    // With a pixel more before, and two after.
    struct Level {
        Grid<float> values;
        double across = 1, down = 1;  // its pixels to one of the picture
    };
    static Slope on(const Level& level, double x, double y);

    std::vector<Level> levels_;             // of rising variance
    float first_variance_ = 0, ratio_ = 2;  // of one level's variance to that before
};

}  // namespace dapple
