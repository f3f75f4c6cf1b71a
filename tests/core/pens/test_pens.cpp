// Sets of pens, their separation, and the dots that they share.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <memory>
#include <numbers>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "core/analysis/distances.h"
#include "core/analysis/periodogram.h"
#include "core/drawing/pen_plan.h"
#include "core/image/colour.h"
#include "core/pens/pen_dots.h"
#include "core/placing/stipple.h"
#include "core/relaxing/relax.h"
#include "core/tile/ranking.h"

using namespace dapple;

namespace {

// Density 1/2 all over the square, shared out in fixed proportions.
PenDensities constant_densities(const std::vector<float>& shares) {
    PenDensities densities{std::make_shared<const Density>(Grid<float>(32, 32, 0.5f)), {}};
    for (const float share : shares)
        densities.each.push_back(std::make_shared<const Density>(Grid<float>(32, 32, 0.5f * share)));
    return densities;
}

Stippling relaxed_dots(const Density& density, std::uint64_t count, int steps = 5) {
    RankedTile tile(make_tile(14217, 2895, 16), RankingMethod::energy);
    Stippling result;
    REQUIRE(stipple(tile, density, PlacerKind::exact, {.count = count}, result));
    REQUIRE(relax(result.dots, density, steps, {.scale = result.scale}));
    return result;
}

std::vector<glm::dvec2> places_of(const DotPieces& dots) {
    std::vector<glm::dvec2> places;
    for_each_position(dots, [&](float x, float y) { places.emplace_back(x, y); });
    return places;
}

}  // namespace

TEST_CASE("a pen's text reads back the same, and what is no pen is told so") {
    for (const char* text :
         {"one", "greys", "cmyk", "cmyk:0.3", "auto:5", "auto:3:0.5", "Sky:#3aa0d8:0.3,Dark ochre:#805010",
          "Sky:#3aa0d8:0.3:0.6,Ink:#101010", "cmyk:0.3+0.04", "cmyk:black=0.8", "cmyk:0.3+0.04:black=0",
          "greys:0.5+0.1", "auto:3:0.5+0.05", "Sky:#3aa0d8:0.3+0.05:0.6,Ink:#101010:0.2+0.02",
          "auto:1:Sky:#3aa0d8:0.3,Ink:#101010"})
        CHECK(text_of(parse_pens(text)) == text);
    CHECK(parse_pens("cmyk:0.3+0").gain_mm == 0);
    CHECK(parse_pens("Sky:#3aa0d8:0.3mm + 0.002in").own[0].gain_mm == doctest::Approx(0.0508));
    CHECK(parse_pens("cmyk:0.5in").width_mm == doctest::Approx(12.7));
    CHECK(parse_pen_list("# mine\n\nSky:#3aa0d8:0.3\n Ochre : #805010\n") ==
          parse_pens("Sky:#3aa0d8:0.3,Ochre:#805010"));
    for (const char* text : {"",
                             "rgb",
                             "cmyk:0",
                             "cmyk:1:2",
                             "auto:0",
                             "auto:13",
                             "auto:x",
                             "auto:2:Sky:#3aa0d8:0.3,Ink:#101010",
                             "auto:1:0.3:Sky:#3aa0d8,Ink:#101010",
                             "auto:#3aa0d8",
                             "one:0.3",
                             "Sky:#3aa0d8:thin",
                             "Sky:blue",
                             "<b>:#123456",
                             "A:#111,A:#222",
                             "A:#111:1:2:3",
                             "A:#111:1:0",
                             "A:#111:1:far",
                             "A:#111:1+",
                             "A:#111:1+wet",
                             "A:#111:1+-0.1",
                             "A:#111:1+11",
                             "A:#111:+1",
                             "cmyk:0.3:0.1",
                             "cmyk:0.3+0.1+0.1",
                             "cmyk:black=2",
                             "cmyk:black=",
                             "greys:black=1",
                             "cmyk:black=1:0.3"}) {
        CAPTURE(text);
        CHECK_THROWS_AS(parse_pens(text), std::runtime_error);
    }
    Palette pens = palette_of(parse_pens("cmyk"));
    sort_pens(pens, PenOrder::lightest);
    CHECK(pens.front().name == "Yellow");
    CHECK(pens.back().name == "Black");
    sort_pens(pens, PenOrder::darkest);
    CHECK(pens.front().name == "Black");
    CHECK(pens.back().name == "Yellow");
    Palette own = parse_pens("Blue:#0000ff,White:#ffffff,Black:#000000,Snow:#ffffff").own;
    const Palette as_listed = own;
    sort_pens(own, PenOrder::listed);
    CHECK(own == as_listed);
    sort_pens(own, PenOrder::darkest);
    CHECK(own.front().name == "Black");
    CHECK(own[2].name == "White");  // of equally light ones, as they were
    CHECK(own[3].name == "Snow");
}

