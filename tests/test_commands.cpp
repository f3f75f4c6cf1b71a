#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "app/files/picture.h"
#include "app/files/save_drawing.h"
#include "app/files/tile_library.h"
#include "tests/child_process.h"
#include "tests/file_text.h"
#include "tests/picture_files.h"
#include "tests/shell.h"
#include "tests/temporary_folder.h"

using namespace dapple;

namespace {

// A soft grey ramp with a black bar: something of everything.
PictureFile test_picture() {
    PictureFile picture{.width = 96, .height = 64};
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const bool bar = x > 40 && x < 50;
            picture.values.push_back(bar ? 0.0f : static_cast<float>(x) / 95.0f);
        }
    }
    return picture;
}

struct Svg {
    pugi::xml_document document;
    std::vector<pugi::xml_node> circles() const {
        std::vector<pugi::xml_node> found;
        for (const pugi::xml_node& circle : document.child("svg").child("g").children("circle"))
            found.push_back(circle);
        return found;
    }
    std::set<std::pair<std::string, std::string>> places() const {
        std::set<std::pair<std::string, std::string>> places;
        for (const pugi::xml_node& circle : circles()) {
            places.emplace(circle.attribute("cx").value(), circle.attribute("cy").value());
        }
        return places;
    }
};

Svg read_svg(const std::filesystem::path& path) {
    Svg svg;
    REQUIRE(svg.document.load_file(path.c_str()));
    return svg;
}

std::string half_of(const std::filesystem::path& file) {
    const std::string whole = text_of(file);
    return whole.substr(0, whole.size() / 2);
}

nlohmann::json read_json(const std::filesystem::path& path) {
    return nlohmann::json::parse(text_of(path));
}

// Share of ink, as a renderer mixes it: in encoded values.
double encoded_ink(const std::filesystem::path& picture) {
    const Picture read = read_picture(picture);
    double sum = 0;
    for (const glm::u8vec4& pixel : read.preview.values) sum += 1 - pixel.x / 255.0;
    return sum / static_cast<double>(read.preview.values.size());
}

// A folder with a picture and an old drawing; after a command that has to fail, all of it must be as it was.
class Scene {
 public:
    Scene() {
        write_picture(folder / "cat.png", test_picture());
        put_text(folder / "old.svg", "the old drawing");
    }

    std::string operator()(const std::string& name) const { return (folder / name).string(); }

    void must_fail(const std::string& arguments, const std::string& words) const {
        const std::size_t before = folder.entries();
        const Outcome outcome = run_dapple(arguments);
        CAPTURE(arguments);
        CAPTURE(outcome.err);
        CHECK((outcome.status == 1 || outcome.status == 2));
        CHECK(outcome.out.empty());
        CHECK(outcome.sentences() == 1);
        CHECK(outcome.err.starts_with("dapple: "));
        CHECK(outcome.err.find(words) != std::string::npos);
        CHECK(text_of(folder / "old.svg") == "the old drawing");
        CHECK(folder.entries() == before);
    }

    TemporaryFolder folder;
};

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
    const std::string from = "render " + scene("cat.png") + " --dots 2000 --dpi 150 -o ";
    REQUIRE(run_dapple(from + scene("cat.svg")).status == 0);
    REQUIRE(run_dapple(from + scene("cat.png.png")).status == 0);
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

