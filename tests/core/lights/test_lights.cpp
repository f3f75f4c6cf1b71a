#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <set>
#include <utility>

#include "core/image/environment.h"
#include "core/lights/direction.h"
#include "core/lights/light_samples.h"
#include "core/lights/lit_objects.h"

using namespace dapple;

namespace {

constexpr double kPi = std::numbers::pi;

RankedTile paper_tile() {
    return {make_tile(14217, 2895, 16), RankingMethod::energy};
}

EnvironmentMap even_map(int height, glm::vec3 light) {
    return EnvironmentMap(Grid<glm::vec3>(2 * height, height, light));
}

EnvironmentMap small_sky() {
    return sky_map({.height = 64, .sun_radius = 2, .sun_radiance = 2000});
}

glm::dvec3 sum_of_weights(const LightSamples& lights) {
    glm::dvec3 sum{};
    for (const LightSample& sample : lights.samples) sum += sample.weight;
    return sum;
}

std::vector<DistantLight> distant(const LightSamples& lights) {
    std::vector<DistantLight> result;
    for (const LightSample& sample : lights.samples)
        result.push_back({direction_of(sample.uv, SphereConvention::openexr), sample.weight});
    return result;
}

// Mean relative error of luminance over normals.
double irradiance_error(const EnvironmentMap& map, const LightSamples& lights) {
    const auto normals = fibonacci_normals(200);
    const auto exact = irradiance(texel_lights(map), normals);
    const auto found = irradiance(distant(lights), normals);
    double sum = 0;
    for (std::size_t i = 0; i < normals.size(); ++i)
        sum += std::abs(luminance(found[i]) / luminance(exact[i]) - 1);
    return sum / static_cast<double>(normals.size());
}

void check_flux(const EnvironmentMap& map, const LightSamples& lights) {
    const glm::dvec3 sum = sum_of_weights(lights), exact = map.total_flux();
    for (int c = 0; c < 3; ++c) CHECK(sum[c] == doctest::Approx(exact[c]).epsilon(1e-9));
}

double least_distance(const std::vector<glm::dvec2>& dots, auto&& chosen) {
    double least = 1;
    for (std::size_t i = 0; i < dots.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (!chosen(dots[i], dots[j])) continue;
            double x = std::abs(dots[i].x - dots[j].x);
            x = std::min(x, 1 - x);
            least = std::min(least, std::hypot(x, (dots[i].y - dots[j].y) / 2));
        }
    }
    return least;
}

}  // namespace

