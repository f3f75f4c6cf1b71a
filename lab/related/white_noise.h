#pragma once
// White noise: independent dots, the yardstick of all others.

#include "lab/related/wanted.h"

namespace dapple {

/// For a picture by inversion (see BentSquare). Any count.
PlainDots white_noise(const DotsWanted& wanted);

}  // namespace dapple
