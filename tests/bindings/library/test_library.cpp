// The library as another program has it: nothing here knows more of core than is installed.

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

#include "core/analysis/report.h"
#include "core/drawing/stippler.h"
#include "core/lights/direction.h"
#include "core/lights/light_samples.h"
#include "core/settings/settings_json.h"
#include "core/tile/tile_file.h"
#include "dapple/dapple.h"
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

std::string written(const Drawing& drawing, DrawingFormat format) {
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
        DrawingFormat format;
    };
    for (const Same& same : {
             Same{R"({"drawing": {"count": 3000}})", "--dots 3000", "svg", DrawingFormat::svg},
             Same{R"({"drawing": {"count": 2000, "relax": 0}})", "--dots 2000 --relax 0", "csv",
                  DrawingFormat::csv},
             Same{R"({"drawing": {"count": 2000, "pens": "cmyk"}})", "--dots 2000 --pens cmyk", "svg",
                  DrawingFormat::svg},
             Same{R"({"drawing": {"count": 1500, "style": "line", "page": {"paper": "A4"}}})",
                  "--dots 1500 --style line --page a4", "hpgl", DrawingFormat::hpgl},
             Same{R"({"drawing": {"count": 1000, "tile": "aperiodic64", "placer": "exact"}})",
                  "--dots 1000 --tile aperiodic64", "dxf", DrawingFormat::dxf},
             Same{R"({"drawing": {"count": 900}, "saving": {"gcode_tool": "laser"}})",
                  "--dots 900 --gcode laser", "gcode", DrawingFormat::gcode},
         }) {
        CAPTURE(same.options);
        Stippler stippler;
        stippler.set_picture(ramp());
        const auto drawing = stippler.draw(settings_of(same.settings));
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
        Settings settings = settings_of(R"({"drawing": {"page": {"width_mm": 90}}})");
        settings.drawing.placing.count = 2000;
        const auto drawing = stippler.draw(settings);
        REQUIRE(drawing);
        CHECK(drawing->count == 2000);
        CHECK(drawing->page.whole.size.width_mm == doctest::Approx(90));
        CHECK(drawing->page.whole.size.height_mm == doctest::Approx(60));
        std::vector<float>& all = xs.emplace_back();
        std::size_t left = 0;
        CHECK(drawing->for_each_piece([&](const Dots& dots) {
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
    const Settings settings =
        settings_of(R"({"drawing": {"count": 2500, "page": {"width_mm": 90}, "pens": "cmyk"}})");
    const DrawingPlan plan = stippler.plan(settings.drawing);
    const auto drawing = stippler.draw(settings);
    REQUIRE(drawing);
    CHECK(plan.dots() == static_cast<double>(drawing->count));
    CHECK(plan.scale() == drawing->scale);
    const PageSize page = plan.layout(plan.scale()).page;
    CHECK(page.width_mm == drawing->page.whole.size.width_mm);
    CHECK(page.height_mm == drawing->page.whole.size.height_mm);
    CHECK(plan.pens.size() == 4);
    CHECK(plan.steps > 0);
    float largest = 0;
    drawing->for_each_piece([&](const Dots& dots) {
        for (const float radius : dots.radius) largest = std::max(largest, radius);
        return true;
    });
    CHECK(largest == doctest::Approx(plan.radius_mm(plan.scale())));
    // By a scale it is about so many.
    const Settings by_scale = settings_of(R"({"drawing": {"count": null, "scale": 3000}})");
    CHECK(double(stippler.draw(by_scale)->count) ==
          doctest::Approx(stippler.plan(by_scale.drawing).dots()).epsilon(0.02));
    DrawingSettings bright;
    bright.automatic_tone = false;
    bright.tone.gamma = 2;
    CHECK(stippler.plan(bright).tone.gamma == 2);

    // As JSON, of the drawing and of its plan.
    const std::string report = report_json(*drawing);
    CHECK(report == report_json(plan, settings.drawing));
    const auto found = nlohmann::json::parse(report);
    CHECK(found["dots"] == 2500);
    CHECK(found["page_mm"] == std::vector{page.width_mm, page.height_mm});
    CHECK(found["pens"].size() == 4);
    CHECK(found["tone"]["gamma"].get<float>() == plan.tone.gamma);
}

TEST_CASE("what to know before plotting is told as the program tells it") {
    Stippler stippler;
    stippler.set_picture(ramp());
    const auto kinds = [&](const char* settings, DrawingFormat format) {
        std::string all;
        for (const Finding& finding : stippler.draw(settings_of(settings))->findings(format))
            all += std::string(name_of(finding.kind)) + " ";
        return all;
    };
    const std::string crowded =
        kinds(R"({"drawing": {"count": 9000, "dot_size": {"sizing": "fixed", "radius_mm": 2}}})",
              DrawingFormat::svg);
    CAPTURE(crowded);
    CHECK(crowded.find("overlap ") != std::string::npos);
    CHECK(crowded.find("tone ") != std::string::npos);
    CHECK(kinds(R"({"drawing": {"count": 500}})", DrawingFormat::csv) == "");
}

TEST_CASE("tiles come as text and as points, and a drawing by a tile's text is that by its name") {
    CHECK(std::ranges::count(built_in_tile_names(), std::string_view("paper16")) == 1);
    const Tile tile = tile_by_name("paper16").tile;
    CHECK(tile.kinds() == 1);
    REQUIRE(tile.points.size() == 16);
    // Doubled, each is one of the others: the paper's tile is the cycle of 2x mod 1.
    for (const BinaryPoint& point : tile.points)
        CHECK(std::ranges::count(tile.points, BinaryPoint{2 * point.x, 2 * point.y}, [](BinaryPoint other) {
                  return BinaryPoint{other.x & ~1ull, other.y & ~1ull};
              }) == 1);
    CHECK_THROWS_WITH(tile_by_name("paper17"), doctest::Contains("paper17 is not a built-in tile"));
    Stippler named, given;
    named.set_picture(ramp());
    given.set_picture(ramp());
    given.set_tile(write_tile(tile_by_name("aperiodic64")));
    CHECK(written(*named.draw(settings_of(R"({"drawing": {"tile": "aperiodic64", "count": 800}})")),
                  DrawingFormat::csv) ==
          written(*given.draw(settings_of(R"({"drawing": {"count": 800}})")), DrawingFormat::csv));
}

TEST_CASE("a drawing tells the copies of its tile, each a quarter of a larger one") {
    Stippler stippler;
    stippler.set_picture(ramp());
    const Settings settings =
        settings_of(R"({"drawing": {"count": 3000, "relax": 0, "tile": "best32", "page": {"width_mm": 160,
        "margins_mm": {"top": 5, "right": 5, "bottom": 5, "left": 5}}}})");
    const Drawing drawing = *stippler.draw(settings);
    const double beside = 2 * (5 + drawing.radius_mm());
    const double longer_side =
        std::min(160 - beside, double{kWidth} / kHeight * (drawing.page.whole.size.height_mm - beside));
    const std::vector<PlacedTile> tiles = drawing.tiles();
    REQUIRE(tiles.size() > 10);
    int deepest = 0;
    for (const PlacedTile& tile : tiles) {
        CHECK(tile.side == doctest::Approx(std::ldexp(longer_side, -tile.level)));
        deepest = std::max(deepest, tile.level);
        if (tile.level == 0) continue;
        CHECK(std::ranges::any_of(tiles, [&](const PlacedTile& larger) {
            const auto is_half = [&](double part, double whole) {
                return std::abs(part - whole) < 1e-6 || std::abs(part - whole - tile.side) < 1e-6;
            };
            return larger.level == tile.level - 1 && is_half(tile.x, larger.x) && is_half(tile.y, larger.y);
        }));
    }
    CHECK(deepest > 0);
    // Every dot lies in one.
    drawing.for_each_piece([&](const Dots& dots) {
        for (std::size_t i = 0; i < dots.x.size(); ++i)
            CHECK(std::ranges::any_of(tiles, [&](const PlacedTile& tile) {
                const double x = dots.x[i] - tile.x, y = dots.y[i] - tile.y, slack = 1e-3;
                return std::min(x, y) > -slack && std::max(x, y) < tile.side + slack;
            }));
        return true;
    });
}

