#include "lab/compare/structure.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numeric>
#include <vector>

#include "core/image/detail.h"
#include "core/image/tone.h"
#include "lab/analysis/ssim.h"

namespace dapple {
namespace {

constexpr double kWindow = 1.5;

glm::dvec2 gradient(const Grid<float>& grid, int x, int y) {
    const int left = std::max(x - 1, 0), right = std::min(x + 1, grid.width - 1);
    const int above = std::max(y - 1, 0), below = std::min(y + 1, grid.height - 1);
    return {(double(grid.at(right, y)) - grid.at(left, y)) / std::max(right - left, 1),
            (double(grid.at(x, below)) - grid.at(x, above)) / std::max(below - above, 1)};
}

Grid<float> as_seen(Grid<float> light, double sigma_px) {
    for (float& value : light.values) value = std::clamp(value, 0.0f, 1.0f);
    light = blurred(std::move(light), sigma_px);
    for (float& value : light.values) value = linear_to_srgb(std::clamp(value, 0.0f, 1.0f));
    return light;
}

}  // namespace

double gradient_correlation(const Grid<float>& a, const Grid<float>& b) {
    assert(a.width == b.width && a.height == b.height);
    double aa = 0, bb = 0, ab = 0;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const glm::dvec2 of_a = gradient(a, x, y), of_b = gradient(b, x, y);
            aa += glm::dot(of_a, of_a);
            bb += glm::dot(of_b, of_b);
            ab += glm::dot(of_a, of_b);
        }
    }
    return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0;
}

Structure structure(const Grid<float>& drawing, const Grid<float>& photograph, double sigma_px) {
    const Grid<float> a = as_seen(drawing, sigma_px), b = as_seen(photograph, sigma_px);
    const Grid<float> similar = ssim_map(a, b, kWindow * std::max(1.0, sigma_px));
    Structure result{.gradients = gradient_correlation(a, b)};
    const std::size_t pixels = b.values.size();
    if (pixels == 0) return result;
    std::vector<std::uint32_t> by_light(pixels);
    std::iota(by_light.begin(), by_light.end(), 0u);
    std::ranges::stable_sort(by_light, {}, [&](std::uint32_t i) { return b.values[i]; });
    for (std::size_t quarter = 0; quarter < 4; ++quarter) {
        const std::size_t first = pixels * quarter / 4, end = pixels * (quarter + 1) / 4;
        double sum = 0;
        for (std::size_t i = first; i < end; ++i) sum += double(similar.values[by_light[i]]);
        result.ssim_by_light[quarter] = end > first ? sum / double(end - first) : 0;
        result.ssim += sum / double(pixels);
    }
    return result;
}

}  // namespace dapple
