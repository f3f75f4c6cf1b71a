#pragma once
// A drawing into a file, for the window and the command line alike.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>

#include "app/drawing_settings.h"
#include "core/image/rectangle.h"
#include "core/placing/dot_order.h"
#include "core/placing/placer.h"
#include "core/placing/stipple.h"
#include "core/routing/short_way.h"

namespace dapple {

enum class DrawingFormat { svg, png, csv };

/// What a name's ending says, in upper or lower case. Throws std::runtime_error if it is another.
DrawingFormat drawing_format(const std::filesystem::path& path);

/// More dots than this are not held in memory to be sorted unless someone asks for an order.
inline constexpr std::uint64_t kMostSortedDots = 5'000'000;

/// Up to so many dots, the shortest way takes about a second.
inline constexpr std::uint64_t kMostRoutedDots = 50'000;

/// The order that suits such a file: SVG is plotted, so shortest, up to kMostRoutedDots, and space, up to
/// kMostSortedDots; else as placed.
DotOrder usual_order(DrawingFormat format, std::uint64_t dots);

/// All dots of a stream, sorted; `recursion` leaves them as they come. The shortest order takes a
/// while.
Dots sorted_dots(const DotStream& stream, DotOrder order, const RoutingWatch& watch = {});

struct DrawingToSave {
    DotStream dots;  // with what says when they appear if they go into a table
    PageSize page;
    double dot_radius_mm = 0;                // of all, or of the largest where they have radii of their own
    std::span<const PlacedTile> tiles = {};  // outlines, for SVG; none, no layer
    std::optional<Rectangle<double>> picture = {};  // page units: where they end; none: at the page's edges
    std::size_t tile_size = 16;                     // N
    double dpi = 300;                               // of a PNG
    std::optional<DotOrder> order = {};  // none: the usual one; `recursion` writes the dots as they come
};

/// For someone who waits.
struct SavingWatch {
    std::stop_token stop;                        // asks to give up
    std::function<void(double share)> progress;  // told now and then how much is written, 0..1
};

/// Writes what the name's ending says. Returns false if stopped. Throws what drawing_format() and
/// save_atomically() throw. In both cases an existing file stays as it was.
bool save_drawing(const std::filesystem::path& path, const DrawingSettings& settings,
                  const DrawingToSave& drawing, const SavingWatch& watch = {});

}  // namespace dapple
