#pragma once
// Points by number theory: Halton, Hammersley, Sobol, rank-1 lattices. They have no seed.
//
// For a picture they are bent (see BentSquare), which keeps their count; every prefix of Halton's and Sobol's
// stays a drawing.

#include <cstdint>

#include "lab/related/wanted.h"

namespace dapple {

/// The digits of i in that base, mirrored at the point: 0.125 for 4 in base 2 (van der Corput). base >= 2.
double radical_inverse(std::uint32_t base, std::uint64_t i);

/// J. H. Halton, "On the efficiency of certain quasi-random sequences of points" (1960), bases 2 and 3:
/// points 0, 1, ... of the sequence.
PlainDots halton(const DotsWanted& wanted);

/// J. M. Hammersley, "Monte Carlo methods for solving multivariable problems" (1960): (i / n, radical inverse
/// of i in base 2).
PlainDots hammersley(const DotsWanted& wanted);

/// The first points of I. M. Sobol's sequence (1967), in its first two dimensions.
PlainDots sobol(const DotsWanted& wanted);

/// The g below n with which the points (i / n, (g i mod n) / n) are farthest apart on the torus, the first of
/// several: S. Dammertz & A. Keller, "Image Synthesis by Rank-1 Lattices" (2008), "maximised minimum distance
/// lattices". All of 1..n/2 are tried, each by reducing the lattice's basis (Gauss). 1 <= n < 2^31.
std::uint32_t best_generator(std::uint32_t n);

/// That lattice.
PlainDots rank1_lattice(const DotsWanted& wanted);

}  // namespace dapple
