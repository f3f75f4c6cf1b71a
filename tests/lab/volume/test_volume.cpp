// Dots in space: placed to the number, settled by the formula, measured; and clouds made thinner.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <random>
#include <set>
#include <vector>

#include "lab/volume/resample_cloud.h"
#include "lab/volume/settle_volume.h"
#include "lab/volume/turning_view.h"
#include "lab/volume/volume.h"
#include "tests/bench/volume_marks.h"

namespace dapple {
namespace {

Volume even_volume(int side) {
    return {.size = glm::ivec3(side),
            .density = std::vector<float>(static_cast<std::size_t>(side) * side * side, 1.0f)};
}

std::vector<glm::dvec3> white_noise(std::size_t count, double side, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(0, side);
    std::vector<glm::dvec3> dots(count);
    for (glm::dvec3& dot : dots) dot = {place(random), place(random), place(random)};
    return dots;
}

double least_distance(const std::vector<glm::dvec3>& points) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) least = std::min(least, glm::distance(points[i], points[j]));
    return least;
}

}  // namespace

TEST_CASE("a volume gets exactly as many dots as asked for, all where it has a density") {
    for (const Volume& volume : {ball_volume(20), gyroid_volume(24)})
        for (const std::size_t count : {1u, 7u, 500u, 4000u}) {
            CAPTURE(count);
            const auto dots = place_in_volume(volume_tile(), volume, count);
            CHECK(dots.size() == count);
            for (const glm::dvec3& dot : dots) CHECK(volume.at(dot) > 0);
            std::set<std::tuple<double, double, double>> places;
            for (const glm::dvec3& dot : dots) places.emplace(dot.x, dot.y, dot.z);
            CHECK(places.size() == count);
        }
}

TEST_CASE("dots are in proportion to the density, and a single voxel gets all of them") {
    Volume halves{.size = {8, 4, 4}, .density = std::vector<float>(128)};
    for (std::size_t i = 0; i < 128; ++i) halves.density[i] = i % 8 < 4 ? 3.0f : 1.0f;
    const auto dots = place_in_volume(volume_tile(), halves, 4000);
    const auto dense = std::ranges::count_if(dots, [](const glm::dvec3& dot) { return dot.x < 4; });
    CHECK(static_cast<double>(dense) == doctest::Approx(3000).epsilon(0.02));

    Volume one{.size = {9, 5, 7}, .density = std::vector<float>(9 * 5 * 7)};
    one.density[(3 * 5 + 2) * 9 + 8] = 0.001f;
    for (const glm::dvec3& dot : place_in_volume(volume_tile(), one, 300)) {
        CHECK(glm::floor(dot) == glm::dvec3(8, 2, 3));
    }
}

TEST_CASE("a step moves dots as the formula of the energy says") {
    const int side = 10;
    const Volume volume = even_volume(side);
    const auto before = white_noise(1000, side, 3);
    auto after = before;
    settle(after, volume, 1);
    const double sigma = 0.45, squared = 2 * sigma * sigma;  // one dot a voxel
    int looked_at = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        // Far enough from the faces, where the density is even, it pulls nowhere.
        const auto inside = [](double at) { return at > 4 && at < 6; };
        if (!inside(before[i].x) || !inside(before[i].y) || !inside(before[i].z)) continue;
        ++looked_at;
        glm::dvec3 force(0);
        for (const glm::dvec3& other : before) {
            const glm::dvec3 apart = before[i] - other;
            if (glm::dot(apart, apart) < 14 * squared)
                force += apart * std::pow(squared, -2.5) * std::exp(-glm::dot(apart, apart) / (2 * squared));
        }
        glm::dvec3 way = 2 * std::pow(sigma, 5) * force;
        if (glm::length(way) > 0.35) way *= 0.35 / glm::length(way);
        CHECK(glm::distance(after[i], before[i] + way) < 1e-4);
    }
    CHECK(looked_at > 3);
}

