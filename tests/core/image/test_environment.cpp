#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "core/image/environment.h"
#include "core/lights/direction.h"
#include "core/lights/lit_objects.h"

using namespace dapple;

namespace {

constexpr double kPi = std::numbers::pi;

Grid<glm::vec3> even(int height, glm::vec3 light) {
    return Grid<glm::vec3>(2 * height, height, light);
}

void check_direction(SphereConvention convention, glm::dvec2 uv, glm::dvec3 expected) {
    CAPTURE(name_of(convention));
    CHECK(glm::distance(direction_of(uv, convention), expected) < 1e-12);
}

}  // namespace

TEST_CASE("the texels' solid angles sum to the sphere and follow the closed form") {
    const EnvironmentMap map(even(16, glm::vec3(1)));
    double sum = 0;
    for (int y = 0; y < 16; ++y) {
        sum += 32 * map.solid_angle(y);
        const double exact = 2 * kPi / 32 * (std::cos(kPi * y / 16) - std::cos(kPi * (y + 1) / 16));
        CHECK(map.solid_angle(y) == doctest::Approx(exact).epsilon(1e-12));
    }
    CHECK(sum == doctest::Approx(4 * kPi).epsilon(1e-12));
}

TEST_CASE("an even map of radiance L has the flux 4 pi L and lights every surface with pi L") {
    const EnvironmentMap map(even(64, {0.5f, 2, 8}));
    CHECK(map.total_flux().x == doctest::Approx(4 * kPi * 0.5).epsilon(1e-9));
    CHECK(map.total_flux().z == doctest::Approx(4 * kPi * 8).epsilon(1e-9));
    for (const glm::dvec3& e : irradiance(texel_lights(map), fibonacci_normals(50)))
        CHECK(e.y == doctest::Approx(kPi * 2).epsilon(1e-3));
}

TEST_CASE("a sun of one texel lights a surface by radiance, solid angle and cosine") {
    Grid<glm::vec3> grid = even(32, glm::vec3(0));
    grid.at(10, 5) = glm::vec3(1e5f);
    const EnvironmentMap map(grid);
    const glm::dvec3 sun = direction_of({10.5 / 64, 5.5 / 32}, SphereConvention::openexr);
    const auto normals = fibonacci_normals(100);
    const auto light = irradiance(texel_lights(map), normals);
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const double exact = 1e5 * map.solid_angle(5) * std::max(0.0, glm::dot(sun, normals[i]));
        CHECK(light[i].x == doctest::Approx(exact).epsilon(1e-9));
    }
}

TEST_CASE("the picture's centre and quarter lie where each convention says") {
    using enum SphereConvention;
    for (const SphereConvention c : {openexr, usd, mitsuba}) {
        check_direction(c, {0.5, 0.5}, {0, 0, 1});
        check_direction(c, {0.25, 0.5}, {1, 0, 0});
        check_direction(c, {0.75, 0.5}, {-1, 0, 0});
        check_direction(c, {0.3, 0}, {0, 1, 0});
        check_direction(c, {0.3, 1}, {0, -1, 0});
    }
    check_direction(blender, {0.5, 0.5}, {1, 0, 0});
    check_direction(blender, {0.25, 0.5}, {0, 1, 0});
    check_direction(blender, {0.1, 0}, {0, 0, 1});
    check_direction(pbrt, {0.5, 0.5}, {-1, 0, 0});
    check_direction(pbrt, {0.25, 0.5}, {0, 1, 0});
    check_direction(pbrt, {0.1, 0}, {0, 0, 1});
}

TEST_CASE("Mitsuba's and pbrt's directions follow their published formulas") {
    for (const glm::dvec2 uv : {glm::dvec2(0.1, 0.3), glm::dvec2(0.6, 0.8), glm::dvec2(0.95, 0.55)}) {
        const double phi = 2 * kPi * uv.x, theta = kPi * uv.y;
        check_direction(SphereConvention::mitsuba, uv,
                        {std::sin(phi) * std::sin(theta), std::cos(theta), -std::cos(phi) * std::sin(theta)});
        check_direction(SphereConvention::pbrt, uv,
                        {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)});
    }
}

TEST_CASE("a place on the map is found again from its direction in every convention") {
    using enum SphereConvention;
    for (const SphereConvention c : {openexr, usd, mitsuba, blender, pbrt}) {
        for (int i = 0; i < 50; ++i) {
            const glm::dvec2 uv(std::fmod(0.013 + 0.37 * i, 1.0), std::fmod(0.021 + 0.23 * i, 1.0));
            CHECK(glm::distance(uv_of(direction_of(uv, c), c), uv) < 1e-12);
        }
    }
}

