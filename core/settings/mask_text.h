#pragma once
// A mask within settings: its levels, packed and written in letters.

#include <string>
#include <string_view>

#include "core/image/mask.h"

namespace dapple {

/// The levels, row after row from the top, as zlib packs them (RFC 1950), in base64.
std::string packed_levels(const Mask& mask);

/// Throws std::runtime_error with what is wrong, "are not ...", if the text is not so many levels.
Mask unpacked_mask(std::string_view text, int width, int height);

}  // namespace dapple
