#include "core/placing/stipple.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace dapple {

namespace {

// The density in double precision, looked up as often as the printed algorithm does.
class Figure8 {
 public:
    Figure8(const Density& density, const Tile& tile, const std::vector<int>& ranks, double scale,
            std::size_t most_dots, Figure8Result& result, const std::stop_token& stop)
        : density_(density),
          scale_(scale),
          most_dots_(most_dots),
          ranks_(ranks),
          successor_(tile.successor),
          result_(result),
          stop_(stop) {
        for (const BinaryPoint p : tile.points) points_.push_back(to_unit_square(p));
        for (const BinaryPoint p : tile.points) quadrant_.push_back(quadrant_of(p));
    }

    // `placed_before`: for each point, whether an ancestor has placed it. It changes nothing but the count of
    // duplicates.
    void place_tile(glm::dvec2 corner, int level, std::uint64_t placed_before) {
        if (stop_.stop_requested() || result_.dots.size() > most_dots_) return;
        const auto count = static_cast<double>(points_.size());
        const double side = std::ldexp(1.0, -level);
        // The paper's 1/A is for 16 points; with other sizes scale keeps its meaning.
        const double max = count / kDotsPerScale / (side * side), min = max / 4;
        result_.tiles.push_back({level, corner.x, corner.y, side, Orientation{}});
        bool subdivide = false;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const glm::dvec2 p = corner + side * points_[i];
            const double ink = scale_ * density_.at(p);
            const double threshold = min + (ranks_[i] + 0.5) / count * (max - min);
            if (ink > threshold) {
                const std::uint64_t bit = std::uint64_t{1} << i;
                if (placed_before & bit) ++result_.duplicates;
                placed_before |= bit;
                result_.dots.x.push_back(static_cast<float>(p.x));
                result_.dots.y.push_back(static_cast<float>(p.y));
                result_.dots.threshold.push_back(static_cast<float>(threshold));
            }
            subdivide = subdivide || ink > max;
        }
        if (!subdivide || level >= kMaxLevel) return;
        for (int q = 0; q < 4; ++q) {
            std::uint64_t inherited = 0;
            for (std::size_t i = 0; i < points_.size(); ++i) {
                if (quadrant_[i] == q && (placed_before >> i & 1))
                    inherited |= std::uint64_t{1} << successor_[i];
            }
            place_tile(corner + side / 2 * glm::dvec2(q & 1, q >> 1), level + 1, inherited);
        }
    }

 private:
    static constexpr int kMaxLevel = 40;  // a double's positions end soon after

    const Density& density_;
    double scale_;
    std::size_t most_dots_;
    const std::vector<int>& ranks_;
    const std::vector<std::uint32_t>& successor_;
    Figure8Result& result_;
    const std::stop_token& stop_;
    std::vector<glm::dvec2> points_;
    std::vector<int> quadrant_;
};

// Gives up beyond so many dots.
Figure8Result place(const Density& density, const Tile& tile, const std::vector<int>& ranks, double scale,
                    std::size_t most_dots, const std::stop_token& stop) {
    if (tile.rule != Rule{} || tile.kinds() > 1 || tile.size() > 62) {
        throw std::runtime_error(
            "the paper's placer (figure8) takes only tiles of one kind whose children are not turned; use "
            "paper16 or another A,B/N tile, or the exact placer");
    }
    if (!(scale >= 0) || !std::isfinite(scale))
        throw std::runtime_error("the scale must be a number from 0 up");
    Figure8Result result;
    result.scale = scale;
    Figure8(density, tile, ranks, scale, most_dots, result, stop).place_tile({0, 0}, 0, 0);
    return result;
}

}  // namespace

Figure8Result place_figure8(const Density& density, const Tile& tile, const std::vector<int>& ranks,
                            double scale, const std::stop_token& stop) {
    return place(density, tile, ranks, scale, std::numeric_limits<std::size_t>::max(), stop);
}

std::optional<Figure8Result> place_figure8_count(const Density& density, const Tile& tile,
                                                 const std::vector<int>& ranks, std::uint64_t count,
                                                 const std::stop_token& stop) {
    constexpr int kCloseRounds = 4;  // from then on any scale will do that has enough
    constexpr double kClose = 1.01;
    constexpr double kMostGrowth = 1e9;
    // A scale at most four times too large has no more. What has is a spot so bright that all places lie in
    // it at once, where a smaller scale loses it.
    const auto most_dots = static_cast<std::size_t>(16 * count + 1'000'000);
    const auto wanted = static_cast<double>(count);
    const double first = scale_for(density, wanted);
    double scale = first;
    for (int round = 1; scale <= first * kMostGrowth; ++round) {
        Figure8Result result = place(density, tile, ranks, scale, most_dots, stop);
        if (stop.stop_requested()) return std::nullopt;
        if (result.dots.size() > most_dots) break;
        const auto found = static_cast<double>(result.dots.size() - result.duplicates);
        if (found >= wanted && (found <= kClose * wanted + 1 || round > kCloseRounds)) return result;
        // Aims at the middle of what is close enough.
        const double share = std::sqrt(kClose) * (wanted + 1) / (found + 1);
        scale *= std::clamp(share, 0.25, 4.0);
    }
    throw std::runtime_error(
        fmt::format("the paper's placer (figure8) does not find {} places in this picture's dark parts; use "
                    "the exact placer",
                    count));
}

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

using PieceSource = std::function<void(const TakePiece& take)>;

std::uint64_t count_of(const PieceSource& pieces) {
    std::uint64_t count = 0;
    pieces([&](const Dots& piece) {
        count += piece.size();
        return true;
    });
    return count;
}

PieceSource finished(const StreamRequest& request, const PieceSource& pieces) {
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
    const PieceSource pieces = [&placer, &density, placing](const TakePiece& take) {
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
