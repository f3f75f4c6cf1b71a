// Masks and the brush that paints them, against their formulas and against pictures turned by hand.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/drawing/pipeline.h"
#include "core/image/mask.h"
#include "core/image/tone.h"

using namespace dapple;

namespace {

Mask half_and_half(int width, int height, std::uint8_t left, std::uint8_t right) {
    Grid<std::uint8_t> levels(width, height, right);
    for (int y = 0; y < height; ++y) std::fill_n(levels.row(y), width / 2, left);
    return Mask(std::move(levels));
}

BrushStroke dab_at(glm::dvec2 place, const Brush& brush, const Mask& mask = {}) {
    BrushStroke stroke(mask, {200, 100}, brush);
    stroke.go_to(place);
    return stroke;
}

}  // namespace

TEST_CASE("a mask's levels multiply the density as its table says, and black stays black") {
    CHECK(mask_factor(0) == 0);
    CHECK(mask_factor(64) == 0.5f);
    CHECK(mask_factor(128) == 1);
    CHECK(mask_factor(191.5f) == doctest::Approx(2));
    CHECK(mask_factor(255) == doctest::Approx(4));
    const glm::ivec2 size{80, 20};
    const Grid<float> grey(size.x, size.y, 0.2f), dark(size.x, size.y, 0.7f);
    const Mask mask = half_and_half(8, 2, 0, 255);
    CHECK(masked(grey, mask, whole_picture(size), size).at(20, 10) == 0);
    CHECK(masked(grey, mask, whole_picture(size), size).at(60, 10) == doctest::Approx(0.8));
    CHECK(masked(dark, mask, whole_picture(size), size).at(60, 10) == 1);
    // Half way between the centres of black and white.
    CHECK(masked(grey, mask, whole_picture(size), size).at(39, 10) <
          masked(grey, mask, whole_picture(size), size).at(40, 10));
}

TEST_CASE("a mask stays where it was painted when the picture is cropped, turned and mirrored") {
    const glm::ivec2 size{40, 24};
    Grid<float> picture(size.x, size.y);
    Grid<std::uint8_t> levels(10, 6);
    for (std::size_t i = 0; i < picture.values.size(); ++i)
        picture.values[i] = static_cast<float>(i % 97) / 200;
    for (std::size_t i = 0; i < levels.values.size(); ++i)
        levels.values[i] = static_cast<std::uint8_t>(i * 53 % 256);
    const Mask mask(levels);
    const Grid<float> whole = masked(picture, mask, whole_picture(size), size);
    for (int i = 0; i < 8; ++i) {
        const Framing framing{{{5, 2}, {33, 21}}, i / 2, i % 2 == 1};
        const Grid<float> one = masked(framed(picture, framing), mask, framing, size),
                          other = framed(whole, framing);
        double worst = 0;
        for (std::size_t k = 0; k < one.values.size(); ++k)
            worst = std::max<double>(worst, std::abs(one.values[k] - other.values[k]));
        CHECK(worst < 1e-6);
    }
}

TEST_CASE("a mirrored picture is what its rows are from right to left, after it was turned") {
    Grid<float> picture(5, 3);
    for (std::size_t i = 0; i < picture.values.size(); ++i) picture.values[i] = static_cast<float>(i);
    for (int turns = 0; turns < 4; ++turns) {
        const Grid<float> turned = framed(picture, {{{0, 0}, {5, 3}}, turns}),
                          mirrored = framed(picture, {{{0, 0}, {5, 3}}, turns, true});
        for (int y = 0; y < turned.height; ++y)
            for (int x = 0; x < turned.width; ++x)
                CHECK(mirrored.at(x, y) == turned.at(turned.width - 1 - x, y));
    }
}

TEST_CASE("middle grey is no mask at all, and a large picture becomes a mask of its mean greys") {
    CHECK(mask_of(Grid<float>(30, 20, srgb_to_linear(128 / 255.0f))).empty());
    Grid<float> stripes(4 * kMostMaskSide, 8);
    for (int y = 0; y < stripes.height; ++y)
        for (int x = 0; x < stripes.width; ++x) stripes.at(x, y) = x % 4 == 0 ? 1.0f : 0.0f;
    const Mask mask = mask_of(stripes);
    CHECK(mask.levels().width == kMostMaskSide);
    CHECK(mask.levels().height == 2);
    CHECK(std::ranges::all_of(mask.levels().values, [](std::uint8_t level) { return level == 64; }));
}

TEST_CASE("a dab is as dense as its formula says at every pixel") {
    const Brush brush{.kind = BrushKind::none, .radius = 0.1, .softness = 0.4, .strength = 0.5};
    const glm::dvec2 place(0.3, 0.2);
    const Mask mask = dab_at(place, brush).mask();
    int touched = 0;
    for (int y = 0; y < 100; ++y) {
        for (int x = 0; x < 200; ++x) {
            const double radii = glm::length(glm::dvec2(x + 0.5, y + 0.5) / 200.0 - place) / 0.1;
            const double t = std::clamp((1 - radii) / 0.4, 0.0, 1.0);
            const double wanted = 128 * (1 - 0.5 * t * t * (3 - 2 * t));
            touched += mask.levels().at(x, y) != 128;
            REQUIRE(std::abs(mask.levels().at(x, y) - wanted) <= 0.501);
        }
    }
    CHECK(touched > 800);  // of 1257 pixels within the rim
}

