#pragma once
// A reader as in readers.h, for pictures: it uses the decoder that the program is linked with.

#include <string>

#include "io/decoding/picture_format.h"

namespace dapple {

void read_any_picture(PictureFormat format, const std::string& bytes);

}  // namespace dapple
