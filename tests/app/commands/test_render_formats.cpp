// dapple render: each kind of file, read by somebody else and compared with the table of the same dots.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <nlohmann/json.hpp>
#include <numeric>
#include <pugixml.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "io/files/picture.h"
#include "tests/file_text.h"
#include "tests/machines.h"
#include "tests/render_scene.h"
#include "tests/run_in_shell.h"

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
    draw_to(scene, "a.gcode", "--gcode servo --pen-up 12.5 --pen-down 70");
    CHECK(text_of(scene("a.gcode")).find("\nM3 S70\nG4 P0.1\nM3 S12.5\n") != std::string::npos);
    draw_to(scene, "a.gcode", "--gcode laser --laser-power 800");
    CHECK(text_of(scene("a.gcode")).find("\nM3 S800\n") != std::string::npos);
    draw_to(scene, "a.gcode", "--pen-up 5 --pen-down -0.5");
    CHECK(text_of(scene("a.gcode")).find("\nG1 Z-0.5 F3000\nG4 P0.1\nG0 Z5\n") != std::string::npos);
    draw_to(scene, "a.gcode", "--dwell 0.00025");
    CHECK(text_of(scene("a.gcode")).find("G4 P0.00025\n") != std::string::npos);
    draw_to(scene, "a.nc");
    draw_to(scene, "b.gcode", "--gcode pen");
    CHECK(text_of(scene("a.nc")) == text_of(scene("b.gcode")));
    draw_to(scene, "a.hpgl");
    draw_to(scene, "a.plt");
    CHECK(farthest_off(table, plotted_hpgl(text_of(scene("a.hpgl"))).dots) < 0.018);
    CHECK(text_of(scene("a.hpgl")) == text_of(scene("a.plt")));
}

TEST_CASE("short bursts of a laser are moves with the beam on, for as long as the dwell says, and no rests") {
    const Scene scene;
    const std::vector<TableDot> table = table_of(scene);
    for (const double dwell : {0.0005, 0.01, 0.049}) {
        CAPTURE(dwell);
        draw_to(scene, "a.gcode", "--gcode laser --laser-power 300 --dwell " + std::to_string(dwell));
        const std::string text = text_of(scene("a.gcode"));
        CHECK(text.find("G4") == text.npos);
        CHECK(text.find("M4 S300\n") != text.npos);
        const Plotted plot = plotted_gcode(text);
        CHECK(farthest_off(table, plot.dots) < 0.026);
        REQUIRE(plot.bursts_s.size() == table.size());
        for (const double seconds : plot.bursts_s) REQUIRE(seconds == doctest::Approx(dwell).epsilon(0.001));
    }
    draw_to(scene, "a.gcode", "--gcode laser --dwell 0.05");
    CHECK(plotted_gcode(text_of(scene("a.gcode"))).bursts_s.empty());
    // Lines have no bursts.
    draw_to(scene, "a.gcode", "--gcode laser --dwell 0.01 --style line");
    const Plotted line = plotted_gcode(text_of(scene("a.gcode")), Lines::drawn);
    CHECK(line.lines.size() == 1);
    CHECK(line.bursts_s.empty());
}

TEST_CASE("a file for a machine says at its head what is in it and how long it takes, as the command does") {
    const Scene scene;
    for (const std::string name : {"a.gcode --gcode laser", "a.hpgl", "a.gcode --style line"}) {
        CAPTURE(name);
        const Outcome outcome = run_dapple("render " + scene("cat.png") + kDrawing + scene("") + name);
        REQUIRE(outcome.status == 0);
        const std::string text = text_of(scene(name.substr(0, name.find(' '))));
        const std::string head =
            text.substr(0, text.find("IN;") == text.npos ? text.find("G21") : text.find("IN;"));
        CHECK(head.find("3,000 dots on a page of 96 x 64 mm") != head.npos);
        CHECK(head.find("0 0 is the lower left corner") != head.npos);
        const std::size_t about = head.find("about ");
        REQUIRE(about != head.npos);
        const std::string time = head.substr(about, head.find_first_of("\n\"", about) - about);
        CHECK(outcome.err.find(time) != std::string::npos);
    }
}

