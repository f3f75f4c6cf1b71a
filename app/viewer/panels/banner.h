#pragma once

#include <glm/vec2.hpp>
#include <string>

namespace dapple {

enum class BannerKind { error, notice };

/// A message at the top of the canvas until the person closes it or another replaces it.
struct Banner {
    BannerKind kind = BannerKind::notice;
    std::string message;  // empty: nothing is shown
};

/// Draws it within a rectangle; clicking the cross empties it.
void draw_banner(Banner& banner, glm::vec2 corner, glm::vec2 size);

}  // namespace dapple
