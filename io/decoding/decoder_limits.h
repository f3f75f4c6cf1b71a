#pragma once
// What a decoder's process may use, so that a file that makes a library go wild costs no more than a
// sentence.

#include <cstdint>

namespace dapple {

/// What the pixels of a picture take: memory at a time, and work, which goes by all of them.
struct PixelBytes {
    std::uint64_t in_memory = 0, in_all = 0;
};

/// More than any picture of at most so many pixels has.
std::uint64_t most_pixel_bytes(std::int64_t most_pixels);

/// Memory and time to look at a file's header with, files to open besides it, and none to write. For good, it
/// is never more than a picture of at most so many pixels may use.
void limit_decoder(std::int64_t most_pixels);

/// Once the size is known: memory to look at a header, and twice over what the pixels take; and time by them.
/// For good: afterwards there is only less.
void limit_decoder_to(const PixelBytes& pixels);

/// Limits memory alone, and not for good.
void limit_decoder_memory(std::uint64_t pixel_bytes);

}  // namespace dapple