TEST_CASE("a density gives dots in proportion, and a white one none that would be drawn") {
    Stippler stippler;
    Grid<float> density(100, 100, 0.2f);
    std::fill_n(density.row(50), 5000, 0.8f);
    stippler.set_density(density);
    const auto drawing = stippler.draw(settings_of(R"({"drawing": {"count": 10000, "relax": 0}})"));
    REQUIRE(drawing);
    int above = 0;
    drawing->for_each_piece([&](const Dots& dots) {
        for (const float y : dots.y) above += y < 100;
        return true;
    });
    CHECK(above == doctest::Approx(2000).epsilon(0.03));
    const Grid<glm::u8vec3> pixels = drawing->pixels(25.4);
    CHECK(pixels.width == 200);
    CHECK(pixels.values.size() == 200u * 200);
}

TEST_CASE(
    "a density's cells have their dots, and none where it is 0, or it changes evenly between their middles") {
    // One cell of nine.
    Grid<float> density(3, 3);
    density.at(1, 1) = 1;
    for (const Reading reading : {Reading::by_cell, Reading::bilinear}) {
        Stippler stippler;
        stippler.set_density(density, reading);
        const auto drawing = stippler.draw(settings_of(
            R"({"drawing": {"count": 2000, "settle_for": "samples", "page": {"width_mm": 3, "margins_mm": {"on":
                true, "top": 0, "right": 0, "bottom": 0, "left": 0}}}})"));
        REQUIRE(drawing);
        int beside = 0;
        drawing->for_each_piece([&](const Dots& dots) {
            for (std::size_t i = 0; i < dots.x.size(); ++i)
                beside += std::abs(dots.x[i] - 1.5f) > 0.501f || std::abs(dots.y[i] - 1.5f) > 0.501f;
            return true;
        });
        // A tent's parts beyond its middle half, of either side.
        const double expected = reading == Reading::by_cell ? 0 : 2000 * (1 - 0.75 * 0.75);
        CHECK(beside == doctest::Approx(expected).epsilon(0.1));
    }
}

