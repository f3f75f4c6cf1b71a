// dapple render: what is drawn, in every format.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "io/files/picture.h"
#include "tests/file_text.h"
#include "tests/picture_files.h"
#include "tests/render_scene.h"
#include "tests/run_in_shell.h"

using namespace dapple;

namespace {

// Share of ink, as a renderer mixes it: in encoded values.
double encoded_ink(const std::filesystem::path& picture) {
    const Picture read = read_picture(picture);
    double sum = 0;
    for (const glm::u8vec4& pixel : read.preview.values) sum += 1 - pixel.x / 255.0;
    return sum / static_cast<double>(read.preview.values.size());
}

// Where the dots of a table lie across the page, in millimetres.
std::vector<double> across_page(const std::string& table) {
    std::istringstream lines(table);
    std::string line;
    std::getline(lines, line);
    std::vector<double> places;
    while (std::getline(lines, line)) places.push_back(std::stod(line));
    return places;
}

// The dots of which x lies from `from` to below `to`.
double dots_between(const std::vector<double>& places, double from, double to) {
    return static_cast<double>(std::ranges::count_if(places, [&](double x) { return x >= from && x < to; }));
}

// Draws a picture, at a millimetre a pixel of the 96, as it is but for some option.
std::vector<double> drawn_with(const Scene& scene, const std::string& picture, const std::string& options) {
    const Outcome outcome = run_dapple("render " + scene(picture) + " -o " + scene("tone.csv") +
                                       " --tone true --relax 0 --width 96 " + options);
    REQUIRE_MESSAGE(outcome.status == 0, outcome.err);
    return across_page(text_of(scene("tone.csv")));
}

}  // namespace

TEST_CASE("a picture becomes an SVG of exactly as many circles as asked for, no two at one place") {
    const Scene scene;
    const Outcome outcome = run_dapple("render " + scene("cat.png") + " -o " + scene("cat.svg") +
                                       " --dots 3000 --width 150 --stats " + scene("cat.json"));
    REQUIRE_MESSAGE(outcome.status == 0, outcome.err);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.starts_with("3,000 dots, "));
    CHECK(std::ranges::count(outcome.err, '\n') == 1);
    const Outcome advised =
        run_dapple("render " + scene("cat.png") + " --dots 3000 --width 150 --advice -o " + scene("b.svg"));
    CHECK(advised.err.find(" on an AxiDraw V3: mostly raising and lowering the pen\n") != std::string::npos);
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
    for (const char* stage : {"place_ms", "order_ms", "write_ms", "check_ms"}) CHECK(stats[stage] >= 0);
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

TEST_CASE("a picture whose light goes far over white is drawn as if it had been exposed for it") {
    const Scene scene;
    PictureFile ramp = test_picture();
    for (float& v : ramp.values) v = std::pow(v, 2.2f);
    ramp.type = "float";
    write_picture(scene.folder / "plain.exr", ramp);
    for (float& v : ramp.values) v *= 100;
    write_picture(scene.folder / "sun.exr", ramp);
    const auto dots = [&](const std::string& options) {
        return drawn_with(scene, "sun.exr", "--scale 300 " + options);
    };
    const std::vector<double> plain = drawn_with(scene, "plain.exr", "--scale 300 ");
    const std::vector<double> chosen = dots("");
    CHECK(std::abs(static_cast<double>(chosen.size()) / static_cast<double>(plain.size()) - 1) < 0.1);
    CHECK(dots("--exposure auto") == chosen);
    // All but the black bar is over white; and all of it nearly black.
    CHECK(dots("--exposure 0").size() < chosen.size() / 2);
    CHECK(dots("--exposure -12").size() > chosen.size() * 3 / 2);
    CHECK(run_dapple("render " + scene("sun.exr") + " -o " + scene("s.csv") + " --stats " + scene("s.json"))
              .status == 0);
    const double stops = read_json(scene("s.json"))["tone"]["exposure"];
    CHECK(stops < -5.5);
    CHECK(stops > -7.5);
}

