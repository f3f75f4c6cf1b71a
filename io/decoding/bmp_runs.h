#pragma once
// BMP files whose pixels are kept as runs (RLE). OpenImageIO 2.4 reads those of greys wrong, and refuses ends
// of lines after the last row, which many programs write.

#include <optional>
#include <vector>

namespace dapple {

/// The same picture as a BMP file of 8 bits a pixel without runs. Nothing: it has none. Throws DecodeError if
/// it ends before its last row does, or goes on after it.
std::optional<std::vector<unsigned char>> bmp_without_runs(int file);

}  // namespace dapple
