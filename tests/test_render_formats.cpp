// dapple render: each kind of file, read by somebody else and compared with the table of the same dots.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "app/files/picture.h"
#include "tests/file_text.h"
#include "tests/machines.h"
#include "tests/render_scene.h"
#include "tests/shell.h"

using namespace dapple;

namespace {

constexpr double kWidth = 96, kHeight = 64;  // mm, as the scene's picture has pixels
const std::string kDrawing = " --dots 3000 --width 96 --order space -o ";

struct TableDot {
    glm::dvec2 at;  // mm from the upper left corner
    double radius;
};

void draw_to(const Scene& scene, const std::string& name, const std::string& options = "") {
    const Outcome outcome = run_dapple("render " + scene("cat.png") + kDrawing + scene(name) + " " + options);
    CAPTURE(outcome.err);
    REQUIRE(outcome.status == 0);
}

std::vector<TableDot> table_of(const Scene& scene, const std::string& options = "") {
    draw_to(scene, "dots.csv", options);
    std::istringstream lines(text_of(scene("dots.csv")));
    std::vector<TableDot> dots;
    std::string line;
    for (std::getline(lines, line); std::getline(lines, line);) {
        TableDot dot{};
        char comma = 0;
        std::istringstream(line) >> dot.at.x >> comma >> dot.at.y >> comma >> dot.radius;
        dots.push_back(dot);
    }
    REQUIRE(dots.size() == 3000);
    return dots;
}

// Largest distance between a dot of the table and the one of the same number that was plotted.
double farthest_off(const std::vector<TableDot>& table, const std::vector<glm::dvec2>& plotted) {
    REQUIRE(plotted.size() == table.size());
    double most = 0;
    for (std::size_t i = 0; i < table.size(); ++i) {
        const glm::dvec2 expected(table[i].at.x, kHeight - table[i].at.y);
        most = std::max(most, glm::distance(expected, plotted[i]));
    }
    return most;
}

// Root mean square of what two pictures of one size differ by, light 0..1; the second one moved so many
// pixels right and down.
double light_difference(const Picture& a, const Picture& b, int moved = 0) {
    REQUIRE(a.light.width == b.light.width);
    REQUIRE(a.light.height == b.light.height);
    double sum = 0;
    int count = 0;
    for (int y = moved; y < a.light.height; ++y) {
        for (int x = moved; x < a.light.width; ++x, ++count) {
            const double d = a.light.at(x, y) - b.light.at(x - moved, y - moved);
            sum += d * d;
        }
    }
    return std::sqrt(sum / count);
}

// Other people's programs, which packages.sh names.
void require_program(const std::string& command) {
    CAPTURE(command);
    REQUIRE(run_in_shell(command + " >/dev/null 2>&1").status == 0);
}

}  // namespace

TEST_CASE(
    "a machine that reads the G-code, or a plotter the HPGL, makes the dots of the table in its order") {
    const Scene scene;
    const std::vector<TableDot> table = table_of(scene);
    for (const std::string machine : {"pen", "servo", "laser"}) {
        CAPTURE(machine);
        draw_to(scene, "a.gcode", "--gcode " + machine + " --feed 1234.5 --dwell 0.25");
        const std::string text = text_of(scene("a.gcode"));
        CHECK(farthest_off(table, plotted_gcode(text).dots) < 0.00075);
        CHECK(text.find(" F1234.5\n") != text.npos);
        CHECK(text.find("G4 P0.25\n") != text.npos);
    }
    draw_to(scene, "a.nc");
    draw_to(scene, "b.gcode", "--gcode pen");
    CHECK(text_of(scene("a.nc")) == text_of(scene("b.gcode")));
    draw_to(scene, "a.hpgl");
    draw_to(scene, "a.plt");
    CHECK(farthest_off(table, plotted_hpgl(text_of(scene("a.hpgl"))).dots) < 0.018);
    CHECK(text_of(scene("a.hpgl")) == text_of(scene("a.plt")));
}