TEST_CASE("turning goes about the up axis by the right-hand rule") {
    using enum SphereConvention;
    CHECK(glm::distance(turned_about_up({0, 0, 1}, 90, openexr), glm::dvec3(1, 0, 0)) < 1e-12);
    CHECK(glm::distance(turned_about_up({0, 1, 0}, 33, openexr), glm::dvec3(0, 1, 0)) < 1e-12);
    CHECK(glm::distance(turned_about_up({1, 0, 0}, 90, blender), glm::dvec3(0, 1, 0)) < 1e-12);
    CHECK(glm::distance(turned_about_up({1, 0, 0}, 90, pbrt), glm::dvec3(0, 1, 0)) < 1e-12);
    CHECK(glm::distance(turned_about_up({0.6, 0.3, -0.2}, 360, pbrt), glm::dvec3(0.6, 0.3, -0.2)) < 1e-12);
}

TEST_CASE("the density of a map is its texels' flux up to one factor and goes round the sides") {
    Grid<glm::vec3> grid = even(8, glm::vec3(1));
    grid.at(0, 3) = glm::vec3(7);
    const EnvironmentMap map(grid);
    const Density density = light_density(map);
    CHECK(density.sides() == Sides::wrap);
    const double factor = density.values().at(5, 5) / map.solid_angle(5);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 16; ++x) {
            const double flux = luminance(map.radiance().at(x, y)) * map.solid_angle(y);
            CHECK(density.values().at(x, y) == doctest::Approx(factor * flux).epsilon(1e-5));
        }
    }
    CHECK(density.at({1 - 1e-9, 3.5 / 16}) > density.at({1 - 1.0 / 16, 3.5 / 16}));
}

TEST_CASE("MIS compensation leaves out what is not above the mean") {
    Grid<glm::vec3> grid = even(8, glm::vec3(1));
    grid.at(4, 3) = glm::vec3(50);
    const Density density = light_density(EnvironmentMap(grid), LightImportance::compensated);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 16; ++x) CHECK((density.values().at(x, y) > 0) == (x == 4 && y == 3));
    }
    CHECK(light_density(EnvironmentMap(even(8, glm::vec3(3))), LightImportance::compensated).mean() > 0);
}

TEST_CASE("the pdf of a map is its light's share per steradian and integrates to one") {
    Grid<glm::vec3> grid = even(8, glm::vec3(1));
    grid.at(4, 3) = glm::vec3(50);
    grid.at(2, 0) = glm::vec3(0);
    const EnvironmentMap map(grid);
    const double flux = luminance(map.total_flux());
    for (const LightImportance importance : {LightImportance::light, LightImportance::compensated}) {
        const Grid<float> pdf = light_pdf(map, importance);
        double sum = 0;
        for (int y = 0; y < 8; ++y) {
            for (int x = 0; x < 16; ++x) {
                sum += pdf.at(x, y) * map.solid_angle(y);
                if (importance == LightImportance::light)
                    CHECK(pdf.at(x, y) == doctest::Approx(luminance(map.radiance().at(x, y)) / flux));
                else
                    CHECK((pdf.at(x, y) > 0) == (x == 4 && y == 3));
            }
        }
        CHECK(sum == doctest::Approx(1));
    }
    const Grid<float> even_pdf =
        light_pdf(EnvironmentMap(even(8, glm::vec3(3))), LightImportance::compensated);
    for (const float value : even_pdf.values) CHECK(value == doctest::Approx(1 / (16 * std::acos(0.0) / 2)));
}

TEST_CASE("maps that cannot be are refused in words") {
    using doctest::Contains;
    CHECK_THROWS_WITH(EnvironmentMap(Grid<glm::vec3>(8, 8)),
                      Contains("8 x 8 pixels are not a latitude-longitude"));
    CHECK_THROWS_WITH(EnvironmentMap(Grid<glm::vec3>()), Contains("twice as wide"));
    CHECK_THROWS_WITH(EnvironmentMap(even(4, glm::vec3(0))), Contains("black all over"));
    Grid<glm::vec3> grid = even(4, glm::vec3(1));
    grid.at(3, 2).y = std::numeric_limits<float>::quiet_NaN();
    CHECK_THROWS_WITH(EnvironmentMap{grid}, Contains("pixel 3, 2 is not a number"));
    grid.at(3, 2).y = std::numeric_limits<float>::infinity();
    CHECK_THROWS_WITH(EnvironmentMap{grid}, Contains("pixel 3, 2 is infinite"));
    grid.at(3, 2).y = -0.5f;
    CHECK_THROWS_WITH(EnvironmentMap{grid}, Contains("pixel 3, 2 is negative"));
}

TEST_CASE("the sky's sun has the flux of its disc whatever the map's size") {
    for (const int height : {128, 256}) {
        Sky sky{.height = height, .sun_radius = 2, .sun_radiance = 1e4, .clouds = 0};
        const EnvironmentMap with = sky_map(sky);
        sky.sun_radiance = 0;
        const double sun = (with.total_flux() - sky_map(sky).total_flux()).x;
        CHECK(sun == doctest::Approx(1e4 * 2 * kPi * (1 - std::cos(2 * kPi / 180))).epsilon(0.01));
    }
}
