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
#include <glm/vec2.hpp>
#include <span>
#include <stop_token>
#include <vector>

#include "core/analysis/domain.h"
#include "core/export.h"

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

}  // namespace dapple
