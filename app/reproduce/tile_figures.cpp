#include <fmt/format.h>

#include <array>
#include <string>
#include <vector>

#include "app/reproduce/figures.h"
#include "core/output/plot.h"
#include "core/tile/ranking.h"

namespace dapple {
namespace {

constexpr int kSide = 300;  // px
constexpr std::array<glm::vec3, 4> kQuadrantColours{
    {{0.04f, 0.44f, 0.72f}, {0.82f, 0.34f, 0.05f}, {0.04f, 0.54f, 0.39f}, {0.54f, 0.31f, 0.69f}}};

// A square with dots, y downwards as on the page.
Plot square(const std::string& title) {
    Plot plot{.title = title,
              .x = {.label = title, .least = 0, .most = 1},
              .y = {.label = "", .least = 0, .most = 1}};
    plot.width = kSide;
    plot.height = kSide;
    return plot;
}

glm::dvec2 place(BinaryPoint p) {
    const glm::dvec2 v = to_unit_square(p);
    return {v.x, 1 - v.y};
}

std::string tile_drawing(const Tile& tile) {
    Plot plot = square("the tile");
    plot.curves.push_back({.name = "", .colour = {0, 0, 0}, .mark = PlotMark::dots});
    for (const BinaryPoint& p : tile.points) plot.curves[0].points.push_back(place(p));
    return svg_plot(plot);
}

// Copies first and larger, so that the tile's own points lie upon them.
std::string copies_drawing(const Tile& tile) {
    Plot plot = square("its half-size copies, own points black");
    for (int q = 0; q < 4; ++q) {
        PlotCurve copy{
            .name = "", .colour = kQuadrantColours[static_cast<std::size_t>(q)], .mark = PlotMark::dots};
        copy.dot_radius = 4.5;
        for (const BinaryPoint& p : tile.points) copy.points.push_back(place(shrink_to_quadrant(q, p)));
        plot.curves.push_back(std::move(copy));
    }
    plot.curves.push_back({.name = "", .colour = {0, 0, 0}, .mark = PlotMark::dots});
    for (const BinaryPoint& p : tile.points) plot.curves.back().points.push_back(place(p));
    return svg_plot(plot);
}

std::string first_points_drawing(const Tile& tile, const std::vector<int>& ranks, int count) {
    Plot plot = square(fmt::format("the first {} points", count));
    plot.curves.push_back({.name = "", .mark = PlotMark::dots});
    plot.curves[0].dot_radius = 4;
    for (std::size_t i = 0; i < tile.size(); ++i)
        if (ranks[i] < count) plot.curves[0].points.push_back(place(tile.points[i]));
    return svg_plot(plot);
}

}  // namespace

void add_tile_figures(HtmlPage& page) {
    const Tile tile = parse_tile_integers("14217,2895/16");
    const std::vector<int> ranks = farthest_point_ranks(tile);
    page.heading("Figures 1 and 2: the self-similar tile and its ranks");
    page.drawings(
        std::array{tile_drawing(tile), copies_drawing(tile)},
        "The tile of Appendix A. Laid on its quadrants at half the size, a colour each, it covers its own "
        "points: each black point lies on a coloured one.");
    std::vector<std::string> drawings;
    for (const int count : {4, 8, 12, 16}) drawings.push_back(first_points_drawing(tile, ranks, count));
    page.drawings(drawings,
                  "Its first points in the order of the ranks: each such set is spread over the whole tile.");

    std::vector<HtmlPage::Row> rows;
    for (int k = 0; k < static_cast<int>(tile.size()); ++k)
        for (std::size_t i = 0; i < tile.size(); ++i) {
            if (ranks[i] != k) continue;
            const glm::dvec2 p = to_unit_square(tile.points[i]) * 65535.0;
            rows.push_back(
                {.cells = {fmt::format("{}", k), fmt::format("{:.0f}", p.x), fmt::format("{:.0f}", p.y)}});
        }
    page.table({"Rank", "x, of 65535", "y, of 65535"}, rows);
}

}  // namespace dapple