TEST_CASE("there are exactly as many samples as asked for and their weights sum to the flux") {
    const EnvironmentMap map = small_sky();
    RankedTile tile = paper_tile();
    for (const std::uint64_t count : {1u, 2u, 17u, 1000u, 20'000u}) {
        for (const PlacerKind placer : {PlacerKind::exact, PlacerKind::figure8}) {
            const LightSamples lights = light_samples(map, tile, {.count = count, .placer = placer});
            CHECK(lights.samples.size() == count);
            check_flux(map, lights);
        }
    }
}

TEST_CASE("position, radiance, compensation and seed leave the sum of the weights alone") {
    const EnvironmentMap map = small_sky();
    RankedTile tile = paper_tile();
    using enum SamplePosition;
    for (const SamplePosition position : {settled, dot, random}) {
        LightRequest request{.count = 300, .position = position, .seed = 5};
        check_flux(map, light_samples(map, tile, request));
        request.importance = LightImportance::compensated;
        check_flux(map, light_samples(map, tile, request));
        request.radiance = SampleRadiance::point;
        if (position == random)
            check_flux(map, light_samples(map, tile, request));
        else
            CHECK_THROWS_WITH(light_samples(map, tile, request),
                              doctest::Contains("needs a random position"));
    }
}

TEST_CASE("a sample's weight is its mean radiance over n times its pdf, and the regions fill the sphere") {
    const EnvironmentMap map = small_sky();
    RankedTile tile = paper_tile();
    const LightSamples lights = light_samples(map, tile, {.count = 500});
    double sphere = 0;
    for (const LightSample& sample : lights.samples) {
        CHECK(glm::distance(sample.radiance / (500 * sample.pdf), sample.weight) < 1e-9);
        sphere += 1 / (500 * sample.pdf);
    }
    CHECK(sphere == doctest::Approx(4 * kPi).epsilon(1e-9));
}

TEST_CASE("the pdf of an even map is 1 / (4 pi) on average and near it everywhere") {
    RankedTile tile = paper_tile();
    const LightSamples lights = light_samples(even_map(128, glm::vec3(1)), tile, {.count = 500});
    for (const LightSample& sample : lights.samples) {
        CHECK(sample.pdf * 4 * kPi > 0.3);
        CHECK(sample.pdf * 4 * kPi < 3);
    }
}

TEST_CASE("point radiance over n times its pdf has the map's light as its mean, whatever is lit by it") {
    // Coloured light with a sun, and what it lights: the upper half, and a cosine about x.
    Grid<glm::vec3> grid(64, 32);
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x)
            grid.at(x, y) = glm::vec3(0.2f + 0.01f * float(x), 0.5f, 0.1f + 0.02f * float(y));
    grid.at(20, 9) = glm::vec3(900, 500, 100);
    const EnvironmentMap map(grid);
    const auto lit = [](glm::dvec2 uv) {
        const glm::dvec3 d = direction_of(uv, SphereConvention::openexr);
        return glm::dvec2(d.y > 0, std::max(d.x, 0.0));
    };
    glm::dvec3 exact[2]{};
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 64; ++x)
            for (int k = 0; k < 2; ++k)
                exact[k] +=
                    lit({(x + 0.5) / 64, (y + 0.5) / 32})[k] * map.solid_angle(y) * glm::dvec3(grid.at(x, y));
    RankedTile tile = paper_tile();
    constexpr int kDraws = 400, kSamples = 16;
    glm::dvec3 mean[2]{};
    for (int draw = 1; draw <= kDraws; ++draw) {
        const LightSamples lights = light_samples(map, tile,
                                                  {.count = kSamples,
                                                   .position = SamplePosition::random,
                                                   .radiance = SampleRadiance::point,
                                                   .seed = std::uint64_t(draw)});
        for (const LightSample& sample : lights.samples) {
            CHECK(glm::distance(sample.radiance, map.at(sample.uv)) == 0);
            for (int k = 0; k < 2; ++k)
                mean[k] += lit(sample.uv)[k] * sample.radiance / (kSamples * sample.pdf) / double(kDraws);
        }
    }
    for (int k = 0; k < 2; ++k)
        for (int c = 0; c < 3; ++c) CHECK(mean[k][c] == doctest::Approx(exact[k][c]).epsilon(0.03));
}

TEST_CASE("each part of a map has as many samples as its pdf says") {
    const EnvironmentMap map = sky_map({.height = 128, .sun_radius = 12, .sun_radiance = 5});
    RankedTile tile = paper_tile();
    constexpr int kCount = 1000, kPart = 32;  // texels a side
    using enum SamplePosition;
    for (const LightImportance importance : {LightImportance::light, LightImportance::compensated}) {
        const Grid<float> pdf = light_pdf(map, importance);
        const bool compensated = importance == LightImportance::compensated;
        for (const SamplePosition position : {settled, dot, random}) {
            const LightSamples lights =
                light_samples(map, tile, {.count = kCount, .importance = importance, .position = position});
            Grid<double> found(map.width() / kPart, map.height() / kPart), expected = found;
            for (const LightSample& sample : lights.samples)
                ++found.at(static_cast<int>(sample.uv.x * found.width),
                           static_cast<int>(sample.uv.y * found.height));
            for (int y = 0; y < map.height(); ++y)
                for (int x = 0; x < map.width(); ++x)
                    expected.at(x / kPart, y / kPart) += kCount * pdf.at(x, y) * map.solid_angle(y);
            double apart = 0;
            for (std::size_t i = 0; i < found.values.size(); ++i)
                apart += std::abs(found.values[i] - expected.values[i]) / kCount;
            CAPTURE(name_of(position));
            // Settled ones move from where there is nothing to sample.
            CHECK(apart < (compensated && position == settled ? 0.15 : 0.06));
        }
    }
}