TEST_CASE("a template of one's own is followed to the letter, and one that is wrong is told with its line") {
    const Scene scene;
    put_text(scene("my.txt"),
             "# Mine\nstart ; begin {feed}\nend ; end\n  move X{x}Y{y}\ndot D{dwell}R{radius}\n");
    draw_to(scene, "a.nc", "--gcode " + scene("my.txt") + " --dot-radius 0.25");
    const std::string text = text_of(scene("a.nc"));
    CHECK(text.starts_with("; begin 3000\nX"));
    CHECK(text.ends_with("\nD0.1R0.25\n; end\n"));
    const std::vector<TableDot> table = table_of(scene);
    std::istringstream lines(text);
    std::string line;
    std::getline(lines, line);
    std::getline(lines, line);
    CHECK(std::stod(line.substr(1)) == doctest::Approx(table[0].at.x).epsilon(0.001));
    struct Wrong {
        const char *text, *words;
    };
    for (const Wrong& wrong :
         {Wrong{"start G21\nmoves X{x}", "wrong.txt: line 2: \"moves\" is not known; lines begin with"},
          Wrong{"move X{x} Y{z}", "line 1: \"{z}\" is not known"},
          Wrong{"move X{x} Y{y", "line 1: \"{y\" is not known"},
          Wrong{"move X{x}", "no line for a dot has {x} and {y}"},
          Wrong{"start {x}\nmove {x} {y}", "start and end lines have none"}}) {
        put_text(scene("wrong.txt"), wrong.text);
        scene.must_fail("render -o " + scene("b.nc") + " --gcode " + scene("wrong.txt"), wrong.words);
    }
    scene.must_fail("render -o " + scene("b.nc") + " --gcode plough",
                    "plough is neither pen, servo nor laser");
    scene.must_fail("render -o " + scene("b.svg") + " --gcode laser", "--gcode: is of G-code");
    scene.must_fail("render -o " + scene("b.nc") + " --feed 0", "--feed: 0 is not possible");
    scene.must_fail("render -o " + scene("b.plt") + " --ink '#f00'",
                    "--ink: a file for machines has no colours");
    scene.must_fail("render -o " + scene("b.dxf") + " --dpi 100", "--dpi: only a PNG or a TIFF has pixels");
}

TEST_CASE("ezdxf finds nothing wrong with the DXF, and circles that are the dots") {
    require_program("/usr/bin/python3 -c 'import ezdxf'");
    const Scene scene;
    const std::vector<TableDot> table = table_of(scene, "--dot-radius 0.345");
    draw_to(scene, "a.dxf", "--dot-radius 0.345");
    put_text(scene("read.py"),
             "import ezdxf, sys\n"
             "drawing = ezdxf.readfile(sys.argv[1])\n"
             "audit = drawing.audit()\n"
             "assert not audit.errors and not audit.fixes, (audit.errors, audit.fixes)\n"
             "for each in drawing.modelspace():\n"
             "    assert each.dxftype() == 'CIRCLE' and each.dxf.layer == 'Dots'\n"
             "    print(each.dxf.center.x, each.dxf.center.y, each.dxf.radius)\n");
    const Outcome read = run_in_shell("/usr/bin/python3 " + scene("read.py") + " " + scene("a.dxf"));
    CAPTURE(read.err);
    REQUIRE(read.status == 0);
    std::istringstream in(read.out);
    std::vector<glm::dvec2> circles;
    glm::dvec2 at{};
    for (double radius = 0; in >> at.x >> at.y >> radius;) {
        CHECK(radius == doctest::Approx(table[circles.size()].radius).epsilon(0.005));
        circles.push_back(at);
    }
    CHECK(farthest_off(table, circles) < 0.00075);
}

TEST_CASE("JSON has the numbers of the table, named as there") {
    const Scene scene;
    static_cast<void>(table_of(scene));
    draw_to(scene, "a.json");
    const nlohmann::json drawing = read_json(scene("a.json"));
    CHECK(drawing["page"] == nlohmann::json{{"width_mm", kWidth}, {"height_mm", kHeight}});
    CHECK(drawing["unit"] == "mm");
    const auto joined = [](const nlohmann::json& values) {
        std::string line;
        for (const auto& value : values)
            line += (line.empty() ? "" : ",") + (value.is_string() ? value.get<std::string>() : value.dump());
        return line;
    };
    std::istringstream lines(text_of(scene("dots.csv")));
    std::string line;
    std::getline(lines, line);
    // The table says the page with each dot, JSON once.
    CHECK(joined(drawing["columns"]) + ",page_width_mm,page_height_mm" == line);
    REQUIRE(drawing["dots"].size() == 3000);
    for (nlohmann::json dot : drawing["dots"]) {
        REQUIRE(std::getline(lines, line));
        dot.push_back(drawing["page"]["width_mm"]);
        dot.push_back(drawing["page"]["height_mm"]);
        REQUIRE(nlohmann::json::parse("[" + line + "]") == dot);
    }
}

