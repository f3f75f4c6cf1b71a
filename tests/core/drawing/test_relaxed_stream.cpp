// Relaxed drawings band by band, and parts of the page, against the whole page relaxed at once.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/drawing/pipeline.h"
#include "core/drawing/relaxed_stream.h"
#include "core/output/sheet.h"
#include "core/placing/stipple.h"
#include "core/relaxing/relax.h"
#include "core/relaxing/stir.h"
#include "core/tile/tile_file.h"
#include "tests/densities.h"
#include "tests/dot_pieces.h"
#include "tests/file_text.h"
#include "tests/places.h"

using namespace dapple;

namespace {

// As photographs are: soft shades, dark spots, a line, very light areas, and paper that is quite bare. So
// long and narrow that a band with its rims is a small part of few dots.
Grid<float> photograph() {
    Grid<float> grid = blotches(20, 320, 11);
    for (int y = 0; y < grid.height; ++y) {
        for (int x = 0; x < grid.width; ++x) {
            const double shade = 0.5 + 0.45 * std::sin(0.21 * x + 0.05 * y) * std::cos(0.06 * y);
            float& v = grid.at(x, y);
            if (y >= 60) v = static_cast<float>(shade);
            if (y >= 160 && y < 190) v = 0.003f;
            if (y >= 220 && y < 240 && x > 5) v = 0;
            if (y == 170) v = 1;
        }
    }
    return grid;
}

Grid<float> on_its_side(const Grid<float>& grid) {
    Grid<float> result(grid.height, grid.width);
    for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x) result.at(y, x) = grid.at(x, y);
    return result;
}

RankedTile& test_tile() {
    static RankedTile tile = [] {
        StoredTile stored = read_tile(text_of(source_folder() / "assets/tiles/aperiodic16.tile"));
        return RankedTile(std::move(stored.tile), stored.ranking);
    }();
    return tile;
}

bool same(const Dots& a, const Dots& b) {
    return a.x == b.x && a.y == b.y && a.threshold == b.threshold && a.critical == b.critical &&
           a.radius == b.radius;
}

Dots whole_page(const Density& density, const PlacingRequest& request, int steps, double& scale) {
    Stippling all;
    REQUIRE(stipple(test_tile(), density, PlacerKind::exact, request, all));
    const double stirring = stirring_of(test_tile().placer().table(), all.scale);
    RelaxingRequest relaxing{.scale = all.scale, .threads = request.threads, .stirring = stirring};
    relaxing.carried = carried(test_tile().placer(), density, request, relaxing);
    REQUIRE(relax(all.dots, density, steps, relaxing));
    scale = all.scale;
    return joined(all.dots);
}