TEST_CASE(
    "compensated samples and those of a surface, weighed by the map's pdf, have all light as their mean") {
    const EnvironmentMap map = small_sky();
    const Grid<float> pdf = light_pdf(map, LightImportance::compensated);
    RankedTile tile = paper_tile();
    constexpr int kDraws = 200, kSamples = 32;
    // What is lit: the cosine about an axis, whose samples are drawn by that cosine, as many of them.
    const glm::dvec3 normal = glm::normalize(glm::dvec3(1, 0.5, 0.2));
    const auto cosine = [&](glm::dvec3 direction) { return std::max(glm::dot(direction, normal), 0.0); };
    const auto share_of_lights = [&](int x, int y, glm::dvec3 direction) {
        return pdf.at(x, y) / (pdf.at(x, y) + cosine(direction) / kPi);
    };
    glm::dvec3 exact{}, by_surface{};
    for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
            const glm::dvec3 direction =
                direction_of({(x + 0.5) / map.width(), (y + 0.5) / map.height()}, SphereConvention::openexr);
            if (cosine(direction) == 0) continue;
            const glm::dvec3 part =
                cosine(direction) * map.solid_angle(y) * glm::dvec3(map.radiance().at(x, y));
            exact += part;
            by_surface += (1 - share_of_lights(x, y, direction)) * part;
        }
    }
    glm::dvec3 mean{};
    double squares = 0;
    for (int draw = 1; draw <= kDraws; ++draw) {
        glm::dvec3 sum = by_surface;
        const LightSamples lights = light_samples(map, tile,
                                                  {.count = kSamples,
                                                   .importance = LightImportance::compensated,
                                                   .position = SamplePosition::random,
                                                   .radiance = SampleRadiance::point,
                                                   .seed = std::uint64_t(draw)});
        for (const LightSample& sample : lights.samples) {
            const glm::ivec2 texel(sample.uv * glm::dvec2(map.width(), map.height()));
            const glm::dvec3 direction = direction_of(sample.uv, SphereConvention::openexr);
            CHECK(pdf.at(texel.x, texel.y) > 0);
            if (cosine(direction) > 0)
                sum += share_of_lights(texel.x, texel.y, direction) * cosine(direction) * sample.radiance /
                       (kSamples * sample.pdf);
        }
        mean += sum / double(kDraws);
        squares += luminance(sum) * luminance(sum) / kDraws;
    }
    const double deviation = std::sqrt(squares - luminance(mean) * luminance(mean));
    CHECK(luminance(mean) ==
          doctest::Approx(luminance(exact)).epsilon(4.5 * deviation / std::sqrt(kDraws) / luminance(exact)));
}