TEST_CASE("a stroke over itself is one stroke, however often the mouse is asked, and erase undoes it") {
    const Brush brush{.kind = BrushKind::more, .radius = 0.05, .softness = 1, .strength = 0.3};
    BrushStroke once = dab_at({0.1, 0.25}, brush), often = dab_at({0.1, 0.25}, brush);
    once.go_to({0.9, 0.25});
    for (int i = 0; i <= 64; ++i) often.go_to({0.1 + 0.8 * i / 64.0, 0.25});
    often.go_to({0.5, 0.25});
    CHECK(once.mask() == often.mask());
    CHECK_FALSE(once.mask().empty());
    // The middle of the way, where only the straight line between the two ends can have been.
    CHECK(once.mask().levels().at(100, 50) > 150);
    BrushStroke erase(once.mask(), {200, 100}, {.kind = BrushKind::erase, .radius = 2, .softness = 0});
    erase.go_to({0.5, 0.25});
    CHECK(erase.mask().empty());
}

TEST_CASE("where dots are finer the density is as many times higher, under whatever level") {
    const Grid<float> grey(80, 20, 0.3f);
    const glm::ivec2 size(80, 20);
    Grid<std::uint8_t> levels(8, 2, 64), fineness(8, 2);
    for (int y = 0; y < 2; ++y)
        for (int x = 4; x < 8; ++x) fineness.at(x, y) = 170;
    const Grid<float> under = masked(grey, Mask(levels, fineness), whole_picture(size), size);
    CHECK(under.at(20, 10) == doctest::Approx(0.15));
    CHECK(under.at(60, 10) == doctest::Approx(0.45));
    CHECK(masked(Grid<float>(80, 20, 1.0f), Mask(levels, fineness), whole_picture(size), size).at(60, 10) ==
          doctest::Approx(1.5));
    CHECK(Mask(levels, fineness).without_finer() == Mask(levels));
    CHECK(Mask(levels, Grid<std::uint8_t>(8, 2)) == Mask(levels));
    CHECK(Mask(Grid<std::uint8_t>(8, 2, kNeutralLevel), Grid<std::uint8_t>(8, 2)).empty());
    CHECK(Mask(levels, fineness) != Mask(levels));
}

TEST_CASE("what is no number is a place on the mask too") {
    Grid<std::uint8_t> levels(3, 2, 7);
    levels.at(0, 0) = 9;
    CHECK(level_at(levels, {NAN, NAN}) == 9);
    CHECK(level_at(levels, {INFINITY, -INFINITY}) == 7);
}

TEST_CASE("the finer brush leaves the levels as they are, and the eraser takes both away") {
    const Brush wide{.kind = BrushKind::fewer, .radius = 0.4, .softness = 0};
    const Mask fewer = dab_at({0.5, 0.25}, wide).mask();
    Brush fine = wide;
    fine.kind = BrushKind::finer;
    fine.strength = 0.5;
    const Mask both = dab_at({0.5, 0.25}, fine, fewer).mask();
    CHECK(both.without_finer() == fewer);
    REQUIRE(both.has_finer());
    CHECK(both.fineness().at(100, 50) == 128);
    CHECK(both.fineness().at(2, 2) == 0);
    Brush erase = wide;
    erase.kind = BrushKind::erase;
    CHECK(dab_at({0.5, 0.25}, erase, both).mask().empty());
    // One that paints levels keeps what is finer.
    CHECK(dab_at({0.5, 0.25}, wide, both).mask().has_finer());
}

TEST_CASE("a picture as a mask's fineness has the mask's shape, and black is none") {
    Grid<std::uint8_t> levels(8, 2, 64);
    Grid<float> light(4, 4);
    light.at(3, 0) = light.at(3, 1) = 1;
    const Mask mask = with_fineness(Mask(levels), light);
    REQUIRE(mask.has_finer());
    CHECK(mask.levels().values == levels.values);
    CHECK(mask.fineness().at(7, 0) == 255);
    CHECK(mask.fineness().at(5, 0) == 0);
    CHECK(with_fineness({}, light).fineness().at(3, 0) == 255);
    CHECK(with_fineness(Mask(levels), Grid<float>(4, 4)) == Mask(levels));
}

TEST_CASE("no dots are placed under black, all asked for lie elsewhere, and the mask gone all is as before") {
    Pipeline pipeline;
    pipeline.set_tile(RankedTile(make_tile(14217, 2895, 16), RankingMethod::energy));
    pipeline.set_light(Grid<float>(64, 64, 0.5f));
    DrawingSettings request{.placing = {.count = 2000}, .relax = 0};
    const auto dots_of = [&] {
        Stippling drawn;
        REQUIRE(pipeline.draw(pipeline.plan(request), drawn));
        Dots all;
        for (const Dots& piece : drawn.dots.pieces) {
            all.x.insert(all.x.end(), piece.x.begin(), piece.x.end());
            all.y.insert(all.y.end(), piece.y.begin(), piece.y.end());
        }
        return all;
    };
    const Dots before = dots_of();
    CHECK(std::ranges::count_if(before.x, [](float x) { return x < 0.5f; }) > 900);
    request.mask = half_and_half(64, 64, 0, 128);
    const Dots under = dots_of();
    CHECK(under.x.size() == 2000);
    CHECK(*std::ranges::min_element(under.x) > 31.0f / 64);
    request.mask = {};
    CHECK(dots_of().x == before.x);
}
