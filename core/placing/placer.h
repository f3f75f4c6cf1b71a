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

#include "core/image/density.h"
#include "core/placing/dots.h"
#include "core/placing/placing_table.h"
#include "core/placing/tie_order.h"

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
    double scale = 0;         // finite, >= 0: about 16 * scale * mean density dots, whatever the tile
    PageWindow window{};      // which dots: those whose position is in [x, x + width) x [y, y + height)
    bool appearance = false;  // fill Dots::threshold and Dots::critical too
    int threads = 1;          // the dots and their order are the same for any number; 0: all cores
    PlacingOrigin origin = PlacingOrigin::window;  // page: the very positions that the whole page's dots have
};

/// A drawing of the whole page with exactly so many dots: those of lowest critical scale; where some are
/// equal, the first in the order of core/placing/tie_order.h.
struct ExactCount {
    std::uint64_t count = 0;
    bool appearance = false;  // as above
    int threads = 1;
    PageWindow window{};  // which of them are handed over, at the positions that they have on the page
};

/// Where a drawing of exactly so many dots ends.
struct CountCut {
    double scale = 0;        // all of the dots exist there, and a few more
    double early_scale = 0;  // below the critical scale of any dot that is dropped
    float limit = 0;         // the highest critical scale of a dot that stays
    TieKey last_tie{};       // of the dots with just that one, those up to this stay

    /// The lowest scale at which all of the dots exist.
    double last_scale() const;
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
    Placer(Placer&&) noexcept;
    Placer& operator=(Placer&&) noexcept;
    ~Placer();

    const PlacingTable& table() const { return *table_; }
    const std::shared_ptr<const PlacingTable>& shared_table() const { return table_; }

    /// Places into `dots`, overwriting it and using its memory again, in the order of the recursion. Returns
    /// false, with `dots` in an unspecified state, if the stop token asked to stop first.
    bool place(const Density& density, const PlacingRequest& request, DotPieces& dots,
               std::stop_token stop = {});

    /// The same dots in the same order, handed over in pieces of some thousands: a drawing of any size in
    /// constant memory.
    bool place_in_pieces(const Density& density, const PlacingRequest& request, const TakePiece& take,
                         std::stop_token stop = {});

    /// Places exactly request.count dots. Returns a scale at which all of them exist, or nothing if stopped.
    /// Throws std::runtime_error if the density is 0 everywhere, or dark nowhere that so many dots fit.
    std::optional<double> place_exactly(const Density& density, const ExactCount& request, DotPieces& dots,
                                        std::stop_token stop = {});

    /// The two halves of that, for drawings too large to be held: the search for the end, and the same dots
    /// in the same order in pieces.
    std::optional<CountCut> find_cut(const Density& density, const ExactCount& request,
                                     std::stop_token stop = {});
    bool place_in_pieces(const Density& density, const ExactCount& request, const CountCut& cut,
                         const TakePiece& take, std::stop_token stop = {});

    /// Where place() and place_exactly() say, from now on, which share of their work is done, 0..1: piece by
    /// piece, for another thread to look at. Now and then a count takes a second try, which begins anew.
    /// Null: nowhere.
    void tell_share(std::atomic<float>* share);

 private:
    std::shared_ptr<const PlacingTable> table_;
    std::unique_ptr<PlacerMemory> memory_;
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

}  // namespace dapple
