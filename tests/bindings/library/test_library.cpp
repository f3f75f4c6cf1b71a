// The library as another program has it: nothing here knows core or app.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "dapple/analysis.h"
#include "dapple/dapple.h"
#include "dapple/drawing.h"
#include "dapple/lights.h"
#include "dapple/tile.h"
#include "tests/run_in_shell.h"
#include "tests/temporary_folder.h"

using namespace dapple;

namespace {

constexpr int kWidth = 60, kHeight = 40;

// A ramp with a bright and a coloured spot.
std::vector<std::uint8_t> pixels_of_ramp() {
    std::vector<std::uint8_t> pixels;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const bool spot = (x - 15) * (x - 15) + (y - 20) * (y - 20) < 60;
            const auto grey = static_cast<std::uint8_t>(x * 4);
            for (const std::uint8_t channel :
                 {grey, spot ? std::uint8_t{220} : grey, spot ? std::uint8_t{40} : grey})
                pixels.push_back(channel);
        }
    }
    return pixels;
}

LightPicture ramp() {
    return picture_of_srgb(pixels_of_ramp(), kWidth, kHeight, 3);
}

std::string text_of_file(const std::filesystem::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string written(const Drawing& drawing, FileFormat format) {
    std::ostringstream out;
    CHECK(drawing.write(out, format));
    return std::move(out).str();
}

}  // namespace

TEST_CASE("the library's files are the program's, byte for byte") {
    const TemporaryFolder folder;
    const std::vector<std::uint8_t> pixels = pixels_of_ramp();
    {
        std::ofstream picture(folder / "ramp.ppm");
        picture << "P6 " << kWidth << ' ' << kHeight << " 255\n";
        picture.write(reinterpret_cast<const char*>(pixels.data()),
                      static_cast<std::streamsize>(pixels.size()));
    }
    struct Same {
        const char *settings, *options, *ending;
        FileFormat format;
    };
    for (const Same& same : {
             Same{R"({"drawing": {"count": 3000}})", "--dots 3000", "svg", FileFormat::svg},
             Same{R"({"drawing": {"count": 2000, "relax": 0}})", "--dots 2000 --relax 0", "csv",
                  FileFormat::csv},
             Same{R"({"drawing": {"count": 2000, "pens": "cmyk"}})", "--dots 2000 --pens cmyk", "svg",
                  FileFormat::svg},
             Same{R"({"drawing": {"count": 1500, "style": "line", "page": {"paper": "A4"}}})",
                  "--dots 1500 --style line --page a4", "hpgl", FileFormat::hpgl},
             Same{R"({"drawing": {"count": 1000, "tile": "aperiodic64", "placer": "exact"}})",
                  "--dots 1000 --tile aperiodic64", "dxf", FileFormat::dxf},
             Same{R"({"drawing": {"count": 900}, "saving": {"gcode_tool": "laser"}})",
                  "--dots 900 --gcode laser", "gcode", FileFormat::gcode},
         }) {
        CAPTURE(same.options);
        Stippler stippler;
        stippler.set_picture(ramp());
        const auto drawing = stippler.draw(Settings(same.settings));
        REQUIRE(drawing);
        const std::string file = (folder / "drawing.").string() + same.ending;
        const Outcome outcome =
            run_dapple("render " + (folder / "ramp.ppm").string() + " -o " + file + " " + same.options);
        CAPTURE(outcome.err);
        REQUIRE(outcome.status == 0);
        CHECK(written(*drawing, same.format) == text_of_file(file));
    }
}

TEST_CASE("a drawing tells its dots in millimetres, and is the same for any number of threads") {
    std::vector<std::vector<float>> xs;
    for (const int threads : {1, 3}) {
        Stippler stippler(threads);
        stippler.set_picture(ramp());
        Settings settings(R"({"drawing": {"page": {"width_mm": 90}}})");
        settings.set_dots(2000);
        const auto drawing = stippler.draw(settings);
        REQUIRE(drawing);
        CHECK(drawing->count() == 2000);
        CHECK(drawing->page_width_mm() == doctest::Approx(90));
        CHECK(drawing->page_height_mm() == doctest::Approx(60));
        std::vector<float>& all = xs.emplace_back();
        std::size_t left = 0;
        CHECK(drawing->for_each([&](const DotSpan& dots) {
            for (std::size_t i = 0; i < dots.x.size(); ++i) {
                all.push_back(dots.x[i]);
                left += dots.x[i] < 30;
                CHECK((dots.x[i] >= 0 && dots.x[i] <= 90.001f && dots.y[i] >= 0 && dots.y[i] <= 60.001f));
                CHECK(dots.radius[i] > 0.1f);
            }
            return true;
        }));
        CHECK(left > 900);  // where it is dark
    }
    CHECK(xs[0].size() == 2000);
    CHECK(xs[0] == xs[1]);
}