TEST_CASE("settled dots are even at all scales, and stay in the volume") {
    const Volume volume = even_volume(16);
    auto dots = white_noise(2000, 16, 1);
    const auto spectrum = [](std::vector<glm::dvec3> places) {
        for (glm::dvec3& place : places) place /= 16.0;
        return volume_spectrum(places, 0.6);
    };
    CHECK(spectrum(dots).power_below_half == doctest::Approx(1).epsilon(0.2));
    CHECK(volume_distances(dots, 4096).mean < 0.55);
    settle(dots, volume, 25);
    CHECK(spectrum(dots).power_below_half < 0.01);
    CHECK(volume_distances(dots, 4096).mean > 0.7);
    const Volume ball = ball_volume(16);
    auto inside = place_in_volume(volume_tile(), ball, 800);
    settle(inside, ball, 15);
    for (const glm::dvec3& dot : inside) CHECK(ball.at(dot) > 0);
}

TEST_CASE("the spectrum of a few dots is its formula's, and a tile that repeats has peaks") {
    const auto dots = white_noise(150, 1, 9);
    const VolumeSpectrum spectrum = volume_spectrum(dots, 1);
    double sum = 0, highest = 0, squares = 0;
    std::vector<double> windows;
    for (const glm::dvec3& dot : dots) {
        double window = 1;
        for (int axis = 0; axis < 3; ++axis) window *= std::pow(std::sin(std::numbers::pi * dot[axis]), 2);
        windows.push_back(window);
        squares += window * window;
    }
    const double root = std::cbrt(150.0);
    int count = 0;
    for (int x = -5; x <= 5; ++x)
        for (int y = -5; y <= 5; ++y)
            for (int z = -5; z <= 5; ++z) {
                const double frequency = std::sqrt(x * x + y * y + z * z);
                if (frequency < 3 || frequency > root || x < 0) continue;  // of k and -k one, as it is there
                std::complex<double> wave;
                for (std::size_t i = 0; i < dots.size(); ++i)
                    wave += windows[i] * std::polar(1.0, -2 * std::numbers::pi *
                                                             (x * dots[i].x + y * dots[i].y + z * dots[i].z));
                highest = std::max(highest, std::norm(wave) / squares);
                sum += std::norm(wave) / squares;
                ++count;
            }
    CHECK(spectrum.highest == doctest::Approx(highest).epsilon(1e-6));
    CHECK(sum / count == doctest::Approx(1).epsilon(0.25));
    auto tiled = place_in_volume(volume_tile(), even_volume(8), 1024);
    for (glm::dvec3& dot : tiled) dot /= 8.0;
    CHECK(volume_spectrum(tiled, 1.2).highest > 20);
    CHECK(volume_spectrum(white_noise(1024, 1, 2), 1.2).highest < 15);
}

TEST_CASE("a cloud's subset has as many of its points as asked for, further apart than farthest points are") {
    // A sphere, nine tenths of which were scanned in its upper half.
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    std::vector<glm::dvec3> cloud;
    while (cloud.size() < 4000) {
        const glm::dvec3 point = glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
        if (point.z > 0 || random() % 9 == 0) cloud.push_back(point);
    }
    const auto subset = even_subset(cloud, 150);
    REQUIRE(subset.size() == 150);
    CHECK(std::ranges::is_sorted(subset));
    CHECK(std::set(subset.begin(), subset.end()).size() == 150);
    std::vector<glm::dvec3> points;
    for (const std::size_t i : subset) points.push_back(cloud[i]);
    const auto upper = std::ranges::count_if(points, [](const glm::dvec3& point) { return point.z > 0; });
    CHECK(std::abs(upper - 75) <= 15);

    std::vector<glm::dvec3> farthest{cloud[0]};
    while (farthest.size() < 150) {
        const auto far = [&](const glm::dvec3& place) {
            double least = std::numeric_limits<double>::infinity();
            for (const glm::dvec3& other : farthest) least = std::min(least, glm::distance(place, other));
            return least;
        };
        farthest.push_back(*std::ranges::max_element(cloud, {}, far));
    }
    CHECK(least_distance(points) > 1.05 * least_distance(farthest));
    CHECK(even_subset(cloud, cloud.size()).size() == cloud.size());
    CHECK(even_subset(cloud, 1).size() == 1);
}

