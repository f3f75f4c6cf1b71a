#pragma once
// Gaussian blue noise: random dots go down the energy of Gaussian kernels.

#include <numbers>

#include "lab/related/wanted.h"

namespace dapple {

inline constexpr int kGaussianSteps = 1000;
/// A kernel's standard deviation, in distances between dots.
inline constexpr double kGaussianKernel = std::numbers::sqrt2 / 2;
/// The mean step down, in distances between dots, below which dots lie still.
inline constexpr double kGaussianStill = 2e-6;

/// A. G. M. Ahmed, J. Ren & P. Wonka, "Gaussian Blue Noise" (2022): dots as Gaussians, against the wanted
/// density seen through the same ones, have as little energy as can be. A kernel's standard deviation is that
/// of the authors' program by default (1, for a pair of them), and so is where it ends, at e^-17 of its
/// middle: what is cut off earlier stirs the dots, and the energy falls no further.
///
/// The authors take a thousand plain steps in their example. Steps here have momentum (Nesterov 1983; on
/// pictures a dot's ends where it leads farther than 60 degrees from its step), by which as many go much
/// farther down: until dots lie still, by kGaussianStill, or for kGaussianSteps.
///
/// What differs: a dot sees others through its own kernel, whatever theirs, which is no wider than a fiftieth
/// of the mean density asks for. A picture goes on beyond its page as in a mirror.
PlainDots gaussian_blue_noise(const DotsWanted& wanted);

}  // namespace dapple
