// What the renderer paints, read back pixel by pixel.

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "app/viewer/background/dot_blocks.h"
#include "app/viewer/background/small_pictures.h"
#include "app/viewer/canvas/renderer.h"
#include "core/image/colour.h"
#include "core/image/tone.h"
#include "tests/dot_pieces.h"
#include "tests/dots_by.h"
#include "tests/offscreen_gl.h"

namespace dapple {
namespace {

constexpr glm::ivec2 kSize{200, 160};
constexpr double kPixelsPerUnit = 100;

class Picture200 {
 public:
    Picture200() {
        framebuffer.resize(kSize);
        look.page_size = {2, 1.6};  // the page fills the canvas
        look.paper = {1, 1, 1};
        look.ink = {0, 0, 0};
        camera = {glm::dvec2(kSize), page_point({1, 0.8}), kPixelsPerUnit};
    }
    /// A dot at a pixel position, not yet drawn.
    void add(double x, double y) {
        dots.x.push_back(static_cast<float>(x / kPixelsPerUnit));
        dots.y.push_back(static_cast<float>(y / kPixelsPerUnit));
    }
    void radius(double pixels) { look.dot_radius = pixels / kPixelsPerUnit; }
    void set_dots(DotPieces given, const PageWindow& window = {}) {
        pieces = std::move(given);
        blocks = dot_blocks(pieces);
        renderer.set_dots(pieces, blocks, window);
    }
    Grid<glm::u8vec4> draw() {
        set_dots(split(dots));
        return draw_again();
    }
    void show_photograph(const Grid<glm::u8vec4>& photograph) {
        renderer.set_picture(std::make_shared<const std::vector<Grid<glm::u8vec4>>>(mipmaps_of(photograph)));
        while (!renderer.upload(1)) continue;
    }
    Grid<glm::u8vec4> draw_again() {
        renderer.draw(framebuffer, camera, look);
        return read_pixels(kSize);
    }

