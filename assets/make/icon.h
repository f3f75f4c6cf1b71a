#pragma once

#include <cstdint>
#include <vector>

namespace dapple::make {

/// The window icon: a stippled ball on paper, transparent around it. RGBA bytes, alpha not premultiplied, row
/// by row from the top. Small sizes get fewer and relatively larger dots, so that each stays a dot.
std::vector<std::uint8_t> icon(int size);

}  // namespace dapple::make