TEST_CASE("dots of several sizes are filled by the pen in G-code and HPGL, but where a template has radii") {
    const Scene scene;
    const std::string from = "render " + scene("cat.png") + " --width 96 --dot-radius 0.2..0.9 ";
    REQUIRE(run_dapple(from + "-o " + scene("a.csv")).status == 0);
    std::istringstream table(text_of(scene("a.csv")));
    std::string line;
    double area = 0;
    for (std::getline(table, line); std::getline(table, line);) {
        std::istringstream numbers(line);
        double x = 0, y = 0, radius = 0;
        char comma = 0;
        numbers >> x >> comma >> y >> comma >> radius;
        area += std::acos(-1) * radius * radius;
    }
    for (const std::string name : {"a.gcode", "a.hpgl"}) {
        CAPTURE(name);
        REQUIRE(run_dapple(from + "--pen-width 0.3 -o " + scene(name)).status == 0);
        const std::string text = text_of(scene(name));
        const Plotted plot =
            name == "a.hpgl" ? plotted_hpgl(text, Lines::drawn) : plotted_gcode(text, Lines::drawn);
        // Each is as wide as its spiral, with half the pen on either side.
        double drawn = static_cast<double>(plot.dots.size()) * std::acos(-1) * 0.15 * 0.15;
        for (const auto& points : plot.lines) {
            const auto [left, right] = std::ranges::minmax(points, {}, &glm::dvec2::x);
            const double radius = (right.x - left.x + 0.3) / 2;
            drawn += std::acos(-1) * radius * radius;
        }
        CHECK(drawn == doctest::Approx(area).epsilon(0.03));
    }
    put_text(scene("radii.txt"), "start G21\nmove G1 X{x} Y{y}\ndot R{radius}\n");
    REQUIRE(run_dapple(from + "--gcode " + scene("radii.txt") + " -o " + scene("a.gcode")).status == 0);
    const std::string text = text_of(scene("a.gcode"));
    double told = 0;
    for (std::size_t at = text.find('R'); at != text.npos; at = text.find('R', at + 1)) {
        const double radius = std::stod(text.substr(at + 1, 10));
        told += std::acos(-1) * radius * radius;
    }
    CHECK(told == doctest::Approx(area).epsilon(0.01));
}

TEST_CASE("a pen's width alone makes each dot of a plot a touch of it, and the tone is that of its touches") {
    const Scene scene;
    const auto finding = [&](const std::string& options) {
        const Outcome outcome = run_dapple("render " + scene("cat.png") + kDrawing + options + " --advice");
        CAPTURE(outcome.err);
        REQUIRE(outcome.status == 0);
        return outcome.err.find("The drawing will look paler than the picture. ") != std::string::npos;
    };
    CHECK(finding(scene("a.svg") + " --pen-width 0.1"));
    CHECK(read_svg(scene("a.svg")).circles().empty());
    CHECK(finding(scene("a.svg") + " --dot-shape point --pen-width 0.1"));
    CHECK(finding(scene("a.hpgl")));  // a pen is 0.3 mm wide unless one says so, and these dots 1.2
    CHECK_FALSE(finding(scene("b.hpgl") + " --dot-radius 0.6 --pen-width 0.3"));
    CHECK(plotted_hpgl(text_of(scene("b.hpgl")), Lines::drawn).lines.size() == 3000);
    scene.must_fail("render -o " + scene("c.svg") + " --dot-radius 0.1 --pen-width 0.3",
                    "--dot-radius: cannot be below 0.15 mm with a pen 0.3 mm wide");
    scene.must_fail("render -o " + scene("c.pdf") + " --pen-width 0.3",
                    "--pen-width: applies to a plotter's pen");
}

