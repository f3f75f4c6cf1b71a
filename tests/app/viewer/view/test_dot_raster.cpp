// Dots as the processor draws them on screen: how much of each pixel is ink.

#include "app/viewer/view/dot_raster.h"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>
#include <span>
#include <vector>

namespace dapple {
namespace {

/// Whether a sample is ink.
bool is_ink(SampledPixels& pixels, int column, int row) {
    constexpr int kSide = SampledPixels::kSide;
    return pixels.row_of_pixels(row / kSide)[column / kSide] >> (row % kSide * kSide + column % kSide) & 1;
}

/// The mean coverage, 0..1, of a page of 40 x 40 pixels that is the whole view.
double mean_coverage(const Dots& dots, double radius, Fineness fineness) {
    const RasterView view{.size = {40, 40}, .pixels_per_unit = 40, .page = {{0, 0}, {40, 40}}};
    DotRaster raster;
    raster.begin(view, raster_grain(view, fineness, radius));
    raster.add(std::vector{RasterDots{.piece = &dots, .count = dots.size(), .high = 1}}, {.radius = radius});
    std::vector<Grid<std::uint8_t>> pictures;
    raster.finish(pictures);
    double sum = 0;
    for (const std::uint8_t byte : pictures.at(0).values) sum += byte / 255.0;
    return sum / static_cast<double>(pictures.at(0).values.size());
}

}  // namespace

TEST_CASE("a stamped disc has the samples of that disc, but for a sixty-fourth or an eighth of a pixel") {
    std::mt19937 random(1);
    for (const double radius : {1.0, 1.7, 3.2, 6.0, 13.0, 33.3, 80.0}) {
        CAPTURE(radius);
        const DiscStamps stamps(radius);
        const double apart = radius < 6 ? 0.5 : 2;  // samples
        SampledPixels pixels(30, 30);
        // Its middle anywhere, also near the edges and beyond them; limits as stretches and pages have them.
        std::uniform_real_distribution<double> place(-radius, 240 + radius);
        for (const SampleWindow limits :
             {SampleWindow{}, SampleWindow{.first_row = 64, .end_row = 128},
              SampleWindow{.first_row = 13, .end_row = 203, .first_column = 5, .end_column = 190}}) {
            for (int i = 0; i < 40; ++i) {
                const glm::dvec2 middle(place(random), place(random));
                for (int y = 0; y < 30; ++y) pixels.clear_row(y);
                stamps.add(pixels, middle.x, middle.y, limits);
                int wrong = 0;
                for (int row = 0; row < 240; ++row)
                    for (int column = 0; column < 240; ++column) {
                        const bool within = row >= limits.first_row && row < limits.end_row &&
                                            column >= limits.first_column && column < limits.end_column;
                        const double far = glm::distance(middle, glm::dvec2(column + 0.5, row + 0.5));
                        const bool ink = is_ink(pixels, column, row);
                        wrong += ink && (!within || far > radius + apart);
                        wrong += !ink && within && far < radius - apart;
                    }
                CHECK(wrong == 0);
            }
        }
    }
}

TEST_CASE("on their average stamps are as large as their disc") {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(100, 140);
    for (const double radius : {1.0, 1.3, 2.0, 3.7, 5.0, 8.1, 20.0, 40.0, 79.0}) {
        CAPTURE(radius);
        const DiscStamps stamps(radius);
        constexpr int kTries = 4000;
        double sum = 0;
        SampledPixels pixels(30, 30);
        std::vector<std::uint16_t> counts(30);
        for (int i = 0; i < kTries; ++i) {
            for (int y = 0; y < 30; ++y) pixels.clear_row(y);
            stamps.add(pixels, place(random), place(random), {});
            for (int y = 0; y < 30; ++y) {
                pixels.count(y, counts);
                for (const std::uint16_t count : counts) sum += count;
            }
        }
        CHECK(sum / kTries == doctest::Approx(std::numbers::pi * radius * radius).epsilon(0.01));
    }
}

TEST_CASE("a pixel has as many samples as were set in it") {
    SampledPixels pixels(3, 1);
    pixels.add_span(0, 0, 23);
    pixels.add_span(3, 5, 9);
    pixels.add_span(7, 8, 8);
    std::vector<std::uint16_t> counts(3);
    pixels.count(0, counts);
    CHECK(counts == std::vector<std::uint16_t>{8 + 3, 8 + 2 + 1, 8});
    for (int row = 0; row < 8; ++row) pixels.add_span(row, 0, 23);
    pixels.count(0, counts);
    CHECK(counts == std::vector<std::uint16_t>(3, 64));
}

TEST_CASE("dots however small cover what they have to: scattered at random, all but exp(-their area)") {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> place(0, 1);
    for (const std::size_t count : {4'000u, 400'000u}) {
        Dots dots;
        for (std::size_t i = 0; i < count; ++i) {
            dots.x.push_back(place(random));
            dots.y.push_back(place(random));
        }
        for (const double load : {0.3, 1.0, 2.0}) {
            const double radius = std::sqrt(load / (std::numbers::pi * static_cast<double>(count)));
            // What lies beyond the page's edges is less than a hundredth of 2 radii.
            const double expected = 1 - std::exp(-load);
            CAPTURE(count);
            CAPTURE(load);
            // So much is chance where there are few.
            const double chance = count > 10'000 ? 0.002 : 0.015;
            CHECK(std::abs(mean_coverage(dots, radius, Fineness::full) - expected) < chance);
            CHECK(std::abs(mean_coverage(dots, radius, Fineness::quick) - expected) < chance);
        }
    }
}

TEST_CASE(
    "drawn at once and in steps it is the same: dots and lines, of several pens, on a page cut off "
    "anywhere") {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(0, 1);
    std::vector<Dots> pieces(3);
    for (std::size_t i = 0; i < 3000; ++i) {
        Dots& piece = pieces[i % 3];
        piece.pen = static_cast<int>(i % 3);
        piece.x.push_back(place(random));
        piece.y.push_back(place(random));
    }
    const std::vector<glm::vec4> lines{{0.1f, 0.1f, 0.9f, 0.7f}, {0.2f, 0.9f, 0.2f, 0.9f}};
    const std::vector<float> widths{0.01f, 0.03f};
    const std::vector<std::uint8_t> pens{1, 2};
    for (const RasterGrain grain :
         {RasterGrain{Fineness::quick, 1}, {Fineness::quick, 3}, {Fineness::full, 2}}) {
        const RasterView view{.size = {301, 211},
                              .origin = {2.3, 5.6},
                              .pixels_per_unit = 200,
                              .page = {{3.4, 7.1}, {280.9, 199.3}},
                              .pens = 3};
        const RasterLook look{.radius = 0.007, .hidden = 0};
        RasterInk ink{.lines = {{.lines = lines, .widths = widths, .pens = pens}}};
        for (const Dots& piece : pieces)
            ink.dots.push_back({.piece = &piece, .count = piece.size(), .high = 1});
        DotRaster raster;
        std::vector<Grid<glm::u8vec4>> in_steps, at_once;
        raster.begin(view, grain);
        for (const RasterDots& dots : ink.dots) raster.add(std::span(&dots, 1), look);
        raster.add(ink.lines[0], look);
        raster.finish(in_steps);
        const double share = raster.draw(view, grain, ink, look, at_once);
        CHECK(share > 0);
        CHECK(share < 1);
        REQUIRE(at_once.size() == 1);
        CHECK(at_once[0].values == in_steps.at(0).values);
        // What lies beyond the page stays bare.
        CHECK(at_once[0].at(1, 100) == glm::u8vec4(0));
        CHECK(at_once[0].at(290, 100) == glm::u8vec4(0));
        CHECK(at_once[0].at(100, 205) == glm::u8vec4(0));
    }
}

TEST_CASE("the smaller the dots, the finer the samples, as far as there is time") {
    const RasterView view{.size = {400, 300}, .pixels_per_unit = 400, .page = {{0, 0}, {400, 300}}};
    CHECK(raster_grain(view, Fineness::full, 0.01) == RasterGrain{Fineness::full, 1});
    CHECK(raster_grain(view, Fineness::quick, 0.01) == RasterGrain{Fineness::quick, 1});
    CHECK(raster_grain(view, Fineness::full, 0.0004).parts == 2);
    CHECK(raster_grain(view, Fineness::full, 1e-9).parts == 2);
    const RasterView small{.size = {100, 75}, .pixels_per_unit = 100, .page = {{0, 0}, {100, 75}}};
    CHECK(raster_grain(small, Fineness::full, 0.0004).parts == 7);
    CHECK(raster_grain(small, Fineness::full, 1e-9).parts == 11);
    // Too much for the memory.
    const RasterView large{.size = {8000, 8000}, .pixels_per_unit = 8000};
    CHECK(raster_grain(large, Fineness::full, 0.01).fineness == Fineness::quick);
}

}  // namespace dapple