TEST_CASE("one pen's share of paper is what the linear light asks for") {
    const Pen black{.name = "Black"};
    const PenMixer mixer(std::span(&black, 1), kWhite);
    for (const float light : {0.0f, 0.2f, 0.5f, 1.0f})
        CHECK(mixer.solve(glm::vec3(light))[0] == doctest::Approx(1 - light).epsilon(0.02));
}

TEST_CASE("what a mixture of pens looks like is separated into shares that look the same") {
    const Palette pens = palette_of(parse_pens("cmyk"));
    const glm::vec3 paper = parse_colour("#f1ead8");
    const PenMixer mixer(pens, paper);
    std::mt19937 random(1);
    for (int k = 0; k < 200; ++k) {
        Shares shares{};
        float sum = 0.2f;  // of bare paper
        for (std::size_t pen = 0; pen < pens.size(); ++pen)
            sum += shares[pen] = static_cast<float>(random() % 1000) / 1000.0f;
        glm::vec3 light = linear_of(paper) * (0.2f / sum);
        for (std::size_t pen = 0; pen < pens.size(); ++pen)
            light += linear_of(paper) * linear_of(pens[pen].colour) * (shares[pen] / sum);
        const Shares found = mixer.solve(light);
        CHECK(*std::ranges::min_element(found) >= 0);
        CHECK(std::accumulate(found.begin(), found.end(), 0.0f) <= 1.0f + 1e-5f);
        CHECK(glm::length(mixer.seen(found) - light) < 0.01f);
    }
    // Between the lattice's colours too.
    const Separation separation(pens, paper);
    for (int k = 0; k < 200; ++k) {
        const glm::vec3 colour =
            glm::vec3(float(random() % 1000), float(random() % 1000), float(random() % 1000)) / 1000.0f;
        const glm::vec3 exact = mixer.seen(mixer.solve(separation.aim(colour)));
        CHECK(glm::length(mixer.seen(separation.shares(colour)) - exact) < 0.02f);
    }
}

TEST_CASE("of a grey that black and the paper make, other pens draw nothing, and of their own colour all") {
    // The paper's tint is no colour of the picture's.
    for (const char* paper : {"#ffffff", "#f1ead8"})
        for (const char* other : {"#c1121f", "#9fb4c8"}) {
            CAPTURE(std::string(other));
            const Palette pens = parse_pens(fmt::format("Black:#000000,Other:{}", other)).own;
            const Separation separation(pens, parse_colour(paper));
            for (const float light : {0.0f, 0.05f, 0.2f, 0.5f, 0.8f, 1.0f}) {
                const Shares shares = separation.shares(glm::vec3(light));
                CHECK(shares[0] == doctest::Approx(1 - light).epsilon(0.002));
                CHECK(shares[1] == 0);
            }
            const glm::vec3 mixed =
                linear_of(parse_colour(paper)) * (0.2f + 0.7f * linear_of(pens[1].colour));
            const Shares shares = separation.mixer().solve(mixed);
            CHECK(shares[0] == doctest::Approx(0.1f).epsilon(0.01));
            CHECK(shares[1] == doctest::Approx(0.7f).epsilon(0.002));
        }
}

