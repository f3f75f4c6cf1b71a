// `dapple testsheet`, read as a plotter reads it, and dot gain, which is read off it.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "core/strokes/strokes.h"
#include "io/files/picture.h"
#include "tests/machines.h"
#include "tests/render_scene.h"

namespace dapple {
namespace {

constexpr double kPxPerMm = 96 / 25.4;

// What a plotter makes of a layer, in millimetres.
struct Layer {
    std::string label;
    double width = 0;
    std::vector<glm::dvec2> dots = {};                // the short lines
    std::vector<std::vector<glm::dvec2>> lines = {};  // the others
};

std::vector<Layer> layers_of(const std::string& file) {
    const Svg svg = read_svg(file);
    std::vector<Layer> layers;
    for (const pugi::xml_node& group : svg.document.child("svg").children("g")) {
        Layer layer{.label = group.attribute("inkscape:label").value(),
                    .width = group.attribute("stroke-width").as_double() / kPxPerMm};
        for (const pugi::xml_node& path : group.children("path")) {
            std::string d = path.attribute("d").value();
            REQUIRE(d.starts_with("M"));
            const bool dot = d.find('h') != std::string::npos;
            std::ranges::replace_if(
                d, [](char c) { return std::strchr("MLh,", c) != nullptr; }, ' ');
            std::istringstream in(d);
            std::vector<double> values;
            for (double value = 0; in >> value;) values.push_back(value / kPxPerMm);
            if (dot) {
                REQUIRE(values.size() == 3);
                CHECK(values[2] < 0.06);
                layer.dots.emplace_back(values[0] + values[2] / 2, values[1]);
                continue;
            }
            REQUIRE(values.size() >= 4);
            std::vector<glm::dvec2>& line = layer.lines.emplace_back();
            for (std::size_t i = 0; i + 1 < values.size(); i += 2)
                line.emplace_back(values[i], values[i + 1]);
        }
        layers.push_back(std::move(layer));
    }
    return layers;
}

// The share that discs of that width cover of the middle of the box around these dots.
double covered_share(const std::vector<glm::dvec2>& dots, double width) {
    glm::dvec2 low = dots[0], high = dots[0];
    for (const glm::dvec2 dot : dots) {
        low = glm::min(low, dot);
        high = glm::max(high, dot);
    }
    const glm::dvec2 edge = (high - low) * 0.15;
    low += edge, high -= edge;
    constexpr int kSide = 300;
    int covered = 0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const glm::dvec2 at = low + (high - low) * glm::dvec2(x + 0.5, y + 0.5) / double(kSide);
            covered +=
                std::ranges::any_of(dots, [&](glm::dvec2 dot) { return glm::distance(at, dot) < width / 2; });
        }
    return covered / double(kSide * kSide);
}

}  // namespace

