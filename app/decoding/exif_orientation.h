#pragma once
// How the camera was held, as EXIF tells it: a TIFF's first directory, tag 274.

#include <span>

namespace dapple {

/// The orientation, 1..8, in an EXIF block without what its file puts before it. 1, upright, if there is none
/// or it is damaged.
int orientation_in(std::span<const unsigned char> exif);

}  // namespace dapple