TEST_CASE("a plan says what settings come to before a dot is placed") {
    Stippler stippler;
    stippler.set_picture(ramp());
    const Settings settings(R"({"drawing": {"count": 2500, "page": {"width_mm": 90}, "pens": "cmyk"}})");
    const Plan plan = stippler.plan(settings);
    const auto drawing = stippler.draw(settings);
    REQUIRE(drawing);
    CHECK(plan.dots == drawing->count());
    CHECK(plan.page_width_mm == drawing->page_width_mm());
    CHECK(plan.page_height_mm == drawing->page_height_mm());
    CHECK(plan.pens.size() == 4);
    CHECK(plan.steps > 0);
    float largest = 0;
    drawing->for_each([&](const DotSpan& dots) {
        for (const float radius : dots.radius) largest = std::max(largest, radius);
        return true;
    });
    CHECK(largest == doctest::Approx(plan.radius_mm));
    // By a scale it is about so many.
    const Settings by_scale(R"({"drawing": {"count": null, "scale": 3000}})");
    CHECK(double(stippler.draw(by_scale)->count()) ==
          doctest::Approx(double(stippler.plan(by_scale).dots)).epsilon(0.02));
    CHECK(stippler.plan(Settings(R"({"drawing": {"automatic_tone": false, "tone": {"gamma": 2}}})")).gamma ==
          2);
}

TEST_CASE("what to know before plotting is told as the program tells it") {
    Stippler stippler;
    stippler.set_picture(ramp());
    const auto kinds = [&](const char* settings, FileFormat format) {
        std::string all;
        for (const Advice& advice : stippler.draw(Settings(settings))->advice(format))
            all += advice.kind + " ";
        return all;
    };
    const std::string crowded = kinds(
        R"({"drawing": {"count": 9000, "dot_size": {"sizing": "fixed", "radius_mm": 2}}})", FileFormat::svg);
    CAPTURE(crowded);
    CHECK(crowded.find("overlap ") != std::string::npos);
    CHECK(crowded.find("tone ") != std::string::npos);
    CHECK(kinds(R"({"drawing": {"count": 500}})", FileFormat::csv) == "");
}

TEST_CASE("tiles come as text and as points, and a drawing by a tile's text is that by its name") {
    const std::vector<std::string> names = tile_names();
    CHECK(std::ranges::count(names, "paper16") == 1);
    const TilePoints points = tile_points(tile_text("paper16"));
    CHECK(points.kinds == 1);
    REQUIRE(points.x.size() == 16);
    // Doubled, each is one of the others: the paper's tile is the cycle of 2x mod 1.
    for (std::size_t i = 0; i < 16; ++i) {
        double nearest = 1;
        for (std::size_t k = 0; k < 16; ++k)
            nearest = std::min(nearest, std::hypot(std::fmod(2 * points.x[i], 1) - points.x[k],
                                                   std::fmod(2 * points.y[i], 1) - points.y[k]));
        CHECK(nearest < 1e-12);
    }
    CHECK_THROWS_WITH(tile_text("paper17"), doctest::Contains("paper17 is no tile"));
    Stippler named, given;
    named.set_picture(ramp());
    given.set_picture(ramp());
    given.set_tile(tile_text("aperiodic64"));
    CHECK(written(*named.draw(Settings(R"({"drawing": {"tile": "aperiodic64", "count": 800}})")),
                  FileFormat::csv) ==
          written(*given.draw(Settings(R"({"drawing": {"count": 800}})")), FileFormat::csv));
}