TEST_CASE("a sun of one texel gets its share of the dots and all of its light is kept") {
    Grid<glm::vec3> grid(256, 128, glm::vec3(0.5f));
    grid.at(40, 50) = glm::vec3(1e5f);
    const EnvironmentMap map(grid);
    RankedTile tile = paper_tile();
    const double sun = 1e5 * map.solid_angle(50);
    const double share = sun / map.total_flux().x;
    for (const std::uint64_t count : {64u, 1000u, 30'000u}) {
        const LightSamples lights =
            light_samples(map, tile, {.count = count, .position = SamplePosition::dot});
        double in_sun = 0, light = 0;
        for (const LightSample& sample : lights.samples) {
            // The density is bilinear, so the sun's dots lie up to a texel beside it.
            const bool near =
                std::abs(sample.uv.x * 256 - 40.5) < 1.01 && std::abs(sample.uv.y * 128 - 50.5) < 1.01;
            in_sun += near;
            if (near) light += sample.weight.x;
        }
        CHECK(in_sun / static_cast<double>(count) == doctest::Approx(share).epsilon(0.05));
        // Few samples: some that stand for the sun have a piece of the sky too, and lie between.
        CHECK(light == doctest::Approx(sun).epsilon(count < 100 ? 0.1 : 0.01));
    }
}

TEST_CASE("a sun of two by two texels is where it is, and takes a settled sample for each of them at most") {
    Grid<glm::vec3> grid(512, 256, glm::vec3(0.3f));
    for (const int y : {75, 76})
        for (const int x : {150, 151}) grid.at(x, y) = glm::vec3(3e4f);
    const EnvironmentMap map(grid);
    RankedTile tile = paper_tile();
    const glm::dvec3 sun = direction_of({151.0 / 512, 76.0 / 256}, SphereConvention::openexr);
    const double flux = 2 * 3e4 * (map.solid_angle(75) + map.solid_angle(76));
    for (const std::uint64_t count : {1u, 2u, 4u, 8u, 16u, 64u, 1000u}) {
        CAPTURE(count);
        const LightSamples lights = light_samples(map, tile, {.count = count});
        check_flux(map, lights);
        double from_sun = 0;
        int in_sun = 0, beside = 0;
        for (const LightSample& sample : lights.samples) {
            CHECK(sample.weight.x > 0);
            const double away = glm::distance(direction_of(sample.uv, SphereConvention::openexr), sun);
            const bool near = away < kPi / 256;  // a texel
            in_sun += near;
            beside += !near && away < 5 * kPi / 256;
            if (near) from_sun += sample.weight.x;
        }
        CHECK(in_sun >= 1);
        CHECK(in_sun <= 4);
        if (count < 100) CHECK(beside == 0);
        if (count >= 8)
            CHECK(from_sun == doctest::Approx(flux).epsilon(1e-6));
        else
            CHECK(from_sun >= flux);
    }
}

TEST_CASE("a map that is black but for one texel is sampled without end or loss") {
    Grid<glm::vec3> grid(64, 32, glm::vec3(0));
    grid.at(0, 0) = {1e5f, 1, 1e-3f};
    const EnvironmentMap map(grid);
    RankedTile tile = paper_tile();
    for (const std::uint64_t count : {1u, 5000u}) {
        const LightSamples lights = light_samples(map, tile, {.count = count});
        CHECK(lights.samples.size() == count);
        check_flux(map, lights);
        const glm::dvec3 lit = direction_of({0.5 / 64, 0.5 / 32}, SphereConvention::openexr);
        const glm::dvec3 found = irradiance(distant(lights), std::vector{lit}).front();
        CHECK(found.x == doctest::Approx(map.total_flux().x).epsilon(0.01));
    }
}

TEST_CASE("no two samples are at the same place, however dense they are") {
    Grid<glm::vec3> grid(64, 32, glm::vec3(0.01f));
    grid.at(20, 9) = glm::vec3(1e5f);
    RankedTile tile = paper_tile();
    const LightSamples lights = light_samples(EnvironmentMap(grid), tile, {.count = 10'000});
    std::set<std::pair<double, double>> places;
    for (const LightSample& sample : lights.samples) places.insert({sample.uv.x, sample.uv.y});
    CHECK(places.size() == 10'000);
}

TEST_CASE("dots keep their distance where the map's sides meet, and none is missing there") {
    RankedTile tile = paper_tile();
    CHECK(meets_itself(tile.tile()));
    const EnvironmentMap map = even_map(64, glm::vec3(1));
    const auto dots = light_dots(map, tile, {.count = 2000});
    const auto across = [](glm::dvec2 a, glm::dvec2 b) { return std::abs(a.x - b.x) > 0.5; };
    const auto within = [](glm::dvec2 a, glm::dvec2 b) { return std::abs(a.x - b.x) <= 0.5; };
    CHECK(least_distance(dots, across) >= 0.999 * least_distance(dots, within));

    // As many dots in a strip about the seam as in strips elsewhere.
    const auto in_strip = [&](double middle) {
        double count = 0;
        for (const glm::dvec2 p : dots) {
            const double away = std::abs(p.x - middle);
            if (std::min(away, 1 - away) < 1.0 / 16) ++count;
        }
        return count;
    };
    for (int i = 0; i < 8; ++i) CHECK(in_strip(0) == doctest::Approx(in_strip(i / 8.0)).epsilon(0.06));
}

TEST_CASE("a map turned halfway round is lit as well as before: the seam is a place like any other") {
    const EnvironmentMap map = small_sky();
    Grid<glm::vec3> turned(map.width(), map.height());
    for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x)
            turned.at(x, y) = map.radiance().at((x + map.width() / 2 - 41) % map.width(), y);
    }
    RankedTile tile = paper_tile();
    const double before = irradiance_error(map, light_samples(map, tile, {.count = 512}));
    const EnvironmentMap other(turned);
    const double after = irradiance_error(other, light_samples(other, tile, {.count = 512}));
    CHECK(after < 2 * before);
    CHECK(before < 2 * after);
}

TEST_CASE("a sun at the pole is found from every side") {
    Grid<glm::vec3> grid(128, 64, glm::vec3(1));
    for (int x = 0; x < 128; ++x) grid.at(x, 0) = glm::vec3(1e4f);
    const EnvironmentMap map(grid);
    RankedTile tile = paper_tile();
    const LightSamples lights = light_samples(map, tile, {.count = 256});
    check_flux(map, lights);
    glm::dvec3 mean{};
    for (const LightSample& sample : lights.samples)
        mean += sample.weight.x * direction_of(sample.uv, SphereConvention::openexr);
    mean = glm::normalize(mean);
    CHECK(mean.y > 0.9999);
    CHECK(irradiance_error(map, lights) < 0.01);
}

TEST_CASE("samples of a row at the pole lie in it, and where bilinear light ends if they are placed by it") {
    Grid<glm::vec3> grid(20, 10);
    for (int x = 0; x < 20; ++x) grid.at(x, 0) = glm::vec3(1);
    const EnvironmentMap map(grid);
    RankedTile tile = paper_tile();
    const auto lowest = [&](SamplePosition position, std::uint64_t count) {
        const LightSamples lights = light_samples(map, tile, {.count = count, .position = position});
        check_flux(map, lights);
        double v = 0;
        for (const LightSample& sample : lights.samples) v = std::max(v, sample.uv.y);
        return v;
    };
    for (const std::uint64_t count : {1u, 5u, 20u}) CHECK(lowest(SamplePosition::settled, count) < 0.1);
    for (const std::uint64_t count : {1u, 100u, 1000u}) {
        CHECK(lowest(SamplePosition::random, count) == doctest::Approx(0.05));
        CHECK(lowest(SamplePosition::dot, count) < 0.15);
        CHECK(lowest(SamplePosition::settled, count) < 0.15);
    }
    CHECK(lowest(SamplePosition::dot, 1000) > 0.1);
}

TEST_CASE("an even map lights every surface with pi L through its samples too") {
    RankedTile tile = paper_tile();
    const LightSamples lights = light_samples(even_map(128, {1, 2, 3}), tile, {.count = 1024});
    for (const glm::dvec3& e : irradiance(distant(lights), fibonacci_normals(100)))
        CHECK(e.z == doctest::Approx(3 * kPi).epsilon(0.005));
}

TEST_CASE("1,024 samples light surfaces within half a per cent, at random places within one") {
    const EnvironmentMap map = small_sky();
    RankedTile tile = paper_tile();
    const auto error = [&](SamplePosition position) {
        return irradiance_error(map, light_samples(map, tile, {.count = 1024, .position = position}));
    };
    CHECK(error(SamplePosition::settled) < 0.005);
    CHECK(error(SamplePosition::dot) < 0.005);
    CHECK(error(SamplePosition::random) < 0.01);
    CHECK(error(SamplePosition::settled) < error(SamplePosition::dot));
}

TEST_CASE("random positions have the exact irradiance as their mean over seeds") {
    const EnvironmentMap map = small_sky();
    RankedTile tile = paper_tile();
    const auto normals = fibonacci_normals(20);
    const auto exact = irradiance(texel_lights(map), normals);
    constexpr int kSeeds = 60;
    std::vector<double> sum(normals.size()), squares(normals.size());
    for (int seed = 1; seed <= kSeeds; ++seed) {
        LightRequest request{.count = 24, .position = SamplePosition::random};
        request.seed = static_cast<std::uint64_t>(seed);
        const auto found = irradiance(distant(light_samples(map, tile, request)), normals);
        for (std::size_t i = 0; i < normals.size(); ++i) {
            const double error = luminance(found[i]) / luminance(exact[i]) - 1;
            sum[i] += error;
            squares[i] += error * error;
        }
    }
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const double mean = sum[i] / kSeeds;
        const double deviation = std::sqrt((squares[i] / kSeeds - mean * mean) / (kSeeds - 1));
        CHECK(std::abs(mean) < 4.5 * deviation);
    }
}

TEST_CASE("the weights within a fixed piece of the map have its flux as their mean over seeds") {
    const EnvironmentMap map = small_sky();
    RankedTile tile = paper_tile();
    const auto inside = [](glm::dvec2 uv) {
        return uv.x > 0.21 && uv.x < 0.43 && uv.y > 0.12 && uv.y < 0.49;
    };
    double exact = 0;
    for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
            if (inside({(x + 0.5) / map.width(), (y + 0.5) / map.height()}))
                exact += luminance(map.radiance().at(x, y)) * map.solid_angle(y);
        }
    }
    constexpr int kSeeds = 100;
    double sum = 0, squares = 0;
    for (int seed = 1; seed <= kSeeds; ++seed) {
        LightRequest request{.count = 100, .position = SamplePosition::random};
        request.seed = static_cast<std::uint64_t>(seed);
        double found = 0;
        for (const LightSample& sample : light_samples(map, tile, request).samples)
            if (inside(sample.uv)) found += luminance(sample.weight);
        sum += found;
        squares += found * found;
    }
    const double mean = sum / kSeeds;
    const double deviation = std::sqrt((squares / kSeeds - mean * mean) / (kSeeds - 1));
    CHECK(std::abs(mean - exact) < 4.5 * deviation);
    CHECK(deviation < 0.02 * exact);
}