    OffscreenContext context;
    GlFramebuffer framebuffer;
    Renderer renderer{dots_by_in_environment()};
    Camera camera;
    CanvasLook look;
    Dots dots;
    DotPieces pieces;
    std::vector<DotBlock> blocks;
};

/// Black ink on the white picture in pixels' areas.
double ink_area(const Grid<glm::u8vec4>& pixels) {
    double sum = 0;
    for (auto p : pixels.values) sum += 1 - srgb_to_linear(static_cast<float>(p.r) / 255);
    return sum;
}

}  // namespace

TEST_CASE("of pens that are hidden neither dots nor lines are drawn") {
    Picture200 picture;
    picture.radius(10);
    DotPieces dots;
    dots.pieces.resize(2);
    for (int pen = 0; pen < 2; ++pen) {
        Dots& own = dots.pieces[static_cast<std::size_t>(pen)];
        own.pen = pen;
        own.x.push_back(pen == 0 ? 0.5f : 1.5f);
        own.y.push_back(0.8f);
    }
    picture.set_dots(dots);
    const double both = ink_area(picture.draw_again());
    for (const std::uint32_t hidden : {1u, 2u, 3u}) {
        picture.look.hidden_pens = hidden;
        const Grid<glm::u8vec4> seen = picture.draw_again();
        CHECK((seen.at(50, 80).r < 128) == ((hidden & 1) == 0));
        CHECK((seen.at(150, 80).r < 128) == ((hidden & 2) == 0));
        CHECK(ink_area(seen) == doctest::Approx(hidden == 3 ? 0 : both / 2).epsilon(0.01));
    }
    const std::vector<Pen> pens(2);
    Strokes strokes;
    strokes.points = {{20, 40}, {180, 40}, {20, 120}, {180, 120}};
    strokes.ends = {2, 4};
    strokes.pens = {0, 1};
    StrokeStream stream = stream_of(strokes, 10);
    stream.widths_mm = {10, 10};
    const ShownStrokes lines = on_screen(stream, pens, 100);
    picture.renderer.set_strokes(lines);
    for (const std::uint32_t hidden : {0u, 1u, 2u}) {
        picture.look.hidden_pens = hidden;
        const Grid<glm::u8vec4> seen = picture.draw_again();
        CHECK((seen.at(100, 40).r < 128) == (hidden != 1));
        CHECK((seen.at(100, 120).r < 128) == (hidden != 2));
    }
}

TEST_CASE("a dot covers its area, whatever its size and place between pixels") {
    for (double radius : {0.2, 0.5, 0.8, 1.5, 4.0, 20.0, 60.0}) {
        CAPTURE(radius);
        Picture200 picture;
        picture.radius(radius);
        for (int i = 0; i < 4; ++i) {
            picture.dots = {};
            picture.add(90 + 0.25 * i, 80.4 + 0.17 * i);
            double area = std::numbers::pi * radius * radius;
            CHECK(ink_area(picture.draw()) == doctest::Approx(area).epsilon(0.03));
        }
    }
}

TEST_CASE("a dot larger than any point sprite is drawn just as round") {
    Picture200 picture;
    picture.radius(300);
    picture.add(-180, 80);  // its rim crosses the canvas at x = 120
    auto pixels = picture.draw();
    CHECK(pixels.at(100, 80).r == 0);
    CHECK(pixels.at(118, 80).r == 0);
    CHECK(pixels.at(122, 80).r == 255);
    // (x + 180)^2 + 70^2 = 300^2
    int rim = static_cast<int>(std::sqrt(300.0 * 300 - 70 * 70) - 180);
    CHECK(pixels.at(rim - 2, 150).r == 0);
    CHECK(pixels.at(rim + 3, 150).r == 255);
}

TEST_CASE("a dot whose centre is outside the canvas still shows its rim") {
    Picture200 picture;
    picture.radius(10);
    picture.add(-5, 80);
    CHECK(picture.draw().at(2, 80).r < 5);
}

TEST_CASE("x goes to the right and y goes down") {
    Picture200 picture;
    picture.radius(5);
    picture.add(30, 20);
    auto pixels = picture.draw();
    CHECK(pixels.at(30, 20).r < 5);
    CHECK(pixels.at(30, 140).r == 255);
    CHECK(pixels.at(170, 20).r == 255);
}

TEST_CASE("dots have the ink's colour and paper the paper's, encoded as given") {
    Picture200 picture;
    picture.look.ink = glm::vec3(10, 100, 200) / 255.0f;
    picture.look.paper = glm::vec3(250, 240, 230) / 255.0f;
    picture.radius(8);
    picture.add(100.5, 80.5);
    auto pixels = picture.draw();
    CHECK(pixels.at(100, 80) == glm::u8vec4(10, 100, 200, 255));
    CHECK(pixels.at(20, 20) == glm::u8vec4(250, 240, 230, 255));
}

TEST_CASE("dots have a colour each until there are other dots") {
    for (const double radius : {10.0, 300.0}) {  // sprites, and squares
        Picture200 picture;
        picture.radius(radius);
        picture.add(50 - radius, 80);
        picture.add(150 + radius, 80);
        picture.draw();
        const std::array colours{glm::u8vec4(200, 0, 0, 255), glm::u8vec4(0, 0, 100, 255)};
        picture.renderer.set_dot_colours(colours);
        const Grid<glm::u8vec4> pixels = picture.draw_again();
        CHECK(glm::u8vec3(pixels.at(45, 80)) == glm::u8vec3(200, 0, 0));
        CHECK(glm::u8vec3(pixels.at(155, 80)) == glm::u8vec3(0, 0, 100));
        CHECK(glm::u8vec3(picture.draw().at(45, 80)) == glm::u8vec3(0, 0, 0));
        // A transparent colour hides its dot.
        const std::array hidden{glm::u8vec4(200, 0, 0, 0), glm::u8vec4(0, 0, 100, 255)};
        picture.renderer.set_dot_colours(hidden);
        CHECK(glm::u8vec3(picture.draw_again().at(45, 80)) == glm::u8vec3(255, 255, 255));
    }
}

TEST_CASE("lines of several pens have a colour and a width each, and those of one pen the ink's") {
    Picture200 picture;
    picture.radius(3);
    picture.add(20, 20);
    picture.draw();
    const float unit = kPixelsPerUnit;
    ShownStrokes strokes;
    strokes.lines = {{20 / unit, 40 / unit, 180 / unit, 40 / unit},
                     {20 / unit, 100 / unit, 180 / unit, 100 / unit}};
    strokes.blocks = {{.count = 2, .low = {0.2f, 0.4f}, .high = {1.8f, 1.0f}}};
    strokes.width = 20 / unit;
    strokes.pens = {0, 1};
    strokes.widths = {20 / unit, 8 / unit};
    const std::array<Pen, 2> pens{{{.name = "Red", .colour = parse_colour("#c80000")},
                                   {.name = "Blue", .colour = parse_colour("#000064")}}};
    picture.renderer.set_pens(pens);
    picture.renderer.set_strokes(strokes);
    Grid<glm::u8vec4> pixels = picture.draw_again();
    CHECK(glm::u8vec3(pixels.at(100, 40)) == glm::u8vec3(200, 0, 0));
    CHECK(glm::u8vec3(pixels.at(100, 47)) == glm::u8vec3(200, 0, 0));
    CHECK(glm::u8vec3(pixels.at(100, 100)) == glm::u8vec3(0, 0, 100));
    CHECK(glm::u8vec3(pixels.at(100, 107)) == glm::u8vec3(255, 255, 255));
    CHECK(glm::u8vec3(pixels.at(20, 20)) == glm::u8vec3(255, 255, 255));  // no dots
    picture.draw();                                                       // other dots
    strokes.pens.clear();
    strokes.widths.clear();
    picture.renderer.set_strokes(strokes);
    pixels = picture.draw_again();
    CHECK(glm::u8vec3(pixels.at(100, 40)) == glm::u8vec3(0, 0, 0));
    CHECK(glm::u8vec3(pixels.at(100, 107)) == glm::u8vec3(0, 0, 0));
}

TEST_CASE("outside the page is the desk, and no shadow falls on the page") {
    Picture200 picture;
    picture.look.page_size = {1, 1};
    picture.look.desk = {0.5f, 0.5f, 0.5f};
    auto pixels = picture.draw();
    CHECK(pixels.at(98, 50).r == 255);
    CHECK(pixels.at(2, 98).r == 255);
    CHECK(pixels.at(190, 50).r == doctest::Approx(127.5).epsilon(0.02));
    CHECK(pixels.at(101, 50).r < 120);
}

TEST_CASE("the photograph shows through as strongly as asked, the right way up") {
    Picture200 picture;
    Grid<glm::u8vec4> photograph(2, 2, glm::u8vec4(0, 0, 0, 255));
    photograph.at(1, 0) = {255, 0, 0, 255};
    picture.show_photograph(photograph);
    picture.look.picture_opacity = 1;
    auto pixels = picture.draw();
    CHECK(pixels.at(190, 10) == glm::u8vec4(255, 0, 0, 255));
    CHECK(pixels.at(10, 10) == glm::u8vec4(0, 0, 0, 255));
    CHECK(pixels.at(190, 150) == glm::u8vec4(0, 0, 0, 255));
    picture.look.picture_opacity = 0.5f;
    CHECK(picture.draw().at(10, 10).r == doctest::Approx(127.5).epsilon(0.02));
    picture.look.picture_opacity = 0;
    CHECK(picture.draw().at(10, 10).r == 255);
}

TEST_CASE("the photograph's light is multiplied by its gain") {
    Picture200 picture;
    picture.show_photograph(Grid<glm::u8vec4>(2, 2, glm::u8vec4(120, 60, 230, 255)));
    picture.look.picture_opacity = 1;
    CHECK(picture.draw().at(100, 80) == glm::u8vec4(120, 60, 230, 255));
    picture.look.picture_gain = 2;
    const auto twice = [](int encoded) {
        return 255 * linear_to_srgb(std::min(2 * srgb_to_linear(static_cast<float>(encoded) / 255), 1.0f));
    };
    const glm::u8vec4 lighter = picture.draw().at(100, 80);
    CHECK(lighter.r == doctest::Approx(twice(120)).epsilon(0.01));
    CHECK(lighter.g == doctest::Approx(twice(60)).epsilon(0.02));
    CHECK(lighter.b == 255);
}

TEST_CASE("a photograph uploaded in slices, however short, is there as a whole and not before") {
    Picture200 picture;
    Grid<glm::u8vec4> photograph(1500, 1200, glm::u8vec4(0, 0, 255, 255));
    for (int x = 0; x < 1500; ++x) photograph.at(x, 1199) = {255, 0, 0, 255};
    picture.look.picture_opacity = 1;
    picture.renderer.set_picture(
        std::make_shared<const std::vector<Grid<glm::u8vec4>>>(mipmaps_of(photograph)));
    int slices = 0;
    while (!picture.renderer.upload(1e-9)) {
        if (slices++ < 3) CHECK(picture.draw().at(100, 80) == glm::u8vec4(255, 255, 255, 255));
        REQUIRE(slices < 1000);
        // One piece of work at least is done in each, or it would never end.
        picture.renderer.upload(1e-4);
    }
    CHECK(slices > 2);
    CHECK(picture.draw().at(100, 80) == glm::u8vec4(0, 0, 255, 255));
    // The last row is there too, seen from near.
    picture.camera = {glm::dvec2(kSize), page_point({1, 1.6}), 1e5};
    CHECK(picture.draw().at(100, 60) == glm::u8vec4(255, 0, 0, 255));
    picture.renderer.set_picture(nullptr);
    CHECK(picture.renderer.upload(0));
    CHECK(picture.draw().at(100, 60) == glm::u8vec4(255, 255, 255, 255));
}

TEST_CASE("a tile's outline is a line of its level's colour where its sides are, and only then") {
    Picture200 picture;
    PlacedTile tile{.level = 3, .x = 0.5, .y = 0.3, .side = 1, .orientation = {}};
    picture.renderer.set_tiles(std::span(&tile, 1));
    picture.look.tiles = true;
    picture.look.pixel_scale = 4;
    auto pixels = picture.draw();
    glm::vec3 colour = level_colour(3) * 255.0f;
    for (glm::ivec2 at : {glm::ivec2(50, 80), {149, 80}, {100, 30}, {100, 129}}) {
        CAPTURE(at.x);
        auto p = pixels.at(at.x, at.y);
        CHECK(std::abs(p.r - (colour.r * 0.85f + 255 * 0.15f)) <= 2);
        CHECK(std::abs(p.b - (colour.b * 0.85f + 255 * 0.15f)) <= 2);
    }
    CHECK(pixels.at(100, 80) == glm::u8vec4(255));
    CHECK(pixels.at(20, 80) == glm::u8vec4(255));
    picture.look.tiles = false;
    CHECK(picture.draw().at(50, 80) == glm::u8vec4(255));
}

TEST_CASE("a dot fades in from its critical scale on") {
    Picture200 picture;
    picture.radius(5);
    picture.add(100, 80);
    picture.dots.critical = {1000};
    // Lighter or smaller: as much less ink.
    const double whole = std::numbers::pi * 25;
    for (const auto& each : {std::pair{990.0, 0.0}, {1075.0, 0.5}, {1200.0, 1.0}, {0.0, 1.0}}) {
        const double scale = each.first, share = each.second;
        CAPTURE(scale);
        picture.look.fade_scale = scale;
        CHECK(std::abs(ink_area(picture.draw()) / whole - share) < 0.03);
    }
}

TEST_CASE("drawn in many steps the page is what it is when drawn at once, tiles and colours too") {
    Picture200 picture;
    picture.radius(0.6);
    for (int i = 0; i < 30'000; ++i)
        picture.add(i * 0.618034 - std::floor(i * 0.618034 / 200) * 200, i / 187.5);
    std::vector<PlacedTile> tiles;
    for (int i = 0; i < 3000; ++i)
        tiles.push_back(
            {.level = 2, .x = i % 60 / 30.0, .y = i / 60 / 30.0, .side = 1 / 30.0, .orientation = {}});
    std::vector<glm::u8vec4> colours;
    for (int i = 0; i < 30'000; ++i) colours.emplace_back(i % 256, 100, i % 77, 255);
    picture.look.tiles = true;
    picture.draw();
    picture.renderer.set_dot_colours(colours);
    picture.renderer.set_tiles(tiles);
    const auto at_once = picture.draw_again();
    GlFramebuffer other;
    other.resize(kSize);
    picture.renderer.begin(picture.camera, picture.look, {});
    int steps = 1;
    while (!picture.renderer.step(other, 0)) {
        ++steps;
        GLint program = 0;  // of which others would keep the name, and it may be deleted
        glGetIntegerv(GL_CURRENT_PROGRAM, &program);
        CHECK(program == 0);
    }
    CHECK(steps > 10);
    other.bind();
    CHECK(read_pixels(kSize).values == at_once.values);
}

TEST_CASE("of too many dots for a quick drawing some are drawn, and the page is as dark") {
    Picture200 picture;
    picture.radius(0.25);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(0, 1);
    for (int i = 0; i < 100'000; ++i) picture.add(200 * place(random), 160 * place(random));
    const double all = ink_area(picture.draw());
    CHECK(picture.renderer.draw_quickly(picture.framebuffer, picture.camera, picture.look, {}, 1e-9) ==
          Fineness::quick);
    picture.framebuffer.bind();
    CHECK(ink_area(read_pixels(kSize)) == doctest::Approx(all).epsilon(0.05));
}

TEST_CASE("of too many dots that say when they appear, those that do so first are drawn quickly") {
    Picture200 picture;
    picture.radius(0.25);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(0, 1);
    // The first ones, of which there are more than are drawn, lie at the left.
    for (int i = 0; i < 100'000; ++i) {
        const bool first = i % 5 < 3;
        picture.add((first ? 0 : 100) + 100 * place(random), 160 * place(random));
        picture.dots.critical.push_back(first ? 1.0f : 100.0f);
    }
    picture.draw();
    CHECK(picture.renderer.draw_quickly(picture.framebuffer, picture.camera, picture.look, {}, 1e-9) ==
          Fineness::quick);
    picture.framebuffer.bind();
    const auto pixels = read_pixels(kSize);
    int left = 0, right = 0;
    for (int y = 0; y < 160; ++y) {
        for (int x = 0; x < 90; ++x) left += pixels.at(x, y).r < 200;
        for (int x = 110; x < 200; ++x) right += pixels.at(x, y).r < 200;
    }
    CHECK(left > 1000);
    CHECK(right == 0);
}

TEST_CASE("dots of a window far into the page lie where the camera says") {
    Picture200 picture;
    const double deep = 100 * 0x1p40;
    const PageWindow window{(1LL << 61) + 12'345'678, (1LL << 60) + 987'654, 2 / deep, 2 / deep};
    picture.camera = {glm::dvec2(kSize), {window.x, window.y}, deep};
    picture.look.dot_radius = 5 / deep;
    picture.look.page_size = {1, 1};
    picture.dots.x = {static_cast<float>(40 / deep)};
    picture.dots.y = {static_cast<float>(30 / deep)};
    picture.set_dots(in_one_piece(picture.dots), window);
    auto pixels = picture.draw_again();
    CHECK(pixels.at(140, 110).r < 5);
    CHECK(pixels.at(137, 110).r < 5);
    CHECK(pixels.at(148, 110).r == 255);
    CHECK(pixels.at(132, 110).r == 255);
}

TEST_CASE("tiles that reach over the page's edges leave the desk around it alone, letters too") {
    Picture200 picture;
    picture.look.page_size = {1.2, 1.1};
    const std::vector<PlacedTile> tiles{{.level = 2, .x = 0.1, .y = 0.1, .side = 1.5, .orientation = {}},
                                        {.level = 3, .x = 0.6, .y = 0.6, .side = 0.99, .orientation = {}},
                                        {.level = 3, .x = 0.75, .y = 0.2, .side = 0.9, .orientation = {}}};
    const auto without = picture.draw();
    picture.renderer.set_tiles(tiles);
    picture.look.tiles = true;
    const auto with = picture.draw();
    int on_page = 0, on_desk = 0;
    for (int y = 0; y < kSize.y; ++y)
        for (int x = 0; x < kSize.x; ++x) {
            if (with.at(x, y) == without.at(x, y)) continue;
            // But for a pixel of lines along the edge.
            (x <= 121 && y <= 111 ? on_page : on_desk) += 1;
        }
    CHECK(on_page > 300);
    CHECK(on_desk == 0);
}

TEST_CASE("a letter F in a tile tells its eight orientations apart") {
    Picture200 picture;
    picture.look.tiles = true;
    for (Orientation g : all_orientations()) {
        CAPTURE(int(g.index));
        PlacedTile tile{.level = 3, .x = 0.3, .y = 0.1, .side = 1.4, .orientation = g};
        picture.renderer.set_tiles(std::span(&tile, 1));
        auto pixels = picture.draw();
        auto inked = [&](glm::dvec2 in_letter) {
            glm::dvec2 at = glm::dvec2(100, 80) + apply(g, in_letter) * (140 * 0.09);
            return pixels.at(static_cast<int>(at.x), static_cast<int>(at.y)) != glm::u8vec4(255);
        };
        // The upright letter: foot, upper right arm, middle arm; not the other corners.
        CHECK(inked({-0.55, 0.8}));
        CHECK(inked({0.5, -0.9}));
        CHECK(inked({0.2, -0.1}));
        CHECK_FALSE(inked({0.55, 0.8}));
        CHECK_FALSE(inked({0.2, 0.5}));
        CHECK_FALSE(inked({0.2, -0.5}));
    }
}

TEST_CASE("of several kinds of tiles the letter's colour is that of the kind") {
    Picture200 picture;
    picture.look.tiles = true;
    for (const auto kind : {std::optional<std::size_t>(), {0}, {1}, {7}, {63}}) {
        PlacedTile tile{.level = 3, .x = 0.3, .y = 0.1, .side = 1.4, .orientation = {}, .kind = kind};
        picture.renderer.set_tiles(std::span(&tile, 1));
        const glm::vec3 colour(glm::vec3(picture.draw().at(93, 73)) / 255.0f);
        const glm::vec3 expected = kind ? kind_colour(*kind) : level_colour(3);
        CHECK(glm::distance(colour, expected) < 0.01f);
    }
}

TEST_CASE("dots have a radius each, until there are dots without") {
    for (const double largest : {10.0, 300.0}) {  // sprites, and squares
        CAPTURE(largest);
        Picture200 picture;
        picture.radius(3);
        picture.add(50, 80);
        picture.add(120 + largest, 80);
        picture.dots.radius = {static_cast<float>(5 / kPixelsPerUnit),
                               static_cast<float>(largest / kPixelsPerUnit)};
        const auto pixels = picture.draw();
        for (const auto& [x, inked] : {std::pair(46, true), {44, false}, {53, true}, {55, false}})
            CHECK(pixels.at(x, 80).r == (inked ? 0 : 255));
        CHECK(pixels.at(118, 80).r == 255);
        CHECK(pixels.at(121, 80).r < 255);
        CHECK(pixels.at(123, 80).r == 0);
        picture.dots.radius.clear();
        CHECK(picture.draw().at(46, 80).r == 255);
        CHECK(picture.draw().at(51, 80).r == 0);
    }
}

TEST_CASE("a dot of radius 0 is not seen, nor in the way of others") {
    Picture200 picture;
    picture.add(50, 80);
    picture.add(120, 80);
    picture.dots.radius = {0, static_cast<float>(5 / kPixelsPerUnit)};
    CHECK(ink_area(picture.draw()) == doctest::Approx(25 * std::numbers::pi).epsilon(0.03));
}

TEST_CASE("dots that lie on each other cover no more than one, and halves of them what they cover together") {
    // Two unit discs whose centres are 1 apart have 2 pi / 3 - sqrt(3) / 2 in common.
    constexpr double lens = 2 * std::numbers::pi / 3 - std::numbers::sqrt3 / 2;
    for (const double radius : {0.3, 1.0, 3.0, 20.0}) {
        CAPTURE(radius);
        Picture200 picture;
        picture.radius(radius);
        for (int i = 0; i < 2; ++i) picture.add(60.3, 80.4);
        const double one = std::numbers::pi * radius * radius;
        CHECK(ink_area(picture.draw()) == doctest::Approx(one).epsilon(0.06));
        picture.add(60.3 + radius, 80.4);
        CHECK(ink_area(picture.draw()) == doctest::Approx(2 * one - lens * radius * radius).epsilon(0.06));
    }
}

TEST_CASE("dots end at the page's edges, wherever these lie between pixels") {
    for (const double shift : {0.0, 0.3, 0.5, 0.8}) {
        for (const double radius : {0.4, 6.0, 300.0}) {
            CAPTURE(shift);
            CAPTURE(radius);
            Picture200 picture;
            picture.look.page_size = {1.2, 1};
            picture.look.desk = {0.5f, 0.5f, 0.5f};
            picture.camera = dragged(picture.camera, {20 + shift, 20 + shift});
            const auto without = picture.draw();
            picture.radius(radius);
            for (int i = 0; i <= 120; ++i) {
                picture.add(i, -0.2);
                picture.add(i, 100.2);
                picture.add(-0.2, std::min(i, 100));
                picture.add(120.2, std::min(i, 100));
            }
            const auto with = picture.draw();
            int on_page = 0, on_desk = 0;
            const double low = 20 + shift;
            for (int y = 0; y < kSize.y; ++y)
                for (int x = 0; x < kSize.x; ++x) {
                    if (with.at(x, y) == without.at(x, y)) continue;
                    const bool touches = x + 1 > low && y + 1 > low && x < low + 120 && y < low + 100;
                    (touches ? on_page : on_desk) += 1;
                }
            CHECK(on_page > 300);
            CHECK(on_desk == 0);
        }
    }
}

TEST_CASE("dots are as dense along the page's edges as within") {
    Picture200 picture;
    picture.look.page_size = {1.2, 1};
    picture.look.desk = {0.5f, 0.5f, 0.5f};
    picture.look.pixel_scale = 0.01f;  // without a shadow
    picture.camera = dragged(picture.camera, {20, 20.7});
    picture.radius(0.3);
    for (int row = 0; row < 200; ++row)
        for (int i = 0; i < 240; ++i) picture.add(i * 0.5 + 0.25, row * 0.5 + 0.25);
    const auto pixels = picture.draw();
    const auto light_of_row = [&](int y) {
        double sum = 0;
        for (int x = 30; x < 130; ++x) sum += srgb_to_linear(static_cast<float>(pixels.at(x, y).r) / 255);
        return sum / 100;
    };
    const double within = light_of_row(70), desk = srgb_to_linear(0.5f);
    CHECK(within < 0.15);
    CHECK(light_of_row(19) == doctest::Approx(desk).epsilon(0.01));
    CHECK(std::abs(light_of_row(20) - (0.3 * within + 0.7 * desk)) < 0.05);
}

TEST_CASE("only the columns asked for are drawn") {
    Picture200 picture;
    picture.radius(30);
    picture.add(100, 80);
    picture.draw();
    picture.look.ink = {1, 0, 0};
    picture.look.paper = {0, 0, 1};
    picture.renderer.draw(picture.framebuffer, picture.camera, picture.look, Fineness::full, {100, 180});
    const auto pixels = read_pixels(kSize);
    CHECK(pixels.at(99, 80) == glm::u8vec4(0, 0, 0, 255));
    CHECK(pixels.at(100, 80) == glm::u8vec4(255, 0, 0, 255));
    CHECK(pixels.at(50, 80) == glm::u8vec4(255));
    CHECK(pixels.at(179, 80) == glm::u8vec4(0, 0, 255, 255));
    CHECK(pixels.at(180, 80) == glm::u8vec4(255));
}

TEST_CASE("fewer dots than before leave none of the old ones") {
    Picture200 picture;
    picture.radius(3);
    for (int i = 0; i < 1000; ++i) picture.add(20 + i % 100, 20 + i / 10);
    picture.draw();
    picture.dots = {};
    picture.add(10, 10);
    double one = ink_area(picture.draw());
    CHECK(one == doctest::Approx(std::numbers::pi * 9).epsilon(0.05));
    picture.dots = {};
    CHECK(ink_area(picture.draw()) == 0);
}

}  // namespace dapple
