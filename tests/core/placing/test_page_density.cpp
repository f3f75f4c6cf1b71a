// A page is laid so that its edges are not the borders of tiles, which dots keep away from.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <utility>

#include "core/drawing/pipeline.h"
#include "core/placing/page.h"
#include "core/tile/tile.h"
#include "core/tile/tile_file.h"
#include "tests/file_text.h"
#include "tests/places.h"

namespace dapple {
namespace {

constexpr int kBands = 6;

// Dots in bands a quarter of a distance wide, from the edge on, over what they would be evenly spread.
std::array<double, kBands> bands(const DotPieces& dots, double height) {
    std::array<double, kBands> found{};
    const double band = std::sqrt(height / static_cast<double>(dots.size())) / 4;
    for_each_position(dots, [&](double x, double y) {
        const double away = std::min({x, 1 - x, y, height - y});
        if (away < kBands * band) ++found[static_cast<std::size_t>(away / band)];
    });
    const double even = 2 * (1 + height) * band / height * static_cast<double>(dots.size());
    for (double& share : found) share /= even;
    return found;
}

}  // namespace

TEST_CASE("cells in finer ones are the same density, on the same tiles") {
    Grid<float> values(3, 2);
    for (int i = 0; i < 6; ++i) values.values[i] = static_cast<float>(i) / 6;
    const Density cells = page_density(values, Reading::by_cell), finer = in_finer_cells(cells, 5);
    CHECK(finer.width() == 15);
    CHECK(finer.tile_corner() == cells.tile_corner());
    CHECK(finer.mean() == doctest::Approx(cells.mean()));
    for (double y = 0.001; y < 0.7; y += 0.05)
        for (double x = 0.001; x < 1; x += 0.05) CHECK(finer.at({x, y}) == cells.at({x, y}));
}

TEST_CASE("dots as placed neither keep off a picture's edges nor stand in rows along them") {
    Pipeline pipeline;
    StoredTile tile = read_tile(text_of(source_folder() / "assets/tiles/aperiodic4096.tile"));
    pipeline.set_tile({std::move(tile.tile), tile.ranking});
    for (const int height : {60, 40, 31}) {
        CAPTURE(height);
        pipeline.set_light(Grid<float>(60, height, 0.4f));
        std::array<double, kBands> mean{};
        const auto counts = {30000u, 40000u, 55000u, 80000u};
        for (const std::uint64_t count : counts) {
            DrawingSettings request;
            request.placing.count = count;
            request.relax = 0;
            Stippling drawn;
            REQUIRE(pipeline.draw(pipeline.plan(request), drawn, {}));
            REQUIRE(drawn.dots.size() == count);
            const auto of_count = bands(drawn.dots, height / 60.0);
            for (std::size_t i = 0; i < mean.size(); ++i)
                mean[i] += of_count[i] / static_cast<double>(counts.size());
        }
        for (std::size_t i = 0; i < mean.size(); ++i) {
            CAPTURE(i);
            CHECK(mean[i] == doctest::Approx(1).epsilon(0.15));
        }
    }
}

TEST_CASE("a page of any shape has no edge that is nearer to a border than a sixth of the tile's side") {
    for (int shorter = 1; shorter <= 1000; ++shorter) {
        CAPTURE(shorter);
        const glm::dvec2 corner = corner_off_edges(1000, shorter);
        CHECK(corner_off_edges(shorter, 1000) == glm::dvec2(corner.y, corner.x));
        for (int level = 0; level < 8; ++level) {
            CAPTURE(level);
            for (const double edge :
                 {0 - corner.x, 1 - corner.x, 0 - corner.y, shorter / 1000.0 - corner.y}) {
                const double tiles = std::ldexp(edge, level);
                CHECK(std::abs(tiles - std::round(tiles)) > 0.166);
            }
        }
    }
}

TEST_CASE("the four tiles that a picture lies across are neighbours that occur within each built-in tile") {
    for (const auto& file : std::filesystem::directory_iterator(source_folder() / "assets/tiles")) {
        CAPTURE(file.path().string());
        const Tile tile = read_tile(text_of(file.path())).tile;
        const std::vector<Neighbour> legal = legal_neighbours(tile.rule, tile.next_kind);
        for (const glm::ivec2 offset : {glm::ivec2(1, 0), {0, 1}, {1, 1}, {1, -1}})
            CHECK(std::ranges::any_of(legal, [&](const Neighbour& each) {
                return each.of == 0 && each.kind == 0 && each.offset == offset &&
                       each.orientation == Orientation();
            }));
    }
}

}  // namespace dapple
