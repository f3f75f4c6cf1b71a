#include "core/stipple.h"

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace dapple {

namespace {

constexpr std::size_t kPieceDots = 10'000;

void hand_over(const Dots& dots, const TakePiece& take) {
    for (std::size_t from = 0; from < dots.size(); from += kPieceDots) {
        const std::size_t to = std::min(dots.size(), from + kPieceDots);
        const auto slice = [&](const FloatBuffer& column) {
            return column.empty() ? FloatBuffer{} : FloatBuffer(column.begin() + from, column.begin() + to);
        };
        if (!take({slice(dots.x), slice(dots.y), slice(dots.threshold), slice(dots.critical)})) return;
    }
}

bool place_in_pieces(Placer& placer, const Density& density, const PlacingRequest& request,
                     const TakePiece& take) {
    Dots dots;
    placer.place(density, request, dots);
    hand_over(dots, take);
    return true;
}

bool place_exactly_in_pieces(Placer& placer, const Density& density, const ExactCount& request,
                             const TakePiece& take) {
    Dots dots;
    place_exactly(placer, density, request, dots);
    hand_over(dots, take);
    return true;
}

}  // namespace

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
        const ExactCount exact{*request.count, request.critical, request.threads};
        const auto scale = tile.placer().place_exactly(density, exact, result.dots, stop);
        if (!scale) return false;
        result.scale = *scale;
    } else {
        PlacingRequest placing;
        placing.scale = request.scale;
        placing.critical = request.critical;
        placing.threads = request.threads;
        if (!tile.placer().place(density, placing, result.dots, stop)) return false;
    }
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    result.place_ms = took.count();
    return true;
}

void fill_critical_scales(Dots& dots, const Density& density) {
    if (dots.critical.size() == dots.size()) return;
    dots.critical.resize(dots.size());
    for (std::size_t i = 0; i < dots.size(); ++i)
        dots.critical[i] = static_cast<float>(dots.threshold[i] / density.at({dots.x[i], dots.y[i]}));
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

// Each piece changed on its way.
Pieces changed(const Pieces& pieces, const std::function<void(Dots&)>& change) {
    return [pieces, change](const TakePiece& take) {
        Dots copy;
        pieces([&](const Dots& piece) {
            copy = piece;
            change(copy);
            return take(copy);
        });
    };
}

}  // namespace

DotStream stream(RankedTile& tile, const Density& density, const StreamRequest& request) {
    const StippleRequest& stipple = request.stipple;
    if (stipple.placer != PlacerKind::exact)
        throw std::runtime_error("the figure8 placer cannot place piece by piece");
    DotStream result;
    Pieces pieces;
    if (stipple.count) {
        Placer& placer = tile.placer();
        const ExactCount exact{*stipple.count, stipple.threads};
        Dots all;
        result.scale = *place_exactly(placer, density, exact, all);
        pieces = [&placer, &density, exact](const TakePiece& take) {
            place_exactly_in_pieces(placer, density, exact, take);
        };
    } else {
        result.scale = stipple.scale;
        const PlacingRequest placing{.scale = stipple.scale,
                                     .window = window_around(request.part),
                                     .threads = stipple.threads,
                                     .origin = PlacingOrigin::page};
        pieces = [&placer = tile.placer(), &density, placing](const TakePiece& take) {
            place_in_pieces(placer, density, placing, take);
        };
    }
    const Pieces cut = request.part == PagePart{}
                           ? pieces
                           : changed(pieces, [part = request.part](Dots& piece) { cut_to(part, piece); });
    const bool all = stipple.count && request.part == PagePart{};
    result.count = all ? *stipple.count : count_of(cut);
    result.for_each_piece = cut;
    if (request.critical && !stipple.count) {
        // Before the cut: the density is looked up on the page.
        result.for_each_piece = changed(pieces, [&density, part = request.part](Dots& piece) {
            fill_critical_scales(piece, density);
            cut_to(part, piece);
        });
    }
    return result;
}

PageSize page_size(const Density& density, double width_mm) {
    const double mm_per_pixel = width_mm / density.width();
    return {width_mm, density.height() * mm_per_pixel, density.longer_side() * mm_per_pixel};
}

}  // namespace dapple