TEST_CASE("what cannot be placed or thinned is refused in a sentence") {
    CHECK_THROWS_WITH(place_in_volume(volume_tile(), {.size = {2, 1, 1}, .density = {0, 0}}, 5),
                      "all voxels are 0, so there is nowhere to place a dot");
    CHECK_THROWS_WITH(place_in_volume(volume_tile(), {.size = {2, 1, 1}, .density = {1, -1}}, 5),
                      "a density of -1; it has to be a number, 0 or more");
    const std::vector<glm::dvec3> same(5, glm::dvec3(1, 2, 3));
    CHECK_THROWS_WITH(even_subset(same, 6), "6 points of a cloud that has 5; give that many or fewer");
    CHECK_THROWS_WITH(even_subset(same, 2),
                      "2 points of a cloud that has 1 distinct ones; give that many or fewer");
    CHECK(even_subset(same, 1).size() == 1);
}

TEST_CASE("from each side all dots are in the picture, and the nearest is darkest") {
    const std::vector<glm::dvec3> dots{{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, 10}, {10, 10, 10}};
    for (const double turn : {0.0, 0.13, 0.5}) {
        const Grid<glm::u8vec3> picture = turned_view(dots, turn, 100);
        std::set<int> greys;
        for (int y = 0; y < 100; ++y)
            for (int x = 0; x < 100; ++x) {
                greys.insert(picture.at(x, y).r);
                const bool edge = x == 0 || y == 0 || x == 99 || y == 99;
                if (edge) CHECK(picture.at(x, y).r == 255);
            }
        CHECK(*greys.begin() < 140);
        CHECK(greys.size() > 4);
    }
}

TEST_CASE("a ball covers as much of the picture as its disc, and the nearer of two hides the other") {
    constexpr int kSide = 420;
    const Box box{glm::dvec3(-1), glm::dvec3(1)};
    const double pixels = kSide / 2.1 / std::sqrt(3.0);  // half the diagonal, from the middle to the margin
    for (const double radius : {0.04, 0.08, 1.0}) {
        const Ball ball{.place = {0.3, -0.4, 0.2}, .radius = radius};
        const auto picture = turned_view(std::array{ball}, {.box = box, .side = kSide});
        double covered = 0;
        for (int y = 0; y < kSide; ++y) {
            int first = kSide, last = -1;  // it is glossy between them
            for (int x = 0; x < kSide; ++x) {
                if (picture.at(x, y).r > 200) continue;
                first = std::min(first, x);
                last = x;
            }
            covered += std::max(last - first + 1, 0);
        }
        const double r = std::min(radius * pixels, kSide / 30.0);
        CHECK(covered == doctest::Approx(std::numbers::pi * r * r).epsilon(0.05));
    }
    const std::array two{Ball{.place = {0, -0.9, 0}, .radius = 0.03, .ink = {1, 0, 0}},
                         Ball{.place = {0, 0.9, 0}, .radius = 0.03, .ink = {0, 0, 1}}};
    const auto middle = [&](double turn) {
        const auto picture = turned_view(two, {.box = box, .turn = turn, .down = 0, .side = kSide});
        return picture.at(kSide / 2, kSide / 2);
    };
    CHECK(middle(0).r > middle(0).b + 100);
    CHECK(middle(0.5).b > middle(0.5).r + 100);
    CHECK(middle(0.25) == glm::u8vec3(255));  // they are beside each other
    const auto above = turned_view(two, {.box = box, .down = 1, .side = kSide});
    const int down = static_cast<int>(kSide / 2 + 0.9 * std::sin(1.0) * pixels);
    CHECK(above.at(kSide / 2, down).r > above.at(kSide / 2, down).b + 100);  // what is in front is lower
}

}  // namespace dapple
