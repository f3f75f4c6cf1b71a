#pragma once
// What is known of the dot under the pointer: where in the subdivision it comes from, and when it appears.

#include <cstddef>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/viewer/background/dots_request.h"
#include "app/viewer/view/camera.h"

namespace dapple {

/// The tile that a drawing was placed with.
struct PlacedWith {
    std::size_t tile_size = 16;  // points
    Rule rule;                   // how it turns its children; of Figure 8 the identity
    PlacerKind placer = PlacerKind::exact;
    /// As TileView has them; without them nothing is known of where a relaxed dot was placed.
    std::span<const glm::vec2> points = {}, newborn = {};
};

struct DotOrigin {
    glm::dvec2 position{0};  // page units from the drawing's window, as drawn
    int level = 0;           // at which it was born
    int rank = 0, born = 0;  // 0 is the first to appear of so many points that the level brings a tile
    double critical = 0;     // it exists at scales above this
    double density = 0;      // where it was placed; with several pens its own pen's
    bool relaxed = false;    // it was moved since
    /// The tile of its level that it was born in. A relaxed dot may have left it: then it is, of the tiles
    /// around, the one in which the place for the dot's level and rank is nearest to the dot.
    std::optional<PlacedTile> tile = {};
};

/// The dot nearest to the pointer, of those within `reach` page units; none if none is, or if the drawing was
/// placed without its thresholds. Within a float's rounding of a tile's edge, `tile` may be the neighbour.
std::optional<DotOrigin> dot_under(const PlacedDrawing& drawing, const PlacedWith& with, PagePoint pointer,
                                   double reach);

/// The same in lines of words, the first one a title.
std::vector<std::string> origin_in_words(const DotOrigin& dot, const PlacedWith& with, double scale);

}  // namespace dapple
