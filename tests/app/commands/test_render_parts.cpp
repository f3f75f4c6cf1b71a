// dapple render: sheets, regions and margins, the parts of a page.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <map>
#include <pugixml.hpp>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "io/files/picture.h"
#include "tests/file_text.h"
#include "tests/render_scene.h"
#include "tests/run_in_shell.h"

using namespace dapple;

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

TEST_CASE("runs that share the sheets of a mural, or pictures, draw each of them once and as one run does") {
    const Scene scene;
    for (const char* folder : {"one", "many"}) std::filesystem::create_directory(scene(folder));
    const std::string mural = "render " + scene("cat.png") + " --dots 900 --sheets 3x2 -o ";
    REQUIRE(run_dapple(mural + scene("one/m.svg")).status == 0);
    std::filesystem::copy(scene("cat.png"), scene("dog.png"));
    std::filesystem::copy(scene("cat.png"), scene("cow.png"));
    const std::string batch = "render " + scene("cat.png") + " " + scene("dog.png") + " " + scene("cow.png") +
                              " --dots 300 --format csv -o ";
    REQUIRE(run_dapple(batch + scene("one/")).status == 0);
    const auto files = [&](const std::string& folder) {
        std::map<std::string, std::string> texts;
        for (const auto& file : std::filesystem::directory_iterator(scene(folder)))
            texts[file.path().filename().string()] = text_of(file.path());
        return texts;
    };
    std::size_t before = 0;
    for (const char* share : {"1/4", "2/4", "3/4", "4/4"}) {
        REQUIRE(run_dapple(mural + scene("many/m.svg") + " --share " + share).status == 0);
        REQUIRE(run_dapple(batch + scene("many/") + " --share " + share).status == 0);
        CHECK(files("many").size() <= before + 4);
        before = files("many").size();
    }
    CHECK(files("one") == files("many"));
    CHECK(files("one").size() == 7 + 3);
    const std::string to = " -o " + scene("m.svg");
    // What is told is what this run did.
    const Outcome second = run_dapple(mural + scene("m.svg") + " --share 2/3");
    CHECK(second.err.find("2 of 6 sheets of") != std::string::npos);
    CHECK(second.err.find("m-B2.svg; the plan is written with share 1") != std::string::npos);
    CHECK(run_dapple(mural + scene("m.svg") + " --share 1/3").err.find("m-plan.svg shows how") !=
          std::string::npos);
    CHECK(run_dapple(batch + scene("many/") + " --share 6/9").err ==
          "none of the 3 pictures is in share 6 of 9; nothing was drawn\n");
    CHECK(run_dapple(mural + scene("m.svg") + " --share 7/9").err ==
          "none of the 6 sheets is in share 7 of 9; nothing was drawn\n");
    scene.must_fail("render --share 1/2" + to,
                    "--share: applies to several pictures or the sheets of a mural");
    scene.must_fail("render --sheets 2x2 --share 0/2" + to, "0/2 is not a share; give one such as 1/4");
    scene.must_fail("render --sheets 2x2 --share 3/2" + to, "3/2 is not a share");
    scene.must_fail("render --sheets 2x2 --share 1/2 --stats " + scene("s.json") + to,
                    "--stats: would be written");
}

TEST_CASE("settings with sheets draw all of them, one page, or one sheet, as the command says") {
    const Scene scene;
    const std::string sample = "render --dots 500 -o ";
    REQUIRE(run_dapple(sample + scene("m.svg") + " --sheets 2x1 --overlap 12").status == 0);
    const std::string again = "render --settings-from " + scene("m-A1.svg") + " ";
    REQUIRE(run_dapple(again + "-o " + scene("n.svg")).status == 0);
    CHECK(text_of(scene("n-B1.svg")) == text_of(scene("m-B1.svg")));
    REQUIRE(run_dapple(again + "-o " + scene("one.svg") + " --sheets 1x1").status == 0);
    REQUIRE(run_dapple(sample + scene("plain.svg")).status == 0);
    CHECK(text_of(scene("one.svg")) == text_of(scene("plain.svg")));
    REQUIRE(run_dapple(again + "-o " + scene("b.csv") + " --sheet 2,1/2x1 --overlap 12").status == 0);
    REQUIRE(run_dapple(sample + scene("m.csv") + " --sheets 2x1 --overlap 12").status == 0);
    CHECK(text_of(scene("b.csv")) == text_of(scene("m-B1.csv")));
    scene.must_fail(again + "-o -", "--sheets: makes several files");
    scene.must_fail(again + scene("cat.png") + " " + scene("cat.png") + " -o " + scene("drawings/"),
                    "--sheets: applies to one picture");
}