TEST_CASE("a drawing tells the copies of its tile, each a quarter of a larger one") {
    Stippler stippler;
    stippler.set_picture(ramp());
    const Settings settings(
        R"({"drawing": {"count": 3000, "relax": 0, "tile": "best32", "page": {"width_mm": 160,
        "margins_mm": {"top": 5, "right": 5, "bottom": 5, "left": 5}}}})");
    const Drawing drawing = *stippler.draw(settings);
    const double beside = 2 * (5 + stippler.plan(settings).radius_mm);
    const double longer_side =
        std::min(160 - beside, double{kWidth} / kHeight * (drawing.page_height_mm() - beside));
    const std::vector<DrawnTile> tiles = drawing.tiles();
    REQUIRE(tiles.size() > 10);
    int deepest = 0;
    for (const DrawnTile& tile : tiles) {
        CHECK(tile.side == doctest::Approx(std::ldexp(longer_side, -tile.level)));
        deepest = std::max(deepest, tile.level);
        if (tile.level == 0) continue;
        CHECK(std::ranges::any_of(tiles, [&](const DrawnTile& larger) {
            const auto is_half = [&](double part, double whole) {
                return std::abs(part - whole) < 1e-6 || std::abs(part - whole - tile.side) < 1e-6;
            };
            return larger.level == tile.level - 1 && is_half(tile.x, larger.x) && is_half(tile.y, larger.y);
        }));
    }
    CHECK(deepest > 0);
    // Every dot lies in one.
    drawing.for_each([&](const DotSpan& dots) {
        for (std::size_t i = 0; i < dots.x.size(); ++i)
            CHECK(std::ranges::any_of(tiles, [&](const DrawnTile& tile) {
                const double x = dots.x[i] - tile.x, y = dots.y[i] - tile.y, slack = 1e-3;
                return std::min(x, y) > -slack && std::max(x, y) < tile.side + slack;
            }));
        return true;
    });
}

TEST_CASE("a density gives dots in proportion, and a white one none that would be drawn") {
    Stippler stippler;
    std::vector<float> density(100 * 100, 0.2f);
    for (std::size_t i = 5000; i < density.size(); ++i) density[i] = 0.8f;
    stippler.set_density(density, 100, 100);
    const auto drawing = stippler.draw(Settings(R"({"drawing": {"count": 10000, "relax": 0}})"));
    REQUIRE(drawing);
    int above = 0;
    drawing->for_each([&](const DotSpan& dots) {
        for (const float y : dots.y) above += y < 100;
        return true;
    });
    CHECK(above == doctest::Approx(2000).epsilon(0.03));
    const PagePixels pixels = drawing->pixels(25.4);
    CHECK(pixels.width == 200);
    CHECK(pixels.rgb.size() == 3u * 200 * 200);
}

TEST_CASE(
    "a density's cells have their dots, and none where it is 0, or it changes evenly between their middles") {
    // One cell of nine.
    std::vector<float> density(9);
    density[4] = 1;
    for (const Interpolation interpolation : {Interpolation::nearest, Interpolation::linear}) {
        Stippler stippler;
        stippler.set_density(density, 3, 3, interpolation);
        const auto drawing = stippler.draw(Settings(
            R"({"drawing": {"count": 2000, "settle_for": "samples", "page": {"width_mm": 3, "margins_mm": {"on":
                true, "top": 0, "right": 0, "bottom": 0, "left": 0}}}})"));
        REQUIRE(drawing);
        int beside = 0;
        drawing->for_each([&](const DotSpan& dots) {
            for (std::size_t i = 0; i < dots.x.size(); ++i)
                beside += std::abs(dots.x[i] - 1.5f) > 0.501f || std::abs(dots.y[i] - 1.5f) > 0.501f;
            return true;
        });
        // A tent's parts beyond its middle half, of either side.
        const double expected = interpolation == Interpolation::nearest ? 0 : 2000 * (1 - 0.75 * 0.75);
        CHECK(beside == doctest::Approx(expected).epsilon(0.1));
    }
}

