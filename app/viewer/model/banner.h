#pragma once
// A message to the person at the window, with at most one thing to do about it.

#include <string>

namespace dapple {

enum class BannerKind { error, notice };

/// An offer that fades with its notice.
inline constexpr const char* kShowInFolder = "Show in folder";

/// A message at the top of the canvas until the person closes it or another replaces it; a notice goes by
/// itself after some seconds, unless the mouse is on it.
struct Banner {
    BannerKind kind = BannerKind::notice;
    std::string message;   // empty: nothing is shown
    float shown_for = -1;  // seconds; below 0: not yet
    std::string offer{};   // on a button; with another than that it stays until it is closed
};

inline bool is_trouble(const Banner& banner) {
    return banner.kind == BannerKind::error && !banner.message.empty();
}

}  // namespace dapple