TEST_CASE("each option of tone makes the drawing darker or lighter, or moves its ink, as its help says") {
    const Scene scene;
    const auto with = [&](const std::string& options) {
        return drawn_with(scene, "cat.png", "--scale 300 " + options);
    };
    // A ramp from black to white, with a black bar from 41 to 50.
    const std::vector<double> plain = with("");
    REQUIRE(plain.size() > 1000);
    for (const std::string darker :
         {"--exposure -0.5", "--brightness -0.2", "--gamma 0.5", "--black-point 0.3"}) {
        CAPTURE(darker);
        CHECK(with(darker).size() > plain.size() * 13 / 12);
    }
    for (const std::string lighter :
         {"--exposure 0.5", "--brightness 0.2", "--gamma 2", "--white-point 0.7"}) {
        CAPTURE(lighter);
        CHECK(with(lighter).size() < plain.size() * 12 / 13);
    }
    const auto share = [](const std::vector<double>& dots, double from, double to) {
        return dots_between(dots, from, to);
    };
    // The dark third and the light one, apart.
    const std::vector<double> hard = with("--contrast 0.5"), flat = with("--contrast -0.5");
    CHECK(share(hard, 15, 40) > share(plain, 15, 40) * 1.05);
    CHECK(share(hard, 60, 85) < share(plain, 60, 85) / 1.2);
    CHECK(share(flat, 15, 40) < share(plain, 15, 40) / 1.05);
    CHECK(share(flat, 60, 85) > share(plain, 60, 85) * 1.2);
    // The bar's ink runs over its edges, and none is lost.
    const std::vector<double> soft = with("--blur 30");
    CHECK(share(soft, 42, 49) < share(plain, 42, 49) / 1.05);
    CHECK(share(soft, 50, 56) > share(plain, 50, 56) * 1.05);
    // Light ink: none in the bar, more to the right.
    const std::vector<double> inverted = with("--invert");
    CHECK(share(inverted, 42, 49) == 0);
    CHECK(share(inverted, 60, 96) > 2 * share(inverted, 0, 40));
    CHECK(share(plain, 0, 40) > 2 * share(plain, 60, 96));
}

TEST_CASE("--detail puts ink of the surroundings into what is faint and a few dots wide") {
    const Scene scene;
    PictureFile faint{.width = 96, .height = 64};
    const auto in_line = [](int x) { return x % 24 >= 11 && x % 24 < 14; };
    for (int i = 0; i < 96 * 64; ++i) faint.values.push_back(in_line(i % 96) ? 0.5f : 0.6f);
    write_picture(scene.folder / "faint.png", faint);
    const auto on_lines = [&](const std::string& options) {
        double dots = 0;
        const std::vector<double> places = drawn_with(scene, "faint.png", "--dots 2500 " + options);
        for (int x = 0; x < 96; ++x)
            if (in_line(x)) dots += dots_between(places, x, x + 1);
        return dots;
    };
    const double none = on_lines("--detail 0"), half = on_lines("--detail 0.5"), all = on_lines("--detail 1");
    CHECK(half > 1.02 * none);
    CHECK(all > 1.02 * half);
}

TEST_CASE("--dot-radius is the radius of the circles and of the spots of ink") {
    const Scene scene;
    const std::string from = "render " + scene("cat.png") + " --dots 40 --relax 2 --width 96 --stats " +
                             scene("r.json") + " --dot-radius ";
    for (const double radius : {0.5, 1.0}) {
        CAPTURE(radius);
        const std::string text = std::to_string(radius);
        REQUIRE(run_dapple(from + text + " -o " + scene("r.svg")).status == 0);
        CHECK(read_json(scene("r.json"))["dot_radius_mm"] == doctest::Approx(radius));
        const Svg svg = read_svg(scene("r.svg"));
        REQUIRE(svg.circles().size() == 40);
        for (const pugi::xml_node& circle : svg.circles())
            CHECK(circle.attribute("r").as_double() == doctest::Approx(radius * 96 / 25.4).epsilon(0.005));
        REQUIRE(run_dapple(from + text + " --dpi 254 --margin 2 -o " + scene("r.png")).status == 0);
        double ink = 0;  // in pixels, a hundred to the square millimetre
        for (const float light : read_picture(scene("r.png")).light.values) ink += 1 - light;
        CHECK(ink / 100 == doctest::Approx(40 * 3.14159265 * radius * radius).epsilon(0.01));
    }
}

