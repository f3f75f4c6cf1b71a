// dapple render: relaxation, tone and dots of several sizes.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/drawing/settings.h"
#include "core/image/tone.h"
#include "tests/file_text.h"
#include "tests/render_scene.h"
#include "tests/run_in_shell.h"

using namespace dapple;

namespace {

struct CsvDot {
    double x, y, radius;
};

std::vector<CsvDot> read_csv(const std::string& path) {
    std::istringstream lines(text_of(path));
    std::vector<CsvDot> dots;
    std::string line;
    std::getline(lines, line);
    CHECK(line.starts_with("x_mm,y_mm,radius_mm"));
    while (std::getline(lines, line)) {
        CsvDot dot{};
        REQUIRE(std::sscanf(line.c_str(), "%lf,%lf,%lf", &dot.x, &dot.y, &dot.radius) == 3);
        dots.push_back(dot);
    }
    return dots;
}

// On how wide a stretch of the page (see test_picture()) the mean radius is taken: left of the bar, dark, and
// right.
double mean_radius(const std::vector<CsvDot>& dots, double from, double to) {
    double sum = 0, count = 0;
    for (const CsvDot& dot : dots) {
        if (dot.x < from || dot.x >= to) continue;
        sum += dot.radius;
        count += 1;
    }
    REQUIRE(count > 0);
    return sum / count;
}

void draw(const std::string& arguments) {
    const Outcome outcome = run_dapple("render " + arguments);
    CAPTURE(arguments);
    CAPTURE(outcome.err);
    REQUIRE(outcome.status == 0);
}

std::string with(const Scene& scene, const std::string& options, const std::string& name) {
    return scene("cat.png") + " --tile paper16 -o " + scene(name) + " --stats " + scene("stats.json") + " " +
           options;
}

}  // namespace

TEST_CASE("--relax moves dots, loses none, and does so by itself") {
    const Scene scene;
    std::map<std::string, std::set<std::pair<std::string, std::string>>> places;
    const std::string usual = "12";  // of so few dots
    for (const std::string& steps : {std::string("0"), std::string("3"), usual, std::string("auto")}) {
        draw(with(scene, "--dots 1500 --relax " + steps, "r.svg"));
        places[steps] = read_svg(scene("r.svg")).places();
        CHECK(read_svg(scene("r.svg")).circles().size() == 1500);
        CHECK(read_json(scene("stats.json"))["relaxing_steps"] == std::stoi(steps == "auto" ? usual : steps));
    }
    CHECK(places["0"] != places["3"]);
    CHECK(places["3"] != places[usual]);
    CHECK(places[usual] == places["auto"]);
    draw(with(scene, "--dots 1500", "r.svg"));
    CHECK(read_svg(scene("r.svg")).places() == places["auto"]);
    std::size_t stayed = 0;
    for (const auto& place : places["3"]) stayed += places["0"].contains(place);
    CHECK(stayed < 150);
}

TEST_CASE("steps that are too many, too few or no number are refused in a sentence") {
    const Scene scene;
    const std::string from = "render " + scene("cat.png") + " -o " + scene("new.svg") + " --relax ";
    scene.must_fail(from + "101", "--relax: 101 is not possible");
    scene.must_fail(from + "-1", "--relax: -1 is not possible");
    scene.must_fail(from + "x", "--relax: x is not a number");
    scene.must_fail(from + "2.5", "--relax: 2.5 is not a whole number");
    scene.must_fail(from + "''", "--relax");
    scene.must_fail(from + "3 --placer figure8 --scale 300", "--relax: does not apply to the figure8 placer");
    CHECK(run_dapple(from + "101").status ==
          run_dapple("render -o " + scene("new.svg") + " --contrast 7").status);
}

