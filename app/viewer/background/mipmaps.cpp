#include "app/viewer/background/mipmaps.h"

#include <algorithm>
#include <glm/vec4.hpp>
#include <utility>

namespace dapple {
namespace {

Grid<glm::u8vec4> halved(const Grid<glm::u8vec4>& picture) {
    Grid<glm::u8vec4> half(std::max(picture.width / 2, 1), std::max(picture.height / 2, 1));
    for (int y = 0; y < half.height; ++y) {
        const glm::u8vec4* const upper = picture.row(std::min(2 * y, picture.height - 1));
        const glm::u8vec4* const lower = picture.row(std::min(2 * y + 1, picture.height - 1));
        for (int x = 0; x < half.width; ++x) {
            const int left = std::min(2 * x, picture.width - 1),
                      right = std::min(2 * x + 1, picture.width - 1);
            const glm::uvec4 sum = glm::uvec4(upper[left]) + glm::uvec4(upper[right]) +
                                   glm::uvec4(lower[left]) + glm::uvec4(lower[right]);
            half.at(x, y) = glm::u8vec4((sum + 2u) / 4u);
        }
    }
    return half;
}

}  // namespace

std::vector<Grid<glm::u8vec4>> mipmaps_of(Grid<glm::u8vec4> picture) {
    std::vector<Grid<glm::u8vec4>> levels;
    if (picture.empty()) return levels;
    levels.push_back(std::move(picture));
    while (levels.back().width > 1 || levels.back().height > 1) levels.push_back(halved(levels.back()));
    return levels;
}

Grid<glm::u8vec4> small_copy(const std::vector<Grid<glm::u8vec4>>& mipmaps, int longest_side) {
    const auto fits = [&](const Grid<glm::u8vec4>& copy) {
        return std::max(copy.width, copy.height) <= longest_side;
    };
    const auto first = std::ranges::find_if(mipmaps, fits);
    return first == mipmaps.end() ? Grid<glm::u8vec4>{} : *first;
}

}  // namespace dapple