TEST_CASE("settings and drawings that were moved from are as before, and a stippler can be given another") {
    Settings settings(R"({"drawing": {"count": 300}})");
    const std::string text = settings.text();
    const Settings moved = std::move(settings);
    CHECK(moved.text() == text);
    CHECK(settings.text() == text);  // NOLINT(bugprone-use-after-move)
    Stippler stippler;
    stippler.set_picture(ramp());
    Drawing drawing = *stippler.draw(moved);
    const Drawing other = std::move(drawing);
    CHECK(drawing.count() == 300);  // NOLINT(bugprone-use-after-move)
    Stippler another = std::move(stippler);
    CHECK(another.draw(moved)->count() == 300);
    const auto refuses = [&](const auto& use) {
        CHECK_THROWS_WITH(use(), "the stippler was moved from; assign another one to it");
    };
    // NOLINTBEGIN(bugprone-use-after-move)
    refuses([&] { stippler.draw(moved); });
    refuses([&] { stippler.plan(moved); });
    refuses([&] { stippler.set_picture(ramp()); });
    refuses([&] { stippler.set_density(std::vector<float>(1, 0.5f), 1, 1); });
    refuses([&] { stippler.set_tile(""); });
    // NOLINTEND(bugprone-use-after-move)
    stippler = std::move(another);
    CHECK(stippler.draw(moved)->count() == 300);
}

TEST_CASE("what is wrong is said in a sentence that names the field") {
    CHECK_THROWS_WITH(Settings(R"({"drawing": {"count": 0}})"),
                      "settings: drawing.count is 0; give a whole number from 1 to 10000000000, or null");
    CHECK_THROWS_WITH(Settings(R"({"drawing": {"dots": 5}})"),
                      "settings: drawing.dots is not known; the usual settings list all fields");
    CHECK_THROWS_WITH(Settings(R"({"drawing": {"tone": {"contrst": 5}}})"),
                      "settings: drawing.tone.contrst is not known; the usual settings list all fields");
    CHECK_THROWS_WITH(Settings(R"({"count": 5})"),
                      "settings: count is not known; fields are in \"drawing\" and \"saving\"");
    CHECK_THROWS_WITH(Settings("{"), doctest::Contains("settings: line 1 is not JSON"));
    CHECK_THROWS_WITH(Settings("[]"), doctest::Contains("settings: "));
    Settings settings;
    CHECK_THROWS_AS(settings.set(R"({"drawing": {"count": 70, "scale": -1}})"), std::runtime_error);
    CHECK(settings.changed() == Settings().changed());
    CHECK(Settings(settings.text()).text() == Settings().text());

    Stippler stippler;
    CHECK_THROWS_WITH(stippler.draw({}), doctest::Contains("there is no picture yet"));
    CHECK_THROWS_WITH(picture_of_srgb(std::vector<std::uint8_t>(5), 2, 2, 1),
                      doctest::Contains("which has 4"));
    LightPicture picture = ramp();
    picture.light[7] = std::nanf("");
    CHECK_THROWS_WITH(stippler.set_picture(picture), doctest::Contains("not finite"));
    CHECK_THROWS_WITH(stippler.set_density(std::vector<float>{0.5f, 2}, 2, 1), doctest::Contains("0 to 1"));
    CHECK_THROWS_WITH(stippler.set_tile("a tile"), doctest::Contains("line 1"));
    stippler.set_picture(ramp());
    CHECK_THROWS_WITH(stippler.draw(Settings(R"({"drawing": {"tile": "/etc/hostname"}})")),
                      doctest::Contains("set_tile()"));
    const auto drawing = stippler.draw(Settings(R"({"drawing": {"count": 100}})"));
    CHECK(drawing->count() == 100);
    CHECK_THROWS_WITH(drawing->pixels(0), "0 pixels to the inch; give more than 0");
    CHECK_THROWS_WITH(drawing->pixels(std::nan("")), doctest::Contains("nan pixels to the inch"));
}