TEST_CASE("relaxed sheets made one by one have the dots of the whole, each once") {
    const Scene scene;
    for (const std::string size : {"--dots 4000", "--dot-radius 0.5..1.2"}) {
        const std::string options = "--width 300 --relax 3 " + size;
        draw(with(scene, options, "whole.csv"));
        // Micrometres from the whole page's corner, and radii in nanometres.
        const auto read = [&](const std::string& name, double x0, double y0, auto& dots) {
            for (const CsvDot& dot : read_csv(scene(name)))
                dots.emplace(std::lround((dot.x + x0) * 1e3), std::lround((dot.y + y0) * 1e3),
                             std::lround(dot.radius * 1e6));
        };
        std::multiset<std::tuple<long, long, long>> whole, on_sheets;
        read("whole.csv", 0, 0, whole);
        CHECK(whole.size() > 1000);
        for (int row = 1; row <= 2; ++row) {
            for (int column = 1; column <= 3; ++column) {
                const std::string sheet = std::to_string(column) + "," + std::to_string(row) + "/3x2";
                draw(with(scene, options + " --sheet " + sheet, "sheet.csv"));
                read("sheet.csv", (column - 1) * 100.0, (row - 1) * 100.0, on_sheets);
            }
        }
        CHECK(on_sheets.size() == whole.size());
        std::size_t found = 0;
        for (const auto& [x, y, radius] : on_sheets) {
            // Adding the corner may round to the next micrometre.
            bool here = false;
            for (long dx = -1; dx <= 1; ++dx)
                for (long dy = -1; dy <= 1; ++dy)
                    for (long dr = -1; dr <= 1; ++dr)
                        here = here || whole.contains({x + dx, y + dy, radius + dr});
            found += here;
        }
        CHECK(found == whole.size());
    }
}

TEST_CASE("two radii draw dots from the smallest in light areas to the largest on black") {
    const Scene scene;
    draw(with(scene, "--dot-radius 0.5..1.5", "r.csv"));
    const std::vector<CsvDot> dots = read_csv(scene("r.csv"));
    const auto [smallest, largest] = std::ranges::minmax(dots, {}, &CsvDot::radius);
    CHECK(smallest.radius >= 0.5 - 1e-6);
    CHECK(smallest.radius < 0.7);
    CHECK(largest.radius <= 1.5 + 1e-6);
    CHECK(largest.radius > 1.45);
    // The page is 200 mm wide for 96 pixels, the picture darkest on the left and in its bar.
    CHECK(mean_radius(dots, 0, 30) > mean_radius(dots, 40, 70) + 0.05);
    CHECK(mean_radius(dots, 40, 70) > mean_radius(dots, 120, 150) + 0.05);
    CHECK(mean_radius(dots, 88, 102) > 1.3);
    CHECK(read_json(scene("stats.json"))["dot_radius_mm"] == doctest::Approx(1.5));
    CHECK(read_json(scene("stats.json"))["dots"] == dots.size());

    draw(with(scene, "--dot-radius 0.5..1.5", "r.svg"));
    std::vector<double> in_svg, in_csv;
    const Svg svg = read_svg(scene("r.svg"));
    for (const pugi::xml_node& circle : svg.circles())
        in_svg.push_back(circle.attribute("r").as_double() * 25.4 / 96);
    for (const CsvDot& dot : dots) in_csv.push_back(dot.radius);
    std::ranges::sort(in_svg);
    std::ranges::sort(in_csv);
    REQUIRE(in_svg.size() == in_csv.size());
    double farthest = 0;
    for (std::size_t i = 0; i < in_svg.size(); ++i)
        farthest = std::max(farthest, std::abs(in_svg[i] - in_csv[i]));
    CHECK(farthest < 0.005);  // of a millimetre

    draw(with(scene, "--dots 1000 --dot-radius 0.7", "r.csv"));
    for (const CsvDot& dot : read_csv(scene("r.csv"))) CHECK(dot.radius == doctest::Approx(0.7));
}

