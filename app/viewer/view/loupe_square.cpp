#include "app/viewer/view/loupe_square.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <vector>

#include "app/viewer/view/view_analysis.h"

namespace dapple {
namespace {

constexpr int kDeepest = 60;
constexpr int kLeastLevel = 3;          // eight tiles across the page
constexpr double kMostATile = 1024;     // so that enough tiles can be laid on one another
constexpr double kMostFolded = 40'000;  // folded
constexpr double kLeastFolded = 8;      // folded
constexpr int kMostAcross = 8;
constexpr double kDotsAround = 400;  // that the density about a place is told from

std::size_t count_around(const DotPieces& dots, glm::dvec2 centre, double side) {
    const auto low_x = static_cast<float>(centre.x - side / 2),
               high_x = static_cast<float>(centre.x + side / 2);
    const auto low_y = static_cast<float>(centre.y - side / 2),
               high_y = static_cast<float>(centre.y + side / 2);
    std::size_t count = 0;
    for_each_position(
        dots, [&](float x, float y) { count += (x >= low_x) & (x < high_x) & (y >= low_y) & (y < high_y); });
    return count;
}

/// Dots per square page unit around a place.
double density_around(const PlacedDrawing& shown, glm::dvec2 place) {
    const DotPieces& dots = shown.dots;
    const double area = std::min(shown.window().width, shown.plan.picture_size().x) *
                        std::min(shown.window().height, shown.plan.picture_size().y);
    double density = static_cast<double>(dots.size()) / area;
    // The square for it depends on the density: twice is enough, unless there are hardly any dots.
    for (int round = 0; round < 2 && density > 0; ++round) {
        const double side = std::sqrt(kDotsAround / density);
        const auto count = static_cast<double>(count_around(dots, place, side));
        density = count / (side * side);
    }
    return density;
}

int default_level(double density, std::size_t tile_size) {
    const double gone_through = std::floor(std::log2(density / static_cast<double>(tile_size)) / 2 + 0.01);
    const double small_enough = std::ceil(std::log2(density / kMostATile) / 2);
    return static_cast<int>(std::max({gone_through, small_enough, double(kLeastLevel)}));
}

/// The first tile of a row of `across` of them that has `place` in its middle, moved so that it lies between
/// low and high.
std::int64_t first_tile(std::int64_t place, std::int64_t side, int across, std::int64_t low,
                        std::int64_t high) {
    const std::int64_t lowest = (low + side - 1) / side, highest = high / side - across;
    const std::int64_t middle = (place - across * side / 2 + side / 2) / side;
    return std::clamp(middle, lowest, std::max(lowest, highest)) * side;
}

}  // namespace

double LoupeSquare::period() const {
    return std::ldexp(1.0, -level);
}

std::optional<LoupeSquare> loupe_square(const PlacedDrawing& shown, std::size_t tile_size, PagePoint place,
                                        int step) {
    const PagePoint page = page_point(shown.plan.picture_size());
    if (place.x < 0 || place.y < 0 || place.x >= page.x || place.y >= page.y) return std::nullopt;
    const PagePoint origin{shown.window().x, shown.window().y};
    const double density = density_around(shown, in_page_units(place - origin));
    if (!(density > 0)) return std::nullopt;
    LoupeSquare square;
    square.level = std::clamp(default_level(density, tile_size) + step, 0, kDeepest);
    const std::int64_t side = std::int64_t(1) << (62 - square.level);

    // What there are dots of: the window's part of the page.
    const PagePoint size = page_point({shown.window().width, shown.window().height});
    const PagePoint low = glm::max(origin, PagePoint(0)), high = glm::min(origin + size, page);
    const std::int64_t room =
        std::min((high.x / side) - (low.x + side - 1) / side, (high.y / side) - (low.y + side - 1) / side);
    const double dots_a_tile = density * square.period() * square.period();
    const double few_enough = std::sqrt(kMostFolded / dots_a_tile);
    square.across = static_cast<int>(std::min({double(room), few_enough, double(kMostAcross)}));
    if (square.across < 2 || dots_a_tile * square.across * square.across < kLeastFolded) return std::nullopt;
    square.corner = {first_tile(place.x, side, square.across, low.x, high.x),
                     first_tile(place.y, side, square.across, low.y, high.y)};
    return square;
}

Folding folded(const PlacedDrawing& shown, const LoupeSquare& square) {
    const glm::dvec2 corner = in_page_units(square.corner - PagePoint{shown.window().x, shown.window().y});
    const double side = square.across * square.period();
    std::vector<glm::dvec2> points;
    for_each_position(shown.dots, [&](float x, float y) {
        const glm::dvec2 p = glm::dvec2(x, y) - corner;
        if (p.x >= 0 && p.y >= 0 && p.x < side && p.y < side) points.push_back(p);
    });
    if (shown.duplicates > 0)
        drop_duplicates(points, same_place({side, side, Topology::window}, points.size()));
    return folded(points, {0, 0}, square.period(), square.across);
}

}  // namespace dapple
