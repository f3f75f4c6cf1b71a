#include "core/lights/light_list.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <numbers>
#include <pugixml.hpp>
#include <sstream>
#include <string>
#include <vector>

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
std::string written(Write write, const LightListStyle& style, const LightSamples& lights = two_lights()) {
    std::ostringstream out;
    TextBuffer text(out);
    write(text, lights, style);
    text.flush();
    return out.str();
}

// What a rotation takes +Z to: the third column of its matrix.
glm::dvec3 turned_z(double w, double x, double y, double z) {
    CHECK(w * w + x * x + y * y + z * z == doctest::Approx(1));
    return {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)};
}

// Every way that a light may shine, the two ends of the axis that is turned too.
LightSamples all_round() {
    LightSamples lights;
    for (const glm::dvec2 uv : {glm::dvec2(0.5, 0.5),
                                {0, 0.5},
                                {0.25, 0.5},
                                {0.75, 0.5},
                                {0.1, 0.2},
                                {0.3, 0},
                                {0.6, 1},
                                {0.9, 0.7}})
        lights.samples.push_back(
            {.uv = uv, .weight = {0.2, 0.4, 0.1 + uv.x}, .radiance = {1, 1, 1}, .pdf = 1});
    return lights;
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
          "# radiance: mean", "# order: priority", "# seed: 0", "# count: 2",
          "# total_flux: 0.10000010000000001 3.2 100000.3",
          "x,y,z,u,v,radiance_r,radiance_g,radiance_b,pdf,weight_r,weight_g,weight_b,angular_radius"}) {
        std::getline(lines, line);
        CHECK(line == expected);
    }
    std::getline(lines, line);
    double x = 0, y = 0, z = 0, u = 0, v = 0;
    CHECK(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,%lf", &x, &y, &z, &u, &v) == 5);
    CHECK(x == doctest::Approx(1));  // the centre's +Z, a quarter turn about +Y
    CHECK(u == 0.5);
    CHECK(line.find(",0.25,0.1,0.2,0.3,") != line.npos);
    // Of 1 / (2 * 0.25) steradians, which are 2 pi (1 - cos a).
    const double radius = std::stod(line.substr(line.rfind(',') + 1)) * std::numbers::pi / 180;
    CHECK(2 * std::numbers::pi * (1 - std::cos(radius)) == doctest::Approx(2));
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

TEST_CASE("glTF's directional lights shine from the sample's direction, colour times intensity strong") {
    const LightSamples lights = all_round();
    const auto json = nlohmann::json::parse(
        written(write_light_gltf, {.rotation_degrees = 30, .source = "a\"b.hdr"}, lights));
    CHECK(json["asset"]["version"] == "2.0");
    CHECK(json["extensionsUsed"][0] == "KHR_lights_punctual");
    const auto& nodes = json["nodes"];
    const auto& punctual = json["extensions"]["KHR_lights_punctual"]["lights"];
    REQUIRE(nodes.size() == lights.samples.size() + 1);
    CHECK(nodes[0]["children"].size() == lights.samples.size());
    for (std::size_t i = 0; i < lights.samples.size(); ++i) {
        const auto& node = nodes[nodes[0]["children"][i].get<std::size_t>()];
        const auto q = node["rotation"].get<std::vector<double>>();
        const glm::dvec3 wanted = direction_of(lights.samples[i], {.rotation_degrees = 30});
        CHECK(glm::distance(turned_z(q[3], q[0], q[1], q[2]), wanted) < 1e-9);
        const auto& light = punctual[node["extensions"]["KHR_lights_punctual"]["light"].get<std::size_t>()];
        CHECK(light["type"] == "directional");
        for (std::size_t k = 0; k < 3; ++k) {
            const double colour = light["color"][k].get<double>();
            CHECK(colour <= 1);
            CHECK(colour * light["intensity"].get<double>() ==
                  doctest::Approx(lights.samples[i].weight[glm::length_t(k)]));
        }
    }
}

TEST_CASE(
    "USD's distant lights and Blender's suns shine from the sample's direction, as wide as its region") {
    const LightSamples lights = all_round();
    const std::string usd = written(write_light_usd, {.convention = SphereConvention::usd}, lights);
    const std::string blender =
        written(write_light_blender, {.convention = SphereConvention::blender}, lights);
    const auto numbers_after = [](const std::string& text, const std::string& what, std::size_t& at) {
        at = text.find(what, at);
        REQUIRE(at != text.npos);
        at += what.size();
        std::vector<double> found;
        for (std::size_t i = at; text[i] != '\n'; ++i) {
            if (std::string("0123456789-.").find(text[i]) == std::string::npos) continue;
            std::size_t used = 0;
            found.push_back(std::stod(text.substr(i), &used));
            i += used - 1;
        }
        return found;
    };
    CHECK(usd.starts_with("#usda 1.0\n"));
    std::size_t in_usd = 0, in_blender = 0;
    const double radius = std::acos(1 - 1.0 / 8 / (2 * std::numbers::pi));
    for (const LightSample& sample : lights.samples) {
        const auto angle = numbers_after(usd, "float inputs:angle = ", in_usd);
        CHECK(angle[0] == doctest::Approx(2 * radius * 180 / std::numbers::pi));
        const auto colour = numbers_after(usd, "color3f inputs:color = (", in_usd);
        CHECK(colour[2] == sample.weight.z);
        const auto q = numbers_after(usd, "quatf xformOp:orient = (", in_usd);
        CHECK(glm::distance(turned_z(q[0], q[1], q[2], q[3]),
                            direction_of(sample.uv, SphereConvention::usd)) < 1e-9);
        const auto sun = numbers_after(blender, "\n    ((", in_blender);
        REQUIRE(sun.size() == 9);
        CHECK(glm::distance(turned_z(sun[0], sun[1], sun[2], sun[3]),
                            direction_of(sample.uv, SphereConvention::blender)) < 1e-9);
        CHECK(sun[4] * sun[7] == doctest::Approx(sample.weight.x));
        CHECK(sun[8] == doctest::Approx(2 * radius));
    }
}
