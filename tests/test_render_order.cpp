// dapple render: in what order dots are written, piece by piece, and what is told about it.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <pugixml.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "app/files/picture.h"
#include "app/files/save_drawing.h"
#include "app/files/tile_library.h"
#include "app/settings/embedded_settings.h"
#include "core/drawing/pipeline.h"
#include "tests/file_text.h"
#include "tests/render_scene.h"
#include "tests/shell.h"

using namespace dapple;

TEST_CASE("the command, which places piece by piece, writes the bytes that the window saves from memory") {
    struct Case {
        std::optional<std::uint64_t> count;
        std::optional<int> relax;
        DotSizing sizing;
        std::string options;
    };
    const Scene scene;
    for (const Case& asked : {Case{30'000, {}, DotSizing::automatic, "--dots 30000"},
                              Case{{}, {}, DotSizing::automatic, "--scale 2500"},
                              Case{30'000, 0, DotSizing::automatic, "--dots 30000 --relax 0"},
                              Case{{}, 2, DotSizing::by_tone, "--relax 2 --dot-radius 0.2..0.5"}}) {
        CAPTURE(asked.options);
        DrawingSettings settings;
        settings.placing.count = asked.count;
        settings.placing.scale = 2500;
        settings.placing.thresholds = true;
        settings.relax = asked.relax;
        settings.dot_size = {.sizing = asked.sizing, .smallest_mm = 0.2, .largest_mm = 0.5};
        Pipeline pipeline;
        pipeline.set_light(read_picture(scene("cat.png")).light);
        pipeline.set_tile(tile_named(tile_in_use(settings), settings.ranking));
        const DrawingPlan plan = pipeline.plan(request_of(settings));
        Drawn drawn;
        REQUIRE(pipeline.draw(plan, drawn));
        for (const std::string ending : {".svg", ".csv", ".png", ".nc", ".json"}) {
            REQUIRE(run_dapple("render " + scene("cat.png") + " -o " + scene("command" + ending) + " " +
                               asked.options)
                        .status == 0);
            CHECK(save_drawing(
                scene("window" + ending), settings,
                {.dots = stream_of(drawn.stippling.dots, drawn.stippling.scale),
                 .page = plan.page,
                 .dot_radius_mm = plan.radius(drawn.stippling.scale) * plan.page.mm_per_page_unit,
                 .tile_size = pipeline.tile().tile().size(),
                 .settings = settings_inside(scene("command" + ending)).value_or("")}));
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
                                " --dots 3000 --stats " + scene("cat.json");
    const Outcome outcome =
        run_in_shell("export ASAN_OPTIONS=detect_leaks=0; script -qec '" + command + "' /dev/null");
    REQUIRE(outcome.status == 0);
    // Before it, on a slow machine, how long it will take.
    CHECK(outcome.out.find("writing 3,000 dots") != std::string::npos);
    CHECK(outcome.out.find("\r\033[K3,000 dots, 0.1 MB; the pen moves ") != std::string::npos);
    const nlohmann::json preflight = read_json(scene("cat.json"))["preflight"];
    CHECK(outcome.out.find(preflight["over_the_edge"].dump() +
                           " dots reach over the page's edge; --margin ") != std::string::npos);
    CHECK(read_svg(scene("cat.svg")).circles().size() == 3000);
}

TEST_CASE("what a plotter will make of a drawing is told without a terminal too, for the machine named") {
    const Scene scene;
    const std::string from = "render " + scene("cat.png") + " --dots 2000 -o ";
    const Outcome laser =
        run_dapple(from + scene("a.svg") + " --tiles --machine grbl-laser --stats " + scene("s.json"));
    REQUIRE(laser.status == 0);
    CHECK(laser.err.find(" on a laser with GRBL's own settings: mostly ") != std::string::npos);
    CHECK(laser.err.find("the layer \"2 Tiles\" has lines") != std::string::npos);
    const nlohmann::json stats = read_json(scene("s.json"));
    CHECK(stats["plotting"]["dots_s"] == doctest::Approx(200));
    CHECK(stats["plotting"]["lifting_s"] == 0);
    CHECK(stats["preflight"]["pen_up_before_m"] > stats["preflight"]["pen_up_m"]);
    const Outcome table = run_dapple(from + scene("a.csv"));
    CHECK(table.err.starts_with("2,000 dots, "));
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
