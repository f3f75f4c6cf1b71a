#pragma once
// The Fourier sums of a point set at integer frequencies, exactly and fast.
//
//      F(i, j) = sum over points of exp(-2 pi i (i x + j y)),   (x, y) in units of the period
//
// Only i >= 0 is stored: F(-i, -j) is the conjugate of F(i, j).

#include <complex>
#include <glm/vec2.hpp>
#include <span>
#include <stop_token>
#include <vector>

namespace dapple {

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

}  // namespace dapple
