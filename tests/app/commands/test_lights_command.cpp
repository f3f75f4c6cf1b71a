#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "core/image/environment.h"
#include "core/lights/direction.h"
#include "core/lights/light_samples.h"
#include "core/lights/sampler_comparison.h"
#include "io/files/environment_file.h"
#include "io/files/save_lights.h"
#include "tests/file_text.h"
#include "tests/picture_files.h"
#include "tests/run_in_shell.h"
#include "tests/temporary_folder.h"

using namespace dapple;
using nlohmann::json;

namespace {

// A dim sky with a bright patch; one value of the first pixel may be spoilt.
PictureFile test_map(float spoilt = 0.5f) {
    PictureFile map{.width = 64, .height = 32, .channels = 3, .type = "float"};
    for (int i = 0; i < 64 * 32; ++i) {
        const float light = i > 600 && i < 620 ? 100.0f : 0.5f;
        for (const float colour : {1.0f, 0.8f, 0.6f}) map.values.push_back(light * colour);
    }
    map.values[0] = spoilt;
    return map;
}

std::string quoted(const std::filesystem::path& path) {
    return "'" + path.string() + "'";
}

void check_refused(const Outcome& outcome, const std::string& word) {
    CAPTURE(outcome.err);
    CHECK(outcome.status != 0);
    CHECK(outcome.status < 128);
    CHECK(outcome.sentences() == 1);
    CHECK(outcome.err.find(word) != outcome.err.npos);
}

}  // namespace

TEST_CASE("dapple lights writes exactly so many samples, whose weights sum to the total flux") {
    const TemporaryFolder folder;
    write_picture(folder / "map.exr", test_map());
    const Outcome outcome =
        run_dapple("lights " + quoted(folder / "map.exr") + " -n 257 -o " + quoted(folder / "samples.json"));
    CHECK_MESSAGE(outcome.status == 0, outcome.err);
    const json file = json::parse(text_of(folder / "samples.json"));
    CHECK(file["convention"] == "openexr");
    CHECK(file["source"] == "map.exr");
    CHECK(file["position"] == "settled");
    CHECK(file["radiance"] == "mean");
    CHECK(file["seed"] == 0);
    REQUIRE(file["samples"].size() == 257);
    const EnvironmentMap map = read_environment(folder / "map.exr").map;
    for (int c = 0; c < 3; ++c) {
        double sum = 0;
        for (const json& sample : file["samples"])
            sum += sample["weight"][static_cast<std::size_t>(c)].get<double>();
        CHECK(sum ==
              doctest::Approx(file["total_flux"][static_cast<std::size_t>(c)].get<double>()).epsilon(1e-9));
        CHECK(sum == doctest::Approx(map.total_flux()[c]).epsilon(1e-9));
    }
    for (const json& sample : file["samples"]) {
        double length = 0;
        for (const json& x : sample["direction"]) length += x.get<double>() * x.get<double>();
        CHECK(length == doctest::Approx(1));
        CHECK(sample["pdf"].get<double>() > 0);
        CHECK(sample["radiance"].size() == 3);
        const double v = sample["v"].get<double>();
        CHECK(sample["direction"][1].get<double>() == doctest::Approx(std::cos(std::acos(-1.0) * v)));
    }
}

