#include "core/image/sky.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/maths/portable_math.h"

namespace dapple {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kSamplesAlongTexel = 8;  // for the sun's edge

// y up.
glm::dvec3 towards(double u, double elevation) {
    const double around = 2 * kPi * u;
    return {portable::cos(elevation) * portable::cos(around), portable::sin(elevation),
            portable::cos(elevation) * portable::sin(around)};
}

// 0..1, smooth, without a seam: a plane of cloud overhead, folded by sines of many sizes.
double cloud(const glm::dvec3& d) {
    const glm::dvec2 p = glm::dvec2(d.x, d.z) / (d.y + 0.12);
    double sum = 0, size = 1;
    glm::dvec2 q = p * 0.9;
    for (int octave = 0; octave < 5; ++octave) {
        q += 0.7 * glm::dvec2(portable::sin(1.9 * q.y + octave), portable::sin(1.7 * q.x + 2.0 * octave));
        sum += size * portable::sin(q.x) * portable::sin(q.y + 0.5);
        size *= 0.5;
        q = glm::dvec2(q.x * 1.6 - q.y * 1.2, q.x * 1.2 + q.y * 1.6);
    }
    return std::clamp(0.9 * sum - 0.1, 0.0, 1.0) * std::min(1.0, 6 * d.y);
}

glm::dvec3 vault(const glm::dvec3& d, const glm::dvec3& sun, double clouds) {
    const glm::dvec3 zenith{0.18, 0.36, 0.85}, horizon{0.95, 0.97, 1.0}, glow{1.0, 0.85, 0.6};
    const double low = portable::exp(-5 * std::max(d.y, 0.0));
    const double near_sun = std::max(glm::dot(d, sun), 0.0);
    glm::dvec3 light = zenith * (1 - low) + horizon * low;
    light += glow * (0.5 * portable::pow(near_sun, 8) + 6 * portable::pow(near_sun, 300));
    const double cover = clouds * cloud(d);
    return light * (1 - 0.8 * cover) + cover * glm::dvec3(1.6, 1.55, 1.5) * (1 + portable::pow(near_sun, 20));
}

}  // namespace

EnvironmentMap sky_map(const Sky& sky) {
    const int width = 2 * sky.height, height = sky.height;
    const glm::dvec3 sun = towards(sky.sun_u, sky.sun_elevation * kPi / 180);
    const double edge = portable::cos(sky.sun_radius * kPi / 180);
    const double texel = kPi / height;
    const double reach = portable::cos(std::min(sky.sun_radius * kPi / 180 + 2 * texel, kPi));
    const glm::dvec3 ground = glm::dvec3(0.16, 0.12, 0.08) * (0.6 + 1.4 * std::max(sun.y, 0.0));

    Grid<glm::vec3> radiance(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto place = [&](double i, double j) {
                return towards((x + i) / width, kPi * (0.5 - (y + j) / height));
            };
            const glm::dvec3 centre = place(0.5, 0.5);
            glm::dvec3 light = centre.y > 0 ? vault(centre, sun, sky.clouds) : ground;
            if (centre.y > 0 && glm::dot(centre, sun) > reach) {
                int inside = 0;
                for (int k = 0; k < kSamplesAlongTexel * kSamplesAlongTexel; ++k) {
                    const glm::dvec3 d = place((k % kSamplesAlongTexel + 0.5) / kSamplesAlongTexel,
                                               (k / kSamplesAlongTexel + 0.5) / kSamplesAlongTexel);
                    inside += glm::dot(d, sun) > edge;
                }
                light += sky.sun_radiance * glm::dvec3(1, 0.92, 0.78) * (1.0 * inside) /
                         (1.0 * kSamplesAlongTexel * kSamplesAlongTexel);
            }
            radiance.at(x, y) = glm::vec3(light);
        }
    }
    return EnvironmentMap(std::move(radiance));
}

}  // namespace dapple
