#pragma once
// Decodes a file in a process of its own.

#include <cstdint>
#include <filesystem>
#include <stop_token>

#include "io/decoding/decoded_image.h"
#include "io/decoding/image_pipe.h"
#include "io/decoding/picture_format.h"
#include "io/descriptor.h"

namespace dapple {

// Pictures from pipes and devices, kept in a file before they are read: decoders go back and forth in them.

/// What comes from a pipe may have no end.
inline constexpr std::uint64_t kMostKeptBytes = 2'000'000'000;

/// Appends what comes from one open file to another, which is empty and may be read too. A PNG and a WebP say
/// where they end: nothing behind is waited for. Of others all is kept. Throws DecodeError with a sentence
/// that names neither: once its beginning has come, if it is in none of picture_formats(); if more than
/// `most` bytes come; if it cannot be read or written; and when it is stopped, also while nothing comes.
void keep_input(int from, int to, std::uint64_t most = kMostKeptBytes, const std::stop_token& stop = {});

/// Where temporary files are made.
std::filesystem::path temporary_folder();

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
