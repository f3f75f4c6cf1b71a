#pragma once
// How the camera was held, as EXIF tells it: a TIFF's first directory, tag 274.

#include <glm/vec2.hpp>
#include <span>

namespace dapple {

/// The EXIF orientation, 1..8. 1 and any other number are upright; 5..8 swap width and height.
struct ExifOrientation {
    int value = 1;
    bool swaps_sides() const { return value >= 5 && value <= 8; }
    /// Where pixel (x, y) of a stored picture of the given size belongs when it is held upright.
    glm::ivec2 upright(int x, int y, int width, int height) const;
};

/// The orientation, 1..8, in an EXIF block without what its file puts before it. 1, upright, if there is none
/// or it is damaged.
int orientation_in(std::span<const unsigned char> exif);

}  // namespace dapple
