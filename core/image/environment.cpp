#include "core/image/environment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "core/maths/portable_math.h"

namespace dapple {

namespace {

constexpr double kPi = std::numbers::pi;

void check(const Grid<glm::vec3>& radiance) {
    const auto& [width, height, values] = radiance;
    if (radiance.empty() || width != 2 * height) {
        throw std::runtime_error(fmt::format(
            "{} x {} pixels are no latitude-longitude map, which is twice as wide as high; convert it first",
            width, height));
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
            throw std::runtime_error(
                fmt::format("the light at pixel {}, {} is {}; repair the map first", x, y, what));
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
    if (!(luminance(total_flux_) > 0)) {
        throw std::runtime_error("the map is black all over: there is no light to take samples of");
    }
}

double EnvironmentMap::solid_angle(int row) const {
    // cos a - cos b = 2 sin((a + b) / 2) sin((b - a) / 2), without the cancellation near the poles.
    const double half = kPi / height() / 2;
    return 2 * kPi / width() * 2 * portable::sin((2 * row + 1) * half) * portable::sin(half);
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
    const double mean = luminance(map.total_flux()) / (4 * kPi);
    const auto fill = [&](double subtracted) {
        std::vector<double> row_factor(height);
        for (int y = 0; y < height; ++y) row_factor[y] = map.solid_angle(y);
        double highest = 0;
        const auto value = [&](int x, int y) {
            return std::max(0.0, luminance(map.radiance().at(x, y)) - subtracted) * row_factor[y];
        };
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) highest = std::max(highest, value(x, y));
        }
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