TEST_CASE("smaller radii make more dots, for the same tone") {
    const Scene scene;
    std::map<std::string, double> dots;
    for (const std::string radii : {"0.5..1", "1..2"}) {
        draw(with(scene, "--dot-radius " + radii, "r.svg"));
        dots[radii] = read_json(scene("stats.json"))["dots"];
    }
    CHECK(dots["0.5..1"] == doctest::Approx(4 * dots["1..2"]).epsilon(0.05));
}

TEST_CASE("radii that cannot be are refused in a sentence") {
    const Scene scene;
    const std::string from = "render " + scene("cat.png") + " -o " + scene("new.svg") + " --dot-radius ";
    scene.must_fail(from + "0.4..0.1", "--dot-radius: 0.4..0.1: put the smaller radius first");
    scene.must_fail(from + "0.1..0.4 --dots 5000", "--dots: cannot be given together with two radii");
    scene.must_fail(from + "0.1..0.4 --scale 5000", "--scale: cannot be given together with two radii");
    for (const std::string wrong : {"0..0.4", "0.1..", "..0.4", "0.1..inf", "0"})
        scene.must_fail(from + wrong, "--dot-radius");
    scene.must_fail(from + "0.0000001..0.0000002", "--dot-radius");  // more dots than there may be
}

TEST_CASE("--tone auto fits the tone to the picture, --tone true leaves it as it is") {
    const Scene scene;
    // Neither black nor white.
    PictureFile dull{.width = 64, .height = 48};
    for (int i = 0; i < 64 * 48; ++i) dull.values.push_back(0.35f + 0.3f * static_cast<float>(i % 64) / 63);
    write_picture(scene.folder / "dull.png", dull);
    const auto tone_of = [&](const std::string& options) {
        draw(scene("dull.png") + " --tile paper16 --dots 500 -o " + scene("t.csv") + " --stats " +
             scene("stats.json") + " " + options);
        return read_json(scene("stats.json"))["tone"];
    };
    const nlohmann::json strong = tone_of("--tone auto --tone-strength 1");
    CHECK(strong["automatic"] == true);
    CHECK(strong["strength"] == 1);
    CHECK(strong["black_point"] > 0.3);
    CHECK(strong["white_point"] < 0.7);
    CHECK(strong["detail"] == 0.5);
    CHECK(strong["black"] == 0.9);
    // The usual strength goes so far of the way from true tone.
    const nlohmann::json automatic = tone_of("--tone auto");
    const std::string drawn = text_of(scene("t.csv"));
    for (const auto& [name, plain] : {std::pair{"black_point", 0.0}, {"white_point", 1.0}, {"black", 1.0}})
        CHECK(automatic[name].get<double>() ==
              doctest::Approx(plain + 0.6 * (strong[name].get<double>() - plain)).epsilon(0.01));
    CHECK(tone_of("") == automatic);
    CHECK(text_of(scene("t.csv")) == drawn);
    CHECK(tone_of("--detail 0.2 --blur 3 --invert")["automatic"] == true);

    const nlohmann::json plain = tone_of("--tone true");
    CHECK(text_of(scene("t.csv")) != drawn);
    CHECK(plain == nlohmann::json{{"automatic", false},
                                  {"strength", 0.6},
                                  {"exposure", 0},
                                  {"black_point", 0},
                                  {"white_point", 1},
                                  {"contrast", 0},
                                  {"brightness", 0},
                                  {"gamma", 1},
                                  {"blur", 0},
                                  {"detail", 0},
                                  {"black", 1},
                                  {"invert", false}});
    const nlohmann::json gamma = tone_of("--gamma 2");
    CHECK(gamma["automatic"] == false);
    CHECK(gamma["gamma"] == 2);
    CHECK(gamma["black_point"] == 0);
    CHECK(gamma["white_point"] == 1);
    CHECK(gamma["detail"] == 0);
    const std::string by_gamma = text_of(scene("t.csv"));
    CHECK(tone_of("--tone true --gamma 2") == gamma);
    CHECK(text_of(scene("t.csv")) == by_gamma);
    CHECK(tone_of("--tone true --detail 0.7")["detail"] == doctest::Approx(0.7));
    CHECK(tone_of("--black 0.7")["automatic"] == true);
    CHECK(tone_of("--black 0.7")["black"] == 0.7);
    CHECK(tone_of("--tone true --black 0.7")["black"] == 0.7);
    CHECK(tone_of("--black auto") == automatic);
    scene.must_fail("render " + scene("dull.png") + " -o " + scene("new.csv") + " --black 0.4",
                    "--black: 0.4 is not possible");
}