TEST_CASE("a pen draws no few dots among many of others, who make up for it") {
    std::mt19937 random(5);
    for (const char* set : {"cmyk", "Red:#c1121f,Blue black:#101828",
                            "Yellow:#ffed00,Blue:#004e9f,Red:#e2001a,Green:#008d36,Black:#1d1d1b"}) {
        CAPTURE(std::string(set));
        const PenChoice choice = parse_pens(set);
        const Palette pens = palette_of(choice);
        const Separation separation(pens, kWhite);
        const auto light = [&random] {
            const float root = float(random() % 33) / 32;  // as the lattice's colours have it
            return root * root;
        };
        for (int k = 0; k < 500; ++k) {
            const glm::vec3 colour =
                k < 33 ? glm::vec3(float(k * k) / 1024) : glm::vec3(light(), light(), light());
            const Shares shares = separation.shares(colour);
            const float all = std::accumulate(shares.begin(), shares.end(), 0.0f);
            for (const float share : shares) CHECK((share < 1e-5f || share > 0.0249f * all));
            const PenMixer& mixer = separation.mixer();
            const glm::vec3 nearest = mixer.seen(mixer.solve(separation.aim(colour)));
            CHECK(std::abs(oklab_of(mixer.seen(shares)).x - oklab_of(nearest).x) < 0.03f);
            CHECK(glm::distance(oklab_of(mixer.seen(shares)), oklab_of(nearest)) < 0.05f);
        }
    }
}

TEST_CASE("black draws as little of greys or as much as it is told to, and every colour stays as it was") {
    Palette pens = palette_of(parse_pens("cmyk"));
    sort_pens(pens, PenOrder::lightest);
    const glm::vec3 paper = parse_colour("#f1ead8");
    const Separation usual(pens, paper), least(pens, paper, 0), less(pens, paper, 0.25), most(pens, paper, 1);
    std::mt19937 random(3);
    for (int k = 0; k < 300; ++k) {
        const glm::vec3 colour =
            glm::vec3(float(random() % 1000), float(random() % 1000), float(random() % 1000)) / 1000.0f;
        const glm::vec3 seen = usual.mixer().seen(usual.shares(colour));
        for (const Separation* other : {&least, &less, &most}) {
            const Shares shares = other->shares(colour);
            CHECK(*std::ranges::min_element(shares) >= 0);
            CHECK(std::accumulate(shares.begin(), shares.end(), 0.0f) <= 1.0f + 1e-4f);
            CHECK(glm::length(other->mixer().seen(shares) - seen) < 1e-3f);
        }
        CHECK(least.shares(colour)[3] <= less.shares(colour)[3] + 1e-5f);
        CHECK(less.shares(colour)[3] <= usual.shares(colour)[3] + 1e-5f);
        CHECK(usual.shares(colour)[3] <= most.shares(colour)[3] + 1e-5f);
    }
    // A middle grey: nearly all of it black ink, or nearly none.
    const glm::vec3 grey(0.35f);
    const Shares black = most.shares(grey), coloured = least.shares(grey);
    CHECK(black[0] + black[1] + black[2] < 0.12f);
    CHECK(coloured[3] < black[3] - 0.25f);
}

TEST_CASE("a colour that no mixture reaches gets paler, and keeps its hue and lightness") {
    const PenMixer mixer(palette_of(parse_pens("cmyk")), kWhite);
    for (const glm::vec3 aim :
         {glm::vec3(0.4f, 0.06f, 0.02f), glm::vec3(0.05f, 0.3f, 0.03f), glm::vec3(0.03f, 0.05f, 0.3f)}) {
        const glm::vec3 seen = mixer.seen(mixer.solve(aim));
        CHECK(luminance(seen) == doctest::Approx(luminance(aim)).epsilon(0.05));
        const glm::vec3 asked = oklab_of(aim), got = oklab_of(seen);
        const float turned = std::remainder(std::atan2(got.z, got.y) - std::atan2(asked.z, asked.y),
                                            2 * std::numbers::pi_v<float>);
        CHECK(std::abs(turned) < 0.35f);
        CHECK(std::hypot(got.y, got.z) < std::hypot(asked.y, asked.z));
    }
}

TEST_CASE("of the pens of a picture in two colours the two are chosen") {
    const std::vector<glm::vec3> colours{linear_of(common_pens()[9].colour),
                                         linear_of(common_pens()[15].colour)};
    Palette chosen = best_pens(colours, common_pens(), 2, kWhite);
    std::ranges::sort(chosen, {}, &Pen::name);
    CHECK(chosen[0].name == "Blue");
    CHECK(chosen[1].name == "Red");
}

