#include "core/lights/lit_sphere.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

using namespace dapple;

namespace {

IrradianceMap lit_from(glm::dvec3 direction) {
    return IrradianceMap(std::vector<DistantLight>{{glm::normalize(direction), glm::dvec3(3)}});
}

int brightness(const Grid<glm::u8vec4>& picture, int x, int y) {
    return picture.at(x, y).x;
}

}  // namespace

TEST_CASE("an irradiance map follows the cosine") {
    const glm::dvec3 light = glm::normalize(glm::dvec3(0.3, 0.5, -0.8));
    const IrradianceMap map = lit_from(light);
    // Normals are 7.5 degrees apart: between two about the shadow's edge the cosine is not straight.
    for (const glm::dvec3& normal : fibonacci_normals(200)) {
        const double exact = 3 * std::max(0.0, glm::dot(light, normal));
        CHECK(std::abs(map.at(normal).x - exact) < 0.11);
    }
}

TEST_CASE("the same light differs from itself by nothing, half of it by a half") {
    const IrradianceMap whole = lit_from({1, 1, 0});
    const IrradianceMap half(
        std::vector<DistantLight>{{glm::normalize(glm::dvec3(1, 1, 0)), glm::dvec3(1.5)}});
    CHECK(difference(whole, whole) == 0);
    CHECK(difference(half, whole) == doctest::Approx(0.5));
}

TEST_CASE("light from the map's left falls on the sphere's left, and turning brings it round") {
    // u = 1/4 is +X.
    const IrradianceMap left = lit_from({1, 0, 0});
    const auto picture = sphere_picture(left, {.size = 64});
    CHECK(brightness(picture, 10, 32) > brightness(picture, 54, 32) + 50);
    CHECK(picture.at(0, 0).w == 0);
    CHECK(picture.at(32, 32).w == 255);
    // 180 degrees about +Y take +X to -X.
    const auto turned = sphere_picture(left, {.size = 64, .turn_degrees = 180});
    CHECK(brightness(turned, 54, 32) > brightness(turned, 10, 32) + 50);
    // 90 degrees take +X to -Z, where the viewer stands.
    const auto front = sphere_picture(left, {.size = 64, .turn_degrees = 90});
    CHECK(brightness(front, 32, 32) > brightness(front, 4, 32) + 20);
}

TEST_CASE("the sphere's rim is as soft as a disc's is where it covers pixels in part, without steps") {
    constexpr int kSize = 64;
    const auto picture = sphere_picture(lit_from({1, 0, 0}), {.size = kSize});
    double area = 0;
    int soft = 0;
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            // The share of the pixel that lies in the disc, counted.
            constexpr int kParts = 16;
            int inside = 0;
            for (int part = 0; part < kParts * kParts; ++part) {
                const glm::dvec2 at(x + (part % kParts + 0.5) / kParts, y + (part / kParts + 0.5) / kParts);
                inside += glm::distance(at, glm::dvec2(kSize / 2.0)) < kSize / 2.0 - 1;
            }
            const double share = inside / double(kParts * kParts), alpha = picture.at(x, y).w / 255.0;
            CHECK(std::abs(alpha - share) < 0.12);
            soft += alpha > 0 && alpha < 1;
            area += alpha;
        }
    }
    CHECK(soft > 150);
    CHECK(area == doctest::Approx(3.14159265 * 31 * 31).epsilon(0.002));
}