TEST_CASE("a mural's sheets, made one by one, have the dots of the whole, each once") {
    const Scene scene;
    for (const std::string dots : {"--dots 5000", "--scale 400"}) {
        const std::string from = "render " + scene("cat.png") + " --width 300 " + dots + " -o ";
        REQUIRE(run_dapple(from + scene("whole.csv")).status == 0);
        // x, y, in micrometres, from the whole page's corner.
        std::multiset<std::pair<long, long>> whole, on_sheets;
        const auto read = [](const std::string& table, double x0, double y0, auto& places) {
            std::istringstream lines(table);
            std::string line;
            std::getline(lines, line);
            while (std::getline(lines, line)) {
                double x = 0, y = 0;
                REQUIRE(std::sscanf(line.c_str(), "%lf,%lf", &x, &y) == 2);
                places.emplace(std::lround((x + x0) * 1e3), std::lround((y + y0) * 1e3));
            }
        };
        read(text_of(scene("whole.csv")), 0, 0, whole);
        for (int row = 1; row <= 2; ++row) {
            for (int column = 1; column <= 3; ++column) {
                const std::string sheet = std::to_string(column) + "," + std::to_string(row) + "/3x2";
                REQUIRE(run_dapple(from + scene("sheet.csv") + " --sheet " + sheet).status == 0);
                read(text_of(scene("sheet.csv")), (column - 1) * 100.0, (row - 1) * 100.0, on_sheets);
            }
        }
        CHECK(on_sheets.size() == whole.size());
        std::size_t found = 0;
        for (const auto& [x, y] : on_sheets) {
            // Adding the corner may round to the next micrometre.
            bool here = false;
            for (long dx = -1; dx <= 1; ++dx)
                for (long dy = -1; dy <= 1; ++dy) here = here || whole.contains({x + dx, y + dy});
            found += here;
        }
        CHECK(found == whole.size());
    }
}

TEST_CASE("a region is what the page shows there, at its place and in its size") {
    const Scene scene;
    const std::string from =
        "render " + scene("cat.png") + " --width 300 --tile paper16 --dots 5000 --dpi 60 -o ";
    REQUIRE(run_dapple(from + scene("page.svg")).status == 0);
    // The second of three columns, the first of two rows.
    for (const std::string ending : {".svg", ".csv", ".png"}) {
        REQUIRE(run_dapple(from + scene("r" + ending) + " --region 100,0,100x100").status == 0);
        REQUIRE(run_dapple(from + scene("s" + ending) + " --sheet 2,1/3x2").status == 0);
        CHECK(text_of(scene("r" + ending)) == text_of(scene("s" + ending)));
    }
    REQUIRE(run_dapple(from + scene("r.svg") + " --tiles --region 110.5,20,80x61").status == 0);
    const Svg page = read_svg(scene("page.svg")), region = read_svg(scene("r.svg"));
    CHECK(region.document.child("svg").attribute("width").value() == std::string("80mm"));
    CHECK(region.document.child("svg").attribute("height").value() == std::string("61mm"));
    const double px = 96 / 25.4;
    std::size_t expected = 0;
    for (const pugi::xml_node& circle : page.circles()) {
        const double x = circle.attribute("cx").as_double() / px, y = circle.attribute("cy").as_double() / px;
        expected += x >= 110.5 && x < 190.5 && y >= 20 && y < 81;
    }
    CHECK(expected > 300);
    // Two decimals of a px leave it open for a dot on the very edge.
    CHECK(std::abs(static_cast<double>(region.circles().size()) - static_cast<double>(expected)) <= 2);
    // The outlines end where the region does.
    std::size_t outlines = 0;
    for (const pugi::xml_node& level :
         region.document.child("svg").child("g").next_sibling("g").children("g")) {
        for (const pugi::xml_node& tile : level.children("rect")) {
            const double x = tile.attribute("x").as_double(), y = tile.attribute("y").as_double();
            CHECK(x >= 0);
            CHECK(y >= 0);
            CHECK(tile.attribute("width").as_double() > 0);
            CHECK(tile.attribute("height").as_double() > 0);
            CHECK(x + tile.attribute("width").as_double() < 80 * px + 0.002);
            CHECK(y + tile.attribute("height").as_double() < 61 * px + 0.002);
            ++outlines;
        }
    }
    CHECK(outlines > 0);
}