TEST_CASE("dapple lights writes CSV, pbrt, Mitsuba and a picture, and takes all of its options") {
    const TemporaryFolder folder;
    write_picture(folder / "map.hdr", test_map());
    const auto run = [&](const std::string& output, const std::string& options) {
        const Outcome outcome = run_dapple("lights " + quoted(folder / "map.hdr") + " -n 20 " + options +
                                           " -o " + quoted(folder / output));
        CHECK_MESSAGE(outcome.status == 0, outcome.err);
        return text_of(folder / output);
    };
    const std::string csv =
        run("s.csv", "--convention blender --rotate 90 --radiance point --position random --seed 7");
    CHECK(std::ranges::count(csv, '\n') == 30);
    CHECK(csv.starts_with("# convention: blender\n# rotation_degrees: 90\n"));
    CHECK(csv.find("\nx,y,z,u,v,") != csv.npos);
    CHECK(run("s.csv", "--convention blender --rotate 90 --radiance point --position random --seed 7") ==
          csv);
    CHECK(run("s.csv", "--convention blender --rotate 90 --radiance point --position random --seed 8") !=
          csv);
    check_refused(run_dapple("lights " + quoted(folder / "map.hdr") + " --radiance point -o " +
                             quoted(folder / "s.csv")),
                  "--radiance: point applies to random samples only; give --position random too");
    const std::string pbrt = run("s.pbrt", "--placer figure8");
    CHECK(pbrt.find("LightSource \"distant\"") != pbrt.npos);
    CHECK(pbrt.find("convention pbrt") != pbrt.npos);
    pugi::xml_document document;
    REQUIRE(document.load_string(run("s.xml", "--position random --tile 14217,2895/16").c_str()));
    int emitters = 0;
    for ([[maybe_unused]] const auto& emitter : document.child("scene").children("emitter")) ++emitters;
    CHECK(emitters == 20);
    CHECK(run("s.csv", "--mis-compensation") != run("s.csv", ""));
    CHECK(run("s.png", "--exposure -1").starts_with("\x89PNG"));
}

TEST_CASE("light that the paper's placer loses is an error, not fewer samples") {
    const TemporaryFolder folder;
    PictureFile map{.width = 64,
                    .height = 32,
                    .channels = 3,
                    .values = std::vector<float>(64 * 32 * 3, 0.0f),
                    .type = "float"};
    map.values[3000] = 1000;
    write_picture(folder / "map.exr", map);
    const std::string command =
        "lights " + quoted(folder / "map.exr") + " -n 20 -o " + quoted(folder / "s.json");
    check_refused(run_dapple(command + " --placer figure8"), "figure8");
    CHECK(run_dapple(command).status == 0);
}

TEST_CASE("without a map there is a sky") {
    const TemporaryFolder folder;
    const Outcome outcome = run_dapple("lights -n 5 -o " + quoted(folder / "sky.json"));
    CHECK_MESSAGE(outcome.status == 0, outcome.err);
    CHECK(json::parse(text_of(folder / "sky.json"))["samples"].size() == 5);
}

TEST_CASE("maps that cannot be sampled are refused in one sentence and the old file stays") {
    const TemporaryFolder folder;
    put_text(folder / "old.json", "old");
    const auto run = [&](const std::string& map) {
        return run_dapple("lights " + quoted(folder / map) + " -n 5 -o " + quoted(folder / "old.json"));
    };
    check_refused(run("missing.hdr"), "no such file");
    check_refused(run("."), "is a folder");
    put_text(folder / "empty.hdr", "");
    check_refused(run("empty.hdr"), "empty");
    put_text(folder / "text.hdr", "not a map");
    check_refused(run("text.hdr"), "not a picture");
    write_picture(
        folder / "square.exr",
        {.width = 8, .height = 8, .channels = 3, .values = std::vector<float>(192, 1.0f), .type = "float"});
    check_refused(run("square.exr"), "twice as wide");
    write_picture(
        folder / "black.exr",
        {.width = 8, .height = 4, .channels = 3, .values = std::vector<float>(96, 0.0f), .type = "float"});
    check_refused(run("black.exr"), "black");
    write_picture(folder / "nan.exr", test_map(std::numeric_limits<float>::quiet_NaN()));
    check_refused(run("nan.exr"), "NaN");
    write_picture(folder / "infinite.exr", test_map(std::numeric_limits<float>::infinity()));
    check_refused(run("infinite.exr"), "infinite");
    write_picture(folder / "negative.exr", test_map(-1));
    check_refused(run("negative.exr"), "negative");
    CHECK(text_of(folder / "old.json") == "old");
}

