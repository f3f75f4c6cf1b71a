#pragma once
// Gaussian blue noise: random dots go down the energy of Gaussian kernels.

#include "lab/related/wanted.h"

namespace dapple {

inline constexpr int kGaussianSteps = 300;
inline constexpr double kGaussianKernel = 0.7;

/// A. G. M. Ahmed, J. Ren & P. Wonka, "Gaussian Blue Noise" (2022): dots as Gaussians, against the wanted
/// density seen through the same ones, have as little energy as can be. By plain descent, kGaussianSteps
/// steps from random dots; a kernel's standard deviation is kGaussianKernel over the root of how many dots
/// are wanted on an area there.
///
/// What differs: a dot sees others through its own kernel, whatever theirs, which ends where it has fallen to
/// e^-9 and is no wider than a fiftieth of the mean density asks for. A picture goes on beyond its page as in
/// a mirror.
PlainDots gaussian_blue_noise(const DotsWanted& wanted);

}  // namespace dapple
