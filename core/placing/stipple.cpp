#include "core/placing/stipple.h"

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
        result.dots = in_one_piece(std::move(placed.dots));
        result.duplicates = placed.duplicates;
    } else if (request.count) {
        const ExactCount exact{*request.count, request.appearance, request.threads};
        const auto scale = tile.placer().place_exactly(density, exact, result.dots, stop);
        if (!scale) return false;
        result.scale = *scale;
    } else {
        PlacingRequest placing;
        placing.scale = request.scale;
        placing.appearance = request.appearance;
        placing.threads = request.threads;
        if (!tile.placer().place(density, placing, result.dots, stop)) return false;
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

DotStream stream(Placer& placer, const Density& density, const StreamRequest& request) {
    const StippleRequest& stipple = request.stipple;
    if (stipple.placer != PlacerKind::exact)
        throw std::runtime_error("the figure8 placer cannot place piece by piece");
    DotStream result;
    Pieces pieces;
    if (stipple.count) {
        const ExactCount exact{*stipple.count, stipple.appearance, stipple.threads,
                               window_around(request.part)};
        const CountCut cut = *placer.find_cut(density, exact);
        result.scale = cut.last_scale();
        pieces = [&placer, &density, exact, cut](const TakePiece& take) {
            placer.place_in_pieces(density, exact, cut, take);
        };
    } else {
        result.scale = stipple.scale;
        const PlacingRequest placing{.scale = stipple.scale,
                                     .window = window_around(request.part),
                                     .appearance = stipple.appearance,
                                     .threads = stipple.threads,
                                     .origin = PlacingOrigin::page};
        pieces = [&placer, &density, placing](const TakePiece& take) {
            placer.place_in_pieces(density, placing, take);
        };
    }
    const bool whole_page = request.part == PagePart{};
    result.for_each_piece = whole_page && !request.finish ? pieces : finished(request, pieces);
    result.count = stipple.count && whole_page ? *stipple.count : count_of(result.for_each_piece);
    return result;
}

PageSize page_size(const Density& density, double width_mm) {
    const double mm_per_pixel = width_mm / density.width();
    return {width_mm, density.height() * mm_per_pixel, density.longer_side() * mm_per_pixel};
}

}  // namespace dapple
