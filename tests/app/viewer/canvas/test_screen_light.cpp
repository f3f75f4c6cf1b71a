// The canvas is as light as the file that is saved, however many dots there are and however near one looks.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/viewer/canvas/renderer.h"
#include "core/drawing/settings.h"
#include "core/image/ink.h"
#include "core/output/raster.h"
#include "core/pens/pen.h"
#include "core/placing/stipple.h"
#include "core/relaxing/relax.h"
#include "io/files/tile_library.h"
#include "tests/dots_by.h"
#include "tests/mean_light.h"
#include "tests/offscreen_gl.h"

namespace dapple {
namespace {

constexpr glm::ivec2 kCanvas{400, 300};
constexpr double kFitted = 360;       // pixels of the page's longer side
constexpr double kMostApart = 0.005;  // of a part's mean light, 0..1

// From white on the left to black on the right; black is where dots overlap most.
Grid<float> ramp() {
    Grid<float> density(300, 200);
    for (int y = 0; y < density.height; ++y)
        for (int x = 0; x < density.width; ++x) density.at(x, y) = static_cast<float>(x) / 299;
    return density;
}

struct Colours {
    glm::vec3 ink, paper;
};
constexpr Colours kBlackOnWhite{kBlack, kWhite};
const Colours kBlueOnSand{{0.1f, 0.2f, 0.7f}, {0.95f, 0.9f, 0.6f}};

/// A drawing, and the file of it.
struct Drawing {
    Drawing(std::uint64_t count, const Colours& c, Palette several = {}, int steps = 0)
        : colours(c), pens(std::move(several)) {
        const Density density(ramp());
        RankedTile tile = tile_named(kDefaultTile);
        REQUIRE(stipple(tile, density, PlacerKind::exact, {.count = count, .threads = 0, .thresholds = true},
                        stippling));
        if (steps > 0) relax(stippling.dots, density, steps, {.scale = stippling.scale, .threads = 0});
        ink = {.relaxing_steps = steps, .level = level_of(stippling.scale, tile.tile().size())};
        const PageSize page = page_size(density, 1);
        size = {page.width_mm, page.height_mm};
        radius = radius_for_tone(stippling.scale, 1.6);
        const RasterRequest request{.dpi = 25.4 * 1800, .threads = 0};
        if (!pens.empty()) share_out();
        const InkPage drawn{.size = page,
                            .dots = stream_of(stippling.dots),
                            .dot_radius_mm = radius,
                            .ink = colours.ink,
                            .pens = pens};
        const RasterSize pixels = raster_size(page, request.dpi);
        file = Grid<glm::u8vec3>(pixels.width, pixels.height);
        rasterise(drawn, request, [&](int first_row, std::span<const Grid<float>> coverage) {
            std::ranges::copy(ink_on_paper(coverage, drawn, colours.paper).values, file.row(first_row));
        });
    }

    // Each pen has one dot in so many, wherever they lie.
    void share_out() {
        DotPieces shared;
        shared.pieces.resize(pens.size());
        std::size_t i = 0;
        for (const Dots& piece : stippling.dots.pieces)
            for (std::size_t k = 0; k < piece.size(); ++k, ++i) {
                Dots& own = shared.pieces[i % pens.size()];
                own.pen = static_cast<int>(i % pens.size());
                own.x.push_back(piece.x[k]);
                own.y.push_back(piece.y[k]);
            }
        stippling.dots = std::move(shared);
    }

    Colours colours;
    Palette pens;
    Stippling stippling;
    InkedDots ink;
    glm::dvec2 size;    // page units
    double radius = 0;  // page units
    Grid<glm::u8vec3> file;
};

class Screen {
 public:
    explicit Screen(const Drawing& drawing) : drawing_(drawing), blocks_(dot_blocks(drawing.stippling.dots)) {
        picture.resize(kCanvas);
        renderer.set_dots(drawing.stippling.dots, blocks_);
        renderer.set_ink(drawing.ink, kDotsPerScale * drawing.stippling.scale);
        renderer.set_pens(drawing.pens);
        look.page_size = drawing.size;
        look.dot_radius = drawing.radius;
        look.ink = drawing.colours.ink;
        look.paper = drawing.colours.paper;
    }