TEST_CASE("rows have the window's names, and every field that they name can be set") {
    const auto rows = nlohmann::json::parse(Settings::rows());
    const auto all = nlohmann::json::parse(Settings().text());
    for (const auto& each : rows.items()) {
        const std::string field = each.key();
        CAPTURE(field);
        std::string pointer = "/" + field;
        std::ranges::replace(pointer, '.', '/');
        CHECK(all.contains(nlohmann::json::json_pointer(pointer)));
        CHECK(each.value()["row"] != "");
    }
    CHECK(rows["drawing.tone.contrast"]["row"] == "Contrast");
    CHECK(rows["drawing.tone.contrast"]["tip"] ==
          "Above 0 parts light from dark, below 0 brings them closer together.");
    CHECK(rows["drawing.page.fit"]["choices"] == std::vector{"inside", "fill"});
    CHECK(rows["drawing.page.width_mm"]["unit"] == "mm");

    // What a slider has at its ends is accepted, and what is beyond the range is not.
    const auto contrast = [](double value) {
        return Settings(nlohmann::json{{"drawing", {{"tone", {{"contrast", value}}}}}}.dump());
    };
    const auto& range = rows["drawing.tone.contrast"];
    CHECK_NOTHROW(contrast(range["from"]));
    CHECK_NOTHROW(contrast(range["to"]));
    CHECK_THROWS(contrast(range["most"].get<double>() + 0.1));
}

TEST_CASE("whoever waits is told, and can stop") {
    Stippler stippler;
    stippler.set_picture(ramp());
    double last = 0;
    const auto drawing = stippler.draw(Settings(), {{}, [&](double share) { last = share; }});
    REQUIRE(drawing);
    CHECK(last == 1);
    std::stop_source stop;
    stop.request_stop();
    CHECK_FALSE(stippler.draw(Settings(R"({"drawing": {"count": 50000}})"), {stop.get_token(), {}}));
    std::ostringstream out;
    CHECK_FALSE(drawing->write(out, FileFormat::svg, {stop.get_token(), {}}));
}

TEST_CASE("a picture is the same from 8 bits, 16 bits, numbers and light") {
    // Grey and alpha: half transparent black, and a grey.
    const std::vector<std::uint8_t> eight{0, 51, 102, 255};
    const LightPicture picture = picture_of_srgb(eight, 2, 1, 2);
    CHECK(picture.light[0] == doctest::Approx(0.8));
    CHECK(picture.light[1] == doctest::Approx(std::pow((0.4 + 0.055) / 1.055, 2.4)));
    std::vector<std::uint16_t> sixteen;
    std::vector<float> numbers;
    for (const std::uint8_t value : eight) {
        sixteen.push_back(static_cast<std::uint16_t>(257 * value));
        numbers.push_back(static_cast<float>(value) / 255);
    }
    CHECK(picture_of_srgb(sixteen, 2, 1, 2).light == picture.light);
    CHECK(picture_of_srgb(numbers, 2, 1, 2).light == picture.light);
    numbers[2] = picture.light[1];
    CHECK(picture_of_light(numbers, 2, 1, 2).light == picture.light);

    const LightPicture coloured = picture_of_light(std::vector<float>{3, 0.5f, 0}, 1, 1, 3);
    CHECK(coloured.colours == std::vector<float>{3, 0.5f, 0});
    CHECK(coloured.light[0] == doctest::Approx(0.2126 * 3 + 0.7152 * 0.5));
    CHECK_THROWS_WITH(picture_of_srgb(std::vector<float>{0.5f, 255}, 2, 1, 1),
                      doctest::Contains("has the value 255; sRGB-encoded numbers are within 0 to 1"));
    CHECK_THROWS_WITH(picture_of_srgb(std::vector<float>{std::nanf("")}, 1, 1, 1), doctest::Contains("nan"));
}

TEST_CASE("a file's name says its format") {
    CHECK(file_format("a.b/cat.SVG") == FileFormat::svg);
    CHECK(file_format("cat.nc") == FileFormat::gcode);
    CHECK(file_format(".plt") == FileFormat::hpgl);
    CHECK(file_format("json") == FileFormat::json);
    CHECK_THROWS_WITH(file_format("cat.pdf"),
                      "cat.pdf: not a format; give svg, gcode, hpgl, dxf, csv or json");
    CHECK_THROWS_WITH(file_format(""), doctest::Contains("not a format"));
}

