#pragma once

#include <glm/vec2.hpp>
#include <string>

namespace dapple {

enum class BannerKind { error, notice };

/// A message at the top of the canvas until the person closes it or another replaces it; a notice goes by
/// itself after some seconds, unless the mouse is on it.
struct Banner {
    BannerKind kind = BannerKind::notice;
    std::string message;   // empty: nothing is shown
    float shown_for = -1;  // seconds; below 0: not yet
};

/// Seconds until a notice looks different; 0: it fades. Infinity if it stays as it is.
double rest_of(const Banner& banner);

/// Draws it within a rectangle; clicking the cross empties it.
void draw_banner(Banner& banner, glm::vec2 corner, glm::vec2 size);

}  // namespace dapple
