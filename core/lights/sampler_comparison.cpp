#include "core/lights/sampler_comparison.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <tuple>

#include "core/lights/direction.h"
#include "core/lights/light_samples.h"
#include "core/maths/portable_math.h"
#include "core/tile/random.h"

namespace dapple {

namespace {

// Which of the steps of a cumulative sum holds a value, and how far in it, 0..1.
struct Step {
    int index;
    double within;
};

Step step_at(std::span<const double> cumulative, double value) {
    const auto above = std::upper_bound(cumulative.begin(), cumulative.end(), value);
    // Rounding may put a value at the end; the last step that has any width is meant.
    auto end = above == cumulative.end() ? std::ranges::lower_bound(cumulative, cumulative.back()) : above;
    if (end == cumulative.begin()) ++end;
    const double from = *(end - 1), to = *end;
    return {static_cast<int>(end - cumulative.begin()) - 1,
            to > from ? std::clamp((value - from) / (to - from), 0.0, 1.0) : 0.5};
}

std::vector<DistantLight> uniform_lights(const EnvironmentMap& map, std::uint64_t count, Random& random) {
    std::vector<DistantLight> lights(static_cast<std::size_t>(count));
    for (DistantLight& light : lights) {
        const glm::dvec2 uv(random.unit(), portable::acos(1 - 2 * random.unit()) / std::numbers::pi);
        const int x = std::min(static_cast<int>(uv.x * map.width()), map.width() - 1);
        const int y = std::min(static_cast<int>(uv.y * map.height()), map.height() - 1);
        light = {direction_of(uv, SphereConvention::openexr),
                 glm::dvec3(map.radiance().at(x, y)) * (4 * std::numbers::pi / static_cast<double>(count))};
    }
    return lights;
}

DistantLight inverted_light(const EnvironmentMap& map, const LightInversion& inversion, glm::dvec2 square,
                            std::uint64_t count) {
    const LightInversion::Place place = inversion.at(square.x, square.y);
    const glm::dvec3 radiance(map.radiance().at(place.column, place.row));
    return {direction_of(place.uv, SphereConvention::openexr),
            radiance * (inversion.total() / (static_cast<double>(count) * luminance(radiance)))};
}

// The brightest rectangle is cut where it has half of its light on either side, across its longer side as
// seen on the sphere. There is nothing random about it.
std::vector<DistantLight> median_cut(const EnvironmentMap& map, std::uint64_t count) {
    const int width = map.width(), height = map.height();
    Grid<double> sums(width + 1, height + 1);  // of all texels above and to the left
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            sums.at(x + 1, y + 1) = luminance(map.radiance().at(x, y)) * map.solid_angle(y) +
                                    sums.at(x, y + 1) + sums.at(x + 1, y) - sums.at(x, y);
    struct Part {
        int left, top, right, bottom;
        double light;
    };
    const auto part = [&](int left, int top, int right, int bottom) {
        return Part{
            left, top, right, bottom,
            sums.at(right, bottom) - sums.at(left, bottom) - sums.at(right, top) + sums.at(left, top)};
    };
    const auto brightest_last = [](const Part& a, const Part& b) {
        return std::tie(a.light, a.left, a.top) < std::tie(b.light, b.left, b.top);
    };
    std::vector<Part> parts{part(0, 0, width, height)}, whole;
    while (parts.size() + whole.size() < count && !parts.empty()) {
        std::ranges::pop_heap(parts, brightest_last);
        const Part cut = parts.back();
        parts.pop_back();
        const int across = cut.right - cut.left, down = cut.bottom - cut.top;
        if (across == 1 && down == 1) {
            whole.push_back(cut);
            continue;
        }
        const double middle = std::numbers::pi * (cut.top + cut.bottom) / (2 * height);
        const bool by_columns = down == 1 || (across > 1 && across * portable::sin(middle) > down);
        int low = 1, high = (by_columns ? across : down) - 1;
        const auto first = [&](int length) {
            return by_columns ? part(cut.left, cut.top, cut.left + length, cut.bottom)
                              : part(cut.left, cut.top, cut.right, cut.top + length);
        };
        while (low < high) {
            const int at = (low + high) / 2;
            if (first(at).light < cut.light / 2)
                low = at + 1;
            else
                high = at;
        }
        const Part half = first(low);
        parts.push_back(half);
        std::ranges::push_heap(parts, brightest_last);
        parts.push_back(by_columns ? part(half.right, cut.top, cut.right, cut.bottom)
                                   : part(cut.left, half.bottom, cut.right, cut.bottom));
        std::ranges::push_heap(parts, brightest_last);
    }
    parts.insert(parts.end(), whole.begin(), whole.end());
    std::vector<DistantLight> lights;
    for (const Part& of : parts) {
        const DistantLight light = block_light(map, {of.left, of.top}, {of.right, of.bottom});
        if (light.direction != glm::dvec3{}) lights.push_back(light);
    }
    return lights;
}

std::vector<DistantLight> own_lights(const EnvironmentMap& map, RankedTile& tile, SamplePosition position,
                                     std::uint64_t count, std::uint64_t seed) {
    std::vector<DistantLight> lights;
    const LightRequest request{.count = count, .position = position, .seed = seed};
    for (const LightSample& sample : light_samples(map, tile, request).samples)
        lights.push_back({direction_of(sample.uv, SphereConvention::openexr), sample.weight});
    return lights;
}

// Halves change places, then the quarters of each, and so on: each bit is flipped or not by a random number
// of its own for every value of the bits before it.
double owen_scrambled(double coordinate, std::uint64_t seed) {
    const auto bits = static_cast<std::uint32_t>(coordinate * 0x1p32);
    std::uint32_t result = 0;
    for (int bit = 31; bit >= 0; --bit) {
        const std::uint64_t before = (std::uint64_t{1} << 32 | bits) >> bit >> 1;  // led by a 1
        result |=
            ((bits >> bit ^ static_cast<std::uint32_t>(portable::mixed(seed ^ portable::mixed(before)))) & 1)
            << bit;
    }
    return result * 0x1p-32;
}

double slope_of(std::span<const std::uint64_t> counts, std::span<const RelativeError> errors) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (!(errors[i].mean > 0)) continue;
        const double x = portable::log(static_cast<double>(counts[i])), y = portable::log(errors[i].mean);
        n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    const double spread = n * sxx - sx * sx;
    return spread > 0 ? (n * sxy - sx * sy) / spread : 0;
}

}  // namespace