TEST_CASE(
    "sheets with an overlap have its dots on both sides, all of the drawing, and a plan of how they join") {
    const Scene scene;
    const std::string from = "render " + scene("cat.png") + " --width 300 --dots 5000 -o ";
    REQUIRE(run_dapple(from + scene("whole.csv")).status == 0);
    const Outcome drawn = run_dapple(from + scene("m.csv") + " --sheets 3x2 --overlap 12");
    REQUIRE_MESSAGE(drawn.status == 0, drawn.err);
    CHECK(drawn.err.find("6 sheets of 108 x 106 mm") != std::string::npos);

    // Millimetres from a corner; where each place of the whole has to be: its sheet begins each 96 and 94 mm.
    const auto places = [](const std::string& table) {
        std::vector<std::pair<double, double>> read;
        std::istringstream lines(table);
        std::string line;
        std::getline(lines, line);
        while (std::getline(lines, line)) {
            double x = 0, y = 0;
            REQUIRE(std::sscanf(line.c_str(), "%lf,%lf", &x, &y) == 2);
            read.emplace_back(x, y);
        }
        return read;
    };
    const auto whole = places(text_of(scene("whole.csv")));
    std::size_t twice = 0;
    for (int row = 0; row < 2; ++row) {
        for (int column = 0; column < 3; ++column) {
            const std::string name =
                "m-" + std::string(1, static_cast<char>('A' + column)) + std::to_string(row + 1) + ".csv";
            auto on_sheet = places(text_of(scene(name)));
            std::vector<std::pair<double, double>> expected;
            for (const auto& [x, y] : whole) {
                const double across = x - 96 * column, down = y - 94 * row;
                if (across >= 0 && across < 108 && down >= 0 && down < 106)
                    expected.emplace_back(across, down);
            }
            CAPTURE(name);
            REQUIRE(on_sheet.size() == expected.size());
            std::ranges::sort(on_sheet);
            std::ranges::sort(expected);
            double furthest = 0;
            for (std::size_t i = 0; i < expected.size(); ++i)
                furthest = std::max(furthest, std::abs(on_sheet[i].first - expected[i].first));
            CHECK(furthest < 2e-3);
            twice += on_sheet.size();
        }
    }
    CHECK(twice > whole.size() + 300);

    const std::string plan = text_of(scene("m-plan.svg"));
    for (const char* said : {">A1<", ">C2<", "300 x 200 mm on 6 sheets of 108 x 106 mm", "cut 6 mm off"}) {
        CAPTURE(std::string(said));
        CHECK(plan.find(said) != std::string::npos);
    }
    // Two cut lines, each with a mark at both ends, in a corner; three in the middle above.
    for (const auto& [sheet, marks] : {std::pair{"1,1", 4}, std::pair{"2,1", 6}}) {
        REQUIRE(run_dapple(from + scene("s.svg") + " --overlap 12 --sheet " + sheet + "/3x2").status == 0);
        pugi::xml_document svg;
        REQUIRE(svg.load_file(scene("s.svg").c_str()));
        const pugi::xml_node layer =
            svg.child("svg").find_child_by_attribute("inkscape:label", "2 Cut marks");
        CHECK(std::ranges::distance(layer.children("path")) == marks);
    }
    scene.must_fail("render " + scene("cat.png") + " -o " + scene("m.svg") + " --sheets 3x2 --overlap 80",
                    "--overlap: an overlap of 80 mm is too wide");
    scene.must_fail("render " + scene("cat.png") + " -o " + scene("m.svg") + " --overlap 8",
                    "--overlap: applies to sheets only");
}

/// Two drawings that are alike but for the settings in them, which keep a region and no sheet.
static void check_same_part(const std::string& file, const std::string& other) {
    const auto seen = [](const std::string& name) {
        std::string text = text_of(name);
        const std::size_t settings = text.find("<metadata>"), end = text.find("</metadata>");
        if (settings != text.npos) text.erase(settings, end - settings);
        return text;
    };
    if (file.ends_with(".png"))
        CHECK(read_picture(file).light.values == read_picture(other).light.values);
    else
        CHECK(seen(file) == seen(other));
}