    /// The largest difference, of any channel, in the thirds of what is seen of the page: on light, middle
    /// and dark tones.
    double difference_from_file(double pixels_per_unit, Fineness fineness = Fineness::full) {
        Camera camera = fitted(glm::dvec2(kCanvas), drawing_.size);
        camera.pixels_per_unit = pixels_per_unit;
        renderer.draw(picture, camera, look, fineness);
        return difference_from_file(camera);
    }

    /// Of as few dots as a preview may have.
    double previews_difference_from_file() {
        const Camera camera = fitted(glm::dvec2(kCanvas), drawing_.size);
        renderer.draw_quickly(picture, camera, look, {}, 1e-9);
        return difference_from_file(camera);
    }

    OffscreenContext context;
    GlFramebuffer picture;
    Renderer renderer{dots_by_in_environment()};
    CanvasLook look;

 private:
    double difference_from_file(const Camera& camera) {
        picture.bind();
        const Grid<glm::u8vec4> pixels = read_pixels(kCanvas);
        const glm::dvec2 corner = to_canvas(camera, PagePoint(0)),
                         end = to_canvas(camera, page_point(drawing_.size));
        const glm::dvec2 low = glm::ceil(glm::max(corner, 0.0)),
                         high = glm::floor(glm::min(end, glm::dvec2(kCanvas)));
        double largest = 0;
        for (int third = 0; third < 3; ++third) {
            const double left = std::floor(glm::mix(low.x, high.x, third / 3.0)),
                         right = std::floor(glm::mix(low.x, high.x, (third + 1) / 3.0));
            const Rectangle<double> on_screen{{left, low.y}, {right, high.y}};
            const double file_pixels = drawing_.file.width / (end.x - corner.x);
            const Rectangle<double> in_file{(on_screen.low - corner) * file_pixels,
                                            (on_screen.high - corner) * file_pixels};
            const glm::dvec3 apart =
                glm::abs(mean_light(pixels, on_screen) - mean_light(drawing_.file, in_file));
            largest = std::max({largest, apart.r, apart.g, apart.b});
        }
        return largest;
    }

