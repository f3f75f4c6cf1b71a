#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/image/colour.h"
#include "core/output/raster.h"

using namespace dapple;

namespace {

// A page of that many pixels whose page units, millimetres and pixels are one and the same.
PageSize pixel_page(int width, int height) {
    return {.width_mm = static_cast<double>(width),
            .height_mm = static_cast<double>(height),
            .mm_per_page_unit = 1};
}
constexpr double kOnePixelPerMm = 25.4;

Dots dots_at(const std::vector<std::pair<float, float>>& places) {
    Dots dots;
    for (const auto& [x, y] : places) {
        dots.x.push_back(x);
        dots.y.push_back(y);
    }
    return dots;
}

Grid<float> draw(const Dots& dots, int width, int height, double radius, int threads = 1) {
    return coverage_of({.size = pixel_page(width, height), .dots = stream_of(dots), .dot_radius_mm = radius},
                       {.dpi = kOnePixelPerMm, .threads = threads});
}

double area(const Grid<float>& coverage) {
    return std::accumulate(coverage.values.begin(), coverage.values.end(), 0.0);
}

double disc_area(double radius) {
    return std::numbers::pi * radius * radius;
}

// The area shared by two discs of equal radius whose centres are so far apart.
double overlap(double radius, double distance) {
    return 2 * radius * radius * std::acos(distance / (2 * radius)) -
           distance / 2 * std::sqrt(4 * radius * radius - distance * distance);
}

}  // namespace

TEST_CASE("a disc covers pi r^2 pixels, wherever it lies in its pixel") {
    std::mt19937 random(2);
    std::uniform_real_distribution<float> place(10, 11);
    for (const double radius : {0.5, 1.0, 2.7, 8.0}) {
        double sum = 0;
        constexpr int trials = 50;
        for (int i = 0; i < trials; ++i) {
            const double one = area(draw(dots_at({{place(random), place(random)}}), 21, 21, radius));
            CHECK(one == doctest::Approx(disc_area(radius)).epsilon(0.05 / radius));
            sum += one;
        }
        CHECK(sum / trials == doctest::Approx(disc_area(radius)).epsilon(0.004));
    }
}

TEST_CASE("a pixel's coverage is the share of it inside the disc") {
    // A quarter disc of radius 1 in each of the four pixels around its centre.
    const Grid<float> four = draw(dots_at({{1, 1}}), 2, 2, 1);
    for (const float share : four.values)
        CHECK(share == doctest::Approx(std::numbers::pi / 4).epsilon(0.005));
    // A disc so large that its edge is a straight line: x < 1.3.
    const Grid<float> edge = draw(dots_at({{1.3f - 20000, 0.5f}}), 4, 1, 20000);
    CHECK(edge.at(0, 0) == 1);
    CHECK(edge.at(1, 0) == doctest::Approx(0.3).epsilon(0.05));
    CHECK(edge.at(2, 0) == 0);
}

TEST_CASE("discs that overlap unite: the area is that of inclusion and exclusion") {
    constexpr double radius = 6;
    for (const double distance : {0.0, 1.0, 5.0, 11.0}) {
        const float x = static_cast<float>(distance);
        const double united = area(draw(dots_at({{10.2f, 10.7f}, {10.2f + x, 10.7f}}), 40, 22, radius));
        CHECK(united == doctest::Approx(2 * disc_area(radius) - overlap(radius, distance)).epsilon(0.003));
    }
}

TEST_CASE("a disc is cut at the page's edges") {
    const double quarter = area(draw(dots_at({{0, 0}}), 9, 9, 5));
    CHECK(quarter == doctest::Approx(disc_area(5) / 4).epsilon(0.005));
    CHECK(area(draw(dots_at({{-20, 3}, {40, 3}, {3, -20}, {3, 40}}), 9, 9, 5)) == 0);
    CHECK(area(draw(dots_at({{4, 4}}), 9, 9, 50)) == 81);
}

TEST_CASE("bands and threads leave no trace in the picture") {
    // Wide and high enough for several bands.
    std::mt19937 random(3);
    std::uniform_real_distribution<float> x(0, 700), y(0, 900);
    std::vector<std::pair<float, float>> places;
    for (int i = 0; i < 3000; ++i) places.emplace_back(x(random), y(random));
    const Grid<float> one = draw(dots_at(places), 700, 900, 3.3, 1);
    CHECK(draw(dots_at(places), 700, 900, 3.3, 4).values == one.values);

    // The same dots 37 pixels further down: the bands fall elsewhere.
    for (auto& place : places) place.second += 37;
    const Grid<float> shifted = draw(dots_at(places), 700, 937, 3.3, 1);
    std::size_t differing = 0;
    for (int row = 0; row < 900; ++row) {
        for (int column = 0; column < 700; ++column) {
            // A dot's y is a float, so the shift moves it by a rounding.
            if (std::abs(shifted.at(column, row + 37) - one.at(column, row)) > 0.02f) ++differing;
        }
    }
    CHECK(differing == 0);
}

TEST_CASE("bands come from the top down without gaps") {
    int next = 0;
    const Dots one = dots_at({{5, 5}});
    rasterise({.size = pixel_page(3000, 1500), .dots = stream_of(one), .dot_radius_mm = 1},
              {.dpi = kOnePixelPerMm, .threads = 3}, [&](int first_row, std::span<const Grid<float>> band) {
                  CHECK(first_row == next);
                  REQUIRE(band.size() == 1);
                  CHECK(band[0].width == 3000);
                  next += band[0].height;
              });
    CHECK(next == 1500);
}