TEST_CASE("the command, which places piece by piece, writes the bytes that the window saves from memory") {
    const Scene scene;
    for (const auto& [count, options] :
         {std::pair{std::optional<std::uint64_t>(30'000), "--dots 30000"}, {std::nullopt, "--scale 2500"}}) {
        DrawingSettings settings;
        settings.stipple.count = count;
        settings.stipple.scale = 2500;
        settings.stipple.critical = true;
        const Density density(density_of(read_picture(scene("cat.png")).light, settings.tone));
        RankedTile tile = tile_named(tile_in_use(settings), settings.ranking);
        Stippling drawn;
        REQUIRE(stipple(tile, density, settings.stipple, drawn));
        for (const std::string ending : {".svg", ".csv", ".png"}) {
            CHECK(save_drawing(scene("window" + ending), settings,
                               {.dots = stream_of(drawn.dots, drawn.scale),
                                .page = page_size(density, settings.width_mm),
                                .tile_size = tile.tile().size()}));
            REQUIRE(
                run_dapple("render " + scene("cat.png") + " -o " + scene("command" + ending) + " " + options)
                    .status == 0);
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
    CHECK(usual == "space");
    CHECK(told(" --order space").second == short_way);
    CHECK(told(" --order recursion").second > 2 * short_way);
}

TEST_CASE("within a margin no dot reaches over the edge, in any format, and sheets still join") {
    const Scene scene;
    const std::string from = "render " + scene("cat.png") +
                             " --width 150 --margin 15 --dots 4000 --dpi 60 --stats " + scene("m.json");
    REQUIRE(run_dapple(from + " -o " + scene("m.svg") + " --tiles").status == 0);
    const Svg svg = read_svg(scene("m.svg"));
    // The picture is 3 by 2, so 120 by 80 mm of it are left.
    CHECK(svg.document.child("svg").attribute("width").value() == std::string("150mm"));
    CHECK(svg.document.child("svg").attribute("height").value() == std::string("110mm"));
    const double px = 96 / 25.4;
    REQUIRE(svg.circles().size() == 4000);
    for (const pugi::xml_node& circle : svg.circles()) {
        const double x = circle.attribute("cx").as_double() / px, y = circle.attribute("cy").as_double() / px;
        CHECK((x >= 14.99 && x <= 135.01 && y >= 14.99 && y <= 95.01));
    }
    for (const pugi::xpath_node& found : svg.document.select_nodes("//g[@id]/rect")) {
        const pugi::xml_node tile = found.node();
        const auto mm = [&](const char* name) { return tile.attribute(name).as_double() / px; };
        CHECK((mm("x") >= 14.99 && mm("x") + mm("width") <= 135.01));
        CHECK((mm("y") >= 14.99 && mm("y") + mm("height") <= 95.01));
    }
    CHECK(read_json(scene("m.json"))["preflight"]["over_the_edge"] == 0);
    CHECK(read_json(scene("m.json"))["duplicates"] == 0);

    REQUIRE(run_dapple(from + " -o " + scene("m.png")).status == 0);
    const Picture png = read_picture(scene("m.png"));
    CHECK(png.light.width == 354);
    CHECK(png.light.height == 260);
    for (int x = 0; x < png.light.width; ++x) CHECK(png.light.at(x, 20) == 1);
    double ink = 0;
    for (const float light : png.light.values) ink += 1 - light;
    CHECK(ink > 5000);

    std::size_t on_sheets = 0;
    for (const std::string sheet : {"1,1/2x2", "2,1/2x2", "1,2/2x2", "2,2/2x2"}) {
        REQUIRE(run_dapple(from + " -o " + scene("s.svg") + " --sheet " + sheet).status == 0);
        on_sheets += read_svg(scene("s.svg")).circles().size();
    }
    CHECK(on_sheets == 4000);
    REQUIRE(run_dapple(from + " -o " + scene("r.svg") + " --region 0,0,75x55").status == 0);
    REQUIRE(run_dapple(from + " -o " + scene("s.svg") + " --sheet 1,1/2x2").status == 0);
    CHECK(text_of(scene("r.svg")) == text_of(scene("s.svg")));
    scene.must_fail("render " + scene("cat.png") + " -o " + scene("new.svg") + " --margin 100",
                    "--margin: 100 mm on either side leave no room on a page 200 mm wide");
}

TEST_CASE("a count is understood as people write it") {
    const Scene scene;
    const auto dots = [&](const std::string& text) {
        REQUIRE(
            run_dapple("render " + scene("cat.png") + " -o " + scene("n.csv") + " --dots " + text).status ==
            0);
        const std::string table = text_of(scene("n.csv"));
        return std::ranges::count(table, '\n') - 1;
    };
    CHECK(dots("1,200") == 1200);
    CHECK(dots("2k") == 2000);
    CHECK(dots("1.5K") == 1500);
    CHECK(dots("0.002M") == 2000);
    CHECK(dots("1e3") == 1000);
}

TEST_CASE("a misspelt command is told with the nearest one, and a name that may be a picture is none") {
    const Scene scene;
    scene.must_fail("rendr x", "there is no command \"rendr\"; did you mean \"render\"?");
    scene.must_fail("analyze x -o y", "there is no command \"analyze\"; did you mean \"analyse\"?");
    scene.must_fail("tile chekc paper16", "there is no command \"chekc\"; did you mean \"check\"?");
    scene.must_fail("frobnicate", "there is no command \"frobnicate\"; --help shows");
    scene.must_fail("missing.png --nonsense", "--nonsense");
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

TEST_CASE(
    "a tile for the window that is none is refused before there is a window, and no command swallows it") {
    const Scene scene;
    scene.must_fail("--tile missing.tile", "missing.tile: no such tile or tile file");
    scene.must_fail("--tile 1,2/17", "17 points");
    scene.must_fail("--tile paper16 render -o " + scene("s.svg"), "--tile: belongs to the window");
    CHECK_FALSE(std::filesystem::exists(scene("s.svg")));
}

TEST_CASE("without a picture the sample is drawn") {
    const Scene scene;
    REQUIRE(run_dapple("render -o " + scene("s.svg") + " --dots 500 --stats " + scene("s.json")).status == 0);
    CHECK(read_svg(scene("s.svg")).circles().size() == 500);
    CHECK(read_json(scene("s.json"))["image_width"] == 1024);
}

TEST_CASE("help names every option and shows examples") {
    const Outcome all = run_dapple("--help"), render = run_dapple("render --help");
    CHECK(all.status == 0);
    CHECK(all.err.empty());
    CHECK(all.out.find("render") != std::string::npos);
    for (const char* option :
         {"--output",     "--scale",      "--dots",   "--placer", "--tile",        "--ranking",
          "--dot-radius", "--width",      "--margin", "--dpi",    "--black-point", "--white-point",
          "--contrast",   "--brightness", "--gamma",  "--blur",   "--invert",      "--ink",
          "--paper",      "--order",      "--sheet",  "--region", "--tiles",       "--background",
          "--threads",    "--huge",       "--stats",  "Examples:"}) {
        CAPTURE(std::string(option));
        CHECK(render.out.find(option) != std::string::npos);
    }
}

TEST_CASE("pictures that cannot be read are refused in a sentence, and an old drawing stays") {
    const Scene scene;
    const auto refused = [&](const std::string& name, const std::string& words) {
        scene.must_fail("render " + scene(name) + " -o " + scene("old.svg"), name + ": " + words);
    };
    put_text(scene("empty.png"), "");
    put_text(scene("text.jpg"), "No picture, but a sentence.\n");
    PictureFile photo{.width = 200, .height = 200};
    for (int i = 0; i < 40'000; ++i) photo.values.push_back(static_cast<float>(i * 7919 % 1000) / 999);
    write_picture(scene("whole.jpg"), photo);
    write_picture(scene("whole.png"), photo);
    put_text(scene("half.jpg"), half_of(scene("whole.jpg")));
    put_text(scene("half.png"), half_of(scene("whole.png")));
    put_text(scene("large.hdr"), "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 30000 +X 40000\n");
    const float nan = std::numeric_limits<float>::quiet_NaN(),
                infinity = std::numeric_limits<float>::infinity();
    write_picture(scene("nan.exr"), {.width = 2, .values = {0, nan}, .type = "float"});
    write_picture(scene("infinite.exr"), {.width = 2, .values = {infinity, 0}, .type = "float"});
    write_picture(scene("white.png"), {.width = 9, .height = 9, .values = std::vector<float>(81, 1.0f)});
    write_picture(scene("clear.png"),
                  {.width = 9, .height = 9, .channels = 4, .values = std::vector<float>(324, 0.0f)});

    refused("none.png", "no such file");
    refused("", "is a folder");
    refused("empty.png", "the file is empty");
    refused("text.jpg", "not a picture");
    refused("half.jpg", "the picture is damaged");
    refused("half.png", "the picture is damaged");
    refused("large.hdr", "40,000 x 30,000 pixels are over 400 megapixels");
    refused("nan.exr", "pixel 1, 0 is not a number");
    refused("infinite.exr", "pixel 0, 0 is infinite");
    refused("white.png", "nothing to draw");
    refused("clear.png", "nothing to draw");
}

TEST_CASE("pictures that are odd but whole are drawn") {
    const Scene scene;
    const auto drawn = [&](const std::string& name, const std::string& options = "--dots 100") {
        const Outcome outcome =
            run_dapple("render " + scene(name) + " -o " + scene("odd.svg") + " " + options);
        CAPTURE(name);
        REQUIRE_MESSAGE(outcome.status == 0, outcome.err);
        return read_svg(scene("odd.svg")).circles().size();
    };
    write_picture(scene("1x1.png"), {.values = {0.25f}});
    write_picture(scene("1x10000.png"),
                  {.width = 1, .height = 10'000, .values = std::vector<float>(10'000, 0.5f)});
    write_picture(scene("black.png"), {.width = 9, .height = 9, .values = std::vector<float>(81, 0.0f)});
    write_picture(scene("white.png"), {.width = 9, .height = 9, .values = std::vector<float>(81, 1.0f)});
    PictureFile deep = test_picture();
    deep.type = "uint16";
    write_picture(scene("deep.tif"), deep);
    const std::string convert = "convert " + scene("cat.png") + " -fill red -draw 'rectangle 0,0 20,20' ";
    REQUIRE(run_in_shell(convert + "-type Palette PNG8:" + scene("palette.png")).status == 0);
    REQUIRE(run_in_shell(convert + "-colorspace CMYK " + scene("cmyk.jpg")).status == 0);
    scene.must_fail(
        "render " + scene("1x10000.png") + " -o " + scene("old.svg"),
        "1x10000.png: 1 x 10000 pixels would make a page 200 mm wide and 2000 m high, and 100 m is "
        "the most; choose a --width of 9.5 or less");
    CHECK(drawn("1x10000.png", "--dots 100 --width 9.5") == 100);
    for (const char* name : {"1x1.png", "black.png", "deep.tif", "palette.png", "cmyk.jpg"}) {
        CHECK(drawn(name) == 100);
    }
    // Asked for by scale, white paper has no dots, and that is a drawing too.
    CHECK(drawn("white.png", "--scale 1000") == 0);
}

TEST_CASE("drawings that cannot be saved are refused in a sentence") {
    const Scene scene;
    const std::string from = "render " + scene("cat.png") + " -o ";
    scene.must_fail(from + scene("missing/a.svg"), "/missing does not exist");
    scene.must_fail(from + scene("cat.png/a.svg"), "is a file, not a folder");
    scene.must_fail(from + scene("old.bmp"), "must end in .svg, .png or .csv");
    scene.must_fail(from + scene("old"), "must end in .svg, .png or .csv");
    scene.must_fail(from + scene("./cat.png"), "would be written over the picture");
    scene.must_fail(from + scene("old.svg") + " --stats " + scene("./old.svg"),
                    "would be written over the drawing");
    scene.must_fail(from + scene("old.svg") + " --stats " + scene("./cat.png"),
                    "would be written over the picture");
    scene.must_fail(from + scene("cat.png"), "would be written over the picture");
    scene.must_fail(from + scene("old.svg") + " --stats " + scene("missing/s.json"),
                    "/missing does not exist");
    std::filesystem::create_directory(scene("folder.svg"));
    scene.must_fail(from + scene("folder.svg"), "is a folder");
    scene.must_fail("render " + scene("cat.png"), "--output");
    // The drawing outgrows what a file may have here; 512 bytes a block.
    const Outcome limited = run_in_shell("ulimit -f 100; exec \"$DAPPLE\" " + from + scene("old.svg"));
    CAPTURE(limited.err);
    CHECK(limited.status == 1);
    CHECK(limited.sentences() == 1);
    CHECK(limited.err.find("old.svg: cannot be written") != std::string::npos);
    CHECK(text_of(scene("old.svg")) == "the old drawing");
}

TEST_CASE("a full or read-only disk is said, the old drawing stays, and nothing is left behind") {
    // A file system of our own, seen by this shell alone.
    const std::string own = run_in_shell("unshare --mount true").status == 0
                                ? "unshare --mount"
                                : "unshare --user --map-root-user --mount";
    if (run_in_shell(own + " sh -c 'mount -t tmpfs none /mnt'").status != 0) {
        MESSAGE("not allowed to mount here");
        return;
    }
    const Scene scene;
    const std::string disk = scene("disk");
    std::filesystem::create_directory(disk);
    const auto on_disk = [&](const std::string& name, const std::string& before) {
        put_text(scene("script"), "mount -t tmpfs -o size=64k none " + disk + " && cd " + disk +
                                      " && printf old >a.svg && printf old >a.png && " + before +
                                      " || exit 99\n\"$DAPPLE\" render " + scene("cat.png") + " -o " + name +
                                      "\necho status $?, $(cat " + name + "), $(ls -A | wc -l) files\n");
        return run_in_shell(own + " sh " + scene("script"));
    };
    for (const std::string name : {"a.svg", "a.png"}) {
        const Outcome full = on_disk(name, "head -c 40000 /dev/zero >filler");
        CAPTURE(full.err);
        CHECK(full.out == "status 1, old, 3 files\n");
        CHECK(full.err == "dapple: " + name + ": cannot be written: the disk is full\n");
    }
    const Outcome read_only = on_disk("a.svg", "mount -o remount,ro " + disk);
    CAPTURE(read_only.err);
    CHECK(read_only.out == "status 1, old, 2 files\n");
    CHECK(read_only.err == "dapple: a.svg: is read-only; choose another name\n");
    const Outcome new_file = on_disk("b.svg", "printf old >b.svg && rm b.svg && mount -o remount,ro " + disk);
    CHECK(new_file.err.starts_with("dapple: b.svg: the folder . is read-only; choose another\n"));
}

TEST_CASE("Ctrl+C while saving leaves the old drawing and nothing else") {
    const Scene scene;
    write_picture(scene("black.png"), {.width = 64, .height = 64, .values = std::vector<float>(4096, 0.0f)});
    const std::size_t before = scene.folder.entries();
    ChildProcess render(
        {DAPPLE_PROGRAM, "render", scene("black.png"), "-o", scene("old.svg"), "--dots", "2000000"});
    // What is written so far lies beside the old drawing.
    REQUIRE(render.brings([&] { return scene.folder.entries() > before; }));
    render.send(SIGINT);
    CHECK(render.wait() == 128 + SIGINT);
    CHECK(text_of(scene("old.svg")) == "the old drawing");
    CHECK(scene.folder.entries() == before);
}

TEST_CASE("option values that cannot be are refused with the option's name") {
    const Scene scene;
    const std::string from = "render " + scene("cat.png") + " -o " + scene("old.svg") + " ";
    struct Wrong {
        const char* option;
        const char* words;
    };
    for (const Wrong& wrong : {Wrong{"--scale -1", "--scale: -1 is not possible"},
                               Wrong{"--scale 0", "--scale: 0 is not possible"},
                               Wrong{"--scale nan", "--scale: nan is not a number"},
                               Wrong{"--scale inf", "--scale: inf is not a number"},
                               Wrong{"--scale 12x", "--scale: 12x is not a number"},
                               Wrong{"--scale 1e30", "--scale: 1e+30 would make"},
                               Wrong{"--dots 0", "--dots: 0 is not possible"},
                               Wrong{"--dots -5", "--dots: -5 is not possible"},
                               Wrong{"--dots 1.5", "--dots: 1.5 is not possible"},
                               Wrong{"--dots 10.000", "--dots: 10.000 is not possible"},
                               Wrong{"--dots 10,00", "--dots: 10,00 is not possible"},
                               Wrong{"--dots 1,0000", "--dots: 1,0000 is not possible"},
                               Wrong{"--dots 1.2345k", "--dots: 1.2345k is not possible"},
                               Wrong{"--dots 99999999999", "--dots: 99999999999 is not possible"},
                               Wrong{"--dots 10 --scale 10", "--dots: cannot be given together with --scale"},
                               Wrong{"--dots 10 --placer figure8", "--dots: the figure8 placer"},
                               Wrong{"--placer best", "--placer: best is not known"},
                               Wrong{"--ranking best", "--ranking: best is not known"},
                               Wrong{"--tile best", "best: no such tile"},
                               Wrong{"--tile 1,2/17", "17 points"},
                               Wrong{"--dot-radius 0", "--dot-radius: 0 is not possible"},
                               Wrong{"--dot-radius -1", "--dot-radius: -1 is not possible"},
                               Wrong{"--width 0", "--width: 0 is not possible"},
                               Wrong{"--width nan", "--width: nan is not a number"},
                               Wrong{"--dpi 0", "--dpi: 0 is not possible"},
                               Wrong{"--threads -1", "--threads: -1 is not possible"},
                               Wrong{"--threads 1.5", "--threads: 1.5 is not a whole number"},
                               Wrong{"--black-point 2", "--black-point: 2 is not possible"},
                               Wrong{"--black-point 0.5 --white-point 0.5", "--black-point: must be below"},
                               Wrong{"--contrast 1.1", "--contrast: 1.1 is not possible"},
                               Wrong{"--gamma 0", "--gamma: 0 is not possible"},
                               Wrong{"--blur -3", "--blur: -3 is not possible"},
                               Wrong{"--sheet 4,1/3x4", "--sheet: '4,1/3x4': sheets are counted"},
                               Wrong{"--region 1,2,3", "--region: '1,2,3' is not a region"},
                               Wrong{"--region 0,0,0x5", "--region: '0,0,0x5': a region needs a width"},
                               Wrong{"--region -1,0,5x5", "--region: '-1,0,5x5': a region's corner"},
                               Wrong{"--region 150,0,60x10", "--region: the region reaches to 210"},
                               Wrong{"--region 0,0,9x9 --sheet 1,1/2x2", "--region: cannot be given"},
                               Wrong{"--ink blue", "--ink: blue: not a colour"},
                               Wrong{"--nonsense", "--nonsense"}}) {
        scene.must_fail(from + wrong.option, wrong.words);
    }
    scene.must_fail("render " + scene("cat.png") + " -o " + scene("new.png") + " --tiles",
                    "--tiles: only an SVG");
    scene.must_fail("render " + scene("cat.png") + " -o " + scene("new.png") + " --width 100000 --dpi 2400",
                    "9448819 x 6299213 pixels, and 1000000 a side and 4 gigapixels");
    scene.must_fail("render " + scene("cat.png") + " -o " + scene("new.png") + " --dpi 100000",
                    "choose 9800 dots to the inch or fewer");
}