TEST_CASE("a template of one's own is followed to the letter, and one that is wrong is told with its line") {
    const Scene scene;
    put_text(scene("my.txt"),
             "# Mine\nstart ; begin {feed}\nend ; end\n  move X{x}Y{y}\ndot D{dwell}R{radius}\n");
    draw_to(scene, "a.nc", "--gcode " + scene("my.txt") + " --dot-radius 0.25");
    const std::string text = text_of(scene("a.nc"));
    CHECK(text.starts_with("; begin 3000\nX"));
    CHECK(text.ends_with("\nD0.1R0.25\n; end\n"));
    const std::vector<TableDot> table = table_of(scene, "--dot-radius 0.25");
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
          Wrong{"start {x}\nmove {x} {y}", "leave them out of start, pen and end lines"}}) {
        put_text(scene("wrong.txt"), wrong.text);
        scene.must_fail("render -o " + scene("b.nc") + " --gcode " + scene("wrong.txt"), wrong.words);
    }
    // One of touches alone draws touches, whatever they are of.
    put_text(scene("touch.txt"), "start G21\nmove G0 X{x} Y{y}\ndot M3\n");
    CHECK(run_dapple("render --dots 20 --dot-shape point -o " + scene("touch.nc") + " --gcode " +
                     scene("touch.txt"))
              .status == 0);
    scene.must_fail(
        "render --dots 20 --dot-shape cross -o " + scene("cross.nc") + " --gcode " + scene("touch.txt"),
        "does not say how to draw lines");
    scene.must_fail("render -o " + scene("b.nc") + " --pen-up 0 --pen-down 0",
                    "--pen-down: the pen is up at 0 and down at 0, so it would never be lifted");
    scene.must_fail("render -o " + scene("b.nc") + " --gcode servo --pen-up 90",
                    "--pen-up: the pen is up at 90 and down at 90");
    scene.must_fail("render -o " + scene("b.nc") + " --gcode plough", "plough is not pen, servo, laser");
    scene.must_fail("render -o " + scene("b.svg") + " --gcode laser", "--gcode: applies to G-code only");
    scene.must_fail("render -o " + scene("b.nc") + " --feed 0", "--feed: 0 is not possible");
    scene.must_fail("render -o " + scene("b.plt") + " --ink '#f00'",
                    "--ink: a file for machines has no colours");
    scene.must_fail("render -o " + scene("b.dxf") + " --dpi 100", "--dpi: only a PNG or a TIFF has pixels");
}