TEST_CASE(
    "poppler finds the page's exact size and title in the PDF, and draws what librsvg draws of the SVG") {
    require_program("pdfinfo -v");
    require_program("rsvg-convert --version");
    const Scene scene;
    for (const std::string options : {"--dot-radius 0.4 --ink '#a03010'",
                                      "--dot-radius 0.2..0.5 --relax 2 --background --paper '#ffe0a0'"}) {
        CAPTURE(options);
        // Two radii make a number of their own.
        const bool by_tone = options.find("..") != options.npos;
        for (const std::string name : {"a.svg", "My cat.pdf"}) {
            const Outcome drawn = run_dapple("render " + scene("cat.png") + (by_tone ? "" : " --dots 3000") +
                                             " --width 96 -o '" + scene(name) + "' " + options);
            CAPTURE(drawn.err);
            REQUIRE(drawn.status == 0);
        }
        const std::string info = run_in_shell("pdfinfo '" + scene("My cat.pdf") + "'").out;
        std::smatch size;
        REQUIRE(std::regex_search(info, size, std::regex("Page size: +([0-9.]+) x ([0-9.]+) pts")));
        CHECK(std::stod(size[1]) == doctest::Approx(kWidth / 25.4 * 72).epsilon(1e-5));
        CHECK(std::stod(size[2]) == doctest::Approx(kHeight / 25.4 * 72).epsilon(1e-5));
        CHECK(std::regex_search(info, std::regex("Title: +My cat\n")));
        CHECK(std::regex_search(info, std::regex("Pages: +1\n")));
        const Outcome drawn =
            run_in_shell("pdftoppm -scale-to-x 960 -scale-to-y 640 -singlefile -png '" + scene("My cat.pdf") +
                         "' " + scene("pdf") + " && rsvg-convert -w 960 -h 640 -b white " + scene("a.svg") +
                         " -o " + scene("svg.png"));
        CAPTURE(drawn.err);
        REQUIRE(drawn.status == 0);
        const Picture pdf = read_picture(scene("pdf.png")), svg = read_picture(scene("svg.png"));
        // Only how edges are smoothed: a pixel, 0.1 mm, makes more of a difference.
        CHECK(light_difference(pdf, svg) < 0.07);
        CHECK(light_difference(pdf, svg, 1) > 0.14);
    }
}

TEST_CASE("a TIFF has the pixels of the PNG and its size on paper, with 8 bits or with 16") {
    const Scene scene;
    for (const std::string colours : {"", "--ink '#a03010'", "--bits 16", "--bits 16 --ink '#a03010'"}) {
        CAPTURE(colours);
        const std::string from =
            "render " + scene("cat.png") + " --dots 2000 --width 60 --dpi 150.5 " + colours;
        REQUIRE(run_dapple(from + " -o " + scene("a.png")).status == 0);
        REQUIRE(run_dapple(from + " -o " + scene("a.tif")).status == 0);
        const Picture png = read_picture(scene("a.png")), tiff = read_picture(scene("a.tif"));
        const bool deep = colours.find("16") != colours.npos;
        // The two readers round the light of a colour with 16 bits each in its own way.
        CHECK(light_difference(png, tiff) <= (deep ? 1e-5 : 0));
        for (const Picture* picture : {&png, &tiff})
            CHECK((picture->description.find("16-bit") != std::string::npos) == deep);
        const std::set<float> tones(png.light.values.begin(), png.light.values.end());
        CHECK((tones.size() > 256) == deep);  // a pixel has 257 shares of ink; 8 bits cannot tell all apart
        const Outcome info = run_in_shell("tiffinfo -D " + scene("a.tif"));
        CHECK(info.status == 0);
        CHECK(info.err.empty());
        CHECK(info.out.find("Resolution: 150.5, 150.5 pixels/inch") != std::string::npos);
    }
}