TEST_CASE(
    "automatic pens are chosen from one's own, with their widths, where there are more than are wanted") {
    const auto chosen = [](const PenChoice& choice) {
        std::string names;
        ColourGrid red_and_blue(2, 1);
        red_and_blue.values = {packed(linear_of(common_pens()[9].colour)),
                               packed(linear_of(common_pens()[15].colour))};
        for (const Pen& pen : pens_for(choice, red_and_blue, 0, kWhite))
            names += fmt::format("{} {:g} ", pen.name, pen.width_mm);
        return names;
    };
    PenChoice choice =
        parse_pens("auto:2:Leaf:#95c11f:0.2,Navy:#0000d0:0.3,Sun:#ffed00:0.4,Rose:#d00000:0.5:0.9");
    choice.order = PenOrder::darkest;
    choice.width_mm = 1;  // as a window's row still has it
    CHECK(chosen(choice) == "Navy 0.3 Rose 0.5 ");
    choice.own.resize(2);  // leaves nothing to choose
    CHECK(chosen(choice) == "Blue 1 Red 1 ");
}

TEST_CASE("automatic pens of a grey picture are greys, if there are any") {
    ColourGrid ramp(100, 10);
    for (int y = 0; y < ramp.height; ++y)
        for (int x = 0; x < ramp.width; ++x) ramp.at(x, y) = packed(glm::vec3(float(x * x) / 9801));
    const auto chosen = [&](const char* pens) { return pens_for(parse_pens(pens), ramp, 0, kWhite); };
    for (const char* pens : {"auto:1", "auto:2", "auto:4", "auto:2:Red:#e2001a,Ink:#1d1d1b,Sky:#009ee3"})
        CHECK(!has_colour(chosen(pens)));
    CHECK(chosen("auto:4").size() == 4);
    CHECK(chosen("auto:1:Red:#e2001a,Sky:#009ee3").size() == 1);
    std::fill_n(ramp.values.begin(), 100, packed(linear_of(parse_colour("#e2001a"))));
    CHECK(has_colour(chosen("auto:2")));
}

TEST_CASE("pens that the paper would swallow are opaque, and others as they are asked to be") {
    const auto ink_of = [](const char* pens, const char* paper, PenInk asked = PenInk::transparent) {
        PenChoice choice = parse_pens(pens);
        choice.ink = asked;
        const Palette made = pens_for(choice, {}, 0, parse_colour(paper));
        for (const Pen& pen : made) CHECK(pen.ink == made.front().ink);
        return made.front().ink;
    };
    CHECK(ink_of("White:#ffffff,Black:#000000", "#b08d57") == PenInk::opaque);
    CHECK(ink_of("Gold:#d4a017,Red:#c1121f", "#111111") == PenInk::opaque);
    for (const char* paper : {"#ffffff", "#f1ead8"}) {
        CHECK(ink_of("cmyk", paper) == PenInk::transparent);
        CHECK(ink_of("cmyk", paper, PenInk::opaque) == PenInk::opaque);
    }
}

TEST_CASE("pens share dots in their proportions, all of them even and each pen's own too") {
    const std::vector<float> shares{0.5f, 0.3f, 0.2f};
    const PenDensities densities = constant_densities(shares);
    const Stippling from = relaxed_dots(*densities.all, 6000);
    const DotPieces dots = pen_dots(from.dots, densities, {.scale = from.scale});
    REQUIRE(dots.pieces.size() == 3);
    const Domain page{1, 1, Topology::window};
    for (std::size_t pen = 0; pen < 3; ++pen) {
        CHECK(dots.pieces[pen].pen == static_cast<int>(pen));
        CHECK(std::abs(static_cast<double>(dots.pieces[pen].size()) - 6000.0 * shares[pen]) <= 2);
        DotPieces own;
        own.pieces.push_back(dots.pieces[pen]);
        const NearestSummary evenness = nearest_summary(places_of(own), page);
        CHECK(evenness.p1 > 0.5);
        CHECK(evenness.mean > 0.74);
    }
    const NearestSummary all = nearest_summary(places_of(dots), page);
    CHECK(all.p1 > 0.65);
    CHECK(all.mean > 0.83);

    const DotPieces on_three = pen_dots(from.dots, densities, {.scale = from.scale, .threads = 3});
    CHECK(places_of(on_three) == places_of(dots));
    // Left where they are they are the same dots.
    const DotPieces still = pen_dots(from.dots, densities, {.scale = from.scale, .move = false});
    const auto sorted = [](std::vector<glm::dvec2> places) {
        std::ranges::sort(
            places, [](glm::dvec2 a, glm::dvec2 b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); });
        return places;
    };
    CHECK(sorted(places_of(still)) == sorted(places_of(from.dots)));
}

