#include "core/lights/light_list.h"

#include <doctest/doctest.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <sstream>
#include <string>

using namespace dapple;

namespace {

LightSamples two_lights() {
    LightSamples lights;
    lights.samples.push_back(
        {.uv = {0.5, 0.5}, .weight = {0.1, 0.2, 0.3}, .radiance = {1, 2, 3}, .pdf = 0.25});
    lights.samples.push_back(
        {.uv = {0.25, 0.5}, .weight = {1e-7, 3, 1e5}, .radiance = {4, 5, 6}, .pdf = 1.0 / 3});
    lights.total_flux = {0.1 + 1e-7, 3.2, 100'000.3};
    return lights;
}

template <class Write>
std::string written(Write write, const LightListStyle& style) {
    std::ostringstream out;
    write(out, two_lights(), style);
    return out.str();
}

}  // namespace

TEST_CASE("a JSON light list reads back to the very numbers") {
    const auto json = nlohmann::json::parse(
        written(write_light_json, {.rotation_degrees = 90, .source = "a\"b\\c\n\xff.hdr"}));
    CHECK(json["convention"] == "openexr");
    CHECK(json["rotation_degrees"] == 90);
    CHECK(json["count"] == 2);
    CHECK(json["source"] == "a\"b\\c??.hdr");
    const LightSamples lights = two_lights();
    CHECK(json["total_flux"][2] == lights.total_flux.z);
    CHECK(json["samples"].size() == 2);
    const auto& second = json["samples"][1];
    CHECK(second["u"] == 0.25);
    CHECK(second["v"] == 0.5);
    CHECK(second["pdf"] == lights.samples[1].pdf);
    CHECK(second["radiance"] == nlohmann::json({4, 5, 6}));
    CHECK(second["weight"][0] == 1e-7);
    // u = 1/4 is +X; a quarter turn about +Y takes +X to -Z.
    CHECK(second["direction"][2].get<double>() == doctest::Approx(-1));
}

TEST_CASE("a CSV light list says what it is of, and has a line a sample") {
    std::istringstream lines(written(write_light_csv, {.rotation_degrees = 90, .source = "a\nb.hdr"}));
    std::string line;
    for (const char* expected :
         {"# convention: openexr", "# rotation_degrees: 90", "# source: a?b.hdr", "# position: settled",
          "# radiance: mean", "# seed: 0", "# count: 2", "# total_flux: 0.10000010000000001 3.2 100000.3",
          "x,y,z,u,v,radiance_r,radiance_g,radiance_b,pdf,weight_r,weight_g,weight_b"}) {
        std::getline(lines, line);
        CHECK(line == expected);
    }
    std::getline(lines, line);
    double x = 0, y = 0, z = 0, u = 0, v = 0;
    CHECK(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,%lf", &x, &y, &z, &u, &v) == 5);
    CHECK(x == doctest::Approx(1));  // the centre's +Z, a quarter turn about +Y
    CHECK(u == 0.5);
    CHECK(line.ends_with(",0.25,0.1,0.2,0.3"));
}

TEST_CASE("pbrt's distant lights shine from the sample's direction to the origin") {
    const std::string text = written(write_light_pbrt, {.convention = SphereConvention::pbrt});
    const std::size_t start = text.find("LightSource");
    double x = 0, y = 0, z = 0, r = 0, g = 0, b = 0;
    CHECK(std::sscanf(
              text.c_str() + start,
              "LightSource \"distant\" \"point3 from\" [ %lf %lf %lf ] \"point3 to\" [ 0 0 0 ] \"rgb L\" [ "
              "%lf %lf %lf ] \"float scale\" [ 1 ]",
              &x, &y, &z, &r, &g, &b) == 6);
    CHECK(x == doctest::Approx(-1));  // pbrt's centre
    CHECK(r == 0.1);
    CHECK(b == 0.3);
}

TEST_CASE("Mitsuba's directional emitters name the way the light travels, and the file is XML") {
    pugi::xml_document document;
    const std::string text = written(write_light_mitsuba, {.source = "odd--name.hdr"});
    REQUIRE(document.load_string(text.c_str()));
    const pugi::xml_node scene = document.child("scene");
    CHECK(std::string(scene.attribute("version").value()) == "3.0.0");
    const pugi::xml_node light = scene.child("emitter");
    CHECK(std::string(light.attribute("type").value()) == "directional");
    CHECK(light.find_child_by_attribute("name", "direction").attribute("z").as_double() ==
          doctest::Approx(-1));
    CHECK(std::string(light.find_child_by_attribute("name", "irradiance").attribute("value").value()) ==
          "0.1, 0.2, 0.3");
}
