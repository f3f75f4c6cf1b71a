#pragma once
// The picture that the program carries inside itself.

#include "io/files/picture.h"

namespace dapple {

/// A still life of shaded solids, 1024 x 1024.
Picture sample_picture(PictureColours colours = PictureColours::left_out);

}  // namespace dapple
