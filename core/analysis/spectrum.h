#pragma once
// Numbers from a power spectrum: its average over rings, its low frequencies, its peaks.
//
// Frequencies f are over sqrt(n) (see periodogram.h). Only one of k and -k counts, which changes no mean.
// P(0) never counts. Where a spectrum ends below the frequencies asked for, what is there counts.

#include <cstddef>
#include <glm/gtc/type_precision.hpp>
#include <vector>

#include "core/analysis/periodogram.h"
#include "core/export.h"
#include "core/image/grid.h"

namespace dapple {

// A power spectrum as a picture.

/// What is coloured as a peak: white noise has so much once in nine million bins.
inline constexpr float kPeakPower = 16;

/// Frequency 0 in the middle, x to the right and y down as on the page, up to the spectrum's highest
/// frequency at the edges. Grey says the power on a fixed logarithmic scale, so that pictures compare: black
/// is 0, white noise (1) a dark grey, white kPeakPower. What is above is orange and at least three pixels
/// wide, so that a single bin, the trace of a repetition, can be seen. Frequency 0 itself is black.
///
/// A bin is a pixel; small spectra are enlarged by a whole number until the longer side is at least
/// `longer_side` / 2, large ones shrunk, each pixel the highest of its bins, until it is at most that.
DAPPLE_API Grid<glm::u8vec3> spectrum_picture(const Periodogram& spectrum, int longer_side = 1024);

/// Frequencies whose length, in units of 1 / sqrt(area), rounds to the same integer (Ulichney 1987, "Digital
/// Halftoning", chapter 3).
struct Ring {
    double frequency = 0;  // of the ring's middle, over sqrt(n)
    std::size_t bins = 0;  // how many, of k and -k one
    double power = 0;      // their mean
    double anisotropy_db = 0;
};

/// Rings 1, 2, ... up to the highest frequency of the periodogram; empty for no points.
/// Anisotropy (Lau & Ulichney 2006, "Blue-noise halftoning for hexagonal grids") is the ring's variance, over
/// bins - 1, over its squared mean, in decibel. One set of an isotropic process has 0 dB however many points,
/// since each P is exponentially distributed about the mean; peaks make it positive. The average of m spectra
/// would have -10 log10(m). A ring with fewer than two bins or no power has 0 dB, and none is below -100.
std::vector<Ring> radial_power(const Periodogram& spectrum);

/// The mean of P over from <= |k| < f, but 0; 0 if there is no such k.
double low_frequency_power(const Periodogram& spectrum, double f, double from = 0);

/// Peaks among the bins 0.5 < |k| < 2, over sqrt(n): where a repetition of the set shows as a Bragg peak.
struct Peaks {
    double highest_bin = 0;            // the greatest P
    int highest_x = 0, highest_y = 0;  // and its frequency (i, j), of several the first by i, then j
    /// The part of all power that the strongest 0.1 % of the bins hold (rounded down, at least one bin).
    /// White noise: 0.001 (1 + ln 1000) = 0.79 %. A perfectly periodic set: 1.
    double top_share = 0;
};
Peaks spectral_peaks(const Periodogram& spectrum);

/// The effective Nyquist frequency in the sense of Heck, Schlömer & Deussen (2013, "Blue Noise Sampling with
/// Controlled Aliasing"): the highest frequency f of a wave that the set samples with little noise among the
/// frequencies up to f. Sampling a wave of frequency f moves the spectrum by f, so that noise is the mean of
/// P over the disc of radius f about a point at distance f; P(0), the wave itself, does not count. The value
/// is the highest f, in steps of half a ring, whose noise is at most `threshold` (1 is white noise; 0.1 is
/// our choice), over sqrt(n) / 2, the Nyquist frequency of the square lattice: 1 for a square lattice, 0 for
/// white noise, at least f0 for a spectrum that is 0 below f0. Never above the spectrum's highest frequency.
double effective_nyquist(const std::vector<Ring>& rings, double threshold = 0.1);

}  // namespace dapple
