#include "core/placing/stipple.h"

#include <algorithm>
#include <chrono>

namespace dapple {

RankedTile::RankedTile(Tile tile, const Ranking& ranking)
    : tile_(std::move(tile)), placer_(make_placing_table(tile_, ranking)) {
    // Figure 8 knows one kind and no other rule, and large tiles take a while.
    if (tile_.rule == Rule{} && tile_.kinds() == 1) own_ranks_ = farthest_point_ranks(tile_);
}

RankedTile::RankedTile(Tile tile, RankingMethod method) : RankedTile(tile, rank(tile, method)) {}

RankedTile ranked_tile(StoredTile stored, std::optional<RankingMethod> method) {
    if (method && *method != stored.method) return {std::move(stored.tile), *method};
    return {std::move(stored.tile), stored.ranking};
}

bool stipple(RankedTile& tile, const Density& density, PlacerKind placer, const PlacingRequest& request,
             Stippling& result, std::stop_token stop) {
    const auto start = std::chrono::steady_clock::now();
    result.duplicates = 0;
    result.steps = 0;
    result.relax_ms = 0;
    if (placer == PlacerKind::figure8) {
        std::optional<Figure8Result> placed =
            request.count ? place_figure8_count(density, tile.tile(), tile.own_ranks(), *request.count, stop)
                          : place_figure8(density, tile.tile(), tile.own_ranks(), request.scale, stop);
        if (!placed || stop.stop_requested()) return false;
        result.dots = in_one_piece(std::move(placed->dots));
        result.duplicates = placed->duplicates;
        result.scale = placed->scale;
    } else {
        const auto scale = tile.placer().place(density, request, result.dots, stop);
        if (!scale) return false;
        result.scale = *scale;
    }
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    result.place_ms = took.count();
    return true;
}

void fill_critical_scales(DotPieces& dots, const Density& density) {
    for (Dots& piece : dots.pieces) {
        if (piece.critical.size() == piece.size()) continue;
        piece.critical.resize(piece.size());
        for (std::size_t i = 0; i < piece.size(); ++i)
            piece.critical[i] = static_cast<float>(piece.threshold[i] / density.at({piece.x[i], piece.y[i]}));
    }
}

namespace {

using Pieces = std::function<void(const TakePiece& take)>;

std::uint64_t count_of(const Pieces& pieces) {
    std::uint64_t count = 0;
    pieces([&](const Dots& piece) {
        count += piece.size();
        return true;
    });
    return count;
}

Pieces finished(const StreamRequest& request, const Pieces& pieces) {
    return [request, pieces](const TakePiece& take) {
        Dots cut;
        pieces([&](const Dots& piece) {
            cut = piece;
            if (request.finish) request.finish(cut);
            cut_to(request.part, cut);
            return take(cut);
        });
    };
}

}  // namespace

PlacingRequest placing_of(Placer& placer, const Density& density, const StreamRequest& request,
                          double around) {
    PlacingRequest placing = request.placing;
    placing.window = window_around(widened(request.part, around));
    placing.origin = PlacingOrigin::page;
    if (placing.count && !placing.cut) placing.cut = placer.find_cut(density, placing);
    if (placing.cut) placing.scale = placing.cut->last_scale();
    return placing;
}

DotStream stream(Placer& placer, const Density& density, const StreamRequest& request) {
    const PlacingRequest placing = placing_of(placer, density, request);
    const Pieces pieces = [&placer, &density, placing](const TakePiece& take) {
        placer.hand_over(density, placing, take);
    };
    const bool whole_page = request.part == PagePart{};
    DotStream result;
    result.scale = placing.scale;
    result.for_each_piece = whole_page && !request.finish ? pieces : finished(request, pieces);
    result.count = placing.count && whole_page ? *placing.count : count_of(result.for_each_piece);
    return result;
}

PageSize page_size(const Density& density, double width_mm) {
    const double mm_per_pixel = width_mm / density.width();
    return {width_mm, density.height() * mm_per_pixel, density.longer_side() * mm_per_pixel};
}

}  // namespace dapple