TEST_CASE("the same request gives the same samples, another seed others") {
    const EnvironmentMap map = small_sky();
    RankedTile tile = paper_tile();
    LightRequest request{.count = 1200, .seed = 3};
    const LightSamples once = light_samples(map, tile, request);
    request.threads = 2;
    const LightSamples again = light_samples(map, tile, request);
    request.seed = 4;
    const LightSamples other = light_samples(map, tile, request);
    int moved = 0;
    for (std::size_t i = 0; i < 1200; ++i) {
        CHECK(once.samples[i].uv == again.samples[i].uv);
        CHECK(once.samples[i].weight == again.samples[i].weight);
        moved += once.samples[i].uv != other.samples[i].uv;
    }
    CHECK(moved > 1000);
}

TEST_CASE("a region's light is that of the texels nearer to its dot than to any other") {
    const EnvironmentMap map = small_sky();
    // Far apart, so that the borders, where a patch is given to one side whole, are short.
    const std::vector<glm::dvec2> dots{{0.1, 0.5},  {0.35, 0.5}, {0.6, 0.5},
                                       {0.85, 0.5}, {0.2, 0.02}, {0.7, 0.98}};
    std::vector<double> nearest(dots.size());
    for (int y = 0; y < map.height(); ++y) {
        for (int x = 0; x < map.width(); ++x) {
            const auto here =
                direction_of({(x + 0.5) / map.width(), (y + 0.5) / map.height()}, SphereConvention::openexr);
            const auto owner = std::ranges::min_element(dots, {}, [&](glm::dvec2 uv) {
                return glm::distance(direction_of(uv, SphereConvention::openexr), here);
            });
            nearest[static_cast<std::size_t>(owner - dots.begin())] += map.solid_angle(y);
        }
    }
    const std::vector<LightRegion> regions = share_light(map, light_density(map).values(), dots);
    for (std::size_t i = 0; i < dots.size(); ++i)
        CHECK(regions[i].solid_angle == doctest::Approx(nearest[i]).epsilon(0.02));
}

