// A drawing that is written piece by piece against the same drawing held in memory.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>

#include "core/output/drawing_format.h"
#include "core/output/raster.h"
#include "core/output/sheet.h"
#include "core/placing/stipple.h"
#include "core/tile/ranking.h"
#include "tests/dot_pieces.h"

using namespace dapple;

namespace {

// A soft shade, a black bar, and bare paper.
Grid<float> picture() {
    Grid<float> grid(90, 60);
    for (int y = 0; y < grid.height; ++y) {
        for (int x = 0; x < grid.width; ++x) {
            const double shade = 0.5 + 0.5 * std::sin(0.1 * x) * std::cos(0.07 * y);
            grid.at(x, y) = x > 70 && x < 75 ? 1.0f : y < 8 ? 0.0f : static_cast<float>(shade);
        }
    }
    return grid;
}

struct Scene {
    RankedTile tile{make_tile(14217, 2895, 16), RankingMethod::energy};
    Density density{picture()};
    PageSize page = page_size(density, 300);

    // Placed at once, then cut: the plain way.
    Dots whole(const PlacingRequest& request, const PagePart& part, double& scale) {
        Stippling all;
        CHECK(stipple(tile, density, PlacerKind::exact, request, all));
        scale = all.scale;
        Dots dots = joined(all.dots);
        cut_to(part, dots);
        return dots;
    }
};

std::string svg_of(const DotStream& dots, const PageSize& page) {
    std::ostringstream out;
    write_svg(out, {.size = page, .dots = dots, .dot_radius_mm = 0.3});
    return out.str();
}

std::string csv_of(const DotStream& dots, const PageSize& page) {
    std::ostringstream out;
    write_csv(out, {.size = page, .dots = dots, .dot_radius_mm = 0.3, .tile_size = 16});
    return out.str();
}

Grid<float> pixels_of(const DotStream& dots, const PageSize& page) {
    const RasterSize size = raster_size(page, 50);
    Grid<float> all(size.width, size.height);
    rasterise({.size = page, .dots = dots, .dot_radius_mm = 0.3}, {.dpi = 50},
              [&](int first_row, std::span<const Grid<float>> band) {
                  std::ranges::copy(band[0].values, all.row(first_row));
              });
    return all;
}

const std::vector<PlacingRequest> kRequests{{.scale = 0, .count = {}, .thresholds = true},
                                            {.scale = 3000, .count = {}, .thresholds = true},
                                            {.scale = 3000, .count = {}, .threads = 3, .thresholds = true},
                                            {.count = 1, .thresholds = true},
                                            {.count = 25'000, .thresholds = true},
                                            {.count = 25'000, .threads = 3, .thresholds = true}};

}  // namespace

TEST_CASE("a streamed drawing is the drawing in memory, byte for byte, in every format") {
    Scene scene;
    for (const PlacingRequest& request : kRequests) {
        CAPTURE(request.scale);
        CAPTURE(request.count.value_or(0));
        double scale = 0;
        const Dots whole = scene.whole(request, {}, scale);
        const DotStream in_memory = stream_of(whole, scale);
        const DotStream dots = stream(scene.tile.placer(), scene.density, {.placing = request, .part = {}});
        CHECK(dots.count == whole.size());
        CHECK(dots.scale == scale);
        CHECK(svg_of(dots, scene.page) == svg_of(in_memory, scene.page));
        CHECK(csv_of(dots, scene.page) == csv_of(in_memory, scene.page));
        CHECK(pixels_of(dots, scene.page).values == pixels_of(in_memory, scene.page).values);
    }
}

TEST_CASE("a sheet or region that is placed for itself is the one cut from the whole, byte for byte") {
    Scene scene;
    const std::vector<Excerpt> excerpts{
        sheet_of(scene.page, {1, 1, 3, 4}), sheet_of(scene.page, {2, 3, 3, 4}),
        sheet_of(scene.page, {3, 4, 3, 4}), region_of(scene.page, {{33.3, 70.7}, {88.8, 115.1}}),
        region_of(scene.page, {{0, 0}, {20, 10}})};
    for (const PlacingRequest& request : kRequests) {
        for (const Excerpt& excerpt : excerpts) {
            double scale = 0;
            const Dots cut = scene.whole(request, excerpt.part, scale);
            const DotStream dots =
                stream(scene.tile.placer(), scene.density, {.placing = request, .part = excerpt.part});
            CHECK(dots.count == cut.size());
            CHECK(dots.scale == scale);
            CHECK(csv_of(dots, excerpt.size) == csv_of(stream_of(cut), excerpt.size));
            CHECK(svg_of(dots, excerpt.size) == svg_of(stream_of(cut), excerpt.size));
        }
    }
}

TEST_CASE("pictures of sheets laid side by side are the picture of the whole, dots across the cuts too") {
    Scene scene;
    constexpr double kRadiusMm = 2.3;
    const RasterRequest raster{.dpi = 2 * 25.4};  // two pixels a millimetre
    const auto picture_of = [&](const PagePart& part, const PageSize& size) {
        const DotStream dots =
            stream(scene.tile.placer(), scene.density, {.placing = {.count = 3000}, .part = part});
        const RasterSize pixels = raster_size(size, raster.dpi);
        Grid<float> all(pixels.width, pixels.height);
        rasterise({.size = size, .dots = dots, .dot_radius_mm = kRadiusMm}, raster,
                  [&](int first_row, std::span<const Grid<float>> band) {
                      std::ranges::copy(band[0].values, all.row(first_row));
                  });
        return all;
    };
    const Grid<float> whole = picture_of({}, scene.page);
    REQUIRE(whole.width == 600);
    REQUIRE(whole.height == 400);
    double across_cuts = 0;
    for (const int row : {0, 1}) {
        for (const int column : {0, 1}) {
            const Excerpt sheet = sheet_of(scene.page, {column + 1, row + 1, 2, 2});
            const double reach = kRadiusMm / sheet.size.mm_per_page_unit;
            const Grid<float> wide = picture_of(widened(sheet.part, reach), sheet.size);
            const Grid<float> own = picture_of(sheet.part, sheet.size);
            REQUIRE(wide.width == 300);
            REQUIRE(wide.height == 200);
            for (int y = 0; y < wide.height; ++y) {
                for (int x = 0; x < wide.width; ++x) {
                    const float expected = whole.at(300 * column + x, 200 * row + y);
                    // Moving the corner rounds positions: a sample point of 256 may lie on the other side.
                    if (std::abs(wide.at(x, y) - expected) > 3.0f / 256) FAIL("pixel ", x, ",", y);
                    across_cuts += expected - own.at(x, y);
                }
            }
        }
    }
    CHECK(across_cuts > 100);  // pixels of ink that a sheet's own dots lack
}

TEST_CASE("streamed sheets have every dot of the page once") {
    Scene scene;
    for (const PlacingRequest& request : kRequests) {
        double scale = 0;
        std::uint64_t on_sheets = 0;
        for (int row = 1; row <= 4; ++row) {
            for (int column = 1; column <= 3; ++column) {
                const PagePart part = sheet_of(scene.page, {column, row, 3, 4}).part;
                on_sheets +=
                    stream(scene.tile.placer(), scene.density, {.placing = request, .part = part}).count;
            }
        }
        CHECK(on_sheets == scene.whole(request, {}, scale).size());
    }
}

TEST_CASE("however many dots there are, they come in small pieces") {
    Scene scene;
    for (const PlacingRequest& request :
         {PlacingRequest{.scale = 50'000, .count = {}}, PlacingRequest{.count = 400'000}}) {
        const DotStream dots = stream(scene.tile.placer(), scene.density, {.placing = request, .part = {}});
        std::size_t largest = 0, all = 0;
        dots.for_each_piece([&](const Dots& piece) {
            largest = std::max(largest, piece.size());
            all += piece.size();
            return true;
        });
        CHECK(all == dots.count);
        CHECK(all > 200'000);
        CHECK(largest < 60'000);
    }
}

TEST_CASE("whoever takes the dots may stop, and begin again") {
    Scene scene;
    const DotStream dots =
        stream(scene.tile.placer(), scene.density, {.placing = {.count = 400'000}, .part = {}});
    int taken = 0;
    dots.for_each_piece([&](const Dots&) { return ++taken < 2; });
    CHECK(taken == 2);
    std::uint64_t all = 0;
    dots.for_each_piece([&](const Dots& piece) {
        all += piece.size();
        return true;
    });
    CHECK(all == 400'000);
}

TEST_CASE("what cannot be placed is not streamed") {
    Scene scene;
    CHECK_THROWS(
        stream(scene.tile.placer(), scene.density, {.placing = {.scale = -1, .count = {}}, .part = {}}));
    CHECK_THROWS(
        stream(scene.tile.placer(), Density(Grid<float>(4, 4)), {.placing = {.count = 5}, .part = {}}));
}
