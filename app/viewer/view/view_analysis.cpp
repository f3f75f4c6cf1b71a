#include "app/viewer/view/view_analysis.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <glm/common.hpp>
#include <limits>
#include <utility>

namespace dapple {
namespace {

constexpr int kPictureSide = 640;          // pixels at most
constexpr double kSamePlace = 1e-3;        // in mean spacings
constexpr std::size_t kCounted = 1 << 16;  // dots looked at to guess how many lie in a rectangle

bool holds(const Rectangle<double>& view, double x, double y) {
    return x >= view.low.x && y >= view.low.y && x <= view.high.x && y <= view.high.y;
}

Rectangle<double> shrunk(const Rectangle<double>& view, double factor) {
    const glm::dvec2 cut = view.size() * ((1 - factor) / 2);
    return {view.low + cut, view.high - cut};
}

bool meet(const Rectangle<double>& view, const DotBlock& block) {
    return block.high.x >= view.low.x && block.high.y >= view.low.y && block.low.x <= view.high.x &&
           block.low.y <= view.high.y;
}

// One for each piece where there are none.
std::vector<DotBlock> whole_pieces(const DotPieces& dots) {
    constexpr float kEverywhere = std::numeric_limits<float>::max();
    std::vector<DotBlock> blocks;
    for (std::size_t piece = 0; piece < dots.pieces.size(); ++piece)
        blocks.push_back({.piece = piece,
                          .count = dots.pieces[piece].size(),
                          .low = glm::vec2(-kEverywhere),
                          .high = glm::vec2(kEverywhere)});
    return blocks;
}

double guessed_count(const DotPieces& dots, const Rectangle<double>& view) {
    const std::size_t step = 1 + dots.size() / kCounted;
    std::size_t found = 0;
    for (const Dots& piece : dots.pieces) {
        for (std::size_t i = 0; i < piece.size(); i += step) found += holds(view, piece.x[i], piece.y[i]);
    }
    return static_cast<double>(found * step);
}

// False if there are more than `most`.
bool collect(const DotPieces& dots, std::span<const DotBlock> blocks, const Rectangle<double>& view,
             std::size_t most, std::vector<glm::dvec2>& points) {
    points.clear();
    for (const DotBlock& block : blocks) {
        if (!meet(view, block)) continue;
        const Dots& piece = dots.pieces[block.piece];
        for (std::size_t i = block.first; i < block.first + block.count; ++i) {
            const glm::dvec2 p(piece.x[i], piece.y[i]);
            if (!holds(view, p.x, p.y)) continue;
            if (points.size() == most) return false;
            points.push_back(glm::clamp(p - view.low, glm::dvec2(0), view.size()));
        }
    }
    return true;
}

std::optional<double> tile_side(const Domain& domain, std::size_t points, std::size_t tile_size) {
    const double tiles = static_cast<double>(points) / domain.area() / static_cast<double>(tile_size);
    if (!(tiles > 0)) return std::nullopt;
    const double side = tile_period(tiles);
    if (2 * side > std::min(domain.width, domain.height) * (1 + 1e-9)) return std::nullopt;
    return side;
}

ViewAnalysis analysed(const ViewAnalysisRequest& request, const std::stop_token& stop) {
    const std::vector<glm::dvec2>& points = request.view.points;
    const Domain& domain = request.view.domain;
    ViewAnalysis result;
    result.dots = points.size();
    result.all = request.view.all;
    if (points.size() < 2) return result;
    if (const auto side = tile_side(domain, points.size(), request.tile_size))
        result.periodicity = periodicity(points, domain, glm::dvec2(*side), {}, stop);
    if (request.measure == Measure::repetition || stop.stop_requested()) return result;
    result.nearest = nearest_summary(points, domain, stop);
    const Periodogram spectrum = periodogram(points, domain, {}, stop);
    if (stop.stop_requested()) return result;
    result.radial_power = radial_power(spectrum);
    result.low_frequency_power = low_frequency_power(spectrum, 0.5);
    result.peaks = spectral_peaks(spectrum);
    result.picture = with_alpha(spectrum_picture(spectrum, kPictureSide));
    return result;
}

}  // namespace

const char* repetition_in_words(double periodicity) {
    if (periodicity >= 0.9) return "repeats itself exactly";
    if (periodicity >= 0.5) return "repeats strongly";
    if (periodicity >= 0.2) return "repeats in part";
    if (periodicity >= 0.05) return "hardly repeats";
    return "no repetition";
}

double same_place(const Domain& domain, std::size_t points) {
    return kSamePlace * std::sqrt(domain.area() / static_cast<double>(points));
}

PointsInView points_in_view(const DotPieces& dots, const Rectangle<double>& view, std::size_t most,
                            std::span<const DotBlock> blocks) {
    PointsInView result;
    std::vector<DotBlock> all;
    if (blocks.empty()) blocks = all = whole_pieces(dots);
    if (!(view.size().x > 0 && view.size().y > 0)) return result;
    Rectangle<double> part = view;
    const auto enough = static_cast<double>(most);
    for (double count = guessed_count(dots, part); count > 1.05 * enough; count = guessed_count(dots, part))
        part = shrunk(part, std::clamp(std::sqrt(enough / count), 0.1, 0.95));
    while (!collect(dots, blocks, part, most, result.points)) part = shrunk(part, 0.95);
    result.domain = {part.size().x, part.size().y, Topology::window};
    result.all = part == view;
    return result;
}

std::optional<ViewAnalysis> analyse_view(ViewAnalysisRequest request, std::stop_token stop) {
    if (request.has_duplicates) {
        std::vector<glm::dvec2>& points = request.view.points;
        drop_duplicates(points, same_place(request.view.domain, points.size()));
    }
    // The other processors are for placing, which must not wait.
    tbb::task_arena own_thread(1);
    ViewAnalysis result = own_thread.execute([&] { return analysed(request, stop); });
    if (stop.stop_requested()) return std::nullopt;
    return result;
}

Background<ViewAnalysis>::Work analysis_work(ViewAnalysisRequest request) {
    return [request = std::move(request)](const Background<ViewAnalysis>::Task& task) mutable {
        try {
            return analyse_view(std::move(request), task.stop());
        } catch (const std::exception& error) {
            std::optional<ViewAnalysis> failed(std::in_place);
            failed->error = error.what();
            return failed;
        }
    };
}

}  // namespace dapple