TEST_CASE("lights carry the map's flux, and points are measured") {
    std::vector<float> sky(3 * 64 * 32, 0.5f);
    for (int i = 0; i < 3; ++i) sky[static_cast<std::size_t>(3 * (8 * 64 + 32) + i)] = 2000;
    const std::vector<SampledLight> lights = sample_lights(sky, 64, 32, {.count = 200});
    CHECK(lights.size() == 200);
    double flux = 0, length = 0;
    for (const SampledLight& light : lights) {
        flux += light.weight[0];
        length += std::hypot(light.direction[0], light.direction[1], light.direction[2]);
    }
    // 4 pi of the sky, and the texel's solid angle, (2 pi / 64) (cos(8 pi / 32) - cos(9 pi / 32)).
    const double pi = 3.14159265358979;
    const double texel = 2 * pi / 64 * (std::cos(8 * pi / 32) - std::cos(9 * pi / 32));
    CHECK(flux == doctest::Approx(4 * pi * 0.5 + texel * 1999.5).epsilon(1e-5));
    CHECK(length == doctest::Approx(200));
    CHECK_THROWS_WITH(sample_lights(sky, 32, 64), doctest::Contains("twice"));
    CHECK_THROWS_WITH(sample_lights(sky, 64, 32, {.threads = -1}), doctest::Contains("threads is -1"));
    CHECK_THROWS_AS(sample_lights(sky, 64, 32, {.count = 0}), std::runtime_error);
    CHECK_THROWS_AS(sample_lights(sky, 64, 32, {.count = 10'000'001}), std::runtime_error);

    std::vector<double> x, y;
    for (int i = 0; i < 32; ++i) {
        for (int k = 0; k < 32; ++k) {
            x.push_back(i + 0.5);
            y.push_back(k + 0.5);
        }
    }
    const PointEvenness grid = evenness_of(x, y, 32, 32);
    CHECK(grid.count == 1024);
    // A square grid's spacing is 1, the largest sqrt(2 / sqrt(3)).
    CHECK(grid.nearest_minimum == doctest::Approx(std::sqrt(std::sqrt(3.0) / 2)));
    CHECK(grid.power_below_05 < 1e-6);
    CHECK(periodicity_of(x, y, 32, 32, 1) == doctest::Approx(1));
    CHECK(periodicity_of(x, y, 32, 32, 11.0 / 9) < 0);  // eight times it is no whole number yet
    CHECK_THROWS_WITH(periodicity_of(x, y, 32, 32, 0), "a period of 0 cannot repeat; give a positive length");
    // One wave a spacing to the right: a peak, halfway between the middle and the edge. None that is longer.
    const SpectrumPicture spectrum = spectrum_of(x, y, 32, 32);
    REQUIRE(spectrum.width == spectrum.height);
    const auto pixel = [&](double right) {
        const auto column = static_cast<std::size_t>((0.5 + right / 2) * spectrum.width);
        const std::size_t at = 3 * (static_cast<std::size_t>(spectrum.height / 2 * spectrum.width) + column);
        return std::vector<int>(&spectrum.rgb[at], &spectrum.rgb[at] + 3);
    };
    CHECK(pixel(0.5) == std::vector{255, 140, 0});
    CHECK(pixel(0.25) == std::vector{0, 0, 0});
    x.pop_back();
    CHECK_THROWS_WITH(evenness_of(x, y, 32, 32), doctest::Contains("1023 values of x and 1024 of y"));
}

TEST_CASE("dots of a tile that repeats meet others after its period, and those of eight kinds do not") {
    Stippler stippler;
    const std::vector<float> grey(1, 0.5f);
    stippler.set_density(grey, 1, 1);
    for (const std::string tile : {"best32", "kinds4096"}) {
        CAPTURE(tile);
        const bool repeats = tile == "best32";
        Settings settings;
        settings.set(std::string(R"({"drawing": {"count": 20000, "relax": 0, "tile": ")") + tile + "\"}}");
        const Drawing drawing = *stippler.draw(settings);
        std::vector<double> x, y;
        drawing.for_each([&](const DotSpan& dots) {
            x.insert(x.end(), dots.x.begin(), dots.x.end());
            y.insert(y.end(), dots.y.begin(), dots.y.end());
            return true;
        });
        const double period = drawing.period_mm();
        // 625 tiles of 32 points are more than the 256 of level 4, and fewer than the next ones; likewise
        // four of 4,096.
        const double side = drawing.page_width_mm() / (repeats ? 16 : 2);
        CHECK(period == doctest::Approx(side).epsilon(0.02));
        const double value = periodicity_of(x, y, drawing.page_width_mm(), drawing.page_height_mm(), period,
                                            PointEdges::unknown);
        CHECK((value > 0.9) == repeats);
        CHECK((value < 0.1) == !repeats);
    }
}

