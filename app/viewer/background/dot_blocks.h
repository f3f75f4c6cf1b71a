#pragma once
// A drawing's dots in blocks that lie together on the page, so that who draws a part of it need not look at
// all of them.

#include <algorithm>
#include <cstddef>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/drawing/settings.h"
#include "core/image/colour.h"
#include "core/image/grid.h"
#include "core/lines/inking.h"
#include "core/pens/pen.h"
#include "core/placing/dot_order.h"
#include "core/placing/dots.h"
#include "core/placing/page.h"
#include "core/placing/placer.h"
#include "core/strokes/strokes.h"
#include "core/text/names.h"
#include "core/tile/tile.h"

namespace dapple {

// Pictures as textures take them.

inline Grid<glm::u8vec4> with_alpha(const Grid<glm::u8vec3>& picture) {
    Grid<glm::u8vec4> opaque(picture.width, picture.height);
    std::ranges::transform(picture.values, opaque.values.begin(),
                           [](glm::u8vec3 pixel) { return glm::u8vec4(pixel, 255); });
    return opaque;
}

// Dots in colours that show where in the subdivision they come from.

enum class DotColouring { ink, level, rank, orientation };
constexpr auto names_of(DotColouring) {
    return names("ink", "level", "rank", "orientation");
}

/// Where stepping through the levels ends: this is all of them.
inline constexpr int kDeepestStep = 8;

struct DotColourChoice {
    DotColouring colouring = DotColouring::ink;
    int deepest_level = kDeepestStep;  // whose dots are shown; kDeepestStep: all
    glm::vec3 ink = kBlack;            // sRGB-encoded 0..1; looked at if levels are left out only

    bool operator==(const DotColourChoice&) const = default;
};

/// Whether that choice needs Dots::threshold.
bool needs_thresholds(const DotColourChoice& choice);

/// What the colours are looked up in: the tile that the dots were placed with, and their window.
struct DotOrigins {
    std::size_t tile_size = 16;  // points
    Rule rule;                   // of a Figure 8 drawing the identity: it turns no tile
    PageWindow window;
    NextKinds next_kind = NextKinds(1);
    glm::dvec2 tile_corner{0, 0};  // see Density
};

/// One colour a dot, sRGB-encoded: of the level it was born at, of its rank among the dots born there, or of
/// the orientation of the tile it was born in, or its kind if there are several. Empty for ink: all alike. A
/// dot within a float's rounding of its tile's edge may get the neighbour's orientation.
std::vector<glm::u8vec4> dot_colours(const DotPieces& dots, const DotOrigins& origins,
                                     DotColouring colouring);

/// Hides the dots born at deeper levels than `deepest` by making their colours transparent; no colours become
/// the ink's first. From kDeepestStep on nothing is hidden.
std::vector<glm::u8vec4> without_deeper_levels(std::vector<glm::u8vec4> colours, const DotPieces& dots,
                                               std::size_t tile_size, int deepest, glm::vec3 ink);

/// Both of these, as chosen; empty: all dots in ink.
std::vector<glm::u8vec4> chosen_colours(const DotPieces& dots, const DotOrigins& origins,
                                        const DotColourChoice& choice);

/// Dark blue for the first (0), then teal, then sand for the last (1): darkness falls along the whole ramp,
/// so it reads without colours too.
glm::vec3 rank_colour(double share);

/// Eight hues; the four mirrored orientations are the paler ones.
glm::vec3 orientation_colour(Orientation orientation);

/// The colour of a kind, for a tile of several: hues as far apart as they can be.
glm::vec3 kind_colour(std::size_t kind);

inline constexpr std::size_t kDotsPerBlock = 4096;

/// Dots that follow each other in a piece.
struct DotBlock {
    std::size_t piece = 0, first = 0;  // where they begin in it
    std::size_t index = 0;             // the first one's among all dots
    std::size_t count = 0;             // at least 1, at most kDotsPerBlock
    glm::vec2 low{0}, high{0};         // the box of their centres, page units from the window's corner
    double radii = 0;                  // their sum, page units; 0 if they have none of their own
    float largest_radius = 0;
};

/// All dots, in their order. Ten million take some hundredths of a second.
std::vector<DotBlock> dot_blocks(const DotPieces& dots);

// What a pen would draw, as lines for the canvas.

struct ShownStrokes {
    std::vector<glm::vec4> lines;  // from x, y to x, y in page units; a touch has no length
    std::vector<DotBlock> blocks;  // of the lines, with the boxes around them
    double width = 0;              // page units; of the widest pen
    // For each line, where several pens draw; empty: all in ink, all as wide.
    std::vector<float> widths;       // page units
    std::vector<std::uint8_t> pens;  // places in the drawing's palette
};

enum class LineWay {
    soon,   // along a Hilbert curve
    final,  // as a file has it
};

/// The same as in a file; a file's longest lines are told in millimetres, these in page units from the
/// picture's corner. None where there would be more than 20 million: dots are then shown as circles. Stopped,
/// it is what was reached. `order` is that of one line through all dots, the shortest if there is none;
/// `pens` are the drawing's, if there are several.
ShownStrokes shown_strokes(const DotPieces& dots, const DrawingSettings& settings,
                           std::optional<DotOrder> order, std::span<const Pen> pens, const PageSize& page,
                           double dot_radius, LineWay way, const std::stop_token& stop = {});

/// Lines and solid blacks among the dots, seen from a window's corner in page units.
ShownStrokes shown_inking(const Inking& inking, std::span<const Pen> pens, glm::dvec2 corner);

/// Strokes as they are, in millimetres from the picture's corner. None where there would be so many.
ShownStrokes on_screen(const StrokeStream& strokes, std::span<const Pen> pens, double mm_per_page_unit);

}  // namespace dapple