TEST_CASE("a stippler that was moved from can be given another") {
    const Settings settings = settings_of(R"({"drawing": {"count": 300}})");
    Stippler stippler;
    stippler.set_picture(ramp());
    Stippler another = std::move(stippler);
    CHECK(another.draw(settings)->count == 300);
    const auto refuses = [&](const auto& use) {
        CHECK_THROWS_WITH(use(), "the stippler was moved from; assign another one to it");
    };
    // NOLINTBEGIN(bugprone-use-after-move)
    refuses([&] { stippler.draw(settings); });
    refuses([&] { stippler.plan(settings.drawing); });
    refuses([&] { stippler.set_picture(ramp()); });
    refuses([&] { stippler.set_density(Grid<float>(1, 1, 0.5f)); });
    refuses([&] { stippler.set_tile(""); });
    // NOLINTEND(bugprone-use-after-move)
    stippler = std::move(another);
    CHECK(stippler.draw(settings)->count == 300);
}

TEST_CASE("what is wrong is said in a sentence that names the field") {
    CHECK_THROWS_WITH(settings_of(R"({"drawing": {"count": 0}})"),
                      "settings: drawing.count is 0; give a whole number from 1 to 10000000000, or null");
    CHECK_THROWS_WITH(settings_of(R"({"drawing": {"dots": 5}})"),
                      "settings: drawing.dots is not known; the default settings list all fields");
    CHECK_THROWS_WITH(settings_of(R"({"drawing": {"tone": {"contrst": 5}}})"),
                      "settings: drawing.tone.contrst is not known; the default settings list all fields");
    CHECK_THROWS_WITH(settings_of(R"({"count": 5})"),
                      "settings: count is not known; fields are in \"drawing\" and \"saving\"");
    CHECK_THROWS_WITH(settings_of("{"), doctest::Contains("settings: line 1 is not JSON"));
    CHECK_THROWS_WITH(settings_of("[]"), doctest::Contains("settings: "));
    Settings settings;
    CHECK_THROWS_AS(read_json(R"({"drawing": {"count": 70, "scale": -1}})", settings), std::runtime_error);
    CHECK(json_of(settings) == json_of({}));
    CHECK(settings_of(json_of(settings)).embedded == settings_of().embedded);
    read_json(R"({"drawing": {"count": 70}})", settings);
    CHECK(settings.embedded == R"({"dapple":1,"drawing":{"count":70}})");

    Stippler stippler;
    CHECK_THROWS_WITH(stippler.draw({}), doctest::Contains("there is no picture yet"));
    CHECK_THROWS_WITH(picture_of_srgb(std::vector<std::uint8_t>(5), 2, 2, 1),
                      doctest::Contains("which has 4"));
    LightPicture picture = ramp();
    picture.light.values[7] = std::nanf("");
    CHECK_THROWS_WITH(stippler.set_picture(picture), doctest::Contains("not finite"));
    CHECK_THROWS_WITH(picture_of_light(std::vector{0.5f, std::nanf("")}, 2, 1, 1),
                      doctest::Contains("not finite"));
    CHECK_THROWS_WITH(stippler.set_picture({ramp().light, ColourGrid(1, 1)}),
                      doctest::Contains("1 values for the colours of a picture of 60 x 40"));
    CHECK_THROWS_WITH(stippler.set_density(Grid<float>(2, 1, 2)), doctest::Contains("0 to 1"));
    CHECK_THROWS_WITH(stippler.set_tile("a tile"), doctest::Contains("line 1"));
    stippler.set_picture(ramp());
    CHECK_THROWS_WITH(stippler.draw(settings_of(R"({"drawing": {"tile": "/etc/hostname"}})")),
                      doctest::Contains("set_tile()"));
    const auto drawing = stippler.draw(settings_of(R"({"drawing": {"count": 100}})"));
    CHECK(drawing->count == 100);
    CHECK_THROWS_WITH(drawing->pixels(0), "0 pixels to the inch; give more than 0");
    CHECK_THROWS_WITH(drawing->pixels(std::nan("")), doctest::Contains("nan pixels to the inch"));
}

