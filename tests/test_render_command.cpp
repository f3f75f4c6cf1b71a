// dapple render: what is drawn, in every format.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "app/files/picture.h"
#include "tests/file_text.h"
#include "tests/picture_files.h"
#include "tests/render_scene.h"
#include "tests/shell.h"

using namespace dapple;

namespace {

// Share of ink, as a renderer mixes it: in encoded values.
double encoded_ink(const std::filesystem::path& picture) {
    const Picture read = read_picture(picture);
    double sum = 0;
    for (const glm::u8vec4& pixel : read.preview.values) sum += 1 - pixel.x / 255.0;
    return sum / static_cast<double>(read.preview.values.size());
}

}  // namespace

TEST_CASE("a picture becomes an SVG of exactly as many circles as asked for, no two at one place") {
    const Scene scene;
    const Outcome outcome = run_dapple("render " + scene("cat.png") + " -o " + scene("cat.svg") +
                                       " --dots 3000 --width 150 --stats " + scene("cat.json"));
    REQUIRE_MESSAGE(outcome.status == 0, outcome.err);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.empty());
    const Svg svg = read_svg(scene("cat.svg"));
    CHECK(svg.circles().size() == 3000);
    CHECK(svg.places().size() == 3000);
    CHECK(svg.document.child("svg").attribute("width").value() == std::string("150mm"));
    CHECK(svg.document.child("svg").attribute("height").value() == std::string("100mm"));

    const nlohmann::json stats = read_json(scene("cat.json"));
    CHECK(stats["dots"] == 3000);
    CHECK(stats["emitted"] == 3000);
    CHECK(stats["duplicates"] == 0);
    CHECK(stats["image_width"] == 96);
    CHECK(stats["image_height"] == 64);
    CHECK(stats["width_mm"] == 150.0);
    CHECK(stats["height_mm"] == doctest::Approx(100));
    CHECK(stats["scale"] > 0);
    CHECK(stats["place_ms"] >= 0);
    CHECK(stats["threads"] >= 1);
}

TEST_CASE("a renderer draws the SVG as the PNG writer draws the dots") {
    const Scene scene;
    const std::string from = "render " + scene("cat.png") + " --dots 2000 -o ";
    REQUIRE(run_dapple(from + scene("cat.svg")).status == 0);
    REQUIRE(run_dapple(from + scene("cat.png.png") + " --dpi 150").status == 0);
    const Outcome outcome = run_in_shell("rsvg-convert --background-color=white --dpi-x 150 --dpi-y 150 -o " +
                                         scene("svg.png") + " " + scene("cat.svg"));
    REQUIRE_MESSAGE(outcome.status == 0, outcome.err);
    // At the edges of dots one mixes light and the other code values, so light itself is compared as ink
    // where both agree: a wide blur of neither. Encoded ink of our picture is the smaller by what edges hold.
    const Picture ours = read_picture(scene("cat.png.png"));
    double ink = 0;
    for (const float light : ours.light.values) ink += 1 - light;
    ink /= static_cast<double>(ours.light.values.size());
    CHECK(encoded_ink(scene("svg.png")) == doctest::Approx(ink).epsilon(0.01));
}

TEST_CASE("a PNG says how large it is on paper") {
    const Scene scene;
    REQUIRE(run_dapple("render " + scene("cat.png") + " -o " + scene("big.PNG") + " --width 100 --dpi 254")
                .status == 0);
    const Outcome info = run_in_shell("oiiotool --info -v " + scene("big.PNG"));
    CHECK(info.out.find("1000 x  667") != std::string::npos);
    CHECK(info.out.find("ResolutionUnit: \"inch\"") != std::string::npos);
    CHECK(info.out.find("XResolution: 254") != std::string::npos);
    CHECK(info.out.find("YResolution: 254") != std::string::npos);
}

