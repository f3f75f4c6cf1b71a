#pragma once
// Gaussians by operations that give the same bits everywhere, which those of the C library do not.

#include <cmath>
#include <numbers>

namespace dapple {

/// t becomes e^t within 1e-5 of it, for t from -8 to 0; of a number or of a vector of them. For t from -120
/// to -8 finite.
template <class T>
inline void take_exponential(T& t) {
    const T s = t * 0.125f;
    T p = s * (1 / 120.0f) + (1 / 24.0f);
    p = p * s + (1 / 6.0f);
    p = p * s + 0.5f;
    p = p * s + 1.0f;
    p = p * s + 1.0f;
    p = p * p;
    p = p * p;
    t = p * p;
}

/// A unit step blurred by a Gaussian, so many standard deviations beyond it, -4 to 5 (Abramowitz and Stegun
/// 26.2.17, within 1e-5), and its slope.
struct BlurredStep {
    float value, slope;

    explicit BlurredStep(float z) {
        slope = -0.5f * z * z;
        take_exponential(slope);
        slope *= std::numbers::inv_sqrtpi_v<float> / std::numbers::sqrt2_v<float>;
        const float t = 1 / (1 + 0.2316419f * std::abs(z));
        float tail = t * 1.330274429f - 1.821255978f;
        tail = tail * t + 1.781477937f;
        tail = tail * t - 0.356563782f;
        tail = tail * t + 0.319381530f;
        tail *= t * slope;
        value = z < 0 ? tail : 1 - tail;
    }
};

}  // namespace dapple
