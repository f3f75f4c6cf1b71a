#pragma once
// Threshold masks (stochastic screening): a matrix that tiles the plane and turns a picture into dots on a
// grid of pixels, one comparison each. A pixel is inked where the picture is darker than the mask's threshold
// there, so the pixels inked in an even grey are those of lowest rank, and each grey's lie within the next
// one's.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <vector>

#include "core/image/grid.h"
#include "core/placing/stipple.h"

namespace dapple {

struct ThresholdSize {
    int width = 64, height = 64;  // pixels, 4..kMostThresholdSide
    int slices = 1;               // of a mask for films: one for each picture of it, again and again

    std::size_t of_slice() const { return static_cast<std::size_t>(width) * height; }
    std::size_t all() const { return of_slice() * slices; }
    bool operator==(const ThresholdSize&) const = default;
};

inline constexpr int kMostThresholdSide = 8192, kMostThresholdSlices = 1024;
inline constexpr std::size_t kMostThresholdPixels = std::size_t{1} << 26;

/// Throws std::runtime_error if there are fewer or more than that.
void check_threshold_size(const ThresholdSize& size);

/// The order in which a mask's pixels are inked as a grey becomes darker: slice after slice, row after row,
/// each slice a permutation of 0..width * height - 1.
struct ThresholdMask {
    ThresholdSize size;
    std::vector<std::uint32_t> ranks;

    std::uint32_t rank(int x, int y, int slice = 0) const {
        return ranks[(static_cast<std::size_t>(slice) * size.height + y) * size.width + x];
    }
};

/// The thresholds of a slice: the share of ink, 0..1, from which on each pixel is inked, by which a grey
/// prints as dark as it is. `gain` is how far a printed pixel reaches beyond its edges (pixels, 0..4), as ink
/// spreads and pens are wider than they are set: fewer pixels then print the same grey. Without a gain
/// (rank + 1/2) / (width * height).
Grid<float> thresholds_of(const ThresholdMask& mask, int slice = 0, double gain = 0);

/// The pixels that are inked of a picture of `light`, linear 0..1: 0 ink, 1 paper. The mask begins in the
/// upper left corner.
Grid<float> screened(const Grid<float>& light, const Grid<float>& thresholds);

/// The places of the inked pixels of an even grey, in pixels from the mask's corner, those of the `count`
/// lowest ranks of a slice: a point set on the torus for core/analysis.
std::vector<glm::dvec2> inked_places(const ThresholdMask& mask, std::uint32_t count, int slice = 0);

// Masks whose order is a self-similar tile's: a pixel is inked when the first dot of an endless subdivision
// falls into it.

/// A square mask, `side` pixels wide (4..2048), whose edges meet as those of the tile do. Throws
/// std::runtime_error if the side is out of its range.
ThresholdMask tile_mask(RankedTile& tile, int side);

// Masks by void and cluster (Ulichney 1993, "The void-and-cluster method for dither array generation"), by
// the energy of a Gaussian around each inked pixel: the next pixel to be inked is the one where there is
// least of it. Opposite edges meet.
//
// A pixel's energy is a whole number, so that what was added is taken away exactly, and the place of least
// energy is kept in a tree: a mask of 1024 x 1024 takes seconds.

struct VoidAndClusterOptions {
    /// Of the Gaussian, in pixels, 0.5..4. Ulichney's 1.5: larger ones are coarser and smoother in middle
    /// greys.
    double sigma = 1.5;
    /// Of several slices: how far a pixel feels itself in the slices before and after, 0.5..8. In its own
    /// slice it feels its neighbours alone, so that each slice is even and so is each pixel's sequence
    /// (Wolfe, Morrical, Akenine-Möller and Ramamoorthi 2022, "Spatiotemporal Blue Noise Masks").
    double slice_sigma = 1.5;
    std::uint64_t seed = 1;
};

/// Told the share that is done, 0..1. False ends it.
using MaskProgress = std::function<bool(double share)>;

/// Throws std::runtime_error as check_threshold_size() does, or if a sigma is out of its range. If it was
/// ended, the ranks are none.
ThresholdMask void_and_cluster(const ThresholdSize& size, const VoidAndClusterOptions& options = {},
                               const MaskProgress& progress = {});

}  // namespace dapple
