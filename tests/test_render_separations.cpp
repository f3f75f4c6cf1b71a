// A grey picture for each pen beside a PNG or a TIFF.

#include <OpenImageIO/imageio.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <sstream>
#include <string>
#include <vector>

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
    for (const std::string ending : {"png", "tif"}) {
        CAPTURE(ending);
        const std::string deep = ending == "tif" ? " --bits 16" : "";
        const std::string draw = "render " + scene("cat.png") +
                                 " --pens 'Mid (grey):#809080:0.6,Ink:#111111:0.4' --dots 900 --width 40 ";
        const Outcome made =
            run_dapple(draw + " --dpi 254 --separations -o " + scene("out." + ending) + deep);
        CAPTURE(made.err);
        REQUIRE(made.status == 0);
        CHECK(made.err.find("out-1-mid-grey." + ending) != std::string::npos);
        const Pixels mix = pixels_of(scene("out." + ending)),
                     own[] = {pixels_of(scene("out-1-mid-grey." + ending)),
                              pixels_of(scene("out-2-ink." + ending))};
        for (const Pixels& one : own) {
            CHECK(one.width == mix.width);
            CHECK(one.height == mix.height);
            CHECK(one.channels == 1);
            CHECK(one.type == (deep.empty() ? "uint8" : "uint16"));
        }
        const glm::vec3 inks[] = {{linear(0x80 / 255.0f), linear(0x90 / 255.0f), linear(0x80 / 255.0f)},
                                  glm::vec3(linear(0x11 / 255.0f))};
        float farthest = 0;
        for (int y = 0; y < mix.height; ++y)
            for (int x = 0; x < mix.width; ++x) {
                glm::vec3 light(1);
                for (int pen = 0; pen < 2; ++pen) light = glm::mix(light, inks[pen], 1 - own[pen].at(x, y));
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
    scene.must_fail(draw + scene("a.png"), "--separations: is for several pens");
    scene.must_fail(draw + scene("a.svg") + " --pens cmyk", "--separations: are of a PNG or a TIFF");
    scene.must_fail(draw + "- --format png --pens cmyk", "--separations: makes several files");
    REQUIRE(run_in_shell("cp " + scene("cat.png") + " " + scene("a-1-yellow.png")).status == 0);
    scene.must_fail("render " + scene("a-1-yellow.png") + " --separations --pens cmyk -o " + scene("a.png"),
                    "a-1-yellow.png");
}

}  // namespace dapple