TEST_CASE("options of dapple lights that cannot be are refused in one sentence") {
    const TemporaryFolder folder;
    const auto run = [&](const std::string& options) {
        return run_dapple("lights -o " + quoted(folder / "x.json") + " " + options);
    };
    check_refused(run("-n 0"), "--samples");
    check_refused(run("-n -3"), "--samples");
    check_refused(run("-n 1.5"), "--samples");
    check_refused(run("-n 10000001"), "--samples");
    check_refused(run("--convention maya"), "maya");
    check_refused(run("--rotate nan"), "--rotate");
    check_refused(run("--radiance most"), "--radiance");
    check_refused(run("--position here"), "--position");
    check_refused(run("--placer best"), "--placer");
    check_refused(run("--tile nothing"), "nothing");
    check_refused(run("--seed -1"), "--seed");
    check_refused(run("--exposure 1"), ".png");
    check_refused(run("--placer figure8 --ranking paper"), "--ranking");
    const auto picture = [&](const std::string& options) {
        return run_dapple("lights -o " + quoted(folder / "x.png") + " " + options);
    };
    for (const std::string option : {"--convention usd", "--rotate 90", "--radiance point"})
        check_refused(picture(option), option.substr(0, option.find(' ')));
    for (const std::string option :
         {"-n 100", "--seed 3", "--convention usd", "--threads 1", "--placer exact"})
        check_refused(run_dapple("lights --compare -o " + quoted(folder / "x.html") + " " + option),
                      "cannot be used with --compare");
    check_refused(run_dapple("lights --convention usd"), "--convention");
    check_refused(run("--compare"), ".html");
    check_refused(run_dapple("lights -o " + quoted(folder / "x.txt")), ".json");
    check_refused(run_dapple("lights -o " + quoted(folder / "none" / "x.json")), "none");
    CHECK(folder.entries() == 0);
}

TEST_CASE("the samples of a sky with a sun keep its flux and light surfaces within half a per cent") {
    const TemporaryFolder folder;
    const EnvironmentMap sky = sky_map({.height = 128});
    PictureFile file{.width = sky.width(), .height = sky.height(), .channels = 3, .type = "float"};
    for (int y = 0; y < sky.height(); ++y)
        for (int x = 0; x < sky.width(); ++x)
            for (int c = 0; c < 3; ++c) file.values.push_back(sky.radiance().at(x, y)[c]);
    write_picture(folder / "sky.hdr", file);
    const EnvironmentMap map = read_environment(folder / "sky.hdr").map;
    // Radiance's format keeps eight bits of the brightest colour of a texel.
    for (int c = 0; c < 3; ++c)
        CHECK(map.total_flux()[c] == doctest::Approx(sky.total_flux()[c]).epsilon(0.01));
    RankedTile tile(make_tile(14217, 2895, 16), RankingMethod::energy);
    const LightSamples samples = light_samples(map, tile, {.count = 1024});
    std::vector<DistantLight> lights;
    glm::dvec3 sum{};
    for (const LightSample& sample : samples.samples) {
        lights.push_back({direction_of(sample.uv, SphereConvention::openexr), sample.weight});
        sum += sample.weight;
    }
    for (int c = 0; c < 3; ++c) CHECK(sum[c] == doctest::Approx(map.total_flux()[c]).epsilon(1e-9));
    const auto normals = fibonacci_normals(100);
    CHECK(relative_error(irradiance(lights, normals), irradiance(texel_lights(map), normals)).mean < 0.005);
}

