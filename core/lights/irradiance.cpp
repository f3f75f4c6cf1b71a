#include "core/lights/irradiance.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/lights/direction.h"
#include "core/maths/portable_math.h"

namespace dapple {

std::vector<DistantLight> texel_lights(const EnvironmentMap& map) {
    std::vector<DistantLight> lights;
    for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
            const glm::dvec3 weight = glm::dvec3(map.radiance().at(x, y)) * map.solid_angle(y);
            if (weight == glm::dvec3{}) continue;
            const glm::dvec2 uv{(x + 0.5) / map.width(), (y + 0.5) / map.height()};
            lights.push_back({direction_of(uv, SphereConvention::openexr), weight});
        }
    }
    return lights;
}

std::vector<DistantLight> block_lights(const EnvironmentMap& map, int texels_a_side) {
    const auto block = [&](int left, int top) {
        glm::dvec3 weight{}, moment{};
        for (int y = top; y < std::min(top + texels_a_side, map.height()); ++y) {
            for (int x = left; x < std::min(left + texels_a_side, map.width()); ++x) {
                const glm::dvec3 light = glm::dvec3(map.radiance().at(x, y)) * map.solid_angle(y);
                const glm::dvec2 uv{(x + 0.5) / map.width(), (y + 0.5) / map.height()};
                weight += light;
                moment += luminance(light) * direction_of(uv, SphereConvention::openexr);
            }
        }
        return DistantLight{moment, weight};
    };
    std::vector<DistantLight> lights;
    for (int y = 0; y < map.height(); y += texels_a_side) {
        for (int x = 0; x < map.width(); x += texels_a_side) {
            const DistantLight light = block(x, y);
            if (light.direction == glm::dvec3{}) continue;
            lights.push_back({glm::normalize(light.direction), light.weight});
        }
    }
    return lights;
}

namespace {

double to_the(unsigned exponent, double base) {
    double power = 1;
    for (; exponent > 0; exponent >>= 1, base *= base)
        if (exponent & 1) power *= base;
    return power;
}

}  // namespace

std::vector<glm::dvec3> irradiance(std::span<const DistantLight> lights, std::span<const glm::dvec3> normals,
                                   unsigned exponent) {
    std::vector<glm::dvec3> result(normals.size());
    tbb::parallel_for(std::size_t{0}, normals.size(), [&](std::size_t i) {
        glm::dvec3 sum{};
        for (const DistantLight& light : lights) {
            const double cosine = glm::dot(light.direction, normals[i]);
            if (cosine > 0) sum += light.weight * to_the(exponent, cosine);
        }
        result[i] = sum;
    });
    return result;
}

RelativeError relative_error(std::span<const glm::dvec3> found, std::span<const glm::dvec3> exact,
                             std::span<const double> weights) {
    RelativeError error;
    double sum = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const double right = luminance(exact[i]), weight = weights.empty() ? 1 : weights[i];
        if (!(right > 0)) continue;
        const double here = std::abs(luminance(found[i]) - right) / right;
        error.mean += weight * here;
        error.largest = std::max(error.largest, here);
        sum += weight;
    }
    if (sum > 0) error.mean /= sum;
    return error;
}

std::vector<glm::dvec3> fibonacci_normals(int count) {
    constexpr double kGoldenAngle = std::numbers::pi * (3 - 2.23606797749978969641);
    std::vector<glm::dvec3> normals(count);
    for (int i = 0; i < count; ++i) {
        const double height = 1 - (2 * i + 1.0) / count, radius = std::sqrt(1 - height * height);
        normals[i] = {radius * portable::cos(i * kGoldenAngle), height,
                      radius * portable::sin(i * kGoldenAngle)};
    }
    return normals;
}

}  // namespace dapple
