#pragma once
// The standard input as a picture.

#include "io/files/picture.h"

namespace dapple {

/// Copies it to a temporary file, since decoders are programs of their own and go back and forth in what they
/// read, and reads that as read_picture() does. The file is gone afterwards, also if a signal ends the
/// program. Throws std::runtime_error with one sentence that begins with "the standard input".
Picture read_picture_from_standard_input(PictureLimit limit = PictureLimit::usual,
                                         PictureColours colours = PictureColours::left_out);

}  // namespace dapple
