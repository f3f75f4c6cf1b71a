#pragma once
// The exact placer: every dot {p : scale * density(p) > threshold(p)} of the endless subdivision, each once.
//
// Lagae & Dutré's recursion (2006, Figure 8) with three changes. A child tile tests only its newborn points,
// so no dot comes twice. Whether to go on is decided by the density's maximum over the square, so nothing is
// lost. Newborn points are ranked jointly, so every density between two levels is about as even as the levels
// are.

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/export.h"
#include "core/image/density.h"
#include "core/placing/dot_order.h"
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

/// Where a drawing of exactly so many dots ends.
struct CountCut {
    double scale = 0;       // all of the dots exist there, and a few more
    double tail_scale = 0;  // below the critical scale of any dot that is dropped
    float limit = 0;        // the highest critical scale of a dot that stays
    TieKey last_tie{};      // of the dots with just that one, those up to this stay

    /// The lowest scale at which all of the dots exist.
    double last_scale() const;
    bool operator==(const CountCut&) const = default;
};

/// Which dots, and what is to be known of them.
struct PlacingRequest {
    double scale = 2500;  // finite, >= 0: about expected_dots(density, scale), whatever the tile
    /// Instead of the scale: exactly so many on the whole page, those of lowest critical scale; where some
    /// are equal, the first in the order of core/placing/dot_order.h.
    std::optional<std::uint64_t> count = {};
    int threads = 1;          // the dots and their order are the same for any number; 0: all cores
    bool thresholds = false;  // fill Dots::threshold and Dots::critical too
    PageWindow window = {};   // of these dots those whose position is in [x, x + width) x [y, y + height)
    PlacingOrigin origin = PlacingOrigin::window;  // page: the very positions that the whole page's dots
                                                   // have; always so where a count is given
    std::optional<CountCut> cut = {};              // that of the count, if find_cut() was asked before

    bool operator==(const PlacingRequest&) const = default;
};

/// Gets a drawing piece by piece, in order. False ends the placing.
using TakePiece = std::function<bool(const Dots& piece)>;

struct PlacerMemory;

/// Keeps its working memory between calls, so that a warm frame allocates nothing.
class Placer {
 public:
    explicit Placer(PlacingTable table);
    /// With a table that others use too.
    explicit Placer(std::shared_ptr<const PlacingTable> table);
    DAPPLE_API Placer(Placer&&) noexcept;
    Placer& operator=(Placer&&) noexcept;
    DAPPLE_API ~Placer();

    const PlacingTable& table() const { return *table_; }
    const std::shared_ptr<const PlacingTable>& shared_table() const { return table_; }

    /// Places into `dots`, overwriting it and using its memory again, in the order of the recursion. Returns
    /// a scale at which all of them exist: the one given, or the lowest that has the count. Nothing, with
    /// `dots` in an unspecified state, if the stop token asked to stop first. Throws std::runtime_error if
    /// the scale is negative or not finite, and given a count if the density is 0 everywhere, or dark nowhere
    /// that so many dots fit.
    std::optional<double> place(const Density& density, const PlacingRequest& request, DotPieces& dots,
                                std::stop_token stop = {});

    /// The same dots in the same order, handed over in pieces of some thousands: a drawing of any size in
    /// constant memory. False if stopped, or ended by the taker.
    bool hand_over(const Density& density, const PlacingRequest& request, const TakePiece& take,
                   std::stop_token stop = {});

    /// The end of a drawing with a count, for who hands it over more than once. Nothing if stopped.
    std::optional<CountCut> find_cut(const Density& density, const PlacingRequest& request,
                                     std::stop_token stop = {});

    /// Where place() says, from now on, which share of its work is done, 0..1: piece by
    /// piece, for another thread to look at. Now and then a count takes a second try, which begins anew.
    /// Null: nowhere.
    void report_share(std::atomic<float>* share);

 private:
    std::optional<double> place_count(const Density& density, const PlacingRequest& request, DotPieces& dots,
                                      const std::stop_token& stop);
    bool hand_over_count(const Density& density, const PlacingRequest& request, const TakePiece& take,
                         const std::stop_token& stop);

    std::shared_ptr<const PlacingTable> table_;
    std::unique_ptr<PlacerMemory> memory_;
};

/// A tile of the subdivision, for drawing its outline.
struct PlacedTile {
    int level = 0;
    double x = 0, y = 0, side = 0;  // page units, from the window's origin
    Orientation orientation;
    std::optional<std::size_t> kind = {};  // if there are several
};

/// The tiles of every level that the recursion goes into and that touch the window, parents before children.
std::vector<PlacedTile> placed_tiles(const PlacingTable& table, const Density& density,
                                     const PlacingRequest& request);

// A drawing's dots on their way into a file: handed over in pieces, so that a drawing of any size needs the
// memory of a piece.

struct DotStream {
    std::uint64_t count = 0;       // of dots in all
    double scale = 0;              // all of them exist at it
    std::uint64_t duplicates = 0;  // of the whole page's dots, Figure 8's only

    /// Hands over all dots, from the first on each time that it is called.
    std::function<void(const TakePiece& take)> for_each_piece = [](const TakePiece&) {};
};

/// Dots in memory, which have to outlive the stream.
DotStream stream_of(const Dots& dots, double scale = 0);
DotStream stream_of(const DotPieces& dots, double scale = 0);
/// Dots in memory that the stream owns.
DotStream stream_of(std::shared_ptr<const DotPieces> dots, double scale = 0);

}  // namespace dapple
