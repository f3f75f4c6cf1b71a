#pragma once
// How much light a picture is to be drawn with: stops (powers of two) that it is multiplied by first.
//
// A photograph's light ends at the white of its paper, 1. Light as it was in front of a camera, as float
// files have it, knows no paper: a sky may be at 5 and the sun at 50,000, or all of it far below 1.

#include "core/image/grid.h"

namespace dapple {

/// Further than from starlight to the sun.
inline constexpr float kMostStops = 20;

/// The exposure that light as it was in front of a camera opens with. 0 if it could be a photograph's: none
/// of it over 1, and the lightest fiftieth not all below 1/16. Else the 98th percentile becomes white, but
/// where a few lamps or a bright window would leave the rest black, or fog would be bleached, the mean of the
/// logarithm comes within 0.09 .. 0.36; in tenths of a stop. Black parts (light of 0 or less) have no say.
float usual_exposure(const Grid<float>& light);

/// The light multiplied by 2^stops. 0 returns the very same values.
Grid<float> exposed(Grid<float> light, float stops);

}  // namespace dapple
