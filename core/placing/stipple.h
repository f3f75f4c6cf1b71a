#pragma once
// The pipeline, density to dots, as the window, the commands, the tests and the benchmark all call it.

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/image/density.h"
#include "core/placing/dot_stream.h"
#include "core/placing/dots.h"
#include "core/placing/figure8.h"
#include "core/placing/page.h"
#include "core/placing/placer.h"
#include "core/tile/ranking.h"
#include "core/tile/tile.h"

namespace dapple {

enum class PlacerKind {
    exact,    // each dot once, no feature lost
    figure8,  // the paper's, literal
};
/// "exact", "figure8".
std::string_view name_of(PlacerKind kind);

/// A tile with everything that placing needs of it, ready for use.
class RankedTile {
 public:
    RankedTile(Tile tile, const Ranking& ranking);
    RankedTile(Tile tile, RankingOrder order);

    const Tile& tile() const { return tile_; }
    const std::vector<int>& own_ranks() const { return own_ranks_; }  // for Figure 8; none if it can't be
    Placer& placer() { return placer_; }

 private:
    Tile tile_;
    std::vector<int> own_ranks_;
    Placer placer_;
};

struct StippleRequest {
    PlacerKind placer = PlacerKind::exact;
    double scale = 2500;                 // ignored when a count is given
    std::optional<std::uint64_t> count;  // exactly so many dots; the exact placer only
    int threads = 1;                     // 0: all cores
    bool appearance = false;             // fill Dots::threshold and Dots::critical too; the exact placer only

    bool operator==(const StippleRequest&) const = default;
};

struct Stippling {
    DotPieces dots;                // as emitted
    double scale = 0;              // the one given, or the one that gives the count
    std::uint64_t duplicates = 0;  // of them (Figure 8 only)
    double place_ms = 0;           // wall time of the placing alone
};

/// Places into `result` (its memory is used again). Returns false if stopped. Throws std::runtime_error if a
/// count is asked of Figure 8, the scale is negative or not finite, or what the placers throw.
bool stipple(RankedTile& tile, const Density& density, const StippleRequest& request, Stippling& result,
             std::stop_token stop = {});

/// What a drawing that is written piece by piece is to have.
struct StreamRequest {
    StippleRequest stipple;  // the exact placer only
    PagePart part;           // of the page; a count is that of the whole page
    /// Called with dots in page units from the page's corner before they are cut; may be empty.
    std::function<void(Dots& piece)> finish = {};
};

/// The same dots in the same order, without holding them: finds the scale and the number of dots now, and
/// places anew for every pass over the stream. The placer and the density have to outlive it. Throws as
/// stipple() does, and if Figure 8 is asked for: its duplicates are counted over all dots.
DotStream stream(Placer& placer, const Density& density, const StreamRequest& request);

/// Fills Dots::critical if it isn't there: Figure 8 fills Dots::threshold only. Positions have to be the
/// page's.
void fill_critical_scales(DotPieces& dots, const Density& density);

/// The page, when the picture fills it.
PageSize page_size(const Density& density, double width_mm);

}  // namespace dapple
