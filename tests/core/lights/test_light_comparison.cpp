#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <pugixml.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "core/image/environment.h"
#include "core/lights/direction.h"
#include "core/lights/sampler_comparison.h"
#include "io/reports/light_report.h"

using namespace dapple;

namespace {

RankedTile paper_tile() {
    return {make_tile(14217, 2895, 16), RankingMethod::energy};
}

EnvironmentMap small_sky() {
    return sky_map({.height = 32, .sun_radius = 4, .sun_radiance = 300});
}

}  // namespace

TEST_CASE("inverting the cumulative sums visits every texel as often as it has light") {
    Grid<glm::vec3> grid(8, 4, glm::vec3(0));
    grid.at(2, 0) = glm::vec3(3);
    grid.at(7, 1) = glm::vec3(1);
    grid.at(0, 3) = glm::vec3(2);
    const EnvironmentMap map(grid);
    const LightInversion inversion(map);
    CHECK(inversion.total() == doctest::Approx(luminance(map.total_flux())));
    constexpr int kSide = 400;
    Grid<double> visits(8, 4);
    for (int i = 0; i < kSide * kSide; ++i) {
        const auto place = inversion.at((i % kSide + 0.5) / kSide, (i / kSide + 0.5) / kSide);
        visits.at(place.column, place.row) += 1.0 / (kSide * kSide);
        CHECK(static_cast<int>(place.uv.x * 8) == place.column);
        CHECK(static_cast<int>(place.uv.y * 4) == place.row);
    }
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 8; ++x) {
            const double share =
                luminance(map.radiance().at(x, y)) * map.solid_angle(y) / luminance(map.total_flux());
            CHECK(std::abs(visits.at(x, y) - share) < 2.0 / kSide);
        }
    }
}

TEST_CASE("inversion never leads to a black texel, at the ends least of all") {
    Grid<glm::vec3> grid(8, 4, glm::vec3(0));
    grid.at(3, 2) = glm::vec3(1);
    const LightInversion inversion{EnvironmentMap(grid)};
    for (const double s : {0.0, 0.5, 1 - 0x1p-53}) {
        for (const double t : {0.0, 0.5, 1 - 0x1p-53}) {
            const auto place = inversion.at(s, t);
            CHECK(place.column == 3);
            CHECK(place.row == 2);
        }
    }
}

TEST_CASE("every sampler has the map's flux as its mean") {
    const EnvironmentMap map = small_sky();
    RankedTile tile = paper_tile();
    for (const LightSampler sampler : kLightSamplers) {
        CAPTURE(name_of(sampler));
        constexpr int kRuns = 40;
        double sum = 0, squares = 0;
        for (std::uint64_t run = 1; run <= kRuns; ++run) {
            double flux = 0;
            for (const DistantLight& light : sampled_lights(map, tile, sampler, 64, run)) {
                CHECK(glm::length(light.direction) == doctest::Approx(1));
                flux += luminance(light.weight);
            }
            sum += flux / kRuns;
            squares += flux * flux / kRuns;
        }
        const double exact = luminance(map.total_flux());
        const double deviation = std::sqrt(std::max(squares - sum * sum, 0.0) / (kRuns - 1));
        CHECK(std::abs(sum - exact) < 4.5 * deviation + 1e-9 * exact);
    }
}

TEST_CASE("random samples err with the root of their number, ours faster and less than the stratified") {
    const EnvironmentMap map = small_sky();
    RankedTile tile = paper_tile();
    const LightComparison comparison =
        compare_samplers(map, tile, {.counts = {16, 64, 256, 1024}, .normals = 100, .runs = 6});
    REQUIRE(comparison.samplers.size() == std::size(kLightSamplers));
    const auto& samplers = comparison.samplers;
    CHECK(samplers[1].slope == doctest::Approx(-0.5).epsilon(0.25));
    CHECK(samplers[2].slope < samplers[1].slope);
    const SamplerErrors& ours = samplers.back();
    CHECK(ours.slope < -0.65);
    for (const std::size_t i : {std::size_t{1}, std::size_t{2}, std::size_t{3}}) {
        CHECK(samplers[1].irradiance[i].mean > samplers[2].irradiance[i].mean);
        CHECK(samplers[2].irradiance[i].mean > samplers[3].irradiance[i].mean);
        CHECK(samplers[3].irradiance[i].mean > ours.irradiance[i].mean);
        for (std::size_t other = 0; other + 1 < samplers.size(); ++other)
            CHECK(samplers[other].glossy[i].mean > ours.glossy[i].mean);
    }
}

