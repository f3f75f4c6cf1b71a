#pragma once
// Masks by void and cluster (Ulichney 1993, "The void-and-cluster method for dither array generation"), by
// the energy of a Gaussian around each inked pixel: the next pixel to be inked is the one where there is
// least of it. Opposite edges meet.
//
// A pixel's energy is a whole number, so that what was added is taken away exactly, and the place of least
// energy is kept in a tree: a mask of 1024 x 1024 takes seconds.

#include <cstdint>
#include <functional>

#include "core/screening/threshold_mask.h"

namespace dapple {

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