TEST_CASE("light below 0 is refused or taken as none, and a picture whose light ends at white is told of") {
    const TemporaryFolder folder;
    write_picture(folder / "map.exr", test_map(-0.5f));
    const std::string map = quoted(folder / "map.exr"), output = " -n 50 -o " + quoted(folder / "s.json");
    check_refused(run_dapple("lights " + map + output),
                  "light is below 0 at 1 pixel; repair the map first, or give --clamp to set it to 0");
    const Outcome clamped = run_dapple("lights " + map + " --clamp" + output);
    CHECK(clamped.status == 0);
    CHECK(clamped.err.find("light below 0 at 1 pixel was set to 0") != clamped.err.npos);
    CHECK(json::parse(text_of(folder / "s.json"))["samples"].size() == 50);
    CHECK(run_dapple("lights " + map + " --clamp" + output).err.find("white") == clamped.err.npos);

    PictureFile dark{.width = 8, .height = 4, .channels = 3, .type = "float"};
    dark.values.assign(8 * 4 * 3, -1.0f);
    write_picture(folder / "dark.exr", dark);
    for (const char* const clamp : {"", " --clamp"})
        check_refused(run_dapple("lights " + quoted(folder / "dark.exr") + clamp + output),
                      "light is below 0 at every pixel; repair the map first");

    REQUIRE(std::system(("convert -size 16x8 gradient: " + quoted(folder / "map.png")).c_str()) == 0);
    const Outcome dim = run_dapple("lights " + quoted(folder / "map.png") + output);
    CHECK(dim.status == 0);
    CHECK(dim.err.find("no light above white") != dim.err.npos);
}

TEST_CASE("a list is about as large as it is said to become") {
    const TemporaryFolder folder;
    for (const std::string ending : {".json", ".csv", ".pbrt", ".xml", ".usda", ".gltf", ".py"}) {
        CAPTURE(ending);
        const std::filesystem::path file = folder / ("s" + ending);
        REQUIRE(run_dapple("lights -n 3000 -o " + quoted(file)).status == 0);
        CHECK(static_cast<double>(std::filesystem::file_size(file)) ==
              doctest::Approx(expected_bytes(*light_file_of(file), 3000)).epsilon(0.15));
    }
}

TEST_CASE("the density by which samples are placed is written beside them, as OpenEXR") {
    const TemporaryFolder folder;
    write_picture(folder / "map.exr", test_map());
    const std::string command = "lights " + quoted(folder / "map.exr") + " -n 20 -o " +
                                quoted(folder / "s.json") + " --pdf " + quoted(folder / "pdf.exr");
    const EnvironmentMap map = read_environment(folder / "map.exr").map;
    for (const LightImportance importance : {LightImportance::light, LightImportance::compensated}) {
        const bool compensated = importance == LightImportance::compensated;
        const Outcome outcome = run_dapple(command + (compensated ? " --mis-compensation" : ""));
        CHECK_MESSAGE(outcome.status == 0, outcome.err);
        const Grid<glm::vec3> written = read_environment(folder / "pdf.exr").map.radiance();
        const Grid<float> pdf = light_pdf(map, importance);
        REQUIRE(written.values.size() == pdf.values.size());
        for (std::size_t i = 0; i < pdf.values.size(); ++i)
            CHECK(written.values[i] == glm::vec3(pdf.values[i]));
    }
    check_refused(run_dapple("lights --pdf " + quoted(folder / "x.exr")), "name one with --output");
    check_refused(run_dapple(command + "x"), "pdf.exrx does not end in .exr");
    check_refused(run_dapple("lights " + quoted(folder / "map.exr") + " -o " + quoted(folder / "s.json") +
                             " --pdf " + quoted(folder / "map.exr")),
                  "map.exr");
}

TEST_CASE("a map of one pixel is an even sky") {
    const TemporaryFolder folder;
    write_picture(folder / "sky.exr", PictureFile{.channels = 3, .values = {2, 2, 2}, .type = "float"});
    const Outcome outcome =
        run_dapple("lights " + quoted(folder / "sky.exr") + " -n 100 -o " + quoted(folder / "s.json"));
    CHECK_MESSAGE(outcome.status == 0, outcome.err);
    CHECK(outcome.err.find("its one pixel is used as even light from all around") != std::string::npos);
    const json file = json::parse(text_of(folder / "s.json"));
    CHECK(file["total_flux"][0].get<double>() == doctest::Approx(8 * std::acos(-1.0)));
    for (const json& sample : file["samples"])
        CHECK(sample["radiance"][0].get<double>() == doctest::Approx(2));
}
