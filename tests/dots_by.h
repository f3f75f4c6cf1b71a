#pragma once
// Who draws the dots in tests of what is drawn: each runs once with either.

#include <cstdlib>
#include <string_view>

#include "app/viewer/canvas/renderer.h"

namespace dapple {

/// As the environment says, "card" or "processor"; or else as the program would.
inline DotsBy dots_by_in_environment() {
    const char* const by = std::getenv("DAPPLE_DOTS_BY");
    if (!by) return usual_dots_by();
    return std::string_view(by) == "card" ? DotsBy::graphics_card : DotsBy::processor;
}

}  // namespace dapple
