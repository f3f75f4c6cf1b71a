#pragma once
// Icons to draw with few dots: shapes that are given by formulas, with hard edges and soft ones.

#include <vector>

#include "lab/compare/measure.h"

namespace dapple {

/// Pixels along each side.
inline constexpr int kIconSide = 256;

/// A star, a leaf, a cup, a moon and a ball with a face.
std::vector<ComparedPicture> icons();

}  // namespace dapple
