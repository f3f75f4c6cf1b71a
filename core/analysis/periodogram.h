#pragma once
// The 2-D power spectrum of a point set, P(k) = |sum over points of exp(-2 pi i k.x)|^2 / n, at the lattice
// of frequencies that fit the domain: k = (i / width, j / height), i and j integers.
//
// White noise has P = 1 on average at every k but 0, where P = n. A square lattice of n = m^2 points has
// P = n at multiples of m and 0 elsewhere.
//
// A window is treated with its own sides as the period. At these frequencies the transform of the window
// itself is zero, so the mean density contributes nothing anywhere but at k = 0 and needs no removal; what
// remains of the edges is a slight leak of power from peaks into their row and column.
//
// The unit of frequency is sqrt(n / area), written "over sqrt(n)": on the unit square |k| / sqrt(n).

#include <complex>
#include <cstddef>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec2.hpp>
#include <span>
#include <stop_token>
#include <vector>

#include "core/analysis/domain.h"
#include "core/export.h"
#include "core/image/grid.h"

namespace dapple {

// The Fourier sums of a point set at integer frequencies, exactly and fast.
//
//      F(i, j) = sum over points of exp(-2 pi i (i x + j y)),   (x, y) in units of the period
//
// Only i >= 0 is stored: F(-i, -j) is the conjugate of F(i, j).

struct FourierSums {
    int max_x = 0, max_y = 0;              // |i| <= max_x, |j| <= max_y
    std::vector<std::complex<float>> sum;  // (max_x + 1) columns of 2 max_y + 1, j ascending

    std::complex<float> at(int i, int j) const {
        return i >= 0 ? sum[index(i, j)] : std::conj(sum[index(-i, -j)]);
    }
    std::size_t index(int i, int j) const {
        return std::size_t(i) * (2 * std::size_t(max_y) + 1) + std::size_t(j + max_y);
    }
};

/// Term by term in double precision: points x (max_x + 1) x (2 max_y + 1) operations.
/// `period` > 0 is the size of the domain. Unfinished when a stop was requested.
FourierSums exact_fourier_sums(std::span<const glm::dvec2> points, glm::dvec2 period, int max_x, int max_y,
                               std::stop_token stop = {});

/// By a nonuniform fast Fourier transform of the first type (Dutt & Rokhlin 1993): every point is spread over
/// 10 x 10 cells of a grid 1.5 times finer than the frequencies ask for, with the "exponential of semicircle"
/// kernel of Barnett, Magland & af Klinteberg (2019, "A Parallel Nonuniform Fast Fourier Transform Library
/// Based on an 'Exponential of Semicircle' Kernel"), and the transform is divided by the kernel's own.
/// Limited by single precision: the error of a sum is below 1e-6 n always, below 1e-5 sqrt(n) for a set
/// without a dominating peak, and ten times less on average. So the power |F|^2 / n has a relative error
/// below 1e-4 where it is 0.1 or more, and of a lattice below 1e-12 n where it should be 0. The same to the
/// bit for any number of threads. Memory: 9 (max_x + 1) (2 max_y + 1) floats and the points.
FourierSums fast_fourier_sums(std::span<const glm::dvec2> points, glm::dvec2 period, int max_x, int max_y,
                              std::stop_token stop = {});

enum class FourierRoute {
    automatic,  // exact up to about 1000 points, else fast
    exact,      // term by term, in double precision
    fast,       // nonuniform FFT: see fast_fourier_sums() for its error, below 1e-4 of P where P >= 0.1
};

struct PeriodogramOptions {
    double highest_frequency = 2;  // over sqrt(n): |i| and |j| go up to this in each direction
    FourierRoute route = FourierRoute::automatic;
};

struct Periodogram {
    Domain domain;
    std::size_t points = 0;        // n
    double highest_frequency = 0;  // as asked for; every k up to it in length is there, and the corners
    int max_x = 0, max_y = 0;      // |i| <= max_x, |j| <= max_y
    std::vector<float> power;      // i = 0..max_x: (max_x + 1) columns of 2 max_y + 1 values, j ascending

    /// P at (i, j); negative i by P(-k) = P(k).
    float at(int i, int j) const {
        if (i < 0) return at(-i, -j);
        return power[std::size_t(i) * (2 * std::size_t(max_y) + 1) + std::size_t(j + max_y)];
    }
    /// |k|^2 area: on the unit square i^2 + j^2, exactly.
    double squared_frequency(int i, int j) const {
        return double(i) * i * (domain.height / domain.width) +
               double(j) * j * (domain.width / domain.height);
    }
};

/// Points as points_inside() gives them. No points: a single P(0) = 0. At frequencies up to 2, 65,536 points
/// take about 0.05 s, a million about a second and 350 MB; both grow with highest_frequency^2 n.
/// The same to the bit for any number of threads. Unfinished when a stop was requested: ask the token.
/// Throws std::runtime_error if the spectrum would have more than 2^28 values.
DAPPLE_API Periodogram periodogram(std::span<const glm::dvec2> points, const Domain& domain,
                                   const PeriodogramOptions& options = {}, std::stop_token stop = {});

// Numbers from a power spectrum: its average over rings, its low frequencies, its peaks.
//
// Frequencies f are over sqrt(n) (see periodogram.h). Only one of k and -k counts, which changes no mean.
// P(0) never counts. Where a spectrum ends below the frequencies asked for, what is there counts.

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
