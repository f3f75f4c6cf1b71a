#pragma once
// A mask within settings: its levels and its finenesses, each packed and written in letters.

#include <string>
#include <string_view>

#include <cstdint>

#include "core/image/grid.h"

namespace dapple {

/// The levels, row after row from the top, as zlib packs them (RFC 1950), in base64.
std::string packed_levels(const Grid<std::uint8_t>& levels);

/// Throws std::runtime_error with what is wrong, "are not ...", if the text is not so many levels.
Grid<std::uint8_t> unpacked_levels(std::string_view text, int width, int height);

}  // namespace dapple
