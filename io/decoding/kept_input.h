#pragma once
// Pictures from pipes and devices, kept in a file before they are read: decoders go back and forth in them.

#include <cstdint>
#include <filesystem>
#include <stop_token>

#include "io/descriptor.h"

namespace dapple {

/// What comes from a pipe may have no end.
inline constexpr std::uint64_t kMostKeptBytes = 2'000'000'000;

/// Appends what comes from one open file to another, which is empty and may be read too. A PNG and a WebP say
/// where they end: nothing behind is waited for. Of others all is kept. Throws DecodeError with a sentence
/// that names neither: once its beginning has come, if it is in none of picture_formats(); if more than
/// `most` bytes come; if it cannot be read or written; and when it is stopped, also while nothing comes.
void keep_input(int from, int to, std::uint64_t most = kMostKeptBytes, const std::stop_token& stop = {});

/// The same into a new file without a name, which is gone with its descriptor.
Descriptor kept_input(int from, const std::stop_token& stop = {});

/// Where temporary files are made.
std::filesystem::path temporary_folder();

}  // namespace dapple
