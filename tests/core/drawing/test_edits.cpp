// What is changed by hand: on the paper, after all else, whatever the number of dots.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "core/drawing/edits.h"
#include "core/drawing/stippler.h"
#include "core/image/tone.h"
#include "core/pens/pen.h"
#include "tests/dot_pieces.h"

using namespace dapple;

namespace {

LightPicture picture() {
    LightPicture made{.light = Grid<float>(120, 80)};
    made.colours = ColourGrid(120, 80);
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 120; ++x) {
            made.light.at(x, y) = srgb_to_linear(static_cast<float>(0.2 + 0.5 * x / 119));
            made.colours.at(x, y) = glm::u16vec3(300 * x, 20'000, 400 * y);
        }
    return made;
}

Settings with_dots(std::uint64_t count, const std::string& edits = "") {
    Settings settings;
    settings.drawing.placing = {.count = count, .threads = 0};
    settings.drawing.relax = 2;
    settings.drawing.edits = edits;
    return settings;
}

Drawing edited_drawing(const Settings& settings) {
    Stippler stippler;
    stippler.set_picture(picture());
    return *stippler.draw(settings);
}

/// A dot in millimetres on the page.
struct OnPaper {
    glm::vec2 at;
    float radius;
    int pen;
    auto order() const { return std::tuple(at.x, at.y, radius, pen); }
    bool operator==(const OnPaper& other) const { return order() == other.order(); }
    bool operator<(const OnPaper& other) const { return order() < other.order(); }
};
std::vector<OnPaper> dots_of(const Drawing& drawing) {
    std::vector<OnPaper> dots;
    drawing.for_each_piece([&](const Dots& piece) {
        for (std::size_t i = 0; i < piece.size(); ++i)
            dots.push_back({{piece.x[i], piece.y[i]}, piece.radius[i], piece.pen});
        return true;
    });
    return dots;
}

std::vector<OnPaper> without(const std::vector<OnPaper>& dots, const std::function<bool(glm::vec2)>& bare) {
    std::vector<OnPaper> left;
    std::ranges::copy_if(dots, std::back_inserter(left), [&](const OnPaper& dot) { return !bare(dot.at); });
    return left;
}

double to_segment(glm::vec2 p, glm::vec2 a, glm::vec2 b) {
    double least = 1e9;  // by brute force
    for (int i = 0; i <= 20'000; ++i)
        least = std::min(least, double(glm::distance(p, a + (b - a) * (static_cast<float>(i) / 20'000))));
    return least;
}

std::string refused(const std::string& edits) {
    try {
        static_cast<void>(parse_edits(edits));
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE(
    "what a brush or a lasso leaves bare stays bare with more dots and another tone, and no other moves") {
    const std::string brush = "bare r7 30,40 90,60;", lasso = "bare 120,20 180,30 150,110 140,60;";
    const auto in_lasso = [](glm::vec2 p) {  // in one of two triangles, of which the second is the dent
        const auto side = [&](glm::vec2 a, glm::vec2 b) {
            return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
        };
        const glm::vec2 a(120, 20), b(180, 30), c(150, 110), d(140, 60);
        const bool upper = side(a, b) > 0 && side(b, d) > 0 && side(d, a) > 0;
        return upper || (side(b, c) > 0 && side(c, d) > 0 && side(d, b) > 0);
    };
    const auto bare = [&](glm::vec2 p) { return in_lasso(p) || to_segment(p, {30, 40}, {90, 60}) < 7; };
    for (const std::uint64_t count : {900, 4000}) {
        for (const float contrast : {0.0F, 0.4F}) {
            Settings settings = with_dots(count);
            settings.drawing.automatic_tone = false;
            settings.drawing.tone.contrast = contrast;
            const std::vector<OnPaper> all = dots_of(edited_drawing(settings));
            settings.drawing.edits = brush + lasso;
            const Drawing edited = edited_drawing(settings);
            const std::vector<OnPaper> left = dots_of(edited);
            CHECK(all.size() == count);
            CHECK(left.size() < all.size());
            CHECK((left == without(all, bare)));
            CHECK(edited.count == left.size());
        }
    }
}

TEST_CASE("an added dot lies where it was put, with the size that it was given, in an SVG too") {
    for (const std::uint64_t count : {500, 3000}) {
        Settings settings = with_dots(count);
        const std::vector<OnPaper> all = dots_of(edited_drawing(settings));
        settings.drawing.edits = "dot 61.25,33.5;dot r4 100,77;";
        const Drawing edited = edited_drawing(settings);
        std::vector<OnPaper> dots = dots_of(edited);
        REQUIRE(dots.size() == all.size() + 2);
        const OnPaper sized = dots.back(), usual = dots[all.size()];
        CHECK(glm::distance(usual.at, {61.25, 33.5}) < 1e-3);
        CHECK(usual.radius == doctest::Approx(all[0].radius));
        CHECK(glm::distance(sized.at, {100, 77}) < 1e-3);
        CHECK(sized.radius == doctest::Approx(4));
        CHECK(edited.radius_mm() == doctest::Approx(4));
        dots.resize(all.size());
        for (std::size_t i = 0; i < all.size(); ++i) CHECK(dots[i].at == all[i].at);
        std::ostringstream svg;
        REQUIRE(edited.write(svg, DrawingFormat::svg));
        CHECK(svg.str().find(R"(<circle cx="377.95" cy="291.02" r="15.118"/>)") !=
              std::string::npos);  // 96 dpi
    }
    // Bare places come in their order, and there is no dot off the page.
    const auto count = [](const std::string& edits) { return edited_drawing(with_dots(500, edits)).count; };
    const auto left = count("bare r4 60,40;");
    CHECK(left < 500);
    CHECK(count("bare r4 60,40;dot 60,41;") == left + 1);
    CHECK(count("dot 60,41;bare r4 60,40;") == left);
    CHECK(count("dot -1,40;dot 60,1000;") == 500);
}

TEST_CASE("sheets and a region have together what the page has, of edits too") {
    Settings settings =
        with_dots(1500, "bare r9 99,66 101,70;dot r3 100,66.6;dot 40,40;bare 5,5 60,5 20,60;dot 9,9;");
    const Drawing whole = edited_drawing(settings);
    std::vector<OnPaper> all = dots_of(whole), together;
    for (const int column : {1, 2})
        for (const int row : {1, 2}) {
            const DrawnPage sheet = drawn_page(whole.layout(), Sheet{column, row, 2, 2});
            const double unit = whole.layout().page.mm_per_page_unit;
            const glm::dvec2 corner = glm::dvec2(sheet.part.part.across.offset, sheet.part.part.down.offset);
            const DotStream stream = whole.dots(sheet.part.part, {});
            const Dots own = all_of(stream);
            CHECK(own.size() == stream.count);
            for (std::size_t i = 0; i < own.size(); ++i)
                together.push_back(
                    {glm::vec2((glm::dvec2(own.x[i], own.y[i]) + corner) * unit + whole.layout().picture.low),
                     static_cast<float>(own.radius[i] * unit), 0});
        }
    REQUIRE(together.size() == all.size());
    std::sort(all.begin(), all.end());
    std::sort(together.begin(), together.end());
    for (std::size_t i = 0; i < all.size(); ++i) {
        CHECK(glm::distance(all[i].at, together[i].at) < 1e-3);
        CHECK(all[i].radius == doctest::Approx(together[i].radius));
    }
}

TEST_CASE("of several pens each draws its own added dots, and a bare place has none of any") {
    Settings settings = with_dots(1500);
    settings.drawing.pens = parse_pens("cmyk:0.4");
    const std::vector<OnPaper> all = dots_of(edited_drawing(settings));
    settings.drawing.edits = "bare r15 70,50;dot p2 70,50;dot p9 75,50;";
    const auto bare = [](glm::vec2 p) { return glm::distance(p, {70, 50}) <= 15; };
    std::vector<OnPaper> left = dots_of(edited_drawing(settings)), wanted = without(all, bare);
    CHECK(wanted.size() + 2 == left.size());
    const auto added = std::ranges::find_if(left, [&](const OnPaper& dot) { return bare(dot.at); });
    REQUIRE(added != left.end());
    CHECK(added->pen == 1);
    CHECK(glm::distance(added->at, {70, 50}) < 1e-3);
    left.erase(added);
    const auto last = std::ranges::find_if(left, [&](const OnPaper& dot) { return bare(dot.at); });
    REQUIRE(last != left.end());
    CHECK(last->pen == std::ranges::max_element(all, {}, &OnPaper::pen)->pen);
    left.erase(last);
    CHECK((left == wanted));
}

TEST_CASE("dots of several sizes, Figure 8's and lines are edited like others") {
    for (const int which : {0, 1, 2}) {
        CAPTURE(which);
        Settings settings = with_dots(1200);
        if (which == 0) settings.drawing.dot_size = {DotSizing::by_tone, 0.2, 0.4, 1.2};
        if (which == 1) settings.drawing.placer = PlacerKind::figure8;
        if (which == 2) settings.drawing.style = DrawingStyle::line;
        const std::vector<OnPaper> all = dots_of(edited_drawing(settings));
        settings.drawing.edits = "bare r12 100,70;dot 100,70;";
        const Drawing edited = edited_drawing(settings);
        std::vector<OnPaper> left = dots_of(edited);
        const OnPaper added = left.back();
        left.pop_back();
        CHECK((left == without(all, [](glm::vec2 p) { return glm::distance(p, {100, 70}) <= 12; })));
        CHECK(left.size() < all.size());
        // As large as those around it.
        const auto beside = std::ranges::min_element(all, {}, [](const OnPaper& dot) {
            return glm::distance(dot.at, {100, 70});
        });
        CHECK(added.radius == doctest::Approx(beside->radius).epsilon(0.1));
        const DotStream stream = edited.dots({}, {});
        CHECK(stream.duplicates < all.size());
        CHECK((which == 1) == (stream.duplicates > 0));
    }
}

TEST_CASE("contours end where it is bare, and those elsewhere stay") {
    Settings settings = with_dots(1000);
    settings.drawing.contours = 0.8;
    Stippler stippler;
    LightPicture disc{.light = Grid<float>(300, 200)};
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 300; ++x) disc.light.at(x, y) = std::hypot(x - 150, y - 100) < 50 ? 0.2F : 0.7F;
    stippler.set_picture(disc);
    const auto lines_in = [&](double left, double right) {
        const Drawing drawing = *stippler.draw(settings);
        int points = 0;
        for (const InkLine& line : drawing.plan.inking->lines)
            points += static_cast<int>(std::ranges::count_if(
                line.points, [&](glm::dvec2 p) { return p.x * 200 > left && p.x * 200 < right; }));
        return points;
    };
    CHECK(lines_in(0, 99) > 0);
    settings.drawing.edits = "bare -1,-1 97,-1 97,200 -1,200;";
    CHECK(lines_in(0, 96) == 0);
    CHECK(lines_in(102, 200) > 0);
}

TEST_CASE("edits are read as they are written, and what is wrong with one is told") {
    const std::string all = "bare r0.1 1,2 -3.5,4e-05;bare 1,1 2,2 3,1;dot 5,6;dot r0.25 p12 7.125,8;";
    std::string again;
    for (const Edit& edit : parse_edits(all)) again += text_of(edit);
    CHECK(again == all);
    CHECK(parse_edits("").empty());
    CHECK(parse_edits("dot 1,2").size() == 1);
    CHECK(refused("dot 1,2;smudge 3,4") == "edit 2, 'smudge 3,4': it has to begin with bare or dot");
    CHECK(refused("dot 1,2 3,4").ends_with("a dot has one place, as in 'dot 10,20'"));
    for (const char* const bare : {"bare 1,2 3,4", "bare r2"})
        CHECK(refused(bare).ends_with("it needs three places or more, or a radius, as in 'bare r2 10,20'"));
    CHECK(refused("dot nan,2").find("'nan' is no number from -100000 to 100000") != std::string::npos);
    CHECK(refused("dot r0 1,2").find("'0' is no number from 1e-06 to 1000") != std::string::npos);
    for (const char* const wrong :
         {"dot 1", "dot 1,", "dot ,", "dot 1,2,3", "dot inf,1", "dot 1,1e6", "dot p0 1,2", "dot p13 1,2",
          "bare p2 r1 1,2", "lasso 1,1 2,2 3,3", "dot  1,2", ";", "dot 1,2; dot 1,2"})
        CHECK_MESSAGE(refused(wrong) != "", wrong);
    std::string many = "bare r1";
    for (int i = 0; i < 100'001; ++i) many += " 1,1";
    CHECK(refused(many) == "the edits have more than 100,000 points");
}