LightInversion::LightInversion(const EnvironmentMap& map)
    : width_(map.width()), height_(map.height()), rows_(1, 0.0) {
    for (int y = 0; y < height_; ++y) {
        double sum = 0;
        columns_.push_back(0);
        for (int x = 0; x < width_; ++x) {
            sum += luminance(map.radiance().at(x, y));
            columns_.push_back(sum);
        }
        rows_.push_back(rows_.back() + sum * map.solid_angle(y));
    }
}

LightInversion::Place LightInversion::at(double s, double t) const {
    const Step row = step_at(rows_, t * rows_.back());
    const std::span columns(columns_.data() + static_cast<std::size_t>(row.index) * (width_ + 1),
                            static_cast<std::size_t>(width_) + 1);
    const Step column = step_at(columns, s * columns.back());
    const double top = portable::cos(std::numbers::pi * row.index / height_);
    const double bottom = portable::cos(std::numbers::pi * (row.index + 1) / height_);
    const double theta = portable::acos(std::clamp(top + (bottom - top) * row.within, -1.0, 1.0));
    return {{(column.index + column.within) / width_, theta / std::numbers::pi}, column.index, row.index};
}

std::vector<DistantLight> sampled_lights(const EnvironmentMap& map, RankedTile& tile, LightSampler sampler,
                                         std::uint64_t count, std::uint64_t seed) {
    Random random(seed * 5 + static_cast<std::uint64_t>(sampler));
    switch (sampler) {
        case LightSampler::uniform:
            return uniform_lights(map, count, random);
        case LightSampler::importance:
        case LightSampler::stratified:
        case LightSampler::sobol:
            break;
        case LightSampler::median_cut:
            return median_cut(map, count);
        case LightSampler::unbiased:
            return own_lights(map, tile, SamplePosition::random, count, seed);
        case LightSampler::settled:
            return own_lights(map, tile, SamplePosition::settled, count, seed);
    }
    const bool stratified = sampler == LightSampler::stratified;
    const auto side =
        stratified ? static_cast<std::uint64_t>(std::sqrt(static_cast<double>(count))) : std::uint64_t{1};
    if (stratified) count = side * side;
    const LightInversion inversion(map);
    std::vector<DistantLight> lights;
    for (std::uint64_t i = 0; i < count; ++i) {
        glm::dvec2 square;
        if (sampler == LightSampler::sobol) {
            square = scrambled(sobol_point(static_cast<std::uint32_t>(i)), seed);
        } else {
            const double s = random.unit(), t = random.unit();
            const glm::dvec2 cell = stratified ? glm::dvec2(i % side, i / side) : glm::dvec2(0);
            square = (cell + glm::dvec2(s, t)) / static_cast<double>(side);
        }
        lights.push_back(inverted_light(map, inversion, square, count));
    }
    return lights;
}

glm::dvec2 sobol_point(std::uint32_t index) {
    // The direction numbers of the second dimension, of the polynomial x + 1: each is the last one xor its
    // half. Those of the first are single bits.
    std::uint32_t x = 0, y = 0, single = 1u << 31, direction = 1u << 31;
    for (; index > 0; index >>= 1, single >>= 1, direction ^= direction >> 1) {
        if ((index & 1) == 0) continue;
        x ^= single;
        y ^= direction;
    }
    return {x * 0x1p-32, y * 0x1p-32};
}

glm::dvec2 scrambled(glm::dvec2 point, std::uint64_t seed) {
    return {owen_scrambled(point.x, portable::mixed(seed)), owen_scrambled(point.y, ~portable::mixed(seed))};
}

LightComparison compare_samplers(const EnvironmentMap& map, RankedTile& tile,
                                 const ComparisonRequest& request) {
    const std::vector<glm::dvec3> normals = fibonacci_normals(request.normals);
    const std::vector<DistantLight> texels = texel_lights(map);
    const std::vector<glm::dvec3> exact = irradiance(texels, normals),
                                  glossy = irradiance(texels, normals, kGlossy);
    LightComparison comparison{request, {}};
    for (const LightSampler sampler : kLightSamplers) {
        SamplerErrors result{.sampler = sampler};
        for (const std::uint64_t count : request.counts) {
            RelativeError& of_irradiance = result.irradiance.emplace_back();
            RelativeError& of_glossy = result.glossy.emplace_back();
            const auto average = [&request](RelativeError& so_far, const RelativeError& run) {
                so_far.mean += run.mean / request.runs;
                so_far.largest += run.largest / request.runs;
            };
            for (int run = 1; run <= request.runs; ++run) {
                const auto lights =
                    sampled_lights(map, tile, sampler, count, static_cast<std::uint64_t>(run));
                average(of_irradiance, relative_error(irradiance(lights, normals), exact));
                average(of_glossy, relative_error(irradiance(lights, normals, kGlossy), glossy));
            }
        }
        result.slope = slope_of(request.counts, result.irradiance);
        comparison.samplers.push_back(std::move(result));
    }
    return comparison;
}

}  // namespace dapple
