// How even dots in space are, and points of a cloud that was made thinner, beside what else could be done.
// Prints tables in Markdown.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "lab/volume/resample_cloud.h"
#include "lab/volume/settle_volume.h"
#include "lab/volume/space_cells.h"
#include "lab/volume/volume.h"
#include "tests/bench/volume_marks.h"

namespace {

using namespace dapple;
using Clock = std::chrono::steady_clock;

double since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

void cube_row(const char* name, std::vector<glm::dvec3> dots, double side, double seconds) {
    const VolumeDistances distances = volume_distances(dots, side * side * side);
    for (glm::dvec3& dot : dots) dot /= side;
    const VolumeSpectrum spectrum = volume_spectrum(dots);
    fmt::print("| {} | {:.0f} | {:.4f} | {:.3f} | {:.3f} | {:.2f} |\n", name, spectrum.highest,
               spectrum.power_below_half, distances.mean, distances.least, seconds);
}

// Over the distance of the hexagonal lattice of as many points on the sphere.
void sphere_row(const char* name, const std::vector<glm::dvec3>& points, double seconds) {
    const double lattice =
        std::sqrt(8 * 3.14159265358979 / std::sqrt(3.0) / static_cast<double>(points.size()));
    const SpaceCells cells(points, box_around(points), lattice);
    double sum = 0, least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t other = cells.nearest(points[i], [&](std::size_t j) { return j != i; });
        const double far = glm::distance(points[i], points[other]) / lattice;
        sum += far;
        least = std::min(least, far);
    }
    const auto upper = std::ranges::count_if(points, [](const glm::dvec3& point) { return point.z > 0; });
    fmt::print("| {} | {} | {:.3f} | {:.3f} | {:.1f} % | {:.2f} |\n", name, points.size(),
               sum / static_cast<double>(points.size()), least,
               100.0 * static_cast<double>(upper) / static_cast<double>(points.size()), seconds);
}

}  // namespace

int main() {
    constexpr int kSide = 32;
    constexpr std::size_t kDots = 8192;
    const Volume cube{.size = glm::ivec3(kSide), .density = std::vector<float>(kSide * kSide * kSide, 1)};
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(0, kSide);
    std::vector<glm::dvec3> noise(kDots);
    for (glm::dvec3& dot : noise) dot = {place(random), place(random), place(random)};
    fmt::print("| dots | highest peak | power below half | mean distance | smallest | seconds |\n");
    fmt::print("|---|---|---|---|---|---|\n");
    cube_row("white noise", noise, kSide, 0);
    auto begin = Clock::now();
    settle(noise, cube, 20);
    cube_row("white noise, settled", noise, kSide, since(begin));
    begin = Clock::now();
    std::vector<glm::dvec3> dots = place_in_volume(volume_tile(), cube, kDots);
    cube_row("placed by the tile", dots, kSide, since(begin));
    begin = Clock::now();
    settle(dots, cube, 20);
    cube_row("placed and settled", dots, kSide, since(begin));
    begin = Clock::now();
    const std::size_t million = place_in_volume(volume_tile(), cube, 1'000'000).size();
    fmt::print("\n{} dots are placed in {:.2f} s.\n\n", million, since(begin));

    std::normal_distribution<double> normal;
    std::vector<glm::dvec3> cloud;
    while (cloud.size() < 200'000) {
        const glm::dvec3 point = glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
        if (point.z > 0 || random() % 10 == 0) cloud.push_back(point);
    }
    fmt::print(
        "| points | number | mean distance | smallest | upper half | seconds |\n|---|---|---|---|---|---|\n");
    for (const std::size_t count : {500u, 5000u}) {
        sphere_row("the cloud's first", {cloud.begin(), cloud.begin() + static_cast<std::ptrdiff_t>(count)},
                   0);
        begin = Clock::now();
        std::vector<double> far(cloud.size(), 9);
        std::vector<glm::dvec3> farthest;
        for (std::size_t next = 0; farthest.size() < count;) {
            farthest.push_back(cloud[next]);
            for (std::size_t i = 0; i < cloud.size(); ++i) {
                far[i] = std::min(far[i], glm::distance(cloud[i], farthest.back()));
                if (far[i] > far[next]) next = i;
            }
        }
        sphere_row("farthest points, plainly", farthest, since(begin));
        begin = Clock::now();
        std::vector<glm::dvec3> even;
        for (const std::size_t i : even_subset(cloud, count)) even.push_back(cloud[i]);
        sphere_row("dapple-lab volume", even, since(begin));
    }
}
