#include "core/lights/lit_objects.h"

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

LitObjects objects_lit_from(glm::dvec3 direction) {
    return LitObjects(std::vector<DistantLight>{{glm::normalize(direction), glm::dvec3(3)}});
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
    CHECK(difference(whole, whole).largest == 0);
    CHECK(difference(half, whole).mean == doctest::Approx(0.5));
    CHECK(difference(half, whole).largest == doctest::Approx(0.5));
}

TEST_CASE("light from the map's left falls on the sphere's left, and turning brings it round") {
    // u = 1/4 is +X.
    const LitObjects left = objects_lit_from({1, 0, 0});
    const auto picture = object_picture(left, LitObject::diffuse, {.size = 64});
    CHECK(brightness(picture, 10, 32) > brightness(picture, 54, 32) + 50);
    CHECK(picture.at(0, 0).w == 0);
    CHECK(picture.at(32, 32).w == 255);
    // 180 degrees about +Y take +X to -X.
    const auto turned = object_picture(left, LitObject::diffuse, {.size = 64, .turn_degrees = 180});
    CHECK(brightness(turned, 54, 32) > brightness(turned, 10, 32) + 50);
    // 90 degrees take +X to -Z, where the viewer stands.
    const auto front = object_picture(left, LitObject::diffuse, {.size = 64, .turn_degrees = 90});
    CHECK(brightness(front, 32, 32) > brightness(front, 4, 32) + 20);
}

TEST_CASE("the sphere's rim is as soft as a disc's is where it covers pixels in part, without steps") {
    constexpr int kSize = 64;
    const auto picture = object_picture(objects_lit_from({1, 0, 0}), LitObject::diffuse, {.size = kSize});
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

TEST_CASE("a glossy sphere mirrors a light where the angles of incidence and reflection are equal") {
    constexpr int kSize = 128;
    // From the left and behind the viewer, who looks along +Z.
    const glm::dvec3 light = glm::normalize(glm::dvec3(0.8, 0.3, -0.6));
    const auto picture = object_picture(objects_lit_from(light), LitObject::glossy, {.size = kSize});
    const glm::dvec3 halfway = glm::normalize(light - glm::dvec3(0, 0, 1));
    glm::dvec2 middle{};
    double sum = 0;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
            const double light_there =
                picture.at(x, y).w == 255 ? std::max(brightness(picture, x, y) - 128, 0) : 0;
            middle += light_there * glm::dvec2(x + 0.5, y + 0.5);
            sum += light_there;
        }
    REQUIRE(sum > 0);
    const double radius = kSize / 2.0 - 1;
    CHECK(middle.x / sum == doctest::Approx(kSize / 2.0 - halfway.x * radius).epsilon(0.05));
    CHECK(middle.y / sum == doctest::Approx(kSize / 2.0 - halfway.y * radius).epsilon(0.05));
}

TEST_CASE("ground lies in the shadow of a sphere on it where a ray to the light meets the sphere") {
    const glm::dvec3 light = glm::normalize(glm::dvec3(0.5, 0.7, -0.4));
    const ShadedGround ground(std::vector<DistantLight>{{light, glm::dvec3(3)}, {-light, glm::dvec3(9)}});
    int in_shadow = 0;
    // Its values are .083 apart: not along the shadow's edge.
    for (double x = -1.8; x <= 1.8; x += 0.1) {
        for (double z = -1.8; z <= 1.8; z += 0.1) {
            const glm::dvec3 to_sphere = glm::dvec3(-x, 1, -z);
            const double along = glm::dot(to_sphere, light);
            const double past = glm::length(to_sphere - along * light);  // of the ray, from the middle
            if (std::abs(past - 1) < 0.13) continue;
            const bool shaded = along > 0 && past < 1;
            CHECK(ground.at({x, z}).x == doctest::Approx(shaded ? 0 : 3 * light.y));
            in_shadow += shaded;
        }
    }
    CHECK(in_shadow > 50);
}

TEST_CASE("the picture of shaded ground has the shadow away from the light, and turns with it") {
    constexpr int kSize = 128;
    const LitObjects objects = objects_lit_from({1, 1, 0});
    const auto at = [&](double turn, double side) {
        const auto picture =
            object_picture(objects, LitObject::shaded, {.size = kSize, .turn_degrees = turn});
        return brightness(picture, static_cast<int>(kSize * (0.5 + side)), kSize / 2);
    };
    CHECK(at(0, -0.35) > at(0, 0.25) + 50);
    CHECK(at(180, 0.35) > at(180, -0.25) + 50);
}

TEST_CASE("pictures of any size show something, whether there is a pixel in the middle or not") {
    const LitObjects objects = objects_lit_from({1, 1, 0});
    for (const int size : {1, 2, 3, 4, 5, 31, 63})
        for (const LitObject object : kLitObjects) {
            CAPTURE(size);
            const auto picture = object_picture(objects, object, {.size = size});
            CHECK(picture.at(size / 2, size / 2).w > 0);
        }
}
