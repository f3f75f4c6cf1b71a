#pragma once
// Decodes a file in a process of its own.

#include <filesystem>

#include "app/decoding/decoded_image.h"

namespace dapple {

/// Gives the first picture of a file to the sink. Throws DecodeError with a sentence that does not name the
/// file: it is missing, a folder, empty, not allowed to be read, in none of picture_formats(), too large,
/// damaged, or its decoder crashed or took more memory or time than a picture of its size may.
void decode_file(const std::filesystem::path& path, const DecodeRequest& request, ImageSink& sink);

}  // namespace dapple