TEST_CASE("where dots come closer in long waves, neither all of them nor any pen's own are left so") {
    const PenDensities densities = constant_densities({0.5f, 0.3f, 0.2f});
    Stippling from = relaxed_dots(*densities.all, 6000, 0);
    constexpr float kPi = std::numbers::pi_v<float>;
    for (Dots& piece : from.dots.pieces)
        for (std::size_t i = 0; i < piece.size(); ++i)
            piece.x[i] += 0.01f * std::sin(6 * kPi * piece.x[i]) * std::cos(7 * kPi * piece.y[i]);
    const auto long_waves = [](const DotPieces& dots) {
        const double of_five = 5 / std::sqrt(double(dots.size()));
        return low_frequency_power(periodogram(places_of(dots), {1, 1, Topology::window}), of_five);
    };
    const DotPieces dots = pen_dots(from.dots, densities, {.scale = from.scale});
    double own = 0;
    for (const Dots& piece : dots.pieces) own += long_waves(in_one_piece(piece)) / 3;
    // 0.0286 if pens are not warped, 0.0227 if all dots are not in the end.
    CHECK(own < 0.018);
    CHECK(long_waves(dots) < 0.005);
}

TEST_CASE("a pen has no dots where it has no share") {
    // Left half the first pen's, right half the second's.
    Grid<float> left(32, 32), right(32, 32);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) (x < 16 ? left : right).at(x, y) = 0.5f;
    PenDensities densities{std::make_shared<const Density>(Grid<float>(32, 32, 0.5f)), {}};
    densities.each = {std::make_shared<const Density>(std::move(left)),
                      std::make_shared<const Density>(std::move(right))};
    const Stippling from = relaxed_dots(*densities.all, 2000);
    const DotPieces dots = pen_dots(from.dots, densities, {.scale = from.scale, .move = false});
    // Over the pixel between the two, both have a share.
    for (const float x : dots.pieces[0].x) CHECK(x < 16.5f / 32);
    for (const float x : dots.pieces[1].x) CHECK(x >= 15.5f / 32);
}

TEST_CASE("large dots and small ones cover as much paper as dots of one size") {
    // As much area of both: of the dots a fifth is twice as wide.
    const PenDensities densities = constant_densities({0.2f, 0.8f});
    const Stippling from = relaxed_dots(*densities.all, 4000);
    const auto covered = [&](const std::vector<double>& areas) {
        const DotPieces dots = pen_dots(from.dots, densities, {.scale = from.scale, .areas = areas});
        const DotPieces on_three =
            pen_dots(from.dots, densities, {.scale = from.scale, .areas = areas, .threads = 3});
        CHECK(places_of(on_three) == places_of(dots));
        constexpr int kSide = 600, kEdge = 60;
        constexpr double kLoad = 0.9;
        Grid<std::uint8_t> paper(kSide, kSide);
        for (const Dots& piece : dots.pieces) {
            CHECK(piece.radius.empty());
            const double share =
                areas.empty() ? densities.each[std::size_t(piece.pen)]->at({0.5, 0.5}) / 0.5 : 0.5;
            const double radius = std::sqrt(share * kLoad / (double(piece.size()) * std::numbers::pi));
            for (std::size_t i = 0; i < piece.size(); ++i)
                for (int y = std::max(0, int((piece.y[i] - radius) * kSide));
                     y <= std::min(kSide - 1, int((piece.y[i] + radius) * kSide)); ++y)
                    for (int x = std::max(0, int((piece.x[i] - radius) * kSide));
                         x <= std::min(kSide - 1, int((piece.x[i] + radius) * kSide)); ++x)
                        if (std::hypot((x + 0.5) / kSide - piece.x[i], (y + 0.5) / kSide - piece.y[i]) <
                            radius)
                            paper.at(x, y) = 1;
        }
        double sum = 0;
        for (int y = kEdge; y < kSide - kEdge; ++y)
            sum += std::accumulate(paper.row(y) + kEdge, paper.row(y) + kSide - kEdge, 0.0);
        return sum / std::pow(kSide - 2 * kEdge, 2);
    };
    const double of_one_size = covered({}), of_two = covered({1, 0.25});
    CHECK(of_one_size == doctest::Approx(0.847).epsilon(0.01));
    CHECK(of_two == doctest::Approx(of_one_size).epsilon(0.015));
}
