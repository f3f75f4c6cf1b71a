#include "core/lights/light_samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/lights/direction.h"
#include "core/lights/light_order.h"
#include "core/lights/regions.h"
#include "core/lights/settling.h"
#include "core/tile/neighbours.h"
#include "core/tile/random.h"

namespace dapple {

namespace {

constexpr double kPlacingShare = 0.4;  // of the time that samples take: most of it for the density

class Stopwatch {
 public:
    double ms() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
    }

 private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// The places of the dots that Figure 8 emits, each once: the `count` of them that appear first as its scale
// grows.
std::vector<glm::dvec2> figure8_dots(const RankedTile& tile, const Density& density, std::uint64_t count,
                                     const std::stop_token& stop) {
    const auto placed = place_figure8_count(density, tile.tile(), tile.own_ranks(), count, stop);
    if (!placed) return {};
    const Dots& dots = placed->dots;
    struct Place {
        float x, y;
        double critical;
    };
    std::vector<Place> places(dots.size());
    for (std::size_t i = 0; i < dots.size(); ++i) {
        const double here = density.at({dots.x[i], dots.y[i]});
        places[i] = {dots.x[i], dots.y[i],
                     here > 0 ? dots.threshold[i] / here : std::numeric_limits<double>::max()};
    }
    std::ranges::sort(places, {}, [](const Place& p) { return std::tuple(p.y, p.x, p.critical); });
    const auto alike = [](const Place& a, const Place& b) { return a.x == b.x && a.y == b.y; };
    places.erase(std::unique(places.begin(), places.end(), alike), places.end());
    std::ranges::stable_sort(places, {}, &Place::critical);
    std::vector<glm::dvec2> chosen(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < count; ++i) chosen[i] = {places[i].x, places[i].y};
    return chosen;
}

std::vector<glm::dvec2> exact_dots(RankedTile& tile, const Density& density, const LightRequest& request,
                                   const std::stop_token& stop) {
    DotPieces dots;
    if (!tile.placer().place(density, {.count = request.count, .threads = request.threads}, dots, stop))
        return {};
    std::vector<glm::dvec2> places;
    places.reserve(dots.size());
    for_each_position(dots, [&](float x, float y) { places.emplace_back(x, y); });
    return places;
}

}  // namespace

namespace {

void check_count(std::uint64_t count) {
    if (count < 1 || count > kMostLightSamples)
        throw std::runtime_error(
            fmt::format("{} samples are not possible; ask for 1 to {}", count, kMostLightSamples));
}

int turn_of(const EnvironmentMap& map, std::uint64_t seed) {
    return seed == 0 ? 0 : static_cast<int>(Random(seed).below(static_cast<std::size_t>(map.width())));
}

// Of a density that is turned by so many columns.
std::vector<glm::dvec2> dots_of(const Density& density, int turn, RankedTile& tile,
                                const LightRequest& request, const std::stop_token& stop) {
    std::vector<glm::dvec2> places = request.placer == PlacerKind::figure8
                                         ? figure8_dots(tile, density, request.count, stop)
                                         : exact_dots(tile, density, request, stop);
    for (glm::dvec2& p : places) {
        p.x += static_cast<double>(turn) / density.width();
        if (p.x >= 1) p.x -= 1;
        p.y = std::min(2 * p.y, 1.0);  // the page's unit is the map's width
    }
    return places;
}

// Samples that are settled, of a map with as many texels that have light. None if stopped.
class SettledSamples {
 public:
    SettledSamples(const EnvironmentMap& map, Grid<float> power, const LightRequest& request)
        : map_(map), power_(std::move(power)), request_(request) {
        take_own_texels();
    }

    std::vector<glm::dvec2> dots(RankedTile& tile, const std::stop_token& stop) const {
        const int turn = turn_of(map_, request_.seed);
        Grid<float> rest(power_.width, power_.height);
        for (int y = 0; y < rest.height; ++y)
            for (int x = 0; x < rest.width; ++x)
                rest.at(x, y) = std::max(power_.at((x + turn) % rest.width, y), 0.0f);
        const float most = std::ranges::max(rest.values);
        for (float& value : rest.values) value /= most;
        LightRequest of_rest = request_;
        of_rest.count -= own_.size();
        return dots_of(Density(std::move(rest), Sides::wrap), turn, tile, of_rest, stop);
    }

    std::vector<LightSample> settled(std::span<const glm::dvec2> dots, const LightWatch& watch) const {
        std::vector<glm::dvec3> lights;
        for (const glm::dvec2 uv : dots) lights.push_back(direction_of(uv, SphereConvention::openexr));
        const TexelTree tree(map_, power_, request_.threads);
        const auto sums = settle(tree, lights, steps_for(request_.count), watch);
        if (!sums) return {};
        std::vector<LightSample> samples;
        for (const glm::ivec2 texel : own_)
            samples.push_back(sample((glm::dvec2(texel) + 0.5) / glm::dvec2(map_.width(), map_.height()),
                                     glm::dvec3(map_.radiance().at(texel.x, texel.y)),
                                     map_.solid_angle(texel.y)));
        for (std::size_t i = 0; i < lights.size(); ++i)
            samples.push_back(sample(uv_of(lights[i], SphereConvention::openexr),
                                     (*sums)[i].flux / (*sums)[i].solid_angle, (*sums)[i].solid_angle));
        return samples;
    }

 private:
    // More have less to gain, and take longer.
    static int steps_for(std::uint64_t count) { return count <= 10'000 ? 8 : count <= 100'000 ? 4 : 2; }

