// Files for each pen: grey pictures beside a PNG or a TIFF, and drawings in place of one.

#include <OpenImageIO/imageio.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "tests/machines.h"
#include "tests/render_scene.h"

namespace dapple {
namespace {

// As it stands in the file, 0..1.
struct Pixels {
    int width = 0, height = 0, channels = 0;
    std::string type = {};
    std::vector<float> values = {};

    float at(int x, int y, int channel = 0) const {
        return values[static_cast<std::size_t>((y * width + x) * channels + channel)];
    }
};

Pixels pixels_of(const std::string& file) {
    const auto in = OIIO::ImageInput::open(file);
    REQUIRE(in);
    const OIIO::ImageSpec& spec = in->spec();
    Pixels pixels{spec.width, spec.height, spec.nchannels, spec.format.c_str()};
    pixels.values.resize(static_cast<std::size_t>(spec.width * spec.height * spec.nchannels));
    REQUIRE(in->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.values.data()));
    return pixels;
}

// IEC 61966-2-1.
float linear(float encoded) {
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

}  // namespace

TEST_CASE("separations are each pen's ink alone, and laid over each other they are the drawing") {
    const Scene scene;
    write_picture(scene("cat.png"), coloured_picture());
    for (const std::string ending : {"png", "tif"}) {
        CAPTURE(ending);
        const std::string deep = ending == "tif" ? " --bits 16" : "";
        const std::string draw = "render " + scene("cat.png") +
                                 " --pens 'Mid (brown):#c0a060:0.6,Ink:#111111:0.4' --dots 900 --width 40 ";
        const Outcome made =
            run_dapple(draw + " --dpi 254 --separations -o " + scene("out." + ending) + deep);
        CAPTURE(made.err);
        REQUIRE(made.status == 0);
        CHECK(made.err.find("out-1-mid-brown." + ending) != std::string::npos);
        const Pixels mix = pixels_of(scene("out." + ending)),
                     own[] = {pixels_of(scene("out-1-mid-brown." + ending)),
                              pixels_of(scene("out-2-ink." + ending))};
        for (const Pixels& one : own) {
            CHECK(one.width == mix.width);
            CHECK(one.height == mix.height);
            CHECK(one.channels == 1);
            CHECK(one.type == (deep.empty() ? "uint8" : "uint16"));
        }
        const glm::vec3 inks[] = {{linear(0xc0 / 255.0f), linear(0xa0 / 255.0f), linear(0x60 / 255.0f)},
                                  glm::vec3(linear(0x11 / 255.0f))};
        float farthest = 0;
        for (int y = 0; y < mix.height; ++y)
            for (int x = 0; x < mix.width; ++x) {
                glm::vec3 light(1);  // what one pen leaves of it the other takes some of
                for (int pen = 0; pen < 2; ++pen)
                    light *= glm::mix(glm::vec3(1), inks[pen], 1 - own[pen].at(x, y));
                for (int c = 0; c < 3; ++c)
                    farthest = std::max(farthest, std::abs(light[c] - linear(mix.at(x, y, c))));
            }
        CHECK(farthest < (deep.empty() ? 0.012f : 0.0005f));
        // Each dot of the table is in its own pen's picture.
        REQUIRE(run_dapple(draw + " -o " + scene("dots.csv")).status == 0);
        std::istringstream lines(text_of(scene("dots.csv")));
        std::string line;
        std::getline(lines, line);
        double area[] = {0, 0};
        while (std::getline(lines, line)) {
            std::istringstream words(line);
            double x = 0, y = 0, radius = 0;
            char comma = 0;
            words >> x >> comma >> y >> comma >> radius;
            const int pen = line.ends_with("Ink");
            area[pen] += 3.14159 * radius * radius;
            const int across = int(x * 10), down = int(y * 10);  // 254 to the inch
            if (across < mix.width && down < mix.height) CHECK(own[pen].at(across, down) < 0.01f);
        }
        // A pen's dots overlap a little, so that they cover less than their areas.
        for (int pen = 0; pen < 2; ++pen) {
            double covered = 0;
            for (const float value : own[pen].values) covered += (1 - value) / 100;
            CHECK(covered < 1.01 * area[pen]);
            CHECK(covered > 20);
            CHECK(covered > 0.6 * area[pen]);
        }
    }
}

TEST_CASE("lines have separations too, and each file its pen's width") {
    const Scene scene;
    REQUIRE(
        run_dapple("render " + scene("cat.png") +
                   " --pens Sand:#d0a040:0.8,Night:#102060:0.4 --style line --dots 400 --width 40 --dpi 254 "
                   "--separations -o " +
                   scene("l.png"))
            .status == 0);
    const Pixels sand = pixels_of(scene("l-1-sand.png")), night = pixels_of(scene("l-2-night.png"));
    const auto ink = [](const Pixels& pixels) {
        double sum = 0;
        for (const float value : pixels.values) sum += 1 - value;
        return sum;
    };
    CHECK(ink(sand) > 1000);
    CHECK(ink(night) > 1000);
    CHECK(sand.values != night.values);
}

TEST_CASE("separations that cannot be are refused, and none overwrites the picture") {
    const Scene scene;
    const std::string draw = "render " + scene("cat.png") + " --separations -o ";
    scene.must_fail(draw + scene("a.png"), "--separations: applies to several pens");
    scene.must_fail(draw + scene("a.svg") + " --pens cmyk", "--separations: applies to a PNG or a TIFF");
    scene.must_fail(draw + "- --format png --pens cmyk", "--separations: makes several files");
    REQUIRE(run_in_shell("cp " + scene("cat.png") + " " + scene("a-1-yellow.png")).status == 0);
    scene.must_fail("render " + scene("a-1-yellow.png") + " --separations --pens cmyk -o " + scene("a.png"),
                    "a-1-yellow.png");
}

TEST_CASE("with registration each separation has crosses in its corners, and nothing else changes") {
    const Scene scene;
    const std::string draw = "render " + scene("cat.png") +
                             " --pens Sand:#d0a040,Night:#102060 --dots 900 --width 60 --dpi 254 "
                             "--separations -o ";
    REQUIRE(run_dapple(draw + scene("a.png")).status == 0);
    REQUIRE(run_dapple(draw + scene("b.png") + " --registration").status == 0);
    const Pixels before = pixels_of(scene("a.png")), after = pixels_of(scene("b.png"));
    CHECK(before.values == after.values);
    for (const std::string pen : {"-1-sand.png", "-2-night.png"}) {
        CAPTURE(pen);
        const Pixels bare = pixels_of(scene("a" + pen)), marked = pixels_of(scene("b" + pen));
        REQUIRE(bare.values.size() == marked.values.size());
        // 60 x 40 mm, 10 pixels to each: crosses 2 mm wide and high, 2 mm from the sides, of lines 0.2 mm
        // wide.
        const auto along = [](int place, int side) { return std::min(place, side - 1 - place); };
        double wrong = 0, white = 0;
        for (int y = 0; y < 400; ++y)
            for (int x = 0; x < 600; ++x) {
                const int across = along(x, 600), down = along(y, 400);
                const bool in_row = (down == 19 || down == 20) && across >= 9 && across < 31;
                const bool in_column = (across == 19 || across == 20) && down >= 9 && down < 31;
                if (in_row || in_column)
                    white += marked.at(x, y);
                else
                    wrong += std::abs(marked.at(x, y) - bare.at(x, y));
            }
        CHECK(white == 0);
        CHECK(wrong == 0);
    }
}

TEST_CASE("with pen files each pen's file has its own dots alone, and waits for no other pen") {
    const Scene scene;
    write_picture(scene("cat.png"), coloured_picture());
    const std::string draw = "render " + scene("cat.png") +
                             " --pens 'Pale (blue):#9cf,Rust:#b52,Ink:#111' --dots 900 --width 60 -o ";
    const std::vector<std::string> pens{"-1-pale-blue", "-2-rust", "-3-ink"};
    for (const std::string ending : {".gcode", ".hpgl"}) {
        CAPTURE(ending);
        const auto plotted = [&](const std::string& name) {
            const std::string text = text_of(scene(name + ending));
            return ending == ".hpgl" ? plotted_hpgl(text) : plotted_gcode(text);
        };
        REQUIRE(run_dapple(draw + scene("all" + ending)).status == 0);
        const Outcome made = run_dapple(draw + scene("own" + ending) + " --pen-files");
        REQUIRE(made.status == 0);
        CHECK(made.err.find("a file for each pen: ") != std::string::npos);
        CHECK_FALSE(std::filesystem::exists(scene("own" + ending)));
        const Plotted all = plotted("all");
        REQUIRE(all.changes.size() == 3);
        std::size_t dots = 0;
        for (std::size_t pen = 0; pen < 3; ++pen) {
            CHECK(all.changes[pen].first_dot == dots);
            const Plotted own = plotted("own" + pens[pen]);
            // A plotter is told to take the first pen; no other machine waits.
            CHECK(own.changes.size() == (ending == ".hpgl" ? 1 : 0));
            REQUIRE(own.dots.size() > 20);
            REQUIRE(dots + own.dots.size() <= all.dots.size());
            const auto from = all.dots.begin() + static_cast<std::ptrdiff_t>(dots);
            CHECK(std::equal(own.dots.begin(), own.dots.end(), from));
            dots += own.dots.size();
        }
        CHECK(dots == all.dots.size());
        CHECK(text_of(scene("own-2-rust" + ending)).find("by the pen Rust on a page of 60 x 40 mm") !=
              std::string::npos);
    }
    const auto circles = [&](const std::string& name) {
        std::istringstream lines(text_of(scene(name + ".svg")));
        std::vector<glm::dvec2> found;
        glm::dvec2 at{};
        for (std::string line; std::getline(lines, line);)
            if (std::sscanf(line.c_str(), "<circle cx=\"%lf\" cy=\"%lf\"", &at.x, &at.y) == 2)
                found.push_back(at);
        return found;
    };
    REQUIRE(run_dapple(draw + scene("all.svg")).status == 0);
    REQUIRE(run_dapple(draw + scene("own.svg") + " --pen-files").status == 0);
    std::vector<glm::dvec2> together;
    for (const std::string& pen : pens) std::ranges::copy(circles("own" + pen), std::back_inserter(together));
    const std::vector<glm::dvec2> all = circles("all");
    CHECK(all.size() == 900);
    REQUIRE(together.size() == all.size());
    double farthest = 0;  // they have as many decimals as so many dots need
    for (std::size_t i = 0; i < all.size(); ++i)
        farthest = std::max(farthest, glm::distance(all[i], together[i]));
    CHECK(farthest < 0.05);
    const std::string pale = text_of(scene("own-1-pale-blue.svg"));
    CHECK(pale.find("inkscape:label=\"1 Pale (blue)\"") != std::string::npos);
    CHECK(pale.find("fill=\"#99ccff\"") != std::string::npos);
    CHECK(pale.find("fill=\"#bb5522\"") == std::string::npos);
    for (const std::string ending : {".pdf", ".dxf"}) {
        REQUIRE(run_dapple(draw + scene("own" + ending) + " --pen-files").status == 0);
        for (const std::string& pen : pens) CHECK(std::filesystem::exists(scene("own" + pen + ending)));
    }
    const std::string fails = "render " + scene("cat.png") + " --pen-files -o ";
    scene.must_fail(fails + scene("a.gcode"), "--pen-files: applies to several pens");
    scene.must_fail(fails + scene("a.png") + " --pens cmyk",
                    "--pen-files: applies to files for plotting only");
    scene.must_fail(fails + scene("a.csv") + " --pens cmyk",
                    "--pen-files: applies to files for plotting only");
    scene.must_fail(fails + "- --format gcode --pens cmyk", "--pen-files: makes several files");
}

}  // namespace dapple