TEST_CASE("a region is kept with the drawing's settings, gives way to sheets, and all drops it") {
    const Scene scene;
    const std::string cat = "render " + scene("cat.png"), from = cat + " --settings-from " + scene("r.svg");
    const auto size = [&](const std::string& arguments, const std::string& name) {
        const Outcome outcome = run_dapple(arguments + " -o " + scene(name));
        CAPTURE(outcome.err);
        REQUIRE(outcome.status == 0);
        const Svg svg = read_svg(scene(name));
        return std::string(svg.document.child("svg").attribute("width").value());
    };
    CHECK(size(cat + " --dots 300 --relax 0 --region 10,20,50.8x38.1", "r.svg") == "50.8mm");
    CHECK(size(from, "a.svg") == "50.8mm");
    CHECK(text_of(scene("a.svg")) == text_of(scene("r.svg")));
    CHECK(size(from + " --region all", "a.svg") == "200mm");
    CHECK(size(from + " --region 0,0,30x20", "a.svg") == "30mm");
    CHECK(size(from + " --sheet 2,1/4x1", "a.svg") == "50mm");
    REQUIRE(run_dapple(from + " --sheets 2x1 --region all -o " + scene("m.svg")).status == 0);
    CHECK(size(cat + " --settings-from " + scene("m-A1.svg"), "m-B1.svg") == "100mm");
    REQUIRE(run_dapple(from + " --sheets 2x1 --share 2/2 -o " + scene("m.svg")).status == 0);
    CHECK(read_svg(scene("m-B1.svg")).document.child("svg").attribute("width").value() ==
          std::string("100mm"));
    scene.must_fail(from + " --width 50 -o " + scene("new.svg"),
                    "--region: the region reaches to 60.8 x 58.1 mm, and the page is 50 x ");
    scene.must_fail(from + " --sheets 2x1 --region 0,0,9x9 -o " + scene("new.svg"),
                    "--region: is a part of what --sheets draws");
}

TEST_CASE("a page that is too large for a format is refused with the sheets that it fits on") {
    const Scene scene;
    const std::string cat = "render " + scene("cat.png") + " -o ";
    scene.must_fail(cat + scene("new.pdf") + " --width 12000", "SVG; or draw it in parts with --sheets 3x3");
    scene.must_fail(cat + scene("new.png") + " --width 60000 --dpi 600",
                    "a part of it; or draw it in parts with --sheets 19x19");
    const Outcome part = run_dapple(cat + scene("new.pdf") + " --width 12000 --sheet 1,1/2x2");
    CHECK(part.err.find("5080 mm") != std::string::npos);
    CHECK(part.err.find("--sheets") == std::string::npos);
}