TEST_CASE("dots too small for the picture's tone are told, with a number and a width that do") {
    const Scene scene;
    const auto said = [&](const std::string& options) {
        const Outcome outcome =
            run_dapple("render " + scene("cat.png") + " --width 96 --margin 0 --relax 5 --advice -o " +
                       scene("r.svg") + " " + options);
        REQUIRE(outcome.status == 0);
        return outcome.err;
    };
    const std::string pale = said("--dots 300 --dot-radius 0.2");
    CAPTURE(pale);
    std::smatch told;
    REQUIRE(std::regex_search(
        pale, told,
        std::regex("paler than the picture. Use ([0-9,]+) dots 0.4 mm wide.* these dots ([0-9.]+) mm wide")));
    const std::string dots = std::regex_replace(told[1].str(), std::regex(","), "");
    const std::string radius = std::to_string(std::stod(told[2]) / 2);
    CHECK(std::stod(dots) > 1000);
    const auto is_right = [&](const std::string& options) {
        return said(options).find("than the picture") == std::string::npos;
    };
    CHECK(is_right("--dots " + dots + " --dot-radius 0.2"));
    CHECK(is_right("--dots 300 --dot-radius " + radius));
    CHECK(is_right("--dots 300"));
    CHECK(said("--dots " + std::to_string(3 * std::stoi(dots)) + " --dot-radius 0.2").find("darker than") !=
          std::string::npos);
    // What fits the tone has the radius that dots have without the option.
    CHECK(read_svg(scene("r.svg")).circles().size() == 3 * std::stoul(dots));
    said("--dots 300");
    CHECK(read_svg(scene("r.svg")).circles()[0].attribute("r").as_double() * 25.4 / 96 ==
          doctest::Approx(std::stod(told[2]) / 2).epsilon(0.03));
}

TEST_CASE("options say another size or tone than the project does, as of a new drawing") {
    const Scene scene;
    const auto stats_of = [&](const std::string& project, const std::string& options) {
        put_text(scene("p.dapple"), R"({"dapple": 1, "picture": "cat.png", "drawing": )" + project + "}");
        const Outcome made = run_dapple("render " + scene("p.dapple") + " --dots 300 --stats " +
                                        scene("s.json") + " -o " + scene("a.svg") + options);
        CAPTURE(made.err);
        REQUIRE(made.status == 0);
        return read_json(scene("s.json"));
    };
    const std::string high = R"({"page": {"height_mm": 90}})",
                      custom = R"({"page": {"paper": "custom", "width_mm": 300, "height_mm": 200}})";
    CHECK(stats_of(high, "")["height_mm"] == 90);
    for (const std::string& project : {high, custom}) {
        CHECK(stats_of(project, " --width 60")["width_mm"] == 60);
        CHECK(stats_of(project, " --height 50")["height_mm"] == 50);
    }
    CHECK(stats_of(custom, " --width 60 --height 50")["width_mm"] == 60);

    const std::string true_light = R"({"automatic_tone": false, "tone": {"detail": 0}})";
    CHECK(stats_of(true_light, "")["tone"]["detail"] == 0);
    CHECK(stats_of(true_light, " --tone auto")["tone"]["detail"] == 0.5);
    CHECK(stats_of(true_light, " --tone auto --detail 0.25")["tone"]["detail"] == 0.25);
    CHECK(stats_of("{}", " --tone true")["tone"]["detail"] == 0);

    const std::string open = R"({"tone": {"black": 0.8}})";
    CHECK(stats_of(open, "")["tone"]["black"] == 0.8);
    CHECK(stats_of(open, " --tone true")["tone"]["black"] == 1);
    CHECK(stats_of(open, " --tone true --black 0.6")["tone"]["black"] == 0.6);
}