const std::vector<PlacingRequest> kRequests{{.scale = 33'000, .count = {}, .thresholds = true},
                                            {.count = 14'000, .threads = 3, .thresholds = true}};

// In millimetres a pixel.
PageSize page_of(const Density& density) {
    return page_size(density, density.width());
}

// A sixth of the page each.
std::vector<PagePart> sheets(const Density& density) {
    std::vector<PagePart> result;
    for (const int row : {1, 2})
        for (const int column : {1, 2, 3})
            result.push_back(sheet_of(page_of(density), {column, row, 3, 2}).part);
    return result;
}

// With radii that follow from where the dots have come to.
void give_radii(Dots& dots) {
    dots.radius.resize(dots.size());
    for (std::size_t i = 0; i < dots.size(); ++i) dots.radius[i] = 0.001f + 0.01f * dots.x[i] * dots.y[i];
}

}  // namespace

TEST_CASE("a drawing relaxed in bands is the whole page relaxed at once, to the bit and in its order") {
    const Density density(photograph());
    for (const PlacingRequest& request : kRequests) {
        for (const int steps : {1, 2, 3, 4}) {
            CAPTURE(request.scale);
            CAPTURE(request.count.value_or(0));
            CAPTURE(steps);
            double scale = 0;
            const Dots whole = whole_page(density, request, steps, scale);
            const std::uint64_t at_once = steps == 2 ? 300 : 1000;
            const DotStream bands = relaxed_stream(test_tile().placer(), density,
                                                   {.placing = request, .part = {}}, steps, at_once);
            std::size_t pieces = 0;
            const Dots streamed = all_of(bands, &pieces);
            CHECK(pieces > (steps == 2 ? 10 : 3));
            // Most of the page has no say in a band.
            CHECK(relaxing_rim(scale, steps) < 0.08 * steps);
            CHECK(bands.scale == scale);
            CHECK(bands.count == whole.size());
            CHECK(same(streamed, whole));
        }
    }
}

TEST_CASE("a drawing that fits into one band is kept, and the same") {
    const Density density(photograph());
    for (const PlacingRequest& request : kRequests) {
        double scale = 0;
        const Dots whole = whole_page(density, request, 3, scale);
        const DotStream one =
            relaxed_stream(test_tile().placer(), density, {.placing = request, .part = {}}, 3);
        std::size_t pieces = 0;
        CHECK(same(all_of(one, &pieces), whole));
        CHECK(pieces == 1);
        CHECK(one.count == whole.size());
        CHECK(one.scale == scale);
        CHECK(same(all_of(one), whole));  // and again
    }
}

TEST_CASE("six relaxed sheets are the page's dots, each exactly once and in the page's order") {
    for (const Density& density : {Density(photograph()), Density(on_its_side(photograph()))}) {
        for (const PlacingRequest& request : kRequests) {
            const int steps = request.count ? 1 : 3;
            double scale = 0;
            const Dots whole = whole_page(density, request, steps, scale);
            std::size_t on_sheets = 0;
            for (const PagePart& part : sheets(density)) {
                Dots expected = whole;
                cut_to(part, expected);
                const DotStream sheet = relaxed_stream(test_tile().placer(), density,
                                                       {.placing = request, .part = part}, steps, 700);
                CHECK(same(all_of(sheet), expected));
                CHECK(sheet.count == expected.size());
                CHECK(sheet.scale == scale);
                CHECK(sheet.count > 100);
                on_sheets += sheet.count;
            }
            CHECK(on_sheets == whole.size());
        }
    }
}

TEST_CASE("a relaxed region has the whole page's dots there, with their radii") {
    const Density density(photograph());
    const PageSize page = page_of(density);
    for (const PlacingRequest& request : kRequests) {
        double scale = 0;
        Dots whole = whole_page(density, request, 2, scale);
        give_radii(whole);
        for (const Rectangle<double>& region :
             {Rectangle<double>{{3.3, 70.7}, {8.8, 115.1}}, {{0, 0}, {20, 10}}, {{12, 0}, {12.7, 320}}}) {
            const PagePart part = region_of(page, region).part;
            Dots expected = whole;
            cut_to(part, expected);
            for (const std::uint64_t at_once : {std::uint64_t{300}, kDotsAtOnce}) {
                const StreamRequest wanted{.placing = request, .part = part, .finish = give_radii};
                const DotStream dots = relaxed_stream(test_tile().placer(), density, wanted, 2, at_once);
                const Dots found = all_of(dots);
                CHECK(found.radius.size() == found.size());
                CHECK(same(found, expected));
                CHECK(dots.count == expected.size());
            }
        }
    }
}

TEST_CASE("dots of a whole page are not relaxed to be counted, wherever it lies on the paper") {
    const Density density(photograph());
    PagePart on_paper;
    on_paper.across.offset = -0.1;
    on_paper.down.offset = -0.2;
    int finished = 0;
    const DotStream bands = relaxed_stream(
        test_tile().placer(), density,
        {.placing = {.count = 5000}, .part = on_paper, .finish = [&](Dots&) { ++finished; }}, 1, 500);
    CHECK(bands.count == 5000);
    CHECK(finished == 0);
    CHECK(all_of(bands).size() == 5000);
    CHECK(finished > 0);
}

TEST_CASE("whoever takes the bands may stop, and begin again") {
    const Density density(photograph());
    const DotStream bands =
        relaxed_stream(test_tile().placer(), density, {.placing = {.count = 5000}, .part = {}}, 1, 500);
    int taken = 0;
    bands.for_each_piece([&](const Dots&) { return ++taken < 2; });
    CHECK(taken == 2);
    CHECK(all_of(bands).size() == 5000);
}

TEST_CASE("what cannot be relaxed in bands is refused") {
    const Density density(photograph());
    Placer& placer = test_tile().placer();
    CHECK_THROWS(
        relaxed_stream(placer, Density(Grid<float>(4, 4)), {.placing = {.count = 5}, .part = {}}, 1));
}

TEST_CASE("sheets of dots with sizes by tone have the whole page's radii") {
    Pipeline pipeline;
    pipeline.set_tile(RankedTile(make_tile(14217, 2895, 16), RankingMethod::energy));
    Grid<float> light = photograph();
    for (float& v : light.values) v = 1 - v;
    pipeline.set_light(std::move(light));
    const DrawingPlan plan =
        pipeline.plan({.relax = 5,  // the last by the dots' ink
                       .dot_size = {.sizing = DotSizing::by_tone, .smallest_mm = 0.2, .largest_mm = 0.4},
                       .page = {.width_mm = 20}});
    Stippling drawn;
    REQUIRE(pipeline.draw(plan, drawn));
    const Dots whole = joined(drawn.dots);
    REQUIRE(whole.radius.size() == whole.size());
    std::size_t on_sheets = 0;
    for (const PagePart& part : sheets(*plan.density)) {
        Dots expected = whole;
        cut_to(part, expected);
        CHECK(same(all_of(pipeline.stream(plan, part)), expected));
        on_sheets += expected.size();
    }
    CHECK(on_sheets == whole.size());
    CHECK(on_sheets > 3000);
}