TEST_CASE("a picture is the same however few dots are in memory at once, and they come in pieces") {
    // Six pages of pixels in as many bands and more; dots of all sizes of neighbourhoods, many on two bands.
    constexpr int width = 900, height = 6000;
    std::mt19937 random(8);
    std::uniform_real_distribution<float> x(-2, width + 2), y(-2, height + 2);
    std::vector<Dots> pieces(40);
    Dots all;
    for (Dots& piece : pieces) {
        for (int i = 0; i < 50; ++i) {
            piece.x.push_back(x(random));
            piece.y.push_back(y(random));
            all.x.push_back(piece.x.back());
            all.y.push_back(piece.y.back());
        }
    }
    int passes = 0;
    const DotStream stream{all.size(), 0, 0, [&](const TakePiece& take) {
                               ++passes;
                               for (const Dots& piece : pieces)
                                   if (!take(piece)) return;
                           }};
    const Grid<float> whole = draw(all, width, height, 3);
    for (const std::uint64_t at_once : {1u, 300u, 1'000'000u}) {
        passes = 0;
        Grid<float> drawn(width, height);
        rasterise({.size = pixel_page(width, height), .dots = stream, .dot_radius_mm = 3},
                  {.dpi = kOnePixelPerMm, .threads = 2, .dots_at_once = at_once},
                  [&](int first_row, std::span<const Grid<float>> band) {
                      std::ranges::copy(band[0].values, drawn.row(first_row));
                  });
        CHECK(drawn.values == whole.values);
        // Once to count, then again for each stretch.
        CHECK((at_once > all.size() ? passes == 2 : passes > 5));
    }
}

TEST_CASE("ink and paper mix as light does") {
    Grid<float> coverage(3, 1);
    coverage.values = {0, 0.5f, 1};
    const Grid<glm::u8vec3> pixels = ink_on_paper(coverage, kBlack, kWhite);
    CHECK(pixels.at(0, 0) == glm::u8vec3(255));
    // Half the light is 188 of 255 when encoded: 1.055 * 0.5^(1/2.4) - 0.055 = 0.7354.
    CHECK(pixels.at(1, 0) == glm::u8vec3(188));
    CHECK(pixels.at(2, 0) == glm::u8vec3(0));
    const Grid<glm::u8vec3> coloured =
        ink_on_paper(coverage, parse_colour("#1d3557"), parse_colour("#f1faee"));
    CHECK(coloured.at(0, 0) == glm::u8vec3(0xf1, 0xfa, 0xee));
    CHECK(coloured.at(2, 0) == glm::u8vec3(0x1d, 0x35, 0x57));
}

TEST_CASE("of two inks that overlap both are seen if they are transparent, the upper one if it is opaque") {
    // Nothing, one, the other, both; and half a pixel of both.
    std::vector<Grid<float>> coverage(2, Grid<float>(5, 1));
    coverage[0].values = {0, 1, 0, 1, 0.5f};
    coverage[1].values = {0, 0, 1, 1, 0.5f};
    std::vector<Pen> pens{{.name = "Yellow", .colour = {1, 1, 0}}, {.name = "Cyan", .colour = {0, 1, 1}}};
    const Grid<glm::u8vec3> through = ink_on_paper(coverage, pens, kWhite);
    CHECK(through.at(0, 0) == glm::u8vec3(255));
    CHECK(through.at(1, 0) == glm::u8vec3(255, 255, 0));
    CHECK(through.at(2, 0) == glm::u8vec3(0, 255, 255));
    CHECK(through.at(3, 0) == glm::u8vec3(0, 255, 0));
    // Half of red's light and half of blue's: 188, as above.
    CHECK(through.at(4, 0) == glm::u8vec3(188, 255, 188));
    // The paper's colour is seen through ink too: half of its light in red, all in green, none in blue.
    const Grid<glm::u8vec3> on_tint = ink_on_paper(coverage, pens, glm::vec3(188, 255, 255) / 255.0f);
    CHECK(on_tint.at(1, 0) == glm::u8vec3(188, 255, 0));
    for (Pen& pen : pens) pen.ink = PenInk::opaque;
    const Grid<glm::u8vec3> hiding = ink_on_paper(coverage, pens, kBlack);
    CHECK(hiding.at(1, 0) == glm::u8vec3(255, 255, 0));
    CHECK(hiding.at(3, 0) == glm::u8vec3(0, 255, 255));
}

TEST_CASE(
    "a page of more pixels than PNG can have, or than minutes can draw, is refused with what would do") {
    const PageSize banner{.width_mm = 25'400, .height_mm = 10, .mm_per_page_unit = 25'400},
        sheet{.width_mm = 200, .height_mm = 150, .mm_per_page_unit = 200};
    CHECK(raster_size(banner, 300).width == 300'000);
    CHECK(raster_size(sheet, 5000).width == 39'370);
    const auto advice = [](const PageSize& page, double dpi, const std::string& size) {
        std::string sentence;
        try {
            raster_size(page, dpi);
        } catch (const std::runtime_error& error) {
            sentence = error.what();
        }
        CAPTURE(sentence);
        CHECK(sentence.find(size) != std::string::npos);
        double advised = 0;
        const std::size_t at = sentence.find("choose ");
        REQUIRE(at != std::string::npos);
        CHECK(std::sscanf(sentence.c_str() + at, "choose %lf dots to the inch", &advised) == 1);
        return advised;
    };
    CHECK(raster_size(banner, advice(banner, 3000, "3000000 x 1181 pixels")).width > 900'000);
    const RasterSize largest = raster_size(sheet, advice(sheet, 100'000, "787402 x 590551 pixels"));
    CHECK(double(largest.width) * largest.height > 3.5e9);
    CHECK(raster_size({.width_mm = 1e-5, .height_mm = 1e-5, .mm_per_page_unit = 1e-5}, 1).height == 1);
}
