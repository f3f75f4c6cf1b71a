// dapple render: in what order dots are written, piece by piece, and what is told about it.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "core/drawing/pipeline.h"
#include "io/files/picture.h"
#include "io/files/save_drawing.h"
#include "io/files/tile_library.h"
#include "io/settings/project.h"
#include "tests/file_text.h"
#include "tests/render_scene.h"
#include "tests/run_in_shell.h"

using namespace dapple;

TEST_CASE("the command, which places piece by piece, writes the bytes that the window saves from memory") {
    struct Case {
        std::optional<std::uint64_t> count;
        std::optional<int> relax;
        DotSizing sizing;
        std::string options;
    };
    const Scene scene;
    for (const Case& asked : {Case{6'000, {}, DotSizing::automatic, "--dots 6000"},
                              Case{{}, {}, DotSizing::automatic, "--scale 500"},
                              Case{6'000, 0, DotSizing::automatic, "--dots 6000 --relax 0"},
                              Case{{}, 2, DotSizing::by_tone, "--relax 2 --dot-radius 0.2..0.5"}}) {
        CAPTURE(asked.options);
        DrawingSettings settings;
        settings.placing.count = asked.count;
        settings.placing.scale = 500;
        settings.placing.thresholds = true;
        settings.relax = asked.relax;
        settings.page.margins = Margins{};
        settings.dot_size = {.sizing = asked.sizing, .smallest_mm = 0.2, .largest_mm = 0.5};
        Pipeline pipeline;
        pipeline.set_light(read_picture(scene("cat.png")).light);
        pipeline.set_tile(tile_named(tile_in_use(settings), settings.ranking));
        const DrawingPlan plan = pipeline.plan(settings);
        Stippling drawn;
        REQUIRE(pipeline.draw(plan, drawn));
        for (const std::string ending : {".svg", ".csv", ".png", ".nc", ".json"}) {
            REQUIRE(run_dapple("render " + scene("cat.png") + " -o " + scene("command" + ending) +
                               " --margin 0 " + asked.options)
                        .status == 0);
            CHECK(save_drawing({.file = {.path = scene("window" + ending),
                                         .format = drawing_format("window" + ending),
                                         .settings = settings,
                                         .embedded = settings_inside(scene("command" + ending)).value_or("")},
                                .dots = stream_of(drawn.dots, drawn.scale),
                                .page = plan.page,
                                .dot_radius_mm = plan.radius(drawn.scale) * plan.page.mm_per_page_unit,
                                .tile_size = pipeline.tile().tile().size()}));
            CHECK(text_of(scene("window" + ending)) == text_of(scene("command" + ending)));
        }
    }
}

TEST_CASE("dots that are sorted in memory are those that are written as they are placed") {
    const Scene scene;
    const std::string from = "render " + scene("cat.png") + " --dots 4000 --sheet 2,2/2x2 -o ";
    const auto sorted_lines = [&](const std::string& options) {
        REQUIRE(run_dapple(from + scene("a.csv") + options).status == 0);
        std::istringstream in(text_of(scene("a.csv")));
        std::vector<std::string> lines;
        for (std::string line; std::getline(in, line);) lines.push_back(line);
        std::ranges::sort(lines);
        return lines;
    };
    const std::vector<std::string> placed = sorted_lines("");
    CHECK(placed.size() > 100);
    CHECK(sorted_lines(" --order priority") == placed);
    CHECK(sorted_lines(" --order space") == placed);
    CHECK(sorted_lines(" --order shortest") == placed);
    CHECK(sorted_lines(" --order recursion") == placed);
}

TEST_CASE("on a terminal a bar shows how much is written, and then what a plotter will make of it") {
    const Scene scene;
    const std::string command = "\"$DAPPLE\" render " + scene("cat.png") + " -o " + scene("cat.svg") +
                                " --dots 3000 --margin 0 --advice --stats " + scene("cat.json");
    const Outcome outcome =
        run_in_shell("export ASAN_OPTIONS=detect_leaks=0; script -qec '" + command + "' /dev/null");
    REQUIRE(outcome.status == 0);
    // Before it, on a slow machine, how long it will take.
    CHECK(outcome.out.find("writing 3,000 dots") != std::string::npos);
    CHECK(outcome.out.find("\r\033[K3,000 dots, 1") != std::string::npos);
    CHECK(outcome.out.find(" mm wide; the pen moves ") != std::string::npos);
    const nlohmann::json preflight = read_json(scene("cat.json"))["preflight"];
    CHECK(outcome.out.find(preflight["over_the_edge"].dump() +
                           " dots reach over the page's edge. Use automatic margins") != std::string::npos);
    CHECK(read_svg(scene("cat.svg")).circles().size() == 3000);
}

TEST_CASE("what a plotter will make of a drawing is told without a terminal too, for the machine named") {
    const Scene scene;
    const std::string from = "render " + scene("cat.png") + " --dots 2000 -o ";
    const Outcome laser =
        run_dapple(from + scene("a.svg") + " --tiles --machine grbl-laser --stats " + scene("s.json"));
    REQUIRE(laser.status == 0);
    CHECK(laser.err.find(" on a laser that runs Grbl: mostly ") != std::string::npos);
    CHECK(laser.err.find("will plot the layer \"% Tiles\"") != std::string::npos);
    const nlohmann::json stats = read_json(scene("s.json"));
    CHECK(stats["plotting"]["dots_s"] == 0);  // it follows the circles
    CHECK(stats["plotting"]["drawing_s"] > 100);
    REQUIRE(run_dapple(from + scene("a.gcode") + " --gcode laser --stats " + scene("g.json")).status == 0);
    CHECK(read_json(scene("g.json"))["plotting"]["dots_s"] == doctest::Approx(200));
    CHECK(stats["plotting"]["lifting_s"] == 0);
    CHECK(stats["preflight"]["pen_up_before_m"] > stats["preflight"]["pen_up_m"]);
    const std::string slow = scene("h.gcode") + " --gcode laser --dwell 2 --stats - 2>/dev/null";
    CHECK(nlohmann::json::parse(run_dapple(from + slow).out)["plotting"]["dots_s"] == doctest::Approx(4000));
    scene.must_fail(from + "- --stats -", "--stats: the drawing is written to the standard output already");
    const Outcome table = run_dapple(from + scene("a.csv"));
    CHECK(table.err.starts_with("2,000 dots, "));
    CHECK(table.err.find("the pen") == std::string::npos);
    const Outcome bare = run_dapple("render " + scene("cat.png") +
                                    " --dots 2 --dot-radius 0.1 --region 0,0,1x1 -o " + scene("b.svg"));
    CHECK(bare.err.starts_with("0 dots"));
    CHECK(bare.err.find(": this is all bare paper\n") != std::string::npos);
    CHECK(table.err.find("overlap") == std::string::npos);
    const Outcome pixels = run_dapple(from + scene("a.png") + " --machine grbl-pen");
    CHECK(pixels.status == 2);
}

TEST_CASE("an SVG is in an order of short pen moves, and its travel, distances and edges are told") {
    const Scene scene;
    const auto told = [&](const std::string& options) {
        REQUIRE(run_dapple("render " + scene("cat.png") + " --dots 3000 --stats " + scene("s.json") + " -o " +
                           scene("cat.svg") + options)
                    .status == 0);
        // Measured on what is in the file.
        const double mm = 25.4 / 96;
        double travel = 0, x = 0, y = 0;
        std::uint64_t over = 0, near = 0;
        const Svg svg = read_svg(scene("cat.svg"));
        std::vector<std::pair<double, double>> places;
        for (const pugi::xml_node& circle : svg.circles()) {
            const double cx = circle.attribute("cx").as_double() * mm,
                         cy = circle.attribute("cy").as_double() * mm,
                         r = circle.attribute("r").as_double() * mm;
            if (!places.empty()) travel += std::hypot(cx - x, cy - y);
            x = cx;
            y = cy;
            places.emplace_back(x, y);
            over += std::min({x, y, 200 - x, 200 * 64 / 96.0 - y}) < r;
        }
        for (const auto& a : places) {
            near += std::ranges::count_if(places, [&](const auto& b) {
                        return std::hypot(a.first - b.first, a.second - b.second) < 0.5;
                    }) > 1;
        }
        const nlohmann::json stats = read_json(scene("s.json")), preflight = stats["preflight"];
        CHECK(preflight["pen_up_m"].get<double>() == doctest::Approx(travel / 1000).epsilon(0.001));
        // Two decimals of a px leave it open for a few.
        CHECK(std::abs(preflight["over_the_edge"].get<double>() - double(over)) <= 2);
        CHECK(std::abs(preflight["nearer_than_0.5_mm"].get<double>() - double(near)) <= 2);
        CHECK(stats["file_bytes"] == std::filesystem::file_size(scene("cat.svg")));
        return std::pair(stats["order"].get<std::string>(), travel);
    };
    const auto [usual, short_way] = told("");
    CHECK(usual == "shortest");
    CHECK(told(" --order shortest").second == short_way);
    CHECK(told(" --order space").second > 1.05 * short_way);
    CHECK(told(" --order recursion").second > 2 * short_way);
}

namespace {

// The kinds of findings among a drawing's figures.
std::set<std::string> kinds_in(const nlohmann::json& stats) {
    std::set<std::string> kinds;
    for (const nlohmann::json& finding : stats["findings"]) {
        CHECK_FALSE(finding["text"].get<std::string>().empty());
        CHECK_FALSE(finding["cure"].get<std::string>().empty());
        kinds.insert(finding["kind"].get<std::string>());
    }
    return kinds;
}

}  // namespace

TEST_CASE("overlap by the pen's width is told of every file that is plotted, and as the same figures") {
    const Scene scene;
    const std::string from = "render " + scene("cat.png") + " --dots 3000 --width 60 --stats " +
                             scene("s.json") + " --pen-width 0.8 --advice -o ";
    for (const std::string how : {"a.gcode", "a.hpgl", "a.svg --dot-shape point", "a.dxf --dot-shape cross",
                                  "a.gcode --dot-shape spiral", "a.svg --style line"}) {
        CAPTURE(how);
        const Outcome outcome = run_dapple(from + scene("") + how);
        REQUIRE(outcome.status == 0);
        CHECK(kinds_in(read_json(scene("s.json"))).contains("overlap"));
        CHECK(outcome.err.find(" % of the dots ") != std::string::npos);
        CHECK(outcome.err.find(". Use fewer dots, a wider page or ") != std::string::npos);
    }
    REQUIRE(run_dapple("render " + scene("cat.png") + " --dots 300 --width 200 --stats " + scene("s.json") +
                       " --pen-width 0.1 -o " + scene("a.hpgl"))
                .status == 0);
    CHECK_FALSE(kinds_in(read_json(scene("s.json"))).contains("overlap"));
}

TEST_CASE("circles in SVG and DXF take the time of following them, and are told as rings") {
    const Scene scene;
    const auto stats = [&](const std::string& name) {
        REQUIRE(run_dapple("render " + scene("cat.png") + " --dots 900 --width 100 --stats " +
                           scene("s.json") + " -o " + scene(name))
                    .status == 0);
        return read_json(scene("s.json"));
    };
    for (const std::string name : {"a.svg", "a.dxf"}) {
        const nlohmann::json rings = stats(name);
        CHECK(kinds_in(rings).contains("rings"));
        // At the speed of lines, and slower where it turns.
        const double mm_per_s = 25.0 / 110 * 8.6979 * 25.4;
        CHECK(rings["plotting"]["drawing_s"].get<double>() >
              rings["preflight"]["rings_m"].get<double>() * 1000 / mm_per_s);
    }
    const nlohmann::json touches = stats("a.hpgl");
    CHECK_FALSE(kinds_in(touches).contains("rings"));
    CHECK(touches["plotting"]["drawing_s"] == 0);
}

TEST_CASE("a picture of pixels is told about too, and a table's tone") {
    const Scene scene;
    const std::string from = "render " + scene("cat.png") + " --dots 3000 --width 100 --stats " +
                             scene("s.json") + " --dot-radius 0.05 -o ";
    const Outcome pixels = run_dapple(from + scene("a.png") + " --dpi 100");
    CAPTURE(pixels.err);
    CHECK(pixels.err.starts_with("3,000 dots, "));
    CHECK(pixels.err.find(" pixels\n") != std::string::npos);
    CHECK(kinds_in(read_json(scene("s.json"))).contains("fine_pixels"));
    CHECK(kinds_in(read_json(scene("s.json"))).contains("tone"));
    REQUIRE(run_dapple(from + scene("a.tif") + " --dpi 600").status == 0);
    CHECK_FALSE(kinds_in(read_json(scene("s.json"))).contains("fine_pixels"));
    CHECK(kinds_in(read_json(scene("s.json"))).contains("tone"));
    REQUIRE(run_dapple(from + scene("a.csv")).status == 0);
    CHECK(kinds_in(read_json(scene("s.json"))) == std::set<std::string>{"tone"});
}

TEST_CASE("near dots, a pen's gap and the layer of tiles are told of a drawing with four pens") {
    const Scene scene;
    const Outcome told = run_dapple(
        "render " + scene("cat.png") + " --dots 3000 --width 40 --tiles --advice -o " + scene("a.svg") +
        " --pens 'Sky:#3aa0d8:0.3:3,Sand:#d0a040:0.3,Rose:#d06080:0.3,Night:#102060:0.3'");
    CAPTURE(told.err);
    REQUIRE(told.status == 0);
    CHECK(told.err.find("; saxi would join them. Use ") != std::string::npos);
    CHECK(told.err.find(" of Night's dots are closer") == std::string::npos);
    const Svg svg = read_svg(scene("a.svg"));
    std::string last;
    for (const pugi::xml_node& layer : svg.document.child("svg").children("g"))
        last = layer.attribute("inkscape:label").value();
    CHECK(told.err.find("will plot the layer \"" + last + "\". Hide that layer") != std::string::npos);
    CHECK(last.ends_with(" Tiles"));
}

TEST_CASE("pens whose width is named touch the paper in files for plotters, unless a shape is asked for") {
    const Scene scene;
    const std::string from = "render " + scene("cat.png") + " --dots 500 --pens greys:0.4 -o ";
    REQUIRE(run_dapple(from + scene("a.svg")).status == 0);
    REQUIRE(run_dapple(from + scene("b.svg") + " --dot-shape point").status == 0);
    CHECK(text_of(scene("a.svg")) == text_of(scene("b.svg")));
    REQUIRE(run_dapple(from + scene("c.svg") + " --dot-shape circle").status == 0);
    CHECK(text_of(scene("c.svg")).find("<circle") != std::string::npos);
    // The settings inside say so, and make the same drawing again.
    REQUIRE(run_dapple("render " + scene("cat.png") + " --settings-from " + scene("a.svg") + " -o " +
                       scene("d.svg"))
                .status == 0);
    CHECK(text_of(scene("d.svg")) == text_of(scene("a.svg")));
    REQUIRE(
        run_dapple("render " + scene("cat.png") + " --dots 500 --pens greys -o " + scene("e.svg")).status ==
        0);
    CHECK(text_of(scene("e.svg")).find("<circle") != std::string::npos);
}

TEST_CASE(
    "it is said that so many dots were put along a curve only, and that a pen touches rather than draws") {
    const Scene scene;
    const std::string from = "render " + scene("cat.png") + " --relax 0 -o " + scene("a.hpgl");
    const std::string curve = " (along a curve, for this many dots; --order shortest finds a shorter route)";
    CHECK(run_dapple(from + " --dots 1,000,001").err.find(curve) != std::string::npos);
    CHECK(run_dapple(from + " --dots 900 --order space").err.find(curve) == std::string::npos);
    CHECK(run_dapple(from + " --dots 900 --dot-shape point")
              .err.find("; the pen touches the paper 900 times, and moves ") != std::string::npos);
}

TEST_CASE("a large file's size is said before it is written") {
    const Scene scene;
    const std::string from = "render " + scene("cat.png") + " --relax 0 --order recursion -o ";
    const Outcome large = run_dapple(from + scene("a.csv") + " --dots 600k");
    REQUIRE(large.status == 0);
    const std::size_t said = large.err.find("about ");
    REQUIRE(said != std::string::npos);
    CHECK(large.err.find(" MB will be written\n600,000 dots, ") != std::string::npos);
    CHECK(
        std::stod(large.err.substr(said + 6)) ==
        doctest::Approx(static_cast<double>(std::filesystem::file_size(scene("a.csv"))) * 1e-6).epsilon(0.1));
    CHECK(run_dapple(from + scene("a.csv") + " --dots 5k").err.find("will be written") == std::string::npos);
}

TEST_CASE("of sheets and of many pictures the findings are told once for each kind, and all figures saved") {
    const Scene scene;
    const std::string stats = " --stats " + scene("s.json");
    const Outcome sheets = run_dapple("render " + scene("cat.png") + " --dots 2000 --width 100 --advice -o " +
                                      scene("m.svg") + " --sheets 2x1" + stats);
    CAPTURE(sheets.err);
    REQUIRE(sheets.status == 0);
    CHECK(sheets.err.find("\nA1: A plotter would draw outlines only") != std::string::npos);
    CHECK(sheets.err.find(" (and 1 more like it)\n") != std::string::npos);
    nlohmann::json all = read_json(scene("s.json"));
    REQUIRE(all.size() == 2);
    CHECK(all[0]["emitted"].get<int>() + all[1]["emitted"].get<int>() > 2000);  // with those across the cut
    CHECK(kinds_in(all[1]).contains("rings"));

    run_in_shell("cp " + scene("cat.png") + " " + scene("dog.png"));
    put_text(scene("bad.jpg"), "no picture");
    const Outcome batch = run_dapple("render " + scene("cat.png") + " " + scene("bad.jpg") + " " +
                                     scene("dog.png") + " --dots 900 --advice -o " + scene("out/") + stats);
    CHECK(batch.status != 0);
    CHECK(batch.err.find("\n  cat.svg: A plotter would draw") != std::string::npos);
    all = read_json(scene("s.json"));
    REQUIRE(all.size() == 2);
    CHECK(all[1]["output"].get<std::string>().ends_with("dog.svg"));
}

TEST_CASE("a preset's and a drawing's settings apply to each of several pictures") {
    const Scene scene;
    run_in_shell("cp " + scene("cat.png") + " " + scene("dog.png"));
    const std::string both = "render " + scene("cat.png") + " " + scene("dog.png") + " --dots 600 -o ";
    const std::string one = "render " + scene("dog.png") + " --dots 600 -o ";
    REQUIRE(run_dapple(one + scene("from.svg") + " --dot-shape cross --pen-width 0.4 --page a5").status == 0);
    for (const std::string& how :
         {std::string(" --preset fine-pen"), " --settings-from " + scene("from.svg")}) {
        CAPTURE(how);
        REQUIRE(run_dapple(both + scene("out/") + how).status == 0);
        REQUIRE(run_dapple(one + scene("one.svg") + how).status == 0);
        CHECK(text_of(scene("out/dog.svg")) == text_of(scene("one.svg")));
    }
}

TEST_CASE("xmllint finds every SVG well formed") {
    if (!is_installed("xmllint --version")) return;
    const Scene scene;
    for (const std::string how : {"--tiles", "--style line", "--pens cmyk:0.3 --registration --background",
                                  "--dot-shape spiral", "--sheet 1,1/2x1 --overlap 8"}) {
        CAPTURE(how);
        REQUIRE(run_dapple("render " + scene("cat.png") + " --dots 400 -o " + scene("a.svg") + " " + how)
                    .status == 0);
        const Outcome checked = run_in_shell("xmllint --noout " + scene("a.svg"));
        CAPTURE(checked.err);
        CHECK(checked.status == 0);
        CHECK(checked.err.empty());
    }
}

TEST_CASE("within the margins lies all ink of a pen, however wide it is beside its dots") {
    const Scene scene;
    for (const std::string how :
         {"--dot-shape point", "--dot-shape cross", "--style line", "--style nearest"}) {
        CAPTURE(how);
        REQUIRE(run_dapple("render " + scene("cat.png") + " --page a5 --margin 15 --dots 9000 --relax 1 " +
                           how + " --pen-width 2 -o " + scene("a.svg") + " --stats " + scene("s.json"))
                    .status == 0);
        CHECK(read_json(scene("s.json"))["preflight"]["outside_the_margins"] == 0);
        const double px = 96 / 25.4;
        double least = 1e9;  // from the line's edge to the nearest margin
        const Svg svg = read_svg(scene("a.svg"));
        const pugi::xml_node root = svg.document.child("svg");
        const double width = root.attribute("width").as_double(),
                     height = root.attribute("height").as_double();
        REQUIRE(width * height == 148 * 210);
        for (const pugi::xpath_node& found : root.select_nodes(".//path")) {
            std::string d = found.node().attribute("d").value();
            if (d.find('h') != std::string::npos) d = d.substr(0, d.find('h'));
            for (char& c : d)
                if (c == 'M' || c == 'L') c = ' ';
            std::istringstream numbers(d);
            for (double x, y; numbers >> x >> y;)
                least =
                    std::min({least, x / px - 16, y / px - 16, width - 16 - x / px, height - 16 - y / px});
        }
        CHECK(least > -0.02);
        CHECK(least < 1.5);
    }
}