TEST_CASE(
    "true light is covered by as much ink as the picture lacks light, at another gamma by as much of that") {
    const Scene scene;
    PictureFile grey{.width = 40, .height = 40, .values = std::vector<float>(1600, 0.6f)};
    write_picture(scene.folder / "grey.png", grey);
    for (const double gamma : {1.0, 2.0}) {
        draw(scene("grey.png") + " --margin 0 --dots 6000 --relax 4 --tone true --gamma " +
             std::to_string(gamma) + " -o " + scene("g.csv") + " --stats " + scene("stats.json"));
        const double ink = 1 - srgb_to_linear(static_cast<float>(std::pow(153 / 255.0, 1 / gamma)));
        const nlohmann::json stats = read_json(scene("stats.json"));
        const double radius = stats["dot_radius_mm"], load = 6000 * 3.14159265 * radius * radius / 40'000;
        // Up to a load of 0.6 even dots hardly overlap.
        if (ink < 0.6) CHECK(load == doctest::Approx(ink).epsilon(0.02));
        if (ink >= 0.6) CHECK(load > ink);
        if (ink >= 0.6) CHECK(load < ink + 0.1);
    }
}

TEST_CASE("a tone that is not known, or asked for in two ways, is refused in a sentence") {
    const Scene scene;
    const std::string from = "render " + scene("cat.png") + " -o " + scene("new.svg") + " --tone ";
    scene.must_fail(from + "other", "--tone: other is not known; there are auto and true");
    for (const std::string option : {"--gamma 2", "--brightness 0.1"})
        scene.must_fail(from + "auto " + option,
                        "--tone: auto cannot be given together with " + option.substr(0, option.find(' ')));
}

TEST_CASE("--detail moves dots to where the picture has some") {
    const Scene scene;
    PictureFile picture = test_picture();
    for (std::size_t i = 0; i < picture.values.size(); ++i)
        picture.values[i] = 0.5f + (i / 3 % 2 == 0 ? 0.02f : -0.02f);
    write_picture(scene.folder / "faint.png", picture);
    std::set<std::string> drawings;
    for (const std::string detail : {"0", "0.5", "1"}) {
        draw(scene("faint.png") + " --dots 1500 --tile paper16 -o " + scene("d.svg") +
             " --tone true --detail " + detail);
        drawings.insert(text_of(scene("d.svg")));
    }
    CHECK(drawings.size() == 3);
    scene.must_fail("render " + scene("cat.png") + " -o " + scene("new.svg") + " --detail 1.1",
                    "--detail: 1.1 is not possible");
}

TEST_CASE(
    "a white picture has no count of dots, which is said in one sentence; by scale or size it has none") {
    const Scene scene;
    write_picture(scene.folder / "white.png",
                  {.width = 30, .height = 20, .values = std::vector<float>(600, 1.0f)});
    const std::string from = "render " + scene("white.png") + " -o " + scene("new.svg");
    for (const std::string options : {"", " --tone true --relax 0"})
        scene.must_fail(from + options, "nothing to draw, as all of it is as light as the paper");
    for (const std::string options : {" --scale 100", " --dot-radius 0.1..0.4"})
        CHECK(run_dapple(from + options).status == 0);
}
