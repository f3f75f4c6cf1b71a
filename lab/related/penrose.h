#pragma once
// Penrose tiles with relaxation: V. Ostromoukhov, C. Donohue & P.-M. Jodoin, "Fast Hierarchical Importance
// Sampling with Blue Noise Properties" (2004).
//
// The tiling is divided where the density asks for more vertices; a vertex is a dot where the density is
// above its number; and the dot is then moved by a correction that depends on its surroundings and on the
// density alone, found once by Lloyd's method on constant densities.
//
// What differs from the paper: see penrose_tiling.h for the numbers. A vertex's surroundings are told by the
// kinds of the triangles that it came from and by how many divisions ago it came (the paper has 21 structural
// indices), and there are corrections for 64 densities from a level to the next (the paper has 8).

#include "lab/related/wanted.h"

namespace dapple {

/// Exactly the count. The first call makes the corrections, which takes about two seconds. There is one
/// tiling, whatever the seed.
PlainDots penrose_tiles(const DotsWanted& wanted);

/// The same dots before they are moved, of which the first n are the drawing with n.
PlainDots penrose_vertices_only(const DotsWanted& wanted);

}  // namespace dapple
