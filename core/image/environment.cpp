#include "core/image/environment.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "core/failure.h"
#include "core/maths/portable_math.h"

namespace dapple {

namespace {

using std::numbers::pi;
constexpr int kSamplesAlongTexel = 8;  // for the sun's edge

// y up.
glm::dvec3 towards(double u, double elevation) {
    const double around = 2 * pi * u;
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
    const glm::dvec3 sun = towards(sky.sun_u, sky.sun_elevation * pi / 180);
    const double edge = portable::cos(sky.sun_radius * pi / 180);
    const double texel = pi / height;
    const double reach = portable::cos(std::min(sky.sun_radius * pi / 180 + 2 * texel, pi));
    const glm::dvec3 ground = glm::dvec3(0.16, 0.12, 0.08) * (0.6 + 1.4 * std::max(sun.y, 0.0));

    Grid<glm::vec3> radiance(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto place = [&](double i, double j) {
                return towards((x + i) / width, pi * (0.5 - (y + j) / height));
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

namespace {

void check(const Grid<glm::vec3>& radiance) {
    const auto& [width, height, values] = radiance;
    if (radiance.empty() || width != 2 * height) {
        throw failure(
            "{} x {} pixels are not a latitude-longitude map, which is twice as wide as high; convert it "
            "first",
            width, height);
    }
    for (int y = 0; y < height; ++y) {
        const glm::vec3* row = radiance.row(y);
        for (int x = 0; x < width; ++x) {
            const float least = std::min({row[x].x, row[x].y, row[x].z});
            const float sum = row[x].x + row[x].y + row[x].z;
            if (std::isfinite(sum) && least >= 0) continue;
            const char* const what = std::isnan(sum) ? "not a number (NaN)"
                                     : least < 0     ? "negative"
                                                     : "infinite";
            throw failure("the light at pixel {}, {} is {}; repair the map first", x, y, what);
        }
    }
}

}  // namespace

double luminance(const glm::dvec3& light) {
    return 0.2126 * light.x + 0.7152 * light.y + 0.0722 * light.z;
}

EnvironmentMap::EnvironmentMap(Grid<glm::vec3> radiance) : radiance_(std::move(radiance)) {
    constexpr int kEven = 64;
    if (radiance_.width == 1 && radiance_.height == 1)
        radiance_ = Grid<glm::vec3>(2 * kEven, kEven, radiance_.at(0, 0));
    check(radiance_);
    for (int y = 0; y < height(); ++y) {
        glm::dvec3 row{};
        for (int x = 0; x < width(); ++x) row += glm::dvec3(radiance_.at(x, y));
        total_flux_ += row * solid_angle(y);
    }
    if (!(luminance(total_flux_) > 0))
        throw std::runtime_error("the map is black all over: there is no light to sample");
}

double EnvironmentMap::solid_angle(int row) const {
    // cos a - cos b = 2 sin((a + b) / 2) sin((b - a) / 2), without the cancellation near the poles.
    const double half = pi / height() / 2;
    return 2 * pi / width() * 2 * portable::sin((2 * row + 1) * half) * portable::sin(half);
}

glm::dvec3 EnvironmentMap::at(glm::dvec2 uv) const {
    const double x = uv.x * width() - 0.5, y = std::clamp(uv.y * height() - 0.5, 0.0, height() - 1.0);
    const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(y);
    const double s = x - x0, t = y - y0;
    const auto texel = [&](int column, int row) {
        return glm::dvec3(radiance_.at((column % width() + width()) % width(), std::min(row, height() - 1)));
    };
    const glm::dvec3 upper = texel(x0, y0) * (1 - s) + texel(x0 + 1, y0) * s;
    const glm::dvec3 lower = texel(x0, y0 + 1) * (1 - s) + texel(x0 + 1, y0 + 1) * s;
    return upper * (1 - t) + lower * t;
}

Density light_density(const EnvironmentMap& map, LightImportance importance, int first_column) {
    const int width = map.width(), height = map.height();
    const double mean = luminance(map.total_flux()) / (4 * pi);
    const auto fill = [&](double subtracted) {
        std::vector<double> row_factor(height);
        for (int y = 0; y < height; ++y) row_factor[y] = map.solid_angle(y);
        double highest = 0;
        const auto value = [&](int x, int y) {
            return std::max(0.0, luminance(map.radiance().at(x, y)) - subtracted) * row_factor[y];
        };
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) highest = std::max(highest, value(x, y));
        Grid<float> density(width, height);
        if (!(highest > 0)) return density;
        for (int y = 0; y < height; ++y) {
            float* const row = density.row(y);
            for (int x = 0; x < width; ++x) {
                const int column = x + first_column;
                row[x] = static_cast<float>(value(column < width ? column : column - width, y) / highest);
            }
        }
        return density;
    };
    if (importance == LightImportance::compensated) {
        Density density(fill(mean * (1 + 1e-9)), Sides::wrap);
        if (density.mean() > 0) return density;
    }
    return Density(fill(0), Sides::wrap);
}

Grid<float> light_pdf(const EnvironmentMap& map, LightImportance importance) {
    Grid<float> pdf = light_density(map, importance).values();
    const double sum = std::accumulate(pdf.values.begin(), pdf.values.end(), 0.0);
    for (int y = 0; y < pdf.height; ++y)
        for (int x = 0; x < pdf.width; ++x)
            pdf.at(x, y) = static_cast<float>(pdf.at(x, y) / (sum * map.solid_angle(y)));
    return pdf;
}

}  // namespace dapple
