#include "core/stipple.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace dapple {

std::string_view name_of(PlacerKind kind) {
    return kind == PlacerKind::exact ? "exact" : "figure8";
}

RankedTile::RankedTile(Tile tile, const Ranking& ranking)
    : tile_(std::move(tile)), placer_(make_placing_table(tile_, ranking)) {
    // Figure 8 knows no other rule, and large tiles take a while.
    if (tile_.rule == Rule{}) own_ranks_ = farthest_point_ranks(tile_);
}

RankedTile::RankedTile(Tile tile, RankingOrder order) : RankedTile(tile, rank(tile, order)) {}

bool stipple(RankedTile& tile, const Density& density, const StippleRequest& request, Stippling& result,
             std::stop_token stop) {
    const auto start = std::chrono::steady_clock::now();
    result.duplicates = 0;
    result.scale = request.scale;
    if (request.placer == PlacerKind::figure8) {
        if (request.count) {
            throw std::runtime_error(
                "an exact number of dots needs the exact placer; give figure8 a scale instead");
        }
        Figure8Result placed = place_figure8(density, tile.tile(), tile.own_ranks(), request.scale);
        result.dots = std::move(placed.dots);
        result.duplicates = placed.duplicates;
    } else if (request.count) {
        const ExactCount exact{*request.count, request.threads};
        const auto scale = place_exactly(tile.placer(), density, exact, result.dots, stop);
        if (!scale) return false;
        result.scale = *scale;
    } else {
        PlacingRequest placing;
        placing.scale = request.scale;
        placing.threads = request.threads;
        if (!tile.placer().place(density, placing, result.dots, stop)) return false;
    }
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    result.place_ms = took.count();
    return true;
}

PageSize page_size(const Density& density, double width_mm) {
    const double mm_per_pixel = width_mm / density.width();
    return {width_mm, density.height() * mm_per_pixel, density.longer_side() * mm_per_pixel};
}

}  // namespace dapple
