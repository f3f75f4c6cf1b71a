#pragma once
// Decoding with a library: each decoder program is linked with one of the functions that do it.

#include <functional>

#include "io/decoding/decoded_image.h"
#include "io/decoding/decoder_limits.h"
#include "io/decoding/picture_format.h"

namespace dapple {

/// Called when the size is known, before the pixels are read, and before that with what a file merely states,
/// which is no less.
using BeforePixels = std::function<void(const PixelBytes&)>;

/// Reads the picture behind an open file descriptor, which stays open. Throws DecodeError with a sentence
/// that does not name the file; what the sink throws passes through.
void decode(int file, PictureFormat format, const DecodeRequest& request, const BeforePixels& before_pixels,
            ImageSink& sink);

}  // namespace dapple
