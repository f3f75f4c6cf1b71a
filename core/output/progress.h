#pragma once

#include <functional>

namespace dapple {

/// Told now and then how much of a file is written, 0..1. What it throws passes through the writer, which is
/// how writing is stopped.
using WritingProgress = std::function<void(double share)>;

/// Dots between two calls: a few a second at least.
inline constexpr std::size_t kDotsPerReport = 1 << 15;

}  // namespace dapple
