#include "core/lights/lit_sphere.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>
#include <vector>

#include "core/lights/direction.h"
#include "core/lights/light_picture.h"

namespace dapple {

namespace {

constexpr int kColumns = 48, kRows = 24;

glm::dvec2 place_of(int column, int row) {
    return {(column + 0.5) / kColumns, (row + 0.5) / kRows};
}

}  // namespace

IrradianceMap::IrradianceMap(std::span<const DistantLight> lights) : values_(kColumns, kRows) {
    std::vector<glm::dvec3> normals;
    for (int y = 0; y < kRows; ++y) {
        for (int x = 0; x < kColumns; ++x)
            normals.push_back(direction_of(place_of(x, y), SphereConvention::openexr));
    }
    values_.values = irradiance(lights, normals);
}

glm::dvec3 IrradianceMap::at(glm::dvec3 normal) const {
    const glm::dvec2 uv = uv_of(normal, SphereConvention::openexr);
    const double x = uv.x * kColumns - 0.5, y = std::clamp(uv.y * kRows - 0.5, 0.0, kRows - 1.0);
    const int x0 = static_cast<int>(std::floor(x)), y0 = std::min(static_cast<int>(y), kRows - 2);
    const auto value = [&](int column, int row) { return values_.at((column + kColumns) % kColumns, row); };
    return glm::mix(glm::mix(value(x0, y0), value(x0 + 1, y0), x - x0),
                    glm::mix(value(x0, y0 + 1), value(x0 + 1, y0 + 1), x - x0), y - y0);
}

double difference(const IrradianceMap& found, const IrradianceMap& exact) {
    double sum = 0, weights = 0;
    for (int y = 0; y < kRows; ++y) {
        const double weight = std::sin(std::numbers::pi * place_of(0, y).y);
        for (int x = 0; x < kColumns; ++x) {
            const double right = luminance(exact.values().at(x, y));
            if (!(right > 0)) continue;
            sum += weight * std::abs(luminance(found.values().at(x, y)) - right) / right;
            weights += weight;
        }
    }
    return weights > 0 ? sum / weights : 0;
}

Grid<glm::u8vec4> sphere_picture(const IrradianceMap& light, const SphereLook& look) {
    Grid<glm::u8vec4> picture(look.size, look.size);
    const double radius = look.size / 2.0 - 1;
    tbb::parallel_for(0, look.size, [&](int j) {
        for (int i = 0; i < look.size; ++i) {
            double right = (i + 0.5 - look.size / 2.0) / radius;
            double up = (look.size / 2.0 - j - 0.5) / radius;
            const double away = std::hypot(right, up);
            const double covered = std::clamp((1 - away) * radius + 0.5, 0.0, 1.0);
            if (away > 1) {
                right /= away;
                up /= away;
            }
            const double towards = std::sqrt(std::max(0.0, 1 - away * away));
            const glm::dvec3 normal =
                turned_about_up({-right, up, -towards}, -look.turn_degrees, SphereConvention::openexr);
            const glm::u8vec3 colour = tone_mapped(light.at(normal) / std::numbers::pi, look.exposure);
            picture.at(i, j) = glm::u8vec4(colour, static_cast<glm::u8>(255 * covered + 0.5));
        }
    });
    return picture;
}

}  // namespace dapple