TEST_CASE("a radius that a drawing could not be read with again is refused") {
    const Scene scene;
    const std::string from = "render " + scene("cat.png") + " --dots 100 -o " + scene("a.svg");
    scene.must_fail(from + " --dot-radius 0.0000001", "--dot-radius");
    scene.must_fail("render " + scene("cat.png") + " -o " + scene("a.svg") + " --dot-radius 1..2 --black 0.5",
                    "--black: has no effect with two radii");
    scene.must_fail(from + " --style line --black 0.5", "--black: has no effect on lines");
    REQUIRE(run_dapple(from + " --dot-radius 0.000001").status == 0);
    CHECK(run_dapple("render " + scene("cat.png") + " --settings-from " + scene("a.svg") + " -o " +
                     scene("b.svg"))
              .status == 0);
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
    const pugi::xml_node background = root.child("g"), ink = background.next_sibling("g");
    CHECK(background.child("rect").attribute("fill").value() == std::string("#ffeedd"));
    CHECK(ink.attribute("inkscape:label").value() == std::string("1 #cc0000"));
    const pugi::xml_node tiles = ink.next_sibling("g");
    CHECK(tiles.attribute("inkscape:label").value() == std::string("% Tiles"));
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
    CHECK(line.starts_with("x_mm,y_mm,radius_mm,level,rank,critical_scale,"));
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

    // A count finds the scale that comes to it, or to a few more.
    REQUIRE(run_dapple("render " + scene("cat.png") + " -o " + scene("n.csv") +
                       " --placer figure8 --dots 3000 --stats " + scene("n.json"))
                .status == 0);
    const nlohmann::json met = read_json(scene("n.json"));
    CHECK(met["dots"] >= 3000);
    CHECK(met["dots"] <= 3060);
    // Its dots are as large as as many others are.
    REQUIRE(run_dapple("render " + scene("cat.png") + " -o " + scene("e.csv") +
                       " --relax 0 --dots 3000 --stats " + scene("e.json"))
                .status == 0);
    const double usual = read_json(scene("e.json"))["dot_radius_mm"];
    CHECK(met["dot_radius_mm"].get<double>() == doctest::Approx(usual).epsilon(0.03));

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

TEST_CASE("a mask leaves paper bare where it is black, and goes with the drawing's own settings") {
    const Scene scene;
    PictureFile mask{.width = 12, .height = 8};
    for (int i = 0; i < 12 * 8; ++i) mask.values.push_back(i % 12 < 4 ? 0.0f : 128 / 255.0f);
    write_picture(scene.folder / "mask.png", mask);
    const std::vector<double> all = drawn_with(scene, "cat.png", "--dots 2000");
    CHECK(dots_between(all, 0, 27) > 500);
    const std::vector<double> dots = drawn_with(scene, "cat.png", "--dots 2000 --mask " + scene("mask.png"));
    CHECK(dots.size() == 2000);
    CHECK(dots_between(dots, 0, 27) == 0);  // up to the last black centre, less a pixel
    const std::string render = "render " + scene("cat.png") + " --dots 500 -o ";
    CHECK(run_dapple(render + scene("a.svg") + " --mask " + scene("mask.png")).status == 0);
    CHECK(run_dapple(render + scene("b.svg") + " --settings-from " + scene("a.svg")).status == 0);
    CHECK(
        run_dapple(render + scene("c.svg") + " --settings-from " + scene("a.svg") + " --mask none").status ==
        0);
    CHECK(text_of(scene("a.svg")) == text_of(scene("b.svg")));
    CHECK(text_of(scene("a.svg")) != text_of(scene("c.svg")));
    CHECK(run_dapple(render + scene("d.svg") + " --mask " + scene("a.svg")).err.find("--mask: ") !=
          std::string::npos);
}

TEST_CASE("dots are finer where a picture says so, which goes with the drawing's own settings too") {
    const Scene scene;
    PictureFile white{.width = 4, .height = 4};
    white.values.assign(16, 1.0f);
    write_picture(scene("white.png"), white);
    const auto run = [&](const std::string& output, const std::string& arguments) {
        return run_dapple("render " + scene("cat.png") + " --margin 0 --dots 500 -o " + scene(output) +
                          arguments);
    };
    REQUIRE(run("plain.svg", "").status == 0);
    REQUIRE(run("fine.svg", " --finer " + scene("white.png")).status == 0);
    // Where all are finer a count of dots is drawn in the size that it has anyway.
    const auto radius = [](const auto& svg) { return svg.circles().at(0).attribute("r").as_double(); };
    const auto plain = read_svg(scene("plain.svg")), fine = read_svg(scene("fine.svg"));
    CHECK(fine.circles().size() == 500);
    CHECK(radius(fine) == doctest::Approx(radius(plain)).epsilon(0.01));
    CHECK(run("again.svg", " --settings-from " + scene("fine.svg")).status == 0);
    CHECK(text_of(scene("again.svg")) == text_of(scene("fine.svg")));
    CHECK(run("none.svg", " --finer none --settings-from " + scene("fine.svg")).status == 0);
    CHECK(text_of(scene("none.svg")) == text_of(scene("plain.svg")));
    const Outcome lines = run("lines.svg", " --style line --finer " + scene("white.png"));
    CHECK(lines.status != 0);
    CHECK(lines.err.find("--finer") != std::string::npos);
}