TEST_CASE("rows have the window's names, and every field that they name can be set") {
    const auto rows = nlohmann::json::parse(rows_json());
    const auto all = nlohmann::json::parse(json_of({}));
    for (const auto& each : rows.items()) {
        const std::string field = each.key();
        CAPTURE(field);
        std::string pointer = "/" + field;
        std::ranges::replace(pointer, '.', '/');
        CHECK(all.contains(nlohmann::json::json_pointer(pointer)));
        CHECK(each.value()["row"] != "");
    }
    CHECK(rows["drawing.tone.contrast"]["row"] == "Contrast");
    CHECK(rows["drawing.tone.contrast"]["tip"] == "Above 0 increases the contrast; below 0 reduces it.");
    CHECK(rows["drawing.page.fit"]["choices"] == std::vector{"inside", "fill"});
    CHECK(rows["drawing.page.width_mm"]["unit"] == "mm");

    // What a slider has at its ends is accepted, and what is beyond the range is not.
    const auto contrast = [](double value) {
        return settings_of(nlohmann::json{{"drawing", {{"tone", {{"contrast", value}}}}}}.dump());
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
    CHECK_FALSE(stippler.draw(settings_of(R"({"drawing": {"count": 50000}})"), {stop.get_token(), {}}));
    std::ostringstream out;
    CHECK_FALSE(drawing->write(out, DrawingFormat::svg, {stop.get_token(), {}}));
}

TEST_CASE("a picture is the same from 8 bits, 16 bits, numbers and light") {
    // Grey and alpha: half transparent black, and a grey.
    const std::vector<std::uint8_t> eight{0, 51, 102, 255};
    const LightPicture picture = picture_of_srgb(eight, 2, 1, 2);
    CHECK(picture.light.values[0] == doctest::Approx(0.8));
    CHECK(picture.light.values[1] == doctest::Approx(std::pow((0.4 + 0.055) / 1.055, 2.4)));
    std::vector<std::uint16_t> sixteen;
    std::vector<float> numbers;
    for (const std::uint8_t value : eight) {
        sixteen.push_back(static_cast<std::uint16_t>(257 * value));
        numbers.push_back(static_cast<float>(value) / 255);
    }
    CHECK(picture_of_srgb(sixteen, 2, 1, 2).light.values == picture.light.values);
    CHECK(picture_of_srgb(numbers, 2, 1, 2).light.values == picture.light.values);
    numbers[2] = picture.light.values[1];
    CHECK(picture_of_light(numbers, 2, 1, 2).light.values == picture.light.values);

    const LightPicture coloured = picture_of_light(std::vector<float>{3, 0.5f, 0}, 1, 1, 3);
    CHECK(unpacked(coloured.colours.values[0]) == glm::vec3(3, 0.5f, 0));
    CHECK(coloured.light.values[0] == doctest::Approx(0.2126 * 3 + 0.7152 * 0.5));
    CHECK_THROWS_WITH(picture_of_srgb(std::vector<float>{0.5f, 255}, 2, 1, 1),
                      doctest::Contains("has the value 255; sRGB-encoded numbers are within 0 to 1"));
    CHECK_THROWS_WITH(picture_of_srgb(std::vector<float>{std::nanf("")}, 1, 1, 1), doctest::Contains("nan"));
}

TEST_CASE("a file's name says its format") {
    CHECK(text_format("a.b/cat.SVG") == DrawingFormat::svg);
    CHECK(text_format("cat.nc") == DrawingFormat::gcode);
    CHECK(text_format(".plt") == DrawingFormat::hpgl);
    CHECK(text_format("json") == DrawingFormat::json);
    CHECK_THROWS_WITH(text_format("cat.pdf"),
                      "cat.pdf: not a format; give svg, gcode, hpgl, dxf, csv or json");
    CHECK_THROWS_WITH(text_format(""), doctest::Contains("not a format"));
}

TEST_CASE("lights carry the map's flux, and points are measured") {
    Grid<glm::vec3> sky(64, 32, glm::vec3(0.5f));
    sky.at(32, 8) = glm::vec3(2000);
    RankedTile tile = ranked_tile(tile_by_name(kDefaultTile));
    const LightSamples lights = light_samples(EnvironmentMap(sky), tile, {.count = 200});
    CHECK(lights.samples.size() == 200);
    double flux = 0, length = 0;
    for (const LightSample& light : lights.samples) {
        flux += light.weight.r;
        const glm::dvec3 to = direction_of(light.uv, SphereConvention::openexr);
        length += std::hypot(to.x, to.y, to.z);
    }
    // 4 pi of the sky, and the texel's solid angle, (2 pi / 64) (cos(8 pi / 32) - cos(9 pi / 32)).
    const double pi = 3.14159265358979;
    const double texel = 2 * pi / 64 * (std::cos(8 * pi / 32) - std::cos(9 * pi / 32));
    CHECK(flux == doctest::Approx(4 * pi * 0.5 + texel * 1999.5).epsilon(1e-5));
    CHECK(length == doctest::Approx(200));
    CHECK_THROWS_WITH(EnvironmentMap(Grid<glm::vec3>(32, 64)), doctest::Contains("twice"));
    for (const std::uint64_t count : {0, 10'000'001})
        CHECK_THROWS_AS(light_samples(EnvironmentMap(sky), tile, {.count = count}), std::runtime_error);

    std::vector<glm::dvec2> points;
    for (int i = 0; i < 32; ++i)
        for (int k = 0; k < 32; ++k) points.emplace_back(i + 0.5, k + 0.5);
    const Domain square{32, 32};
    const PointReport grid = *analyse(points, square);
    CHECK(grid.count == 1024);
    // A square grid's spacing is 1, the largest sqrt(2 / sqrt(3)).
    CHECK(grid.nearest.minimum == doctest::Approx(std::sqrt(std::sqrt(3.0) / 2)));
    CHECK(grid.power_below_05 < 1e-6);
    CHECK(periodicity(points, square, glm::dvec2(1)).value == doctest::Approx(1));
    // Eight times it is no whole number yet.
    CHECK(periodicity(points, square, glm::dvec2(11.0 / 9)).value < 0);
    // One wave a spacing to the right: a peak, halfway between the middle and the edge. None that is longer.
    const Grid<glm::u8vec3> spectrum = spectrum_picture(grid.spectrum);
    REQUIRE(spectrum.width == spectrum.height);
    const auto pixel = [&](double right) {
        return spectrum.at(static_cast<int>((0.5 + right / 2) * spectrum.width), spectrum.height / 2);
    };
    CHECK(pixel(0.5) == glm::u8vec3(255, 140, 0));
    CHECK(pixel(0.25) == glm::u8vec3(0));
}

TEST_CASE("dots of a tile that repeats meet others after its period, and those of eight kinds do not") {
    Stippler stippler;
    stippler.set_density(Grid<float>(1, 1, 0.5f));
    for (const std::string tile : {"best32", "kinds4096"}) {
        CAPTURE(tile);
        const bool repeats = tile == "best32";
        Settings settings;
        settings.drawing.placing.count = 20'000;
        settings.drawing.relax = 0;
        settings.drawing.tile = tile;
        const Drawing drawing = *stippler.draw(settings);
        std::vector<glm::dvec2> points;
        drawing.for_each_piece([&](const Dots& dots) {
            for (std::size_t i = 0; i < dots.size(); ++i) points.emplace_back(dots.x[i], dots.y[i]);
            return true;
        });
        const double period = drawing.period_mm();
        // 625 tiles of 32 points are more than the 256 of level 4, and fewer than the next ones; likewise
        // four of 4,096.
        const double side = drawing.page.whole.size.width_mm / (repeats ? 16 : 2);
        CHECK(period == doctest::Approx(side).epsilon(0.02));
        const auto& [width, height, ignored] = drawing.page.whole.size;
        const double value = periodicity(points, {width, height, Topology::window}, glm::dvec2(period)).value;
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
    CHECK(std::string(svg, size) == written(*same.draw(settings_of(json)), DrawingFormat::svg));
    CHECK(std::strlen(svg) == size);
    dapple_free(svg);
    CHECK_FALSE(dapple_drawing_text(drawing, "bmp", nullptr));
    CHECK(std::string(dapple_error()).find("bmp: not a format") != std::string::npos);
    dapple_drawing_free(drawing);
    dapple_stippler_free(stippler);
    dapple_drawing_free(nullptr);
    dapple_free(nullptr);
}
