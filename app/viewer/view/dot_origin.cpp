#include "app/viewer/view/dot_origin.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/image/density.h"
#include "core/text/number_words.h"

namespace dapple {
namespace {

struct FoundDot {
    const Dots* piece = nullptr;
    std::size_t index = 0;
    double distance = 0;
};

// Blocks are boxes of dots: most lie too far away to be looked into.
FoundDot nearest_dot(const PlacedDrawing& drawing, glm::dvec2 at, double reach) {
    FoundDot nearest{.distance = reach};
    for (const DotBlock& block : drawing.blocks) {
        const glm::dvec2 low(block.low), high(block.high);
        if (glm::distance(at, glm::clamp(at, low, high)) > nearest.distance) continue;
        const Dots& piece = drawing.dots.pieces[block.piece];
        for (std::size_t i = block.first; i < block.first + block.count; ++i) {
            const double distance = glm::distance(at, glm::dvec2(piece.x[i], piece.y[i]));
            if (distance <= nearest.distance) nearest = {&piece, i, distance};
        }
    }
    return nearest;
}

PagePoint in_units(glm::dvec2 page_units) {
    return PagePoint(page_units * 0x1p62);
}

// In 2^-62 page units from the page's corner; walks down to the square from a root tile, all of which are
// alike, turning as the rule says.
PlacedTile tile_around(PagePoint on_page, int level, const Rule& rule, const PlacedDrawing& drawing) {
    constexpr int kDigits = 62;
    const int depth = std::min(level, kDigits);
    const PagePoint root = in_units(drawing.tile_corner), at = on_page - root;
    Orientation tile;
    for (int d = 1; d <= depth; ++d) {
        const int quadrant =
            static_cast<int>((at.x >> (kDigits - d)) & 1) + 2 * static_cast<int>((at.y >> (kDigits - d)) & 1);
        tile =
            compose(tile, rule.child[static_cast<std::size_t>(apply_to_quadrant(inverse(tile), quadrant))]);
    }
    const auto corner = [&](std::int64_t x) { return (x >> (kDigits - depth)) << (kDigits - depth); };
    const PageWindow& window = drawing.window();
    return {.level = level,
            .x = std::ldexp(static_cast<double>(corner(at.x) + root.x - window.x), -kDigits),
            .y = std::ldexp(static_cast<double>(corner(at.y) + root.y - window.y), -kDigits),
            .side = std::ldexp(1.0, -level),
            .orientation = tile};
}

PagePoint on_page(const PageWindow& window, glm::dvec2 in_window) {
    return PagePoint(window.x, window.y) + in_units(in_window);
}

// Steps move a dot by less than the distance to its neighbours, while a tile has the same rank many such
// distances away.
std::optional<PlacedTile> tile_before_relaxing(const DotOrigin& dot, const PlacedWith& with,
                                               const PlacedDrawing& drawing) {
    const bool is_own = dot.level == 0 || with.placer == PlacerKind::figure8;
    const std::span<const glm::vec2> born = is_own ? with.points : with.newborn;
    const auto rank = static_cast<std::size_t>(dot.rank);
    if (rank >= born.size()) return std::nullopt;
    const int level = is_own ? dot.level : dot.level - 1;  // of the tiles that bring it
    const std::int64_t side = (std::int64_t{1} << 62) >> std::min(level, 62);
    const PagePoint here = on_page(drawing.window(), dot.position);
    std::optional<PlacedTile> nearest;
    glm::dvec2 placed{0};
    for (int i = 0; i < 9; ++i) {
        const PagePoint at = here + side * PagePoint(i % 3 - 1, i / 3 - 1);
        const PlacedTile tile = tile_around(at, level, with.rule, drawing);
        const glm::dvec2 place = glm::dvec2(tile.x, tile.y) +
                                 tile.side * (apply(tile.orientation, glm::dvec2(born[rank]) - 0.5) + 0.5);
        const glm::dvec2 there = in_page_units({drawing.window().x, drawing.window().y}) + place;
        if (there.x < 0 || there.y < 0 || there.x >= 1 || there.y >= 1) continue;
        if (nearest && glm::distance(place, dot.position) >= glm::distance(placed, dot.position)) continue;
        nearest = tile;
        placed = place;
    }
    if (!nearest || is_own) return nearest;
    return tile_around(on_page(drawing.window(), placed), dot.level, with.rule, drawing);
}

std::string ordinal(int n) {
    const int tens = n % 100, last = n % 10;
    const bool teen = tens >= 11 && tens <= 13;
    return fmt::format("{}{}", grouped(static_cast<std::uint64_t>(n)),
                       teen || last > 3 || last == 0 ? "th"
                       : last == 1                   ? "st"
                       : last == 2                   ? "nd"
                                                     : "rd");
}

// Scales from thousandths to billions and more.
std::string scale_in_words(double scale) {
    return scale >= 1000 && scale < 1e15 ? grouped(static_cast<std::uint64_t>(std::llround(scale)))
                                         : fmt::format("{:.4g}", scale);
}

std::string turn_in_words(Orientation orientation) {
    const int degrees = 90 * (orientation.index & 3);
    if (orientation.index == 0) return "Its tile stands upright";
    if (orientation.index == 4) return "Its tile is mirrored left to right";
    // y points down: what is counter-clockwise on paper with y up is clockwise here.
    return fmt::format("Its tile is {}turned by {}° clockwise",
                       orientation.index > 4 ? "mirrored left to right, then " : "", degrees);
}

}  // namespace

std::optional<DotOrigin> dot_under(const PlacedDrawing& drawing, const PlacedWith& with, PagePoint pointer,
                                   double reach) {
    const glm::dvec2 at = way_between({drawing.window().x, drawing.window().y}, pointer);
    const FoundDot found = nearest_dot(drawing, at, reach);
    if (!found.piece || found.piece->threshold.size() != found.piece->size() ||
        found.piece->critical.size() != found.piece->size())
        return std::nullopt;
    const Dots& piece = *found.piece;
    const float threshold = piece.threshold[found.index], critical = piece.critical[found.index];
    if (threshold == 0) return std::nullopt;  // added by hand: of no tile
    const TileRank rank = tile_rank_of(threshold, with.tile_size);
    const int n = static_cast<int>(with.tile_size);
    DotOrigin dot{.position = {piece.x[found.index], piece.y[found.index]},
                  .level = rank.level,
                  .rank = rank.level == 0 ? rank.rank : rank.rank - n,
                  .born = rank.level == 0 ? n : 3 * n,
                  .critical = critical,
                  .density = threshold / critical,
                  .relaxed = drawing.steps > 0};
    if (with.placer == PlacerKind::figure8) {
        dot.rank = figure8_rank_of(threshold, with.tile_size).rank;
        dot.born = n;
    }
    dot.tile = dot.relaxed
                   ? tile_before_relaxing(dot, with, drawing)
                   : tile_around(on_page(drawing.window(), dot.position), dot.level, with.rule, drawing);
    return dot;
}

std::vector<std::string> origin_in_words(const DotOrigin& dot, const PlacedWith& with, double scale) {
    const std::string born = grouped(static_cast<std::uint64_t>(dot.born));
    std::vector<std::string> lines{fmt::format("Level {}, {} of {}", dot.level, ordinal(dot.rank + 1), born)};
    if (dot.level == 0 || with.placer == PlacerKind::figure8)
        lines.push_back(fmt::format("In the order of the tile's {} points", born));
    else
        lines.push_back(fmt::format("In the order of the {} points that a division adds", born));
    if (dot.tile && with.placer == PlacerKind::exact) lines.push_back(turn_in_words(dot.tile->orientation));
    lines.push_back(fmt::format("Appears above scale {}; drawn at {}", scale_in_words(dot.critical),
                                scale_in_words(scale)));
    lines.push_back(
        fmt::format("Density {:.3f}{}", dot.density, dot.relaxed ? " where it was placed" : " there"));
    if (dot.relaxed)
        lines.emplace_back(dot.tile ? "Moved from its place in the tile by relaxation"
                                    : "Moved by relaxation; tile unknown");
    return lines;
}

}  // namespace dapple