TEST_CASE(
    "a picture comes through the standard input and a drawing goes to the standard output as with files") {
    const Scene scene;
    const std::string file = "render " + scene("cat.png") + " --dots 2000 -o ";
    const auto piped = [&](const std::string& options) {
        return run_in_shell("cat " + scene("cat.png") + " | \"$DAPPLE\" render - --dots 2000 -o - " +
                            options + " | cat");
    };
    REQUIRE(run_dapple(file + scene("a.svg")).status == 0);
    CHECK(piped("").out == text_of(scene("a.svg")));
    REQUIRE(run_dapple(file + scene("a.png") + " --dpi 60").status == 0);
    CHECK(piped("--format png --dpi 60").out == text_of(scene("a.png")));
    CHECK(piped("--format pdf").out.starts_with("%PDF-"));
    // A file is added to, not replaced.
    REQUIRE(run_in_shell("echo first >" + scene("b.plt") + "; \"$DAPPLE\" " + file + "- --format hpgl >>" +
                         scene("b.plt"))
                .status == 0);
    CHECK(text_of(scene("b.plt")).starts_with("first\nIN;SP1;\n"));
    CHECK(piped("--format tif").err.find("--format: tif is not written from its beginning") !=
          std::string::npos);
    CHECK(run_in_shell("echo no picture | \"$DAPPLE\" render - -o " + scene("c.svg"))
              .err.starts_with("dapple: the standard input: "));
    CHECK(run_in_shell("\"$DAPPLE\" " + file + "- >/dev/full").err.find("the standard output: cannot be") !=
          std::string::npos);
    scene.must_fail(file + scene("c.svg") + " --format png", "--format: png, but the name");
}

TEST_CASE("one line goes through all dots, each once: in an SVG, in G-code, and as short as it is told") {
    const Scene scene;
    const std::string picture = scene("cat.png");
    const Outcome told = run_dapple("render " + picture + " --dots 2000 --width 96 --style line --stats " +
                                    scene("a.json") + " -o " + scene("a.svg"));
    CAPTURE(told.err);
    REQUIRE(told.status == 0);
    CHECK(told.err.find("the pen draws 1 line of ") != std::string::npos);
    const std::string svg = text_of(scene("a.svg"));
    // As svg says it, in px from the upper left corner.
    const std::size_t begin = svg.find("<path d=\"M") + 10;
    REQUIRE(svg.find("<path", begin) == std::string::npos);
    std::string path = svg.substr(begin, svg.find('"', begin) - begin);
    for (char& c : path)
        if (c == 'L') c = ' ';
    std::vector<glm::dvec2> line;
    std::istringstream numbers(path);
    for (glm::dvec2 p; numbers >> p.x >> p.y;) line.push_back(p * 25.4 / 96.0);
    REQUIRE(line.size() == 2000);
    double length = 0;
    for (std::size_t i = 1; i < line.size(); ++i) length += glm::distance(line[i - 1], line[i]);
    CHECK(std::abs(length / 1000 - std::stod(told.err.substr(told.err.find("line of ") + 8))) < 0.06);
    // The shortest of all is about 0.7124 sqrt(n A) for dots all over a page (Applegate and others 2006), and
    // less where they crowd.
    CHECK(length < 0.93 * std::sqrt(2000 * kWidth * kHeight));
    REQUIRE(run_dapple("render " + picture + " --dots 2000 --width 96 --style line -o " + scene("a.gcode"))
                .status == 0);
    const Plotted plot = plotted_gcode(text_of(scene("a.gcode")), Lines::drawn);
    REQUIRE(plot.lines.size() == 1);
    REQUIRE(plot.lines[0].size() == line.size());
    double most = 0;
    for (std::size_t i = 0; i < line.size(); ++i)
        most = std::max(most, glm::distance(plot.lines[0][i], glm::dvec2(line[i].x, kHeight - line[i].y)));
    CHECK(most < 0.005);
}
