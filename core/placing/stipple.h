#pragma once
// From a density to its dots: a tile made ready for placing, the choice between the two placers, and dots
// either kept or streamed. core/drawing/pipeline.h calls this for a picture.

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/export.h"
#include "core/image/density.h"
#include "core/placing/dots.h"
#include "core/placing/page.h"
#include "core/placing/placer.h"
#include "core/text/names.h"
#include "core/tile/ranking.h"
#include "core/tile/tile.h"
#include "core/tile/tile_file.h"

namespace dapple {

// The paper's placer as printed (Lagae & Dutré 2006, Figure 8): the reference, the baseline and a mode of the
// viewer.

struct Figure8Result {
    Dots dots;                      // as emitted, duplicates included
    double scale = 0;               // they were placed at
    std::uint64_t duplicates = 0;   // dots emitted again at a place that has one
    std::vector<PlacedTile> tiles;  // every tile visited, parents first
};

/// Recursive, in double precision; decides about subdivision at the tile's N points and tests inherited
/// points again. ranks: each point's place in the tile's own order, from farthest_point_ranks(). Throws
/// std::runtime_error if the tile's rule is not the identity: the paper knows no other. Stopped, it returns
/// what it has so far.
Figure8Result place_figure8(const Density& density, const Tile& tile, const std::vector<int>& ranks,
                            double scale, const std::stop_token& stop = {});

/// The same at a scale that has so many distinct dots, or a few more: how many a scale has is known once they
/// are placed. Nothing if stopped. Throws std::runtime_error as above, and if so many are not found, or only
/// with far more: what a tile's points miss is lost.
std::optional<Figure8Result> place_figure8_count(const Density& density, const Tile& tile,
                                                 const std::vector<int>& ranks, std::uint64_t count,
                                                 const std::stop_token& stop = {});

enum class PlacerKind {
    exact,    // each dot once, no feature lost
    figure8,  // the paper's, literal
};
constexpr auto names_of(PlacerKind) {
    return names("exact", "figure8");
}

/// A tile with everything that placing needs of it, ready for use.
class RankedTile {
 public:
    RankedTile(Tile tile, const Ranking& ranking);
    RankedTile(Tile tile, RankingMethod method);

    const Tile& tile() const { return tile_; }
    const std::vector<int>& own_ranks() const { return own_ranks_; }  // for Figure 8; none if it can't be
    Placer& placer() { return placer_; }
    const Placer& placer() const { return placer_; }

 private:
    Tile tile_;
    std::vector<int> own_ranks_;
    Placer placer_;
};

/// A stored tile, ready for use. If its ranking is not by the method given here, it is ranked anew.
DAPPLE_API RankedTile ranked_tile(StoredTile stored, std::optional<RankingMethod> method = {});

/// The dots of a drawing, kept.
struct Stippling {
    DotPieces dots;                // as emitted, or as they lie after `steps`
    int steps = 0;                 // of relaxation
    double scale = 0;              // the one given, or the one that gives the count
    std::uint64_t duplicates = 0;  // of them (Figure 8 only)
    double place_ms = 0;           // wall time of the placing alone,
    double relax_ms = 0;           // and of the steps
};

/// Places into `result` (its memory is used again). Figure 8 gives the whole page's dots with their
/// thresholds, and a few more than a count asks for. Returns false if stopped. Throws what the placers throw.
bool stipple(RankedTile& tile, const Density& density, PlacerKind placer, const PlacingRequest& request,
             Stippling& result, std::stop_token stop = {});

/// What a drawing that is written piece by piece is to have.
struct StreamRequest {
    PlacingRequest placing;  // its window has no say, nor has its origin
    PagePart part = {};      // of the page; a count is that of the whole page
    /// Called with dots in page units from the page's corner before they are cut; may be empty.
    std::function<void(Dots& piece)> finish = {};
};

/// How to place the dots of the part, and those up to `around` page units around it, at their positions on
/// the page. A count's end is found here, once for all passes and parts.
PlacingRequest placing_of(Placer& placer, const Density& density, const StreamRequest& request,
                          double around = 0);

/// The dots of the part in the exact placer's order, without holding them: finds the scale and the number of
/// dots now, and places anew for every pass over the stream. The placer and the density have to outlive it.
/// Throws as Placer::place() does.
DotStream stream(Placer& placer, const Density& density, const StreamRequest& request);

/// Fills Dots::critical if it isn't there: Figure 8 fills Dots::threshold only. Positions have to be the
/// page's.
void fill_critical_scales(DotPieces& dots, const Density& density);

/// The page, when the picture fills it.
PageSize page_size(const Density& density, double width_mm);

}  // namespace dapple
