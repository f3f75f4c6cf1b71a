#pragma once
// Steps down the energy of Gaussian kernels.
//
// Each dot is a Gaussian as wide as dots are apart where it lies, and the wanted density has as much ink of
// the other sign. Dots go down the energy of both together (Ahmed, Ren and Wonka 2022, with kernels that
// follow the density). Where Lloyd's steps make dots even, these also make them as many as there should be,
// over every few of them: tones and edges come out truer, and the low part of the spectrum all but vanishes.
// Where dots differ in size each counts by its area, so that the ink is what there should be, not the number.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "core/image/density.h"
#include "core/image/detail.h"
#include "core/relaxing/blurred_density.h"
#include "core/relaxing/dot_rows.h"

namespace dapple {

// Gaussians by operations that give the same bits everywhere, which those of the C library do not.

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

/// A kernel's standard deviation, in distances between dots. Wider ones lower the spectrum further, and cost
/// distances: those that make dots even, those of pictures, and those of samples, whose sums are to be near
/// an integral.
inline constexpr float kEvenKernel = 0.36f, kPictureKernel = 0.45f, kSampleKernel = 0.7f;

/// The ink, which is the density where areas do not differ, as kernels of that width see it, which dots
/// placed at this scale have.
BlurredDensity blurred_for_kernels(const Density& density, double scale, float kernel,
                                   const DotAreas& areas = {});

/// What the wanted density has to be multiplied with at this scale to have the ink of so many dots, with what
/// it has beyond the page's edges. Else a dense part would lack some, and pull them out of a sparse one.
float ink_for(const Density& density, double scale, float kernel, double dots);

/// The steps of a row's dots, one row after another. All that is given has to outlive it.
class EnergySteps {
 public:
    /// A dot feels others in at most so many rows on either side.
    static constexpr int kFarthestRow = 24;
    /// It moves through fewer rows than this.
    static constexpr int kLongestStep = 4;

    /// `blurred` for the same kernel and areas.
    EnergySteps(const DotRows& rows, const BlurredDensity& blurred, const PageRows& page, float kernel,
                const DotAreas& areas = {}, float ink = 1)
        : rows_(rows), blurred_(blurred), page_(page), kernel_(kernel), areas_(areas), ink_(ink) {}

    void begin_row(std::int64_t row) { cursors_.begin(rows_, row); }

    /// The step of a dot of that row, by such a stride: one of 1 and more overshoots the energy's steepest
    /// waves. Each dot asked for lies further to the right than the one before.
    DotStep step(std::size_t dot, float stride);

 private:
    // A Gaussian that stands for two kernels: its variance, and how far apart dots are where it lies.
    struct Kernels {
        float variance, apart;
    };
    template <bool kWeighed>
    DotStep by_dots(float x, float y, float variance);
    // The slope of the density that dots are to match, which ends at the page's edges; a row.
    DotStep slope(float x, float y, const Kernels& kernels, float tone) const;

    const DotRows& rows_;
    const BlurredDensity& blurred_;
    const PageRows page_;
    const float kernel_;
    const DotAreas areas_;
    const float ink_;
    RowCursors<kFarthestRow> cursors_;
};

}  // namespace dapple
