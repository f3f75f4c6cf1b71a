#pragma once
// Dart throwing: dots at random, none nearer to another than a radius.

#include "lab/related/wanted.h"

namespace dapple {

/// The radius of maximal dart throwing that gives about so many dots on the unit square: where discs of half
/// of it cover 0.547 of the plane (random sequential addition; Feder 1980, "Random sequential adsorption").
double dart_radius(std::size_t count);

/// Maximal: darts at random (R. L. Cook 1986) until no free place is left. By M. S. Ebeida et al., "A Simple
/// Algorithm for Maximal Poisson-Disk Sampling in High Dimensions" (2012): darts go to the cells that are not
/// known to be covered, which are divided again and again. On the unit square, whose opposite edges meet; no
/// two dots are nearer than `radius`, 0 < radius < 1/2. None if stopped.
PlainDots maximal_darts(double radius, std::uint64_t seed, const std::stop_token& stop = {});

/// For constant density: maximal_darts(dart_radius(count)), so about one in a hundred more or less than asked
/// for. For a picture: M. McCool & E. Fiume, "Hierarchical Poisson Disk Sampling Distributions" (1992), where
/// the radius shrinks whenever darts miss too often, so that the count is met and every prefix is a drawing;
/// it goes with one over the root of the density at the new dot. That one is not maximal.
PlainDots dart_throwing(const DotsWanted& wanted);

}  // namespace dapple
