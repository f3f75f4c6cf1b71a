#pragma once
// The libraries' part: each decoder program has one of them.

#include "app/decoding/decoded_image.h"
#include "app/decoding/picture_format.h"

namespace dapple {

/// Called when the size is known, before the pixels are read: bytes that all of them take in memory.
using BeforePixels = void (*)(std::uint64_t bytes);

/// Reads the picture behind an open file descriptor, which stays open. Throws DecodeError with a sentence
/// that does not name the file; what the sink throws passes through.
void decode(int file, PictureFormat format, const DecodeRequest& request, BeforePixels before_pixels,
            ImageSink& sink);

}  // namespace dapple