    const Drawing& drawing_;
    std::vector<DotBlock> blocks_;
};

}  // namespace

TEST_CASE("from a few dots to millions, from far and from near, the canvas is as light as the file") {
    for (const std::uint64_t count : {2'000u, 40'000u, 200'000u, 2'000'000u}) {
        const Drawing drawing(count, kBlackOnWhite);
        Screen screen(drawing);
        for (const double zoom : {0.06, 0.25, 1.0, 3.3}) {
            CAPTURE(count);
            CAPTURE(zoom);
            CHECK(screen.difference_from_file(kFitted * zoom) < kMostApart);
        }
    }
}

TEST_CASE("so it is in each channel with coloured ink on coloured paper, given to all dots or one by one") {
    const Drawing drawing(40'000, kBlueOnSand);
    Screen screen(drawing);
    for (const double zoom : {0.06, 1.0, 3.3}) {
        CAPTURE(zoom);
        CHECK(screen.difference_from_file(kFitted * zoom) < kMostApart);
    }
    const glm::u8vec3 ink(glm::round(drawing.colours.ink * 255.0f));
    const std::vector colours(40'000, glm::u8vec4(ink, 255));
    screen.renderer.set_dot_colours(colours);
    screen.look.ink = {0, 1, 0};
    for (const double zoom : {0.06, 1.0, 3.3}) {
        CAPTURE(zoom);
        CHECK(screen.difference_from_file(kFitted * zoom) < kMostApart);
    }
}

TEST_CASE("dots of several pens are seen through one another, or hide each other, as they are in the file") {
    // As many pens as need a picture of their dots, two and three.
    for (const char* pens :
         {"cmyk", "Sky:#3aa0d8,Rust:#c04010,Leaf:#40a030,Sun:#ffed00,Rose:#e05090",
          "A:#3aa0d8,B:#c04010,C:#40a030,D:#ffed00,E:#e05090,F:#808080,G:#ffb0b0,H:#b0ffb0,"
          "I:#d02020,J:#20d020,K:#2020d0"}) {
        CAPTURE(std::string(pens));
        Palette palette = palette_of(parse_pens(pens));
        std::vector<glm::dvec3> mean;
        for (const PenInk ink : {PenInk::transparent, PenInk::opaque}) {
            for (Pen& pen : palette) pen.ink = ink;
            const Drawing drawing(2'000, kBlueOnSand, palette);
            Screen screen(drawing);
            for (const double zoom : {0.06, 1.0, 3.3}) {
                CAPTURE(zoom);
                CHECK(screen.difference_from_file(kFitted * zoom) < kMostApart);
            }
            mean.push_back(mean_light(drawing.file, {{900, 0}, {1800, 1200}}));
        }
        CHECK(mean[0].g < mean[1].g - 0.05);  // both inks take light
    }
}

TEST_CASE("white ink on black paper is as light as the file too") {
    const Drawing drawing(40'000, {kWhite, kBlack});
    Screen screen(drawing);
    for (const double zoom : {0.06, 1.0, 3.3}) {
        CAPTURE(zoom);
        CHECK(screen.difference_from_file(kFitted * zoom) < kMostApart);
    }
}

TEST_CASE("what is drawn quickly is as light as what is drawn fully") {
    for (const std::uint64_t count : {2'000u, 40'000u, 2'000'000u}) {
        const Drawing drawing(count, kBlackOnWhite);
        Screen screen(drawing);
        for (const double zoom : {0.06, 1.0, 3.3}) {
            CAPTURE(count);
            CAPTURE(zoom);
            CHECK(screen.difference_from_file(kFitted * zoom, Fineness::quick) < kMostApart);
        }
    }
}

TEST_CASE("a preview of some of the dots is about as light as all of them, as placed and relaxed") {
    for (const int steps : {0, 10}) {
        for (const std::uint64_t count : {12'000u, 30'000u, 80'000u}) {
            CAPTURE(steps);
            CAPTURE(count);
            const Drawing drawing(count, kBlackOnWhite, {}, steps);
            Screen screen(drawing);
            CHECK(screen.previews_difference_from_file() < (steps == 0 ? 2 : 3) * kMostApart);
        }
    }
}

TEST_CASE("large dots need one sample a pixel, small ones more, and quickly drawn ones few") {
    CHECK(samples_per_side(10, {1000, 800}, Fineness::full) == 1);
    CHECK(samples_per_side(10, {1000, 800}, Fineness::quick) == 1);
    CHECK(samples_per_side(3, {1000, 800}, Fineness::full) == 2);
    CHECK(samples_per_side(0.3, {1000, 800}, Fineness::full) == 5);
    CHECK(samples_per_side(0.3, {1000, 800}, Fineness::quick) == 1);
    CHECK(samples_per_side(0.02, {50, 40}, Fineness::full) == 75);
    CHECK(samples_per_side(0.001, {16, 16}, Fineness::full) <= 128);
    for (const double radius : {10.0, 1.0, 0.1, 1e-3, 1e-9}) {
        for (const glm::ivec2 pixels : {glm::ivec2(1, 1), {16, 5000}, {4000, 3000}, {9000, 9000}}) {
            CAPTURE(radius);
            CAPTURE(pixels.x);
            const SampleLimits limits{.largest_side = 8000, .most = 20e6};
            const int samples = samples_per_side(radius, pixels, Fineness::full, limits);
            CHECK(samples >= 1);
            if (samples == 1) continue;
            CHECK(samples * std::max(pixels.x, pixels.y) <= 8000);
            CHECK(static_cast<double>(samples) * samples * pixels.x * pixels.y <= 20e6);
        }
    }
}

}  // namespace dapple
