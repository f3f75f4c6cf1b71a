#pragma once
// What a decoder's process may use. A file that makes a library go wild then costs a sentence.

#include <cstdint>

namespace dapple {

/// Memory to look at a file's header with, files to open besides it, and none to write.
void limit_decoder();

/// As many bytes as it takes to look at a header, and as many more twice over.
void limit_decoder_memory(std::uint64_t pixel_bytes);

/// Once the size is known: memory for so many bytes of pixels twice over, and time by them.
void limit_decoder_to(std::uint64_t pixel_bytes);

}  // namespace dapple
