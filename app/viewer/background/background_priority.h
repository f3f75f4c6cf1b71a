#pragma once
// The window's thread goes first: what works in the background has a lower priority, so that a window on a
// busy machine still answers. Linux alone tells threads apart in this; elsewhere nothing changes.

#include <functional>

namespace dapple {

/// Does `work` in the thread that calls, which works in the background: lowers its priority for good, and
/// meanwhile that of the threads that oneTBB sends to help it. (Those that are started then have it from the
/// beginning.)
void behind_window(const std::function<void()>& work);

}  // namespace dapple