TEST_CASE("blocks of a map's texels light a surface as the texels do, however their light lies in them") {
    const EnvironmentMap sky = small_sky();
    Grid<glm::vec3> radiance = sky.radiance();
    radiance.at(5, radiance.height / 3) = glm::vec3(3000, 2000, 1000);  // at a block's side
    const EnvironmentMap map(radiance);
    const std::vector<glm::dvec3> normals = fibonacci_normals(50);
    const auto exact = irradiance(texel_lights(map), normals);
    for (const int side : {2, 3}) {
        const std::vector<DistantLight> blocks = block_lights(map, side);
        const int columns = (map.width() + side - 1) / side, rows = (map.height() + side - 1) / side;
        CHECK(blocks.size() == static_cast<std::size_t>(columns) * rows);
        glm::dvec3 flux{};
        for (const DistantLight& light : blocks) flux += light.weight;
        CHECK(glm::distance(flux, map.total_flux()) < 1e-9 * glm::length(flux));
        // Within a block directions differ by half its diagonal, h; from the centre of gravity that is felt
        // as its square.
        const double h = side * kPi / map.height() / std::sqrt(2.0);
        const auto found = irradiance(blocks, normals);
        for (std::size_t i = 0; i < normals.size(); ++i)
            CHECK(std::abs(luminance(found[i]) - luminance(exact[i])) < h * h * luminance(flux));
    }
}

