#pragma once
// A power spectrum as a picture.

#include <glm/gtc/type_precision.hpp>

#include "core/analysis/periodogram.h"
#include "core/image/grid.h"

namespace dapple {

/// What is coloured as a peak: white noise has so much once in nine million bins.
inline constexpr float kPeakPower = 16;

/// Frequency 0 in the middle, x to the right and y down as on the page, up to the spectrum's highest
/// frequency at the edges. Grey says the power on a fixed logarithmic scale, so that pictures compare: black
/// is 0, white noise (1) a dark grey, white kPeakPower. What is above is orange and at least three pixels
/// wide, so that a single bin, the trace of a repetition, can be seen. Frequency 0 itself is black.
///
/// A bin is a pixel; small spectra are enlarged by a whole number until the longer side is at least
/// `longer_side` / 2, large ones shrunk, each pixel the highest of its bins, until it is at most that.
Grid<glm::u8vec3> spectrum_picture(const Periodogram& spectrum, int longer_side = 1024);

}  // namespace dapple