TEST_CASE("a comparison is written as a table, a plot and a page that are well-formed") {
    LightComparison comparison;
    comparison.request.counts = {16, 64};
    for (const LightSampler sampler : kLightSamplers)
        comparison.samplers.push_back({.sampler = sampler,
                                       .irradiance = {{0.25, 0.5}, {0.125, 0.25}},
                                       .glossy = {{0.5, 1}, {0.375, 0.625}},
                                       .slope = -0.5});
    std::ostringstream csv;
    write_comparison_csv(csv, comparison);
    CHECK(csv.str().starts_with(
        "sampler,samples,relative_error,largest_error,glossy_error,largest_glossy_error,slope\n"
        "\"uniform random\",16,0.25,0.5,0.5,1,-0.5\n"
        "\"uniform random\",64,0.125,0.25,0.375,0.625,-0.5\n"));
    pugi::xml_document document;
    CHECK(document.load_string(comparison_plot(comparison).c_str()));
    CHECK(document.load_string(comparison_page(comparison, "a < b").c_str()));
    const std::string table = comparison_table(comparison);
    CHECK(table.find("12.5 %") != table.npos);
    CHECK(table.find("37.5 %") != table.npos);
    CHECK(table.find("62.5 %") != table.npos);
    CHECK(table.find("1.0\n") != table.npos);
}

TEST_CASE("the error of irradiance is the mean of what luminance is wrong by, and the most of it") {
    const std::vector<glm::dvec3> exact{glm::dvec3(1), glm::dvec3(2), glm::dvec3(0)};
    const std::vector<glm::dvec3> found{glm::dvec3(1.1), glm::dvec3(1), glm::dvec3(5)};
    CHECK(relative_error(found, exact).mean == doctest::Approx((0.1 + 0.5) / 2));
    CHECK(relative_error(found, exact).largest == doctest::Approx(0.5));
}

TEST_CASE("the median cut parts a map where it has half of its light on either side") {
    // Light in four texels, by twos far apart.
    Grid<glm::vec3> grid(16, 8, glm::vec3(0));
    for (const glm::ivec2 lit : {glm::ivec2(2, 3), glm::ivec2(3, 4), glm::ivec2(11, 3), glm::ivec2(12, 4)})
        grid.at(lit.x, lit.y) = glm::vec3(1);
    const EnvironmentMap map(grid);
    RankedTile tile = paper_tile();
    const double flux = luminance(map.total_flux());
    for (const std::uint64_t count : {1u, 2u, 4u, 100u}) {
        const auto lights = sampled_lights(map, tile, LightSampler::median_cut, count, 1);
        REQUIRE(lights.size() == std::min<std::size_t>(count, 4));
        for (const DistantLight& light : lights)
            CHECK(luminance(light.weight) == doctest::Approx(flux / double(lights.size())));
    }
}

TEST_CASE("a glossy surface sees light by the power of its cosine") {
    const std::vector<DistantLight> lights{{{0, 1, 0}, glm::dvec3(2)}, {{0.6, 0.8, 0}, glm::dvec3(1)}};
    const std::vector<glm::dvec3> normals{{0, 1, 0}, {0, -1, 0}};
    const auto seen = irradiance(lights, normals, 50);
    CHECK(seen[0].x == doctest::Approx(2 + std::pow(0.8, 50)));
    CHECK(seen[1].x == 0);
}
