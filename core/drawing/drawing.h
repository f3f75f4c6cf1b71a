#pragma once
// A drawing on its way into a file: its dots, the page, and what is drawn in the dots' place; and the order
// in which they go there.

#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/drawing/settings.h"
#include "core/image/rectangle.h"
#include "core/lines/inking.h"
#include "core/output/drawing_format.h"
#include "core/output/sheet.h"
#include "core/placing/dot_order.h"
#include "core/placing/page.h"
#include "core/placing/placer.h"
#include "core/routing/short_way.h"
#include "core/strokes/dot_shape.h"
#include "core/strokes/strokes.h"
#include "core/watch.h"

namespace dapple {

/// More dots than this are not held in memory to be sorted unless someone asks for an order.
inline constexpr std::uint64_t kMostSortedDots = 5'000'000;

/// Up to so many dots a short way is found by itself: seconds, for a plot that it makes minutes shorter.
inline constexpr std::uint64_t kMostRoutedDots = 1'000'000;

/// The order that suits such a file: shortest for one that is plotted, up to kMostRoutedDots, and space, up
/// to kMostSortedDots; else as placed. One line through all dots is the shortest in any file, up to
/// kMostSortedDots, and then along a Hilbert curve.
DotOrder usual_order(DrawingFormat format, std::uint64_t dots, DrawingStyle style = DrawingStyle::dots);

/// Whether the order of the dots shows in such a file.
bool has_order(DrawingFormat format, DrawingStyle style);

/// The machine that such a file is most often for.
Machine usual_machine(DrawingFormat format, GcodeTool tool);

/// All dots of a stream, sorted; `recursion` leaves them as they come. The shortest order takes a
/// while.
Dots sorted_dots(const DotStream& stream, DotOrder order, const Watch& watch = {});

/// The same, each pen's by themselves, one pen after the other. If stopped, some are missing.
DotPieces sorted_by_pen(const DotStream& stream, DotOrder order, const Watch& watch = {});

/// Sorts the dots of each piece. Returns how long the way along the curve was, in page units, if it was made
/// shorter.
std::optional<double> put_in_order(DotPieces& by_pen, DotOrder order, const Watch& watch = {});

/// What is to be saved where.
struct DrawingFile {
    std::filesystem::path path = {};  // "-": the standard output
    DrawingFormat format = DrawingFormat::svg;
    DrawingSettings settings = {};
    SavingChoice saving = {};
    std::string embedded = {};  // see embedded_settings(); empty: none go into the file
};

/// What goes into such a file.
struct DrawingToSave {
    DrawingFile file = {};
    DotStream dots;  // with what says when they appear if they go into a table
    PageSize page;
    Palette pens = {};                    // several, for Dots::pen; none: the ink
    double dot_radius_mm = 0;             // of all, or of the largest where they have radii of their own
    std::vector<PlacedTile> tiles = {};   // outlines, for SVG; none, no layer
    std::vector<CutMark> cut_marks = {};  // of a sheet, for SVG and PDF
    std::optional<Rectangle<double>> picture = {};  // page units: where they end; none: at the page's edges
    std::size_t tile_size = 16;                     // N
    /// Where lines from dot to dot are drawn on a part of the page: the dots are the whole page's, and `page`
    /// is the part, whose corner is so many millimetres from theirs.
    std::optional<glm::dvec2> part_corner_mm = {};
    DrawnInking inking = {};  // lines and solid blacks among the dots
    std::optional<StrokeStream> strokes =
        {};  // what is drawn in the dots' place, if not what follows from them
};

/// Each dot's shape in such a file. Where a machine would only touch the paper, a spiral fills dots of
/// several sizes, unless a template of one's own asks for their {radius}.
DotMark mark_in(const DrawingFile& file);

/// What a pen draws of the dots in the order given; none where they are filled circles, and of tables, which
/// have dots alone. With lines and solid blacks where a pen draws these too. Lines from dot to dot are held
/// in memory; the drawing has to outlive the stream.
std::optional<StrokeStream> strokes_of(const DrawingToSave& drawing);

/// The order of its dots in the file: the one asked for, or usual_order().
DotOrder order_of(const DrawingToSave& drawing);

}  // namespace dapple
