#pragma once
// How often each lightness occurs in a picture.

#include <array>
#include <cstdint>

#include "core/image/grid.h"

namespace dapple {

/// Counts of sRGB-encoded lightness, 0 black to 1 white. Bin i holds the values nearest to i / kSteps, so
/// each of the 256 values of an 8-bit picture lies in the middle of a bin (every fourth one).
struct Histogram {
    static constexpr int kSteps = 4 * 255;

    std::array<std::uint64_t, kSteps + 1> counts{};
    std::uint64_t total = 0;  // of all counts

    /// The encoded value that bin i stands for.
    static constexpr float value_of(int i) { return static_cast<float>(i) / kSteps; }

    bool operator==(const Histogram&) const = default;
};

/// The histogram of a picture of linear light, exposed by so many stops, taken as density_of() takes it:
/// values outside 0..1 are clamped, NaN is white. A frame of one tone, as around a slide or a film, is left
/// out: on each side the rows or columns that differ by no more than two 8-bit steps from the picture's
/// corner, if they are a fiftieth of the picture at least. A picture of one tone is all counted. A few
/// milliseconds a megapixel.
Histogram histogram_of(const Grid<float>& light, float exposure = 0);

/// The encoded value below or at which that percentage (0..100) of the pixels lie, by nearest rank; right to
/// half a bin. 0 if the histogram is empty.
float percentile(const Histogram& histogram, double percent);

}  // namespace dapple
