#include "app/viewer/shell/screens.h"

#include <algorithm>
#include <cstdint>
#include <glm/common.hpp>

namespace dapple {

bool is_within_reach(const Rectangle<int>& window, std::span<const Rectangle<int>> screens) {
    constexpr int kHold = 40;
    return std::ranges::any_of(screens, [&](const Rectangle<int>& screen) {
        return window.high.x >= screen.low.x + kHold && window.low.x <= screen.high.x - kHold &&
               window.low.y >= screen.low.y && window.low.y <= screen.high.y - kHold;
    });
}

std::size_t screen_under(const Rectangle<int>& window, std::span<const Rectangle<int>> screens) {
    std::size_t best = 0;
    std::int64_t most = 0;
    for (std::size_t i = 0; i < screens.size(); ++i) {
        const glm::ivec2 shared = glm::max(
            glm::min(window.high, screens[i].high) - glm::max(window.low, screens[i].low), glm::ivec2(0));
        const std::int64_t area = std::int64_t{shared.x} * shared.y;
        if (area <= most) continue;
        most = area;
        best = i;
    }
    return best;
}

}  // namespace dapple
