#include "app/viewer/background/dot_blocks.h"

#include <algorithm>
#include <numeric>
#include <span>

namespace dapple {

std::vector<DotBlock> dot_blocks(const DotPieces& dots) {
    std::vector<DotBlock> blocks;
    blocks.reserve(dots.size() / kDotsPerBlock + dots.pieces.size());
    std::size_t index = 0;
    for (std::size_t piece = 0; piece < dots.pieces.size(); ++piece) {
        const Dots& columns = dots.pieces[piece];
        const bool has_radii = columns.radius.size() == columns.size();
        for (std::size_t first = 0; first < columns.size(); first += kDotsPerBlock) {
            const std::size_t count = std::min(kDotsPerBlock, columns.size() - first);
            const auto part = [&](const FloatBuffer& column) {
                return std::span(column).subspan(first, count);
            };
            const auto [left, right] = std::ranges::minmax(part(columns.x));
            const auto [top, bottom] = std::ranges::minmax(part(columns.y));
            DotBlock block{.piece = piece,
                           .first = first,
                           .index = index,
                           .count = count,
                           .low = {left, top},
                           .high = {right, bottom}};
            if (has_radii) {
                const auto radii = part(columns.radius);
                block.radii = std::accumulate(radii.begin(), radii.end(), 0.0);
                block.largest_radius = std::ranges::max(radii);
            }
            blocks.push_back(block);
            index += count;
        }
    }
    return blocks;
}

}  // namespace dapple
