// The page of a drawing: papers, margins, and the part of the picture that comes onto it.

#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/drawing/page_setup.h"

namespace dapple {
namespace {

PageSetup on_paper(const char* name, Margins margins = {}) {
    PageSetup setup{.margins = margins};
    read_paper(name, setup);
    return setup;
}

std::string why_not(const auto& what) {
    try {
        what();
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE(
    "a paper of the A and B series is half of the one before, and its sides are as 1 to the root of 2") {
    for (const auto& [first, last] : {std::pair(Paper::a0, Paper::a6), std::pair(Paper::b0, Paper::b6)}) {
        for (int i = static_cast<int>(first); i <= static_cast<int>(last); ++i) {
            const glm::dvec2 size = paper_size(static_cast<Paper>(i));
            CHECK(size.y / size.x == doctest::Approx(std::sqrt(2.0)).epsilon(0.006));
            if (i == static_cast<int>(first)) continue;
            const glm::dvec2 before = paper_size(static_cast<Paper>(i - 1));
            CHECK(size.y == before.x);
            CHECK(size.x == std::floor(before.y / 2));
        }
    }
    // ISO 216: A0 is a square metre, B0 a metre wide.
    CHECK(paper_size(Paper::a0).x * paper_size(Paper::a0).y == doctest::Approx(1e6).epsilon(1e-3));
    CHECK(paper_size(Paper::b0).x == 1000);
}

TEST_CASE("papers are named in upper or lower case, and other sizes in any unit of length") {
    CHECK(on_paper("A4").paper == Paper::a4);
    CHECK(on_paper("ansi-c").paper == Paper::ansi_c);
    CHECK(on_paper("Arch D").paper == Paper::arch_d);
    for (const char* const letter : {"8.5x11in", "8.5inx11in", "21.59cmx279.4mm", "215.9x279.4"}) {
        CAPTURE(letter);
        const PageSetup setup = on_paper(letter);
        CHECK(setup.paper == Paper::custom);
        CHECK(setup.width_mm == doctest::Approx(paper_size(Paper::letter).x));
        CHECK(*setup.height_mm == doctest::Approx(paper_size(Paper::letter).y));
    }
    for (const char* const wrong :
         {"", "a7", "custom", "as the picture", "210", "x", "210x", "1x2x3", "0x10"})
        CHECK_THROWS_AS(on_paper(wrong), std::runtime_error);
}

TEST_CASE("the page lies as the picture does, unless told otherwise or its sides were given") {
    const auto width = [](PageSetup setup, glm::ivec2 picture, PageOrientation orientation) {
        setup.orientation = orientation;
        return layout_of(setup, picture).page.width_mm;
    };
    const PageSetup a4 = on_paper("a4"), own = on_paper("210x297");
    CHECK(width(a4, {300, 200}, PageOrientation::automatic) == 297);
    CHECK(width(a4, {200, 300}, PageOrientation::automatic) == 210);
    CHECK(width(a4, {300, 200}, PageOrientation::portrait) == 210);
    CHECK(width(own, {300, 200}, PageOrientation::automatic) == 210);
    CHECK(width(own, {300, 200}, PageOrientation::landscape) == 297);
}

TEST_CASE("the picture and the dots' radius around it lie in the middle of what the margins leave") {
    const PageSetup setup = on_paper("200x300", {10, 20, 30, 40});
    const DotReach of_page{.mm = 2}, of_picture{.picture_units = 0.02};
    for (const DotReach& reach : {of_page, of_picture}) {
        const PageLayout layout = layout_of(setup, {300, 200}, reach);
        CHECK(layout.within_margins == Rectangle<double>{{40, 10}, {180, 270}});
        const double radius = reach.mm + reach.picture_units * layout.page.mm_per_page_unit;
        const auto [low, high] = layout.picture;
        CHECK(low.x - radius == doctest::Approx(40));
        CHECK(high.x + radius == doctest::Approx(180));
        CHECK(low.y - 10 == doctest::Approx(270 - high.y));
        CHECK((high.x - low.x) / (high.y - low.y) == doctest::Approx(1.5));
    }
}

TEST_CASE("usual margins cut no dot of a page of the picture's shape, whose size they leave; those of 0 do") {
    const DotReach reach{.mm = 0.5, .picture_units = 0.01};
    PageSetup setup{.width_mm = 150, .margins = parse_margins("auto")};
    CHECK(keeps_dots_inside(setup));
    const PageLayout usual = layout_of(setup, {300, 200}, reach);
    CHECK(usual.page.width_mm == 150);
    CHECK(usual.page.height_mm == doctest::Approx(100));
    CHECK(usual.reach_mm == doctest::Approx(0.01 * usual.page.mm_per_page_unit));
    const auto [low, high] = usual.picture;
    CHECK(low.y == doctest::Approx(usual.reach_mm));
    CHECK(high.y == doctest::Approx(100 - usual.reach_mm));
    CHECK(low.x > usual.reach_mm);
    CHECK((high.x - low.x) / (high.y - low.y) == doctest::Approx(1.5));
    setup.margins = Margins{};
    CHECK_FALSE(keeps_dots_inside(setup));
    CHECK(layout_of(setup, {300, 200}, reach).picture == Rectangle<double>{{0, 0}, {150, 100}});
}

TEST_CASE(
    "filled, the page shows the middle of the crop, in the shape that the margins leave; the turns come "
    "last") {
    PageSetup setup = on_paper("200x300", {50, 0, 50, 0});  // leaves a square
    setup.fit = PageFit::fill;
    setup.crop = parse_crop("10%,0%,80%x100%");
    CHECK(framing_of(setup, {300, 100}) == Framing{{{100, 0}, {200, 100}}, 0});
    setup.margins.reset();
    setup.quarter_turns = 1;  // 2 by 3 on the page, so 3 by 2 of the picture
    CHECK(framing_of(setup, {300, 100}) == Framing{{{75, 0}, {225, 100}}, 1});
    CHECK(framing_of(setup, {300, 100}).size() == glm::ivec2(100, 150));
    setup.crop = parse_crop("100,50,201x40");
    CHECK(why_not([&] {
              return framing_of(setup, {300, 100});
          }) == "the part reaches to 301 x 90 pixels, and the picture is 300 x 100");
}

TEST_CASE("four quarter turns are none, and one moves the upper left pixel to the upper right") {
    Grid<float> picture(3, 2);
    for (std::size_t i = 0; i < 6; ++i) picture.values[i] = static_cast<float>(i);
    const auto turned = [](const Grid<float>& grid, int turns) {
        return framed(grid, {{{0, 0}, {grid.width, grid.height}}, turns});
    };
    // 0 1 2     3 0
    // 3 4 5     4 1
    //           5 2
    CHECK(turned(picture, 1).values == std::vector<float>{3, 0, 4, 1, 5, 2});
    Grid<float> again = picture;
    for (int turns = 1; turns <= 4; ++turns) {
        again = turned(again, 1);
        CHECK(again.values == turned(picture, turns % 4).values);
    }
    CHECK(framed(picture, {{{1, 0}, {3, 1}}, 2}).values == std::vector<float>{2, 1});
}

TEST_CASE("margins without room, and what is none, are refused with what is wrong") {
    CHECK(why_not([] {
              return layout_of(on_paper("a4", {0, 150, 0, 60}), {2, 3});
          }) == "60 mm left and 150 mm right leave no room on a page 210 mm wide");
    CHECK(why_not([] {
              return layout_of(on_paper("20x20"), {2, 3}, {.mm = 10});
          }) == "20 x 20 mm within the margins leave no room for dots of radius 10 mm");
    CHECK(text_of(*parse_margins("1cm")) == "10");
    CHECK(text_of(*parse_margins("1cm,2,1in,0")) == "10,2,25.4,0");
    for (const char* const wrong : {"", "wide", "1,2", "1,2,3,4,5", "-1", "1,2,3,inf"})
        CHECK_THROWS_AS(parse_margins(wrong), std::runtime_error);
    CHECK(parse_crop("0,0,100%x50%") == parse_crop("0%,0%,100%x50%"));  // 0 is the same in either unit
    CHECK(parse_crop("0,0,100x50").unit == Crop::Unit::pixels);
    for (const char* const wrong :
         {"10%,0%,80x100%", "0,10,80%x100%", "%,0,5x5", "1,2,3", "-1,0,5x5", "0,0,0x5", ""})
        CHECK_THROWS_AS(parse_crop(wrong), std::runtime_error);
}

}  // namespace dapple
