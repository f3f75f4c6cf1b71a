#pragma once
// Decodes a file in a process of its own.

#include <filesystem>
#include <stop_token>

#include "io/decoding/decoded_image.h"
#include "io/decoding/image_pipe.h"
#include "io/decoding/picture_format.h"

namespace dapple {

/// The program that decodes a format: beside the running one, or where that is installed or built. Throws
/// DecodeError where it is missing.
std::filesystem::path decoder_for(PictureFormat format);

/// Gives the first picture of a file to the sink. Throws DecodeError with a sentence that does not name the
/// file: it is missing, a folder, empty, not allowed to be read, in none of picture_formats(), too large,
/// damaged, or its decoder crashed or took more memory or time than a picture of its size may; and when it is
/// stopped, which ends the decoder at once.
void decode_file(const std::filesystem::path& path, const DecodeRequest& request, ImageSink& sink,
                 std::stop_token stop = {});

/// A smaller picture of the same, as DecodeRequest::enough_side says: of a large JPEG or raw file, or of a
/// TIFF or EXR with mipmaps. Throws DecodeError for any other.
void decode_file_smaller(const std::filesystem::path& path, const DecodeRequest& request, ImageSink& sink,
                         std::stop_token stop = {});

/// The same by a given decoder, run as decoder_main.cpp says.
void decode_file_by(const std::filesystem::path& decoder, const std::filesystem::path& path,
                    const DecodeRequest& request, ImageSink& sink, const DecoderPatience& patience = {});

}  // namespace dapple
