#pragma once
// What a Radiance picture says of itself (radsite.lbl.gov/radiance/refer/filefmts.pdf), read without a
// library.

#include <cstddef>
#include <glm/mat3x3.hpp>
#include <string>

namespace dapple {

struct RadianceHeader {
    /// The header of the same pixels, first row first, as OpenImageIO reads it: that needs a FORMAT, and
    /// numbers two of the eight orders of rows and columns by each other's EXIF number.
    std::string plain;
    std::size_t size = 0;    // bytes before the pixels
    int orientation = 1;     // EXIF's, of the stored rows
    float pixel_aspect = 1;  // a stored pixel's length along its row for that across
    /// From the values to the light: they were multiplied by every EXPOSURE and every COLORCORR.
    glm::mat3 light = glm::mat3(1);
};

/// Of an open file, whose descriptor keeps its place. Throws DecodeError with a sentence if it is none that
/// can be read: its pixels are XYZ, it has no size, an EXPOSURE or COLORCORR that is not a number over 0.
RadianceHeader radiance_header(int file);

}  // namespace dapple