TEST_CASE("a region is what the page shows there, at its place and in its size") {
    const Scene scene;
    const std::string from = "render " + scene("cat.png") + " --width 300 --tile paper16 --dots 5000 -o ";
    REQUIRE(run_dapple(from + scene("page.svg")).status == 0);
    // The second of three columns, the first of two rows.
    for (const std::string ending : {".svg", ".csv", ".png"}) {
        const std::string fine = ending == ".png" ? " --dpi 60" : "";
        REQUIRE(run_dapple(from + scene("r" + ending) + fine + " --region 100,0,100x100").status == 0);
        REQUIRE(run_dapple(from + scene("s" + ending) + fine + " --sheet 2,1/3x2").status == 0);
        check_same_part(scene("r" + ending), scene("s" + ending));
    }
    REQUIRE(run_dapple(from + scene("r.svg") + " --tiles --region 110.5,20,80x61").status == 0);
    const Svg page = read_svg(scene("page.svg")), region = read_svg(scene("r.svg"));
    CHECK(region.document.child("svg").attribute("width").value() == std::string("80mm"));
    CHECK(region.document.child("svg").attribute("height").value() == std::string("61mm"));
    const double px = 96 / 25.4;
    std::size_t expected = 0;
    for (const pugi::xml_node& circle : page.circles()) {
        const double x = circle.attribute("cx").as_double() / px, y = circle.attribute("cy").as_double() / px;
        const double r = circle.attribute("r").as_double() / px;  // of those that reach in
        expected += x >= 110.5 - r && x < 190.5 + r && y >= 20 - r && y < 81 + r;
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

TEST_CASE("the sheets of a PNG or an SVG, laid together, are the page: dots reach over the seams") {
    const Scene scene;
    // Dots 16 pixels wide, at a pixel a millimetre; some lie across every seam.
    const std::string from = "render " + scene("cat.png") + " --width 192 --dot-radius 8 -o ";
    const auto drawn = [&](const std::string& name, const std::string& options, const std::string& ending) {
        const std::string pixels = ending == ".png" ? " --dpi 25.4" : "";
        REQUIRE(run_dapple(from + scene(name + ending) + options + pixels).status == 0);
        if (ending == ".svg")
            REQUIRE(run_in_shell("rsvg-convert --dpi-x 25.4 --dpi-y 25.4 -b white " + scene(name + ending) +
                                 " -o " + scene(name + ".png"))
                        .status == 0);
        return read_picture(scene(name + ".png"));
    };
    for (const auto& [dots, ending] :
         {std::pair(" --dots 80 --relax 0", ".png"), std::pair(" --dots 80 --relax 2", ".png"),
          std::pair(" --dots 80 --relax 2", ".svg")}) {
        CAPTURE(dots);
        CAPTURE(ending);
        const Picture page = drawn("page", dots, ending);
        REQUIRE(page.light.width == 192);
        REQUIRE(page.light.height == 128);
        int black_at_seams = 0;
        for (int y = 0; y < 128; ++y)
            black_at_seams += page.light.at(95, y) == 0 && page.light.at(96, y) == 0;
        for (int x = 0; x < 192; ++x)
            black_at_seams += page.light.at(x, 63) == 0 && page.light.at(x, 64) == 0;
        CHECK(black_at_seams > 30);
        for (int row = 0; row < 2; ++row) {
            for (int column = 0; column < 2; ++column) {
                const std::string sheet = std::to_string(column + 1) + "," + std::to_string(row + 1) + "/2x2";
                const Picture part = drawn("s", dots + (" --sheet " + sheet), ending);
                REQUIRE(part.light.width == 96);
                REQUIRE(part.light.height == 64);
                float farthest = 0;
                for (int y = 0; y < 64; ++y)
                    for (int x = 0; x < 96; ++x)
                        farthest = std::max(farthest, std::abs(part.light.at(x, y) -
                                                               page.light.at(x + 96 * column, y + 64 * row)));
                CHECK(farthest < 0.05f);
            }
        }
    }
}

TEST_CASE("lengths may be in inches, centimetres or points: the same drawing to the byte as in millimetres") {
    const Scene scene;
    const std::string from = "render " + scene("cat.png") + " --dots 300 -o ";
    REQUIRE(run_dapple(from + scene("mm.svg") + " --width 203.2 --margin 12.7 --dot-radius 0.5").status == 0);
    REQUIRE(run_dapple(from + scene("in.svg") + " --width 8in --margin 1.27cm --dot-radius 0.05cm").status ==
            0);
    CHECK(text_of(scene("in.svg")) == text_of(scene("mm.svg")));
    CHECK(text_of(scene("in.svg")).find("width=\"203.2mm\"") != std::string::npos);
}

TEST_CASE("within a margin no dot reaches over the edge, in any format, and sheets still join") {
    const Scene scene;
    const std::string from =
        "render " + scene("cat.png") + " --width 150 --margin 15 --dots 4000 --stats " + scene("m.json");
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

    REQUIRE(run_dapple(from + " -o " + scene("m.png") + " --dpi 60").status == 0);
    const Picture png = read_picture(scene("m.png"));
    CHECK(png.light.width == 354);
    CHECK(png.light.height == 260);
    for (int x = 0; x < png.light.width; ++x) CHECK(png.light.at(x, 20) == 1);
    double ink = 0;
    for (const float light : png.light.values) ink += 1 - light;
    CHECK(ink > 5000);

    std::size_t on_sheets = 0;
    for (const std::string sheet : {"1,1/2x2", "2,1/2x2", "1,2/2x2", "2,2/2x2"}) {
        REQUIRE(run_dapple(from + " -o " + scene("s.dxf") + " --sheet " + sheet).status == 0);
        on_sheets += read_json(scene("m.json"))["dots"].get<std::size_t>();
    }
    CHECK(on_sheets == 4000);
    REQUIRE(run_dapple(from + " -o " + scene("r.svg") + " --region 0,0,75x55").status == 0);
    REQUIRE(run_dapple(from + " -o " + scene("s.svg") + " --sheet 1,1/2x2").status == 0);
    check_same_part(scene("r.svg"), scene("s.svg"));
    scene.must_fail("render " + scene("cat.png") + " -o " + scene("new.svg") + " --margin 100",
                    "--margin: 100 mm on either side leave no room on a page 200 mm wide");
}

TEST_CASE("on a paper with margins exactly so many dots lie, all of each within the margins, on sheets too") {
    const Scene scene;
    const std::string from = "render " + scene("cat.png") + " --page a5 --margin 12,14,16,18 --dots 900";
    // Small dots, large dots, and dots of all sizes; the picture upright, lying, and filling the paper.
    for (const std::string how :
         {" --relax 0", " --fit fill --rotate 90", " --dot-radius 2.5 --orientation portrait",
          " --crop 20%,10%,60%x80% --rotate 270 --orientation landscape"}) {
        CAPTURE(how);
        REQUIRE(run_dapple(from + how + " -o " + scene("p.svg") + " --stats " + scene("p.json")).status == 0);
        const Svg svg = read_svg(scene("p.svg"));
        const double px = 96 / 25.4, width = svg.document.child("svg").attribute("width").as_double(),
                     height = svg.document.child("svg").attribute("height").as_double();
        CHECK(width * height == 148 * 210);
        REQUIRE(svg.circles().size() == 900);
        double least = 1e9;  // from a dot's rim to the nearest margin
        for (const pugi::xml_node& circle : svg.circles()) {
            const auto mm = [&](const char* name) { return circle.attribute(name).as_double() / px; };
            const double x = mm("cx"), y = mm("cy"), r = mm("r");
            least = std::min({least, x - r - 18, width - 14 - x - r, y - r - 12, height - 16 - y - r});
        }
        // Coordinates are rounded to a hundredth of a px.
        CHECK(least > -0.005);
        CHECK(least < 1.5);
        CHECK(read_json(scene("p.json"))["preflight"]["outside_the_margins"] == 0);
        std::size_t on_sheets = 0;
        for (const std::string sheet : {"1,1/2x1", "2,1/2x1"}) {
            REQUIRE(run_dapple(from + how + " -o " + scene("s.dxf") + " --stats " + scene("s.json") +
                               " --sheet " + sheet)
                        .status == 0);
            on_sheets += read_json(scene("s.json"))["dots"].get<std::size_t>();
        }
        CHECK(on_sheets == 900);
    }
    const std::string begin = "render " + scene("cat.png") + " -o " + scene("new.svg");
    scene.must_fail(begin + " --page a4 --width 100", "--width: cannot be given together with --page");
    scene.must_fail(begin + " --fit fill", "--fit: has no effect where the page has the picture's shape");
    scene.must_fail(begin + " --page a9", "--page: a9 is not known");
    scene.must_fail(begin + " --rotate 45", "--rotate: 45 is not known");
    scene.must_fail(begin + " --crop 0,0,97x10",
                    "--crop: the part reaches to 97 x 10 pixels, and the picture is 96 x 64");
    scene.must_fail(begin + " --page a6 --dot-radius 60", "--dot-radius: ");
}

TEST_CASE("where the disk is full in the middle of several files, those before it stay and are told of") {
    const Scene scene;
    // White above: the first two sheets are small.
    std::string picture = "P2 8 8 255\n";
    for (int i = 0; i < 64; ++i) picture += i < 32 ? "255 " : "0 ";
    put_text(scene("half.pgm"), picture);
    const std::string program = "ulimit -f 8; exec \"$DAPPLE\" ";  // of 512 bytes
    const Outcome mural = run_in_shell(program + "render " + scene("half.pgm") +
                                       " --dots 2000 --sheets 2x2 -o " + scene("h.svg"));
    CHECK(mural.status == 1);
    CHECK(mural.err.find("h-A2.svg: cannot be written") != std::string::npos);
    CHECK(mural.err.find("; the 2 before it are saved, and stay\n") != std::string::npos);
    CHECK(std::filesystem::exists(scene("h-B1.svg")));
    const Outcome film = run_in_shell(program + "record " + scene("half.pgm") + " -o " + scene("f/") +
                                      " --seconds 1 --fps 8 --size 100 --dots 3000");
    CHECK(film.status == 1);
    CHECK(film.err.find(" before it are saved, and stay\n") != std::string::npos);
    CHECK(std::filesystem::exists(scene("f/frame-0001.png")));
    for (const auto& entry : std::filesystem::directory_iterator(scene.folder / ""))
        CHECK(entry.path().extension() != ".part");
}