    LightSample sample(glm::dvec2 uv, const glm::dvec3& radiance, double solid_angle) const {
        return {uv, radiance * solid_angle, radiance,
                1 / (solid_angle * static_cast<double>(request_.count))};
    }

    // A texel that has as much power as a sample is to have, or more, is a sample's alone, and so on with
    // what is left; one sample at least is for the others.
    void take_own_texels() {
        while (own_.size() + 1 < request_.count) {
            double rest = 0;
            for (const float power : power_.values) rest += std::max(power, 0.0f);
            const double share = rest / static_cast<double>(request_.count - own_.size());
            std::vector<glm::ivec2> found;
            for (int y = 0; y < power_.height; ++y)
                for (int x = 0; x < power_.width; ++x)
                    if (power_.at(x, y) > 0 && power_.at(x, y) >= share) found.emplace_back(x, y);
            std::ranges::stable_sort(found, std::ranges::greater{},
                                     [&](glm::ivec2 texel) { return power_.at(texel.x, texel.y); });
            found.resize(std::min<std::size_t>(found.size(), request_.count - own_.size() - 1));
            if (found.empty()) return;
            for (const glm::ivec2 texel : found) power_.at(texel.x, texel.y) = -1;
            own_.insert(own_.end(), found.begin(), found.end());
        }
    }

    const EnvironmentMap& map_;
    Grid<float> power_;  // of the texels that are no sample's alone; below 0 for those
    const LightRequest& request_;
    std::vector<glm::ivec2> own_;
};

}  // namespace

std::vector<glm::dvec2> light_dots(const EnvironmentMap& map, RankedTile& tile, const LightRequest& request,
                                   const std::stop_token& stop) {
    check_count(request.count);
    const int turn = turn_of(map, request.seed);
    return dots_of(light_density(map, request.importance, turn), turn, tile, request, stop);
}

namespace {

LightSamples as_placed(const EnvironmentMap& map, RankedTile& tile, const LightRequest& request,
                       const LightWatch& watch) {
    if (request.radiance == SampleRadiance::point && request.position != SamplePosition::random)
        throw std::runtime_error(
            "the radiance at a sample's point needs a random position: other points have no density");
    LightSamples result{.position = request.position,
                        .radiance = request.radiance,
                        .order = request.order,
                        .seed = request.seed,
                        .total_flux = map.total_flux()};
    check_count(request.count);
    const Stopwatch placing;
    const Grid<float> power = light_density(map, request.importance).values();
    const auto lit = std::ranges::count_if(power.values, [](float value) { return value > 0; });
    std::optional<SettledSamples> settling;
    if (request.position == SamplePosition::settled && static_cast<std::uint64_t>(lit) >= request.count)
        settling.emplace(map, power, request);
    const std::vector<glm::dvec2> dots =
        settling ? settling->dots(tile, watch.stop) : light_dots(map, tile, request, watch.stop);
    if (!watch.goes_on(kPlacingShare)) return result;
    result.place_ms = placing.ms();

    const Stopwatch sharing;
    const bool drawn = request.position == SamplePosition::random;
    const LightWatch while_sharing{
        watch.stop, [&watch](double share) { watch.goes_on(kPlacingShare + (1 - kPlacingShare) * share); }};
    if (settling) {
        result.samples = settling->settled(dots, while_sharing);
        result.share_ms = sharing.ms();
        return result;
    }
    const std::vector<LightRegion> regions =
        share_light(map, power, dots, drawn ? std::optional(request.seed) : std::nullopt, while_sharing);
    if (regions.empty()) return result;
    result.samples.resize(dots.size());
    for (std::size_t i = 0; i < dots.size(); ++i) {
        const LightRegion& region = regions[i];
        LightSample& sample = result.samples[i];
        sample.uv = dots[i];
        if (request.position == SamplePosition::settled && glm::length(region.moment) > 0)
            sample.uv = uv_of(region.moment, SphereConvention::openexr);
        if (request.position == SamplePosition::random && region.power > 0) sample.uv = region.drawn;
        sample.weight = region.flux;
        sample.radiance = region.flux / region.solid_angle;
        double density = 1 / region.solid_angle;
        if (request.radiance == SampleRadiance::point && region.power > 0) {
            sample.radiance = map.at(sample.uv);
            const glm::ivec2 texel(sample.uv * glm::dvec2(power.width, power.height));
            density = power.at(texel.x, texel.y) / (map.solid_angle(texel.y) * region.power);
        }
        sample.pdf = density / static_cast<double>(dots.size());
    }
    result.share_ms = sharing.ms();
    return result;
}

}  // namespace

LightSamples light_samples(const EnvironmentMap& map, RankedTile& tile, const LightRequest& request,
                           const LightWatch& watch) {
    LightSamples lights = as_placed(map, tile, request, watch);
    if (request.order == LightOrder::placed) return lights;
    std::vector<LightSample> ordered;
    ordered.reserve(lights.samples.size());
    for (const std::uint32_t number : priority_order(lights.samples))
        ordered.push_back(lights.samples[number]);
    lights.samples = std::move(ordered);
    return lights;
}

bool meets_itself(const Tile& tile) {
    return std::ranges::any_of(legal_neighbours(tile.rule, tile.next_kind), [](const Neighbour& neighbour) {
        return neighbour.of == 0 && neighbour.kind == 0 && neighbour.offset == glm::ivec2(1, 0) &&
               neighbour.orientation == Orientation{};
    });
}

}  // namespace dapple