TEST_CASE("samples tell how far they are, up to the end, and can be given up at any moment") {
    const EnvironmentMap map = small_sky();
    RankedTile tile = paper_tile();
    for (const PlacerKind placer : {PlacerKind::exact, PlacerKind::figure8}) {
        std::vector<double> shares;
        const LightRequest request{.count = 300, .placer = placer};
        const LightSamples lights = light_samples(
            map, tile, request, {.stop = {}, .progress = [&](double share) { shares.push_back(share); }});
        CHECK(lights.samples.size() == 300);
        REQUIRE(shares.size() > 20);
        CHECK(std::ranges::is_sorted(shares));
        CHECK(shares.front() > 0);
        CHECK(shares.back() > 0.95);
        CHECK(shares.back() <= 1);
        for (std::size_t step = 0; step < shares.size(); step += 7) {
            std::stop_source giving_up;
            std::size_t told = 0;
            const auto stop_here = [&](double) {
                if (told++ == step) giving_up.request_stop();
            };
            CHECK(light_samples(map, tile, request, {giving_up.get_token(), stop_here}).samples.empty());
            CHECK(told == step + 1);  // and at once
        }
        std::stop_source before;
        before.request_stop();
        CHECK(light_dots(map, tile, request, before.get_token()).empty());
    }
}

TEST_CASE("counts that are not possible are refused") {
    const EnvironmentMap map = even_map(4, glm::vec3(1));
    RankedTile tile = paper_tile();
    CHECK_THROWS_WITH(light_samples(map, tile, {.count = 0}), doctest::Contains("ask for 1 to 10000000"));
    CHECK_THROWS_WITH(light_samples(map, tile, {.count = 10'000'001}), doctest::Contains("not possible"));
}

TEST_CASE("the first samples in order of priority stand for all, once the others' light goes to them") {
    const EnvironmentMap map = small_sky();
    RankedTile tile = paper_tile();
    const LightSamples all = light_samples(map, tile, {.count = 1000});
    const LightSamples placed = light_samples(map, tile, {.count = 1000, .order = LightOrder::placed});
    const auto places_of = [](const LightSamples& lights) {
        std::set<std::pair<double, double>> places;
        for (const LightSample& sample : lights.samples) places.insert({sample.uv.x, sample.uv.y});
        return places;
    };
    CHECK(places_of(all) == places_of(placed));
    const auto direction = [](const LightSample& sample) {
        return direction_of(sample.uv, SphereConvention::openexr);
    };
    // Each of the first so many has the light of those that it is nearest to, from the middle of it.
    const auto error_of_first = [&](const LightSamples& lights, std::size_t count) {
        LightSamples few;
        few.samples.assign(lights.samples.begin(), lights.samples.begin() + std::ptrdiff_t(count));
        std::vector<glm::dvec3> middles(count);
        for (std::size_t i = 0; i < lights.samples.size(); ++i) {
            const glm::dvec3 here = direction(lights.samples[i]);
            std::size_t nearest = 0;
            double most = -2;
            for (std::size_t k = 0; k < count; ++k) {
                const double cosine = glm::dot(direction(lights.samples[k]), here);
                if (cosine > most) most = cosine, nearest = k;
            }
            if (i >= count) few.samples[nearest].weight += lights.samples[i].weight;
            middles[nearest] += luminance(lights.samples[i].weight) * here;
        }
        for (std::size_t k = 0; k < count; ++k)
            few.samples[k].uv = uv_of(middles[k], SphereConvention::openexr);
        check_flux(map, few);
        return irradiance_error(map, few);
    };
    for (const std::size_t count : {10u, 30u, 100u, 300u}) {
        CAPTURE(count);
        const double own = irradiance_error(map, light_samples(map, tile, {.count = count}));
        CHECK(error_of_first(all, count) < 4 * own);
        CHECK(error_of_first(all, count) < 0.5 * error_of_first(placed, count));
    }
}