TEST_CASE("a test sheet has each pen's single dots, pairs at growing gaps, and tones of so much ink") {
    const Scene scene;
    const Outcome made =
        run_dapple("testsheet --pens 'Ink:#111:0.5+0.1,Sky:#3aa0d8:0.3' -o " + scene("t.svg"));
    CAPTURE(made.err);
    REQUIRE(made.status == 0);
    const std::vector<Layer> layers = layers_of(scene("t.svg"));
    REQUIRE(layers.size() == 2);
    CHECK(layers[0].label == "1 Sky");
    CHECK(layers[1].label == "2 Ink");
    struct Told {
        double width, dot, step;
        std::size_t gaps;
    };
    const Told told[] = {{0.3, 0.3, 0.02, 16}, {0.5, 0.6, 0.05, 14}};
    for (std::size_t pen = 0; pen < 2; ++pen) {
        const auto [width, dot_width, step, gaps] = told[pen];
        const Layer& layer = layers[pen];
        CHECK(layer.width == doctest::Approx(width).epsilon(0.002));
        for (const glm::dvec2 dot : layer.dots) {
            CHECK(std::min(dot.x, dot.y) > 13);
            CHECK(std::max(dot.x - 210, dot.y - 297) < -13);
        }
        // Crosses to lay one pen's sheet over the other's by: two lines in each corner.
        std::set<std::pair<bool, bool>> corners;
        std::size_t marks = 0;
        for (const auto& line : layer.lines) {
            const glm::dvec2 middle = (line.front() + line.back()) / 2.0;
            const bool at_side = middle.x < 9.1 || middle.x > 200.9;
            if (!at_side || (middle.y > 9.1 && middle.y < 287.9)) continue;
            corners.emplace(middle.x < 100, middle.y < 100);
            ++marks;
        }
        CHECK(corners.size() == 4);
        CHECK(marks == 8);

        auto dot = layer.dots.begin();
        for (int i = 0; i < 10; ++i, ++dot) CHECK(dot->y == layer.dots[0].y);
        // From edge to edge, if its dots were as wide as the pen; two decimals of a px are 0.003 mm.
        for (std::size_t i = 0; i < gaps; ++i)
            for (int alike = 0; alike < 3; ++alike) {
                const glm::dvec2 first = *dot++, second = *dot++;
                CHECK(second.x == doctest::Approx(first.x));
                CHECK(std::abs(second.y - first.y - width - double(i) * step) < 0.004);
            }
        // Tones lie side by side.
        std::map<int, std::vector<glm::dvec2>> tones;
        for (; dot != layer.dots.end(); ++dot) tones[int((dot->x - 14) / (182 / 6.0))].push_back(*dot);
        REQUIRE(tones.size() == 6);
        const double shares[] = {0.1, 0.25, 0.5, 0.75, 0.9, 1};
        for (const auto& [place, dots] : tones) {
            CAPTURE(place);
            CHECK(std::abs(covered_share(dots, dot_width) - shares[place]) < 0.03);
        }
    }
}

TEST_CASE("the other formats of a test sheet have the same dots, pen by pen") {
    const Scene scene;
    const std::string sheet = "testsheet --pens 'Ink:#111:0.5,Sky:#3aa0d8:0.3' --page letter -o ";
    REQUIRE(run_dapple(sheet + scene("t.svg")).status == 0);
    const std::vector<Layer> layers = layers_of(scene("t.svg"));
    REQUIRE(layers.size() == 2);
    const std::size_t all = layers[0].dots.size() + layers[1].dots.size();
    const Outcome made = run_dapple(sheet + scene("t.gcode"));
    CAPTURE(made.err);
    REQUIRE(made.status == 0);
    CHECK(made.err.find("2 pens, ") != std::string::npos);
    const Plotted plotted = plotted_gcode(text_of(scene("t.gcode")), Lines::drawn);
    REQUIRE(plotted.changes.size() == 2);
    CHECK(plotted.changes[1].pen == "2 Ink");
    CHECK(plotted.changes[1].first_dot == layers[0].dots.size());
    REQUIRE(plotted.dots.size() == all);
    for (std::size_t i = 0; i < layers[0].dots.size(); ++i)
        CHECK(glm::distance(plotted.dots[i], {layers[0].dots[i].x, 279.4 - layers[0].dots[i].y}) < 0.005);
    for (const char* name : {"t.hpgl", "t.pdf", "t.dxf", "t.png"}) {
        CAPTURE(name);
        CHECK(run_dapple(sheet + scene(name)).status == 0);
        CHECK(std::filesystem::file_size(scene(name)) > 3000);
    }
}

TEST_CASE("a test sheet that cannot be is told in a sentence, and nothing is written") {
    const Scene scene;
    const std::string to = " -o " + scene("old.svg");
    scene.must_fail("testsheet -o " + scene("a.svg"), "--pens is required");
    scene.must_fail("testsheet --pens cmyk" + to,
                    "--pens: Yellow has no width, which its dots are compared with");
    scene.must_fail("testsheet --pens one" + to, "--pens: one has no width or name");
    scene.must_fail("testsheet --pens auto:3:0.3" + to, "--pens: auto chooses pens for a picture");
    scene.must_fail("testsheet --pens A:#000:0.001" + to, "give the width of a real pen, 0.02 mm or more");
    scene.must_fail("testsheet --pens cmyk:3" + to, "a test sheet has room for up to 2 mm");
    scene.must_fail("testsheet --pens cmyk:0.3 --page a6" + to, "and the page is 105; give a4");
    scene.must_fail("testsheet --pens cmyk:2 --page 297x100" + to, "give fewer pens, or a larger page");
    scene.must_fail("testsheet --pens cmyk:0.3 -o " + scene("a.csv"), "a table has no lines");
    scene.must_fail("testsheet --pens cmyk:0.3 -o " + scene("a.doc"), "a.doc: a drawing's name must end in");
    scene.must_fail("testsheet --pens cmyk:0.3 -o " + scene("a.svg") + " --feed 100",
                    "--feed: applies to G-code");
    scene.must_fail("testsheet --pens cmyk:0.3 -o " + scene("none/a.svg"), "none");
    scene.must_fail("render --pens cmyk:0.3+wet -o " + scene("a.svg"), "--pens: wet cannot be a dot gain");
}