TEST_CASE(
    "ezdxf reads lines of a DXF in millimetres, through the dots in their order, and touches as points") {
    require_program("/usr/bin/python3 -c 'import ezdxf'");
    const Scene scene;
    draw_to(scene, "a.dxf", "--style line");
    draw_to(scene, "a.gcode", "--style line");
    draw_to(scene, "b.dxf", "--dot-shape point --pens 'Ink:#000:0.3,Red:#f00:0.3'");
    put_text(scene("read.py"),
             "import ezdxf, sys\n"
             "for name in sys.argv[1:]:\n"
             "    drawing = ezdxf.readfile(name)\n"
             "    audit = drawing.audit()\n"
             "    assert not audit.errors and not audit.fixes, (audit.errors, audit.fixes)\n"
             "    assert drawing.units == ezdxf.units.MM and drawing.header['$MEASUREMENT'] == 1\n"
             "    for each in drawing.modelspace():\n"
             "        assert each.dxftype() == ('LWPOLYLINE' if each.dxf.layer == 'Lines' else 'POINT')\n"
             "        if each.dxftype() == 'POINT': continue\n"
             "        for x, y in each.get_points('xy'): print(x, y)\n");
    const Outcome read =
        run_in_shell("/usr/bin/python3 " + scene("read.py") + " " + scene("a.dxf") + " " + scene("b.dxf"));
    CAPTURE(read.err);
    REQUIRE(read.status == 0);
    std::istringstream in(read.out);
    std::vector<glm::dvec2> places;
    for (glm::dvec2 at{}; in >> at.x >> at.y;) places.push_back(at);
    const Plotted machine = plotted_gcode(text_of(scene("a.gcode")), Lines::drawn);
    REQUIRE(machine.lines.size() == 1);
    REQUIRE(places.size() == machine.lines[0].size());
    for (std::size_t i = 0; i < places.size(); ++i)
        REQUIRE(glm::distance(places[i], machine.lines[0][i]) < 1e-6);
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
             "assert drawing.dxfversion == 'AC1015' and drawing.units == ezdxf.units.MM\n"
             "assert drawing.header['$MEASUREMENT'] == 1\n"
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

TEST_CASE("of several pens each has its own dots, in tables, on machines and on the layers of a DXF") {
    const Scene scene;
    write_picture(scene("cat.png"), coloured_picture());
    const std::string pens = "--pens 'Pale (blue):#9cf:0.4,Rust red:#b52:0.4,Ink:#111:0.4' --dot-radius 0.2";
    const std::vector<TableDot> table = table_of(scene, pens);
    const std::vector<std::string> names{"Pale (blue)", "Rust red", "Ink"};  // the lightest first
    std::vector<std::size_t> pen_of;                                         // each dot's, by the table
    std::istringstream lines(text_of(scene("dots.csv")));
    std::string line;
    std::getline(lines, line);
    CHECK(line.ends_with(",critical_scale,page_width_mm,page_height_mm,pen"));
    while (std::getline(lines, line)) {
        const auto name = std::ranges::find(names, line.substr(line.rfind(',') + 1));
        REQUIRE(name != names.end());
        pen_of.push_back(static_cast<std::size_t>(name - names.begin()));
    }
    REQUIRE(pen_of.size() == table.size());
    CHECK(std::ranges::is_sorted(pen_of));
    std::vector<std::size_t> first_dots;  // of each pen
    for (std::size_t pen = 0; pen < 3; ++pen)
        first_dots.push_back(static_cast<std::size_t>(std::ranges::find(pen_of, pen) - pen_of.begin()));
    CHECK(first_dots[1] > 50);
    CHECK(first_dots[2] > first_dots[1] + 50);
    CHECK(first_dots[2] < table.size() - 50);

    const auto check_changes = [&](const Plotted& plotted, const std::vector<std::string>& words) {
        REQUIRE(plotted.changes.size() == 3);
        for (std::size_t pen = 0; pen < 3; ++pen) {
            CHECK(plotted.changes[pen].pen == words[pen]);
            CHECK(plotted.changes[pen].first_dot == first_dots[pen]);
        }
    };
    for (const std::string machine : {"pen", "servo", "laser"}) {
        CAPTURE(machine);
        draw_to(scene, "a.gcode", pens + " --gcode " + machine);
        const Plotted plotted = plotted_gcode(text_of(scene("a.gcode")));
        CHECK(farthest_off(table, plotted.dots) < 0.00075);
        check_changes(plotted, {"1 Pale [blue]", "2 Rust red", "3 Ink"});
    }
    draw_to(scene, "a.hpgl", pens);
    check_changes(plotted_hpgl(text_of(scene("a.hpgl"))), {"1", "2", "3"});
    put_text(scene("one.txt"), "move X{x} Y{y}\n");
    scene.must_fail("render -o " + scene("b.nc") + " " + pens + " --gcode " + scene("one.txt"),
                    "the template for G-code does not say how pens are changed");

    draw_to(scene, "a.json", pens);
    const nlohmann::json read_back = nlohmann::json::parse(text_of(scene("a.json")));
    REQUIRE(read_back["pens"].size() == 3);
    CHECK(read_back["columns"].back() == "pen");
    for (std::size_t pen = 0; pen < 3; ++pen) CHECK(read_back["pens"][pen]["name"] == names[pen]);
    CHECK(read_back["pens"][1]["colour"] == "#bb5522");
    CHECK(read_back["pens"][1]["width_mm"] == 0.4);
    REQUIRE(read_back["dots"].size() == table.size());
    for (std::size_t i = 0; i < table.size(); ++i) CHECK(read_back["dots"][i].back() == pen_of[i]);

    require_program("/usr/bin/python3 -c 'import ezdxf'");
    draw_to(scene, "a.dxf", pens);
    put_text(scene("read.py"),
             "import ezdxf, sys\n"
             "from ezdxf.colors import aci2rgb\n"
             "drawing = ezdxf.readfile(sys.argv[1])\n"
             "audit = drawing.audit()\n"
             "assert not audit.errors and not audit.fixes, (audit.errors, audit.fixes)\n"
             "wanted = {'1_Pale__blue_': (0x99, 0xcc, 0xff), '2_Rust_red': (0xbb, 0x55, 0x22), '3_Ink': "
             "(17, 17, 17)}\n"
             "for name, rgb in wanted.items():\n"
             "    off = lambda n: sum((a - b) ** 2 for a, b in zip(aci2rgb(n), rgb)) ** 0.5\n"
             "    colour = drawing.layers.get(name).dxf.color\n"
             "    nearest = min([n for n in range(1, 256) if n != 7], key=off)\n"
             "    assert colour == 7 or off(colour) < off(nearest) + 25, (name, colour, nearest)\n"
             "    assert colour != 7 or sum(rgb) < 60, name\n"
             "for each in drawing.modelspace(): print(each.dxf.layer)\n");
    const Outcome read = run_in_shell("/usr/bin/python3 " + scene("read.py") + " " + scene("a.dxf"));
    CAPTURE(read.err);
    REQUIRE(read.status == 0);
    std::istringstream layers(read.out);
    const std::vector<std::string> layer_names{"1_Pale__blue_", "2_Rust_red", "3_Ink"};
    for (std::size_t i = 0; i < table.size(); ++i) {
        std::getline(layers, line);
        CHECK(line == layer_names[pen_of[i]]);
    }
}

TEST_CASE("of several pens the one that draws first is the lightest, the darkest or the first of the list") {
    const Scene scene;
    const auto layers = [&](const std::string& options) {
        REQUIRE(run_dapple("render " + scene("cat.png") + " --dots 300 " + options + " -o " + scene("p.svg"))
                    .status == 0);
        std::vector<std::string> names;
        pugi::xml_document svg;
        REQUIRE(svg.load_file(scene("p.svg").c_str()));
        for (const auto& found : svg.select_nodes("//*[@inkscape:label]"))
            names.emplace_back(found.node().attribute("inkscape:label").value());
        return names;
    };
    const std::string pens = "--pens Night:#102060,Pale:#b0d8e8,Sand:#d0a040 ";
    using Names = std::vector<std::string>;
    CHECK(layers(pens) == Names{"1 Pale", "2 Sand", "3 Night"});
    CHECK(layers(pens + "--pen-order darkest") == Names{"1 Night", "2 Sand", "3 Pale"});
    CHECK(layers("--pen-order listed " + pens) == Names{"1 Night", "2 Pale", "3 Sand"});
}

TEST_CASE(
    "readers of SVG and PDF see the inks of overlapping dots both, or the upper one, as the PNG has them") {
    require_program("rsvg-convert --version");
    require_program("pdftoppm -v");
    const Scene scene;
    // So large that they overlap nearly everywhere.
    const std::string options = "render " + scene("cat.png") +
                                " --dots 300 --width 60 --dot-radius 3 --pens "
                                "Sun:#ffe000:6,Sky:#40c0ff:6,Rose:#ff60a0:6 --background --paper '#f1ead8' ";
    std::array<double, 2> mean_light{};
    for (const bool transparent : {true, false}) {
        const std::string ink = transparent ? "" : "--pen-ink opaque ";
        for (const char* name : {"p.svg", "p.pdf", "p.png"})
            REQUIRE(run_dapple(options + ink + (name == std::string("p.png") ? "--dpi 254 -o " : "-o ") +
                               scene(name))
                        .status == 0);
        const Outcome shown =
            run_in_shell("rsvg-convert -w 600 -h 400 " + scene("p.svg") + " -o " + scene("svg.png") +
                         " && pdftoppm -scale-to-x 600 -scale-to-y 400 -singlefile -png " + scene("p.pdf") +
                         " " + scene("pdf"));
        CAPTURE(shown.err);
        REQUIRE(shown.status == 0);
        const Picture svg = read_picture(scene("svg.png")), pdf = read_picture(scene("pdf.png")),
                      png = read_picture(scene("p.png"));
        CHECK(light_difference(svg, png) < 0.05);
        CHECK(light_difference(pdf, png) < 0.05);
        const std::vector<float>& light = png.light.values;
        mean_light[transparent ? 0 : 1] =
            std::accumulate(light.begin(), light.end(), 0.0) / static_cast<double>(light.size());
    }
    CHECK(mean_light[0] < mean_light[1] - 0.03);
}

TEST_CASE("the layers of an SVG, plotted one after the other, touch no place twice") {
    const Scene scene;
    REQUIRE(
        run_dapple("render " + scene("cat.png") + " --dots 900 --width 60 --pens cmyk -o " + scene("p.svg"))
            .status == 0);
    pugi::xml_document svg;
    REQUIRE(svg.load_file(scene("p.svg").c_str()));
    std::vector<glm::dvec2> touched;
    std::size_t layers = 0;
    for (const auto& found : svg.select_nodes("//g[@inkscape:groupmode='layer']")) {
        const std::size_t before = touched.size();
        for (const pugi::xml_node& dot : found.node().children("circle"))
            touched.emplace_back(dot.attribute("cx").as_double(), dot.attribute("cy").as_double());
        layers += touched.size() > before;
    }
    CHECK(layers >= 3);
    REQUIRE(touched.size() == 900);
    double nearest = 60;
    for (std::size_t i = 0; i < touched.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            nearest = std::min(nearest, glm::distance(touched[i], touched[j]));
    CHECK(nearest > 1.5);  // of 96 in an inch; some 6 where all of the page is as dark
}

TEST_CASE("shapes and lines of several pens look alike in SVG, PDF and PNG, and their figures are told") {
    require_program("pdfinfo -v");
    require_program("rsvg-convert --version");
    const Scene scene;
    for (const std::string drawn : {"--style line", "--dot-shape ring", "--dot-shape point"}) {
        const std::string options =
            "render " + scene("cat.png") +
            " --dots 900 --width 60 --pens 'Sand:#d0a040:0.8,Night:#102060:0.4:1.5' " + drawn +
            " --advice -o ";
        for (const char* name : {"p.svg", "p.pdf"}) {
            const Outcome made =
                run_dapple(options + scene(name) + " --registration --stats " + scene("p.json"));
            CAPTURE(made.err);
            REQUIRE(made.status == 0);
            CHECK(made.err.find("\n  1 Sand: ") != std::string::npos);
            CHECK(made.err.find("\n  2 Night: ") != std::string::npos);
            CHECK((made.err.find("the pen is changed once") != std::string::npos) ==
                  (name == std::string("p.svg")));
        }
        const nlohmann::json stats = read_json(scene("p.json"));
        REQUIRE(stats["pens"].size() == 2);
        CHECK(stats["pens"][1]["gap_mm"] == 1.5);
        CHECK(stats["pens"][0]["dots"].get<int>() + stats["pens"][1]["dots"].get<int>() == 900);
        for (const auto& pen : stats["pens"]) {
            CHECK(pen["wanted"].get<double>() == doctest::Approx(pen["dots"].get<double>()).epsilon(0.1));
            CHECK(pen["nearest"]["mean"].get<double>() > 0.5);
        }
        REQUIRE(run_dapple(options + scene("p.png") + " --dpi 254").status == 0);
        const Outcome shown =
            run_in_shell("rsvg-convert -w 600 -h 400 -b white " + scene("p.svg") + " -o " + scene("svg.png") +
                         " && pdftoppm -scale-to-x 600 -scale-to-y 400 " + "-singlefile -png " +
                         scene("p.pdf") + " " + scene("pdf"));
        CAPTURE(shown.err);
        REQUIRE(shown.status == 0);
        const Picture svg = read_picture(scene("svg.png")), pdf = read_picture(scene("pdf.png")),
                      png = read_picture(scene("p.png"));
        CHECK(light_difference(svg, pdf) < 0.07);
        // The PNG has no registration marks.
        CHECK(light_difference(svg, png) < 0.1);
        CHECK(light_difference(svg, png, 2) > 0.12);
    }
    scene.must_fail("render -o " + scene("x.svg") + " --registration",
                    "--registration: applies to several pens");
    scene.must_fail("render -o " + scene("x.svg") + " --pen-order listed",
                    "--pen-order: applies to several pens");
    scene.must_fail("render -o " + scene("x.svg") + " --pen-ink opaque",
                    "--pen-ink: applies to several pens");
    scene.must_fail("render -o " + scene("x.png") + " --pens cmyk --registration",
                    "--registration: applies to files for plotting only");
}

TEST_CASE(
    "a PDF has a layer for each pen, which readers can hide, and the paper and cut marks in their own") {
    require_program("pdfinfo -v");
    const Scene scene;
    const Outcome made = run_dapple("render " + scene("cat.png") +
                                    " --dots 900 --width 60 --pens 'Sand:#d0a040,Night (x):#102060' --sheet "
                                    "1,1/2x1 --overlap 5 --background --paper '#eeeeee' -o " +
                                    scene("p.pdf"));
    CAPTURE(made.err);
    REQUIRE(made.status == 0);
    std::string file = text_of(scene("p.pdf"));
    CHECK(file.find("/Name (Paper)") != std::string::npos);
    CHECK(file.find("/Name (1 Sand)") != std::string::npos);
    CHECK(file.find("/Name (2 Night \\(x\\))") != std::string::npos);
    CHECK(file.find("/Name (3 Cut marks)") != std::string::npos);
    CHECK(run_in_shell("pdfinfo " + scene("p.pdf")).out.find("Pages:           1\n") != std::string::npos);
    const auto darkest = [&](const std::string& name) {
        const Outcome shown =
            run_in_shell("pdftoppm -r 72 -singlefile -png " + scene(name) + " " + scene("shown"));
        REQUIRE(shown.status == 0);
        return std::ranges::min(read_picture(scene("shown.png")).light.values);
    };
    CHECK(darkest("p.pdf") < 0.2);
    // All layers are hidden at first, and nothing is left.
    const std::string on = "/BaseState /ON /", off = "/BaseState /OFF/";
    const auto state = file.find(on);
    REQUIRE(state != std::string::npos);
    put_text(scene("hidden.pdf"), file.replace(state, on.size(), off));
    CHECK(darkest("hidden.pdf") == 1);
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
    CHECK(text_of(scene("b.plt")).starts_with("first\nCO \""));
    CHECK(piped("--format tif").err.find("--format: TIFF cannot go to a pipe") != std::string::npos);
    CHECK(run_in_shell("echo no picture | \"$DAPPLE\" render - -o " + scene("c.svg"))
              .err.starts_with("dapple: the standard input: "));
    CHECK(run_in_shell("\"$DAPPLE\" " + file + "- >/dev/full").err.find("the standard output: cannot be") !=
          std::string::npos);
    scene.must_fail(file + scene("c.svg") + " --format png", "--format: png, but the name");
}

TEST_CASE("one line goes through all dots, each once: in an SVG, in G-code, and as short as it is told") {
    const Scene scene;
    const std::string picture = scene("cat.png");
    const Outcome told =
        run_dapple("render " + picture + " --dots 2000 --width 96 --style line --advice --stats " +
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
    double length = 0, longest = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        length += glm::distance(line[i - 1], line[i]);
        longest = std::max(longest, glm::distance(line[i - 1], line[i]));
    }
    CHECK(read_json(scene("a.json"))["strokes"]["longest_mm"] == doctest::Approx(longest).epsilon(0.01));
    CHECK(told.err.find(" mm from dot to dot") != std::string::npos);
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

TEST_CASE("of several pictures each becomes a drawing in the folder, and a bad one is told and stops none") {
    const Scene scene;
    put_text(scene("bad.jpg"), "no picture");
    run_in_shell("cp " + scene("cat.png") + " " + scene("dog.png"));
    const std::string pictures = scene("cat.png") + " " + scene("bad.jpg") + " " + scene("dog.png");
    const std::string how = " --dots 500 --width 96 --jobs 2 --format pdf";
    const Outcome all = run_dapple("render " + pictures + how + " -o " + scene("out/"));
    CHECK(all.status != 0);
    CHECK(all.err.find("2 drawings in ") != std::string::npos);
    CHECK(all.err.find("1 picture failed:\n") != std::string::npos);
    CHECK(all.err.find("bad.jpg: ") != std::string::npos);
    REQUIRE(
        run_dapple("render " + scene("cat.png") + " --dots 500 --width 96 -o " + scene("cat.pdf")).status ==
        0);
    // But for the time it takes, the same as alone.
    CHECK(text_of(scene("out/cat.pdf")) == text_of(scene("cat.pdf")));
    // But for its title, whose letters take a byte more or less.
    const auto bytes = [](const std::string& file) { return static_cast<double>(text_of(file).size()); };
    CHECK(std::abs(bytes(scene("out/dog.pdf")) - bytes(scene("cat.pdf"))) < 8);
    const Outcome no_folder = run_dapple("render " + pictures + " -o " + scene("a.svg"));
    CHECK(no_folder.status != 0);
    CHECK(no_folder.err.find("3 pictures need a folder") != std::string::npos);
    const Outcome twice =
        run_dapple("render " + scene("cat.png") + " " + scene("cat.png") + " -o " + scene("out/"));
    CHECK(twice.err.find("would both become") != std::string::npos);
}
