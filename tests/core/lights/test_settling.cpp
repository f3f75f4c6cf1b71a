// Lights that settle, against a search through all lights for each texel.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "core/image/environment.h"
#include "core/lights/direction.h"
#include "core/lights/light_samples.h"
#include "core/lights/settling.h"

using namespace dapple;

namespace {

EnvironmentMap small_sky() {
    return sky_map({.height = 50, .sun_radius = 3, .sun_radiance = 900});
}

std::vector<glm::dvec3> random_directions(int count) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    std::vector<glm::dvec3> directions;
    for (int i = 0; i < count; ++i) {
        const double x = normal(random), y = normal(random);
        directions.push_back(glm::normalize(glm::dvec3(x, y, normal(random))));
    }
    return directions;
}

glm::dvec3 texel_direction(const EnvironmentMap& map, int x, int y) {
    return direction_of({(x + 0.5) / map.width(), (y + 0.5) / map.height()}, SphereConvention::openexr);
}

std::size_t nearest(const std::vector<glm::dvec3>& lights, glm::dvec3 direction) {
    const auto found =
        std::ranges::max_element(lights, {}, [&](glm::dvec3 light) { return glm::dot(light, direction); });
    return static_cast<std::size_t>(found - lights.begin());
}

// Of all texels: power times the squared distance to the light that they are nearest to.
double energy(const EnvironmentMap& map, const Grid<float>& power, const std::vector<glm::dvec3>& lights) {
    double sum = 0;
    for (int y = 0; y < map.height(); ++y)
        for (int x = 0; x < map.width(); ++x) {
            const glm::dvec3 here = texel_direction(map, x, y);
            sum += power.at(x, y) * (2 - 2 * glm::dot(lights[nearest(lights, here)], here));
        }
    return sum;
}

}  // namespace

TEST_CASE("each light stands for the texels that are nearest to it, but for those that are left out") {
    const EnvironmentMap map = small_sky();
    Grid<float> power = light_density(map).values();
    for (const int x : {3, 40, 77}) power.at(x, 20) = -1;
    for (const int count : {1, 2, 30, 3000}) {
        CAPTURE(count);
        const std::vector<glm::dvec3> lights = random_directions(count);
        std::vector<TexelSum> plain(lights.size());
        for (int y = 0; y < map.height(); ++y)
            for (int x = 0; x < map.width(); ++x) {
                if (power.at(x, y) < 0) continue;
                TexelSum& own = plain[nearest(lights, texel_direction(map, x, y))];
                own.flux += map.solid_angle(y) * glm::dvec3(map.radiance().at(x, y));
                own.solid_angle += map.solid_angle(y);
                own.power += power.at(x, y);
                own.moment += double(power.at(x, y)) * texel_direction(map, x, y);
            }
        for (const int threads : {1, 3}) {
            const TexelTree tree(map, power, threads);
            const Grid<std::uint32_t> numbers = tree.nearest_of(lights);
            int others = 0;
            for (int y = 0; y < map.height(); ++y)
                for (int x = 0; x < map.width(); ++x)
                    others += numbers.at(x, y) != nearest(lights, texel_direction(map, x, y));
            CHECK(others == 0);
            const auto found = tree.nearest_to(lights, {});
            REQUIRE(found);
            double off = 0;
            for (std::size_t i = 0; i < lights.size(); ++i)
                off += glm::distance((*found)[i].flux, plain[i].flux) +
                       std::abs((*found)[i].solid_angle - plain[i].solid_angle) +
                       std::abs((*found)[i].power - plain[i].power) +
                       glm::distance((*found)[i].moment, plain[i].moment);
            CHECK(off < 1e-9);
        }
    }
}

TEST_CASE("lights that settle come nearer to the light that they stand for, and none stays idle") {
    const EnvironmentMap map = small_sky();
    const Grid<float> power = light_density(map).values();
    const TexelTree tree(map, power, 1);
    std::vector<glm::dvec3> lights = random_directions(200);
    for (int i = 0; i < 50; ++i) lights[std::size_t(i)] = lights[50];  // of these, 50 are idle
    const double before = energy(map, power, lights);
    const auto sums = settle(tree, lights, 8);
    REQUIRE(sums);
    CHECK(energy(map, power, lights) < 0.35 * before);
    for (const TexelSum& own : *sums) CHECK(own.power > 0);
    for (const glm::dvec3& light : lights) CHECK(glm::length(light) == doctest::Approx(1));
}

TEST_CASE("there are as many settled samples as texels at most; more are placed as before") {
    const EnvironmentMap map(Grid<glm::vec3>(8, 4, glm::vec3(1)));
    RankedTile tile(make_tile(14217, 2895, 16), RankingMethod::energy);
    for (const std::uint64_t count : {31u, 32u, 33u, 100u}) {
        const LightSamples lights = light_samples(map, tile, {.count = count});
        CHECK(lights.samples.size() == count);
        glm::dvec3 flux{};
        for (const LightSample& sample : lights.samples) flux += sample.weight;
        CHECK(flux.x == doctest::Approx(4 * std::numbers::pi));
    }
}

TEST_CASE("whatever a map's light is, its samples are finite, as many as asked for, and have all of it") {
    RankedTile tile(make_tile(14217, 2895, 16), RankingMethod::energy);
    for (unsigned seed = 1; seed <= 120; ++seed) {
        std::mt19937 random(seed);
        const int height = 1 + static_cast<int>(random() % (seed % 3 == 0 ? 3 : 20));
        Grid<glm::vec3> light(2 * height, height);
        std::uint64_t lit = 0;
        for (glm::vec3& texel : light.values) {
            if (random() % 4 < seed % 4) continue;  // black
            const float some = std::pow(10.0f, static_cast<float>(random() % 60) - 30);
            texel = glm::vec3(some, some / 2, 2 * some);
            ++lit;
        }
        if (lit == 0) continue;
        const EnvironmentMap map(light);
        for (const std::uint64_t count : {std::uint64_t{1}, lit / 2 + 1, lit, lit + 1}) {
            CAPTURE(seed);
            CAPTURE(count);
            const LightSamples lights = light_samples(map, tile, {.count = count, .seed = seed % 3});
            CHECK(lights.samples.size() == count);
            glm::dvec3 flux{};
            bool finite = true;
            for (const LightSample& sample : lights.samples) {
                flux += sample.weight;
                finite &= std::isfinite(sample.uv.x + sample.uv.y + sample.radiance.x + sample.pdf);
            }
            CHECK(finite);
            CHECK(glm::distance(flux, map.total_flux()) < 1e-9 * glm::length(map.total_flux()));
        }
    }
}