TEST_CASE("C gets the same bytes, and errors as text") {
    dapple_stippler* const stippler = dapple_stippler_new(1);
    REQUIRE(stippler);
    CHECK_FALSE(dapple_draw(stippler, nullptr, nullptr, nullptr));
    CHECK(std::string(dapple_error()).find("no picture yet") != std::string::npos);
    const std::vector<std::uint8_t> pixels = pixels_of_ramp();
    CHECK(dapple_set_picture(stippler, nullptr, kWidth, kHeight, 3) == -1);
    CHECK(std::string(dapple_error()) == "pixels is NULL");
    CHECK(dapple_set_picture(stippler, pixels.data(), -1, kHeight, 3) == -1);
    const auto refused = [](int result, const char* sentence) {
        CHECK(result == -1);
        CHECK(std::string(dapple_error()).find(sentence) != std::string::npos);
    };
    const int most = std::numeric_limits<int>::max();
    for (const int threads : {-1, 1025, most}) {
        CHECK_FALSE(dapple_stippler_new(threads));
        CHECK(std::string(dapple_error()) ==
              "threads is " + std::to_string(threads) + "; give a whole number from 0 to 1024");
    }
    for (const int channels : {-1, 0, 5, most})
        refused(dapple_set_picture(stippler, pixels.data(), kWidth, kHeight, channels), "channels 1 to 4");
    const std::vector<float> light(1, 0.5f);
    for (const auto& [width, height] : {std::pair{0, 1}, {1, 0}, {-1, -1}, {most, -most}}) {
        refused(dapple_set_picture(stippler, pixels.data(), width, height, 1), "sides are 1 or more");
        refused(dapple_set_light(stippler, light.data(), nullptr, width, height), "sides are 1 or more");
        refused(dapple_set_density(stippler, light.data(), width, height), "sides are 1 or more");
        refused(dapple_set_linear_density(stippler, light.data(), width, height), "sides are 1 or more");
    }
    refused(dapple_set_picture(stippler, pixels.data(), most, most, 4), "megapixels");
    refused(dapple_set_light(stippler, light.data(), light.data(), most, most), "megapixels");
    refused(dapple_set_density(stippler, light.data(), most, 2), "megapixels");
    REQUIRE(dapple_set_picture(stippler, pixels.data(), kWidth, kHeight, 3) == 0);
    const char* const json = R"({"drawing": {"count": 500}})";
    CHECK_FALSE(dapple_draw(stippler, "{\"drawing\": {\"count\": -1}}", nullptr, nullptr));
    CHECK(std::string(dapple_error()).find("drawing.count is -1") != std::string::npos);
    CHECK_FALSE(dapple_draw(
        stippler, json, [](double, void*) { return 1; }, nullptr));
    CHECK(std::string(dapple_error()) == "stopped");
    dapple_drawing* const drawing = dapple_draw(stippler, json, nullptr, nullptr);
    REQUIRE(drawing);
    CHECK(dapple_drawing_count(drawing) == 500);
    std::vector<float> x(500, -1);
    CHECK(dapple_drawing_dots(drawing, x.data(), nullptr, nullptr, nullptr) == 0);
    double width = 0;
    dapple_drawing_page_mm(drawing, &width, nullptr);
    for (const float each : x) CHECK((each >= 0 && each <= width + 0.001));

    Stippler same;
    same.set_picture(ramp());
    std::size_t size = 0;
    char* const svg = dapple_drawing_text(drawing, "svg", &size);
    REQUIRE(svg);
    CHECK(std::string(svg, size) == written(*same.draw(Settings(json)), FileFormat::svg));
    CHECK(std::strlen(svg) == size);
    dapple_free(svg);
    CHECK_FALSE(dapple_drawing_text(drawing, "bmp", nullptr));
    CHECK(std::string(dapple_error()).find("bmp: not a format") != std::string::npos);
    dapple_drawing_free(drawing);
    dapple_stippler_free(stippler);
    dapple_drawing_free(nullptr);
    dapple_free(nullptr);
}
