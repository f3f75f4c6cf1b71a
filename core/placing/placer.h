#pragma once
// The exact placer: every dot {p : scale * density(p) > threshold(p)} of the endless subdivision, each once.
//
// Lagae & Dutré's recursion (2006, Figure 8) with three changes. A child tile tests only its newborn points,
// so no dot comes twice. Whether to go on is decided by the density's maximum over the square, so nothing is
// lost. Newborn points are ranked jointly, so every density between two levels is about as even as the levels
// are.

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/image/density.h"
#include "core/placing/dots.h"
#include "core/placing/placing_table.h"

namespace dapple {

/// A part of the page. The origin is an integer so that a window 2^-40 wide is as sharp as the whole page.
struct PageWindow {
    std::int64_t x = 0, y = 0;     // in 2^-62 of the root square's side
    double width = 1, height = 1;  // page units

    bool operator==(const PageWindow&) const = default;
};

/// Where positions are counted from.
enum class PlacingOrigin { window, page };

struct PlacingRequest {
    double scale = 0;       // finite, >= 0: about 16 * scale * mean density dots, whatever the tile
    PageWindow window{};    // which dots: those whose position is in [x, x + width) x [y, y + height)
    bool critical = false;  // fill Dots::critical too
    int threads = 1;        // the dots and their order are the same for any number; 0: all cores
    PlacingOrigin origin = PlacingOrigin::window;  // page: the very positions that the whole page's dots have
};

/// Keeps its working memory between calls, so that a warm frame allocates nothing.
class Placer {
 public:
    explicit Placer(PlacingTable table);

    const PlacingTable& table() const { return table_; }

    /// Places into `dots`, overwriting it, in the order of the recursion. Returns false, with `dots` in an
    /// unspecified state, if the stop token asked to stop first.
    bool place(const Density& density, const PlacingRequest& request, Dots& dots, std::stop_token stop = {});

 private:
    PlacingTable table_;
    std::vector<Dots> parts_;  // one a task
};

/// A tile of the subdivision, for drawing its outline.
struct PlacedTile {
    int level = 0;
    double x = 0, y = 0, side = 0;  // page units, from the window's origin
    Orientation orientation;
};

/// The tiles of every level that the recursion goes into and that touch the window, parents before children.
std::vector<PlacedTile> placed_tiles(const PlacingTable& table, const Density& density,
                                     const PlacingRequest& request);

/// A drawing with exactly so many dots: those of lowest critical scale; where some are equal, a few of them
/// spread evenly, always the same ones.
struct ExactCount {
    std::uint64_t count = 0;
    int threads = 1;
};

/// Places exactly request.count dots of the whole page, with Dots::critical filled. Returns a scale at which
/// all of them exist, or nothing if stopped. Throws std::runtime_error if the density is 0 everywhere.
std::optional<double> place_exactly(Placer& placer, const Density& density, const ExactCount& request,
                                    Dots& dots, std::stop_token stop = {});

}  // namespace dapple