TEST_CASE("each letter of a pen's writing is another, and lies in its box") {
    std::set<std::vector<double>> seen;
    for (const char letter : std::string("ABCDEFGHIJKLMNOPQRSTUVWXYZ123456789.-+()_")) {
        CAPTURE(letter);
        Strokes strokes;
        add_text(strokes, std::string(1, letter), {10, 20}, 3, 1);
        REQUIRE(!strokes.points.empty());
        std::vector<double> numbers;
        for (const glm::dvec2 p : strokes.points) {
            CHECK((p.x >= 10 && p.x <= 12 && p.y >= 20 && p.y <= 23));
            numbers.insert(numbers.end(), {p.x, p.y});
        }
        for (std::size_t i = 0; i < strokes.ends.size(); ++i) {
            CHECK(pen_of(strokes, i) == 1);
            CHECK(strokes.ends[i] - (i == 0 ? 0 : strokes.ends[i - 1]) > 1);  // no touches
        }
        CHECK(seen.insert(numbers).second);
    }
    Strokes two;
    add_text(two, "i i", {0, 0}, 6, 0);
    CHECK(two.ends.size() == 6);
    CHECK(two.points.back().x == doctest::Approx(14));
    CHECK(text_width_mm("i i", 6) == doctest::Approx(16));
}

TEST_CASE("a pen with a dot gain makes the dots of a wider pen, and draws lines as fine as it is") {
    const Scene scene;
    write_picture(scene("cat.png"), coloured_picture());
    const auto drawn = [&](const std::string& pens, const std::string& name, const std::string& more = "") {
        const Outcome made = run_dapple("render " + scene("cat.png") + " --dots 2000 --width 60 --pens '" +
                                        pens + "' -o " + scene(name) + more);
        CAPTURE(made.err);
        REQUIRE(made.status == 0);
        return text_of(scene(name));
    };
    const std::string gains = "Pale:#9cf:0.3+0.1,Ink:#111:0.3", wide = "Pale:#9cf:0.4,Ink:#111:0.3",
                      none = "Pale:#9cf:0.3,Ink:#111:0.3";
    CHECK(drawn(gains, "a.csv") == drawn(wide, "b.csv"));
    CHECK(drawn(gains, "a.csv") != drawn(none, "c.csv"));
    drawn(gains, "a.png", " --dpi 200");
    drawn(wide, "b.png", " --dpi 200");
    CHECK(read_picture(scene("a.png")).light.values == read_picture(scene("b.png")).light.values);
    // In an SVG of touches the dots are as wide as they come out.
    drawn(gains, "a.svg");
    CHECK(layers_of(scene("a.svg"))[0].width == doctest::Approx(0.4).epsilon(0.002));
    CHECK(layers_of(scene("a.svg"))[1].width == doctest::Approx(0.3).epsilon(0.002));
    drawn(gains, "a.svg", " --style line");
    CHECK(layers_of(scene("a.svg"))[0].width == doctest::Approx(0.3).epsilon(0.002));
    // Touched dots that are wider overlap more.
    const auto overlapping = [&](const std::string& pens) {
        drawn(pens, "o.hpgl", " --stats " + scene("o.json"));
        const nlohmann::json stats = read_json(scene("o.json"));
        CHECK(stats["pens"][0].contains("gain_mm"));
        return stats["preflight"]["overlapping"].get<int>();
    };
    CHECK(overlapping("Pale:#9cf:0.3+0.4,Ink:#111:0.3+0.4") > overlapping("Pale:#9cf:0.3,Ink:#111:0.3"));
}

}  // namespace dapple