TEST_CASE("colours, background and tiles are drawn as asked") {
    const Scene scene;
    REQUIRE(run_dapple("render " + scene("cat.png") + " -o " + scene("c.svg") +
                       " --scale 100 --ink '#c00' --paper '#ffeedd' --background --tiles")
                .status == 0);
    const Svg svg = read_svg(scene("c.svg"));
    const pugi::xml_node root = svg.document.child("svg");
    CHECK(root.first_child().attribute("fill").value() == std::string("#ffeedd"));
    CHECK(root.child("g").attribute("inkscape:label").value() == std::string("1 #cc0000"));
    const pugi::xml_node tiles = root.child("g").next_sibling("g");
    CHECK(tiles.attribute("inkscape:label").value() == std::string("2 Tiles"));
    const double width = 200 * 96 / 25.4, height = width * 64 / 96;
    for (const pugi::xml_node& level : tiles.children("g")) {
        for (const pugi::xml_node& tile : level.children("rect")) {
            CHECK(tile.attribute("x").as_double() + tile.attribute("width").as_double() < width + 0.01);
            CHECK(tile.attribute("y").as_double() + tile.attribute("height").as_double() < height + 0.01);
            CHECK(tile.attribute("height").as_double() > 0);
        }
    }
    REQUIRE(run_dapple("render " + scene("cat.png") + " -o " + scene("c.png") +
                       " --dpi 50 --ink '#c00' --paper '#ffeedd'")
                .status == 0);
    const Picture png = read_picture(scene("c.png"));
    CHECK(std::ranges::count(png.preview.values, glm::u8vec4(0xcc, 0, 0, 255)) > 100);
    CHECK(png.preview.at(png.preview.width - 1, 1) == glm::u8vec4(0xff, 0xee, 0xdd, 255));
}

TEST_CASE("the same dots come out in every format, on any number of threads") {
    const Scene scene;
    const std::string from = "render " + scene("cat.png") + " --dots 1500 -o ";
    REQUIRE(run_dapple(from + scene("one.csv") + " --threads 1").status == 0);
    REQUIRE(run_dapple(from + scene("two.csv") + " --threads 2").status == 0);
    REQUIRE(run_dapple(from + scene("dots.svg") + " --order recursion").status == 0);
    const std::string table = text_of(scene("one.csv"));
    CHECK(table == text_of(scene("two.csv")));
    std::istringstream lines(table);
    std::string line;
    std::getline(lines, line);
    CHECK(line == "x_mm,y_mm,radius_mm,level,rank,critical_scale");
    const Svg svg = read_svg(scene("dots.svg"));
    for (const pugi::xml_node& circle : svg.circles()) {
        REQUIRE(std::getline(lines, line));
        double x = 0, y = 0;
        REQUIRE(std::sscanf(line.c_str(), "%lf,%lf", &x, &y) == 2);
        CHECK(std::abs(circle.attribute("cx").as_double() - x * 96 / 25.4) < 0.006);
        CHECK(std::abs(circle.attribute("cy").as_double() - y * 96 / 25.4) < 0.006);
    }
    CHECK(!std::getline(lines, line));
}

TEST_CASE(
    "Figure 8 reports its duplicates, about a quarter, and loses a hairline that the exact placer draws") {
    const Scene scene;
    REQUIRE(run_dapple("render " + scene("cat.png") + " -o " + scene("f.csv") +
                       " --placer figure8 --scale 4000 --stats " + scene("f.json"))
                .status == 0);
    const nlohmann::json stats = read_json(scene("f.json"));
    CHECK(stats["emitted"] == stats["dots"].get<int>() + stats["duplicates"].get<int>());
    CHECK(stats["duplicates"].get<double>() / stats["emitted"].get<double>() ==
          doctest::Approx(0.25).epsilon(0.1));

    PictureFile line{.width = 1000, .height = 1000, .values = std::vector<float>(1'000'000, 1.0f)};
    for (int y = 0; y < 1000; ++y) line.values[static_cast<std::size_t>(y) * 1000 + 501] = 0;
    write_picture(scene("line.png"), line);
    const auto dots_with = [&](const std::string& placer) {
        const Outcome outcome =
            run_dapple("render " + scene("line.png") + " -o " + scene("line.csv") +
                       " --scale 20000 --placer " + placer + " --stats " + scene("line.json"));
        REQUIRE_MESSAGE(outcome.status == 0, outcome.err);
        return read_json(scene("line.json"))["dots"].get<int>();
    };
    CHECK(dots_with("figure8") == 0);
    // The line is 1/1000 of the page; along so thin a strip dots are not quite even.
    CHECK(dots_with("exact") == doctest::Approx(16 * 20000 / 1000.0).epsilon(0.3));
}

TEST_CASE("without a picture the sample is drawn") {
    const Scene scene;
    REQUIRE(run_dapple("render -o " + scene("s.svg") + " --dots 500 --stats " + scene("s.json")).status == 0);
    CHECK(read_svg(scene("s.svg")).circles().size() == 500);
    CHECK(read_json(scene("s.json"))["image_width"] == 1024);
}
