#include "lab/related/covered.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lab/related/growing_grid.h"

namespace dapple {

std::vector<float> coverage_by_load(const PlainDots& dots) {
    constexpr int kPlaces = 10'000;
    GrowingGrid grid({1, 1, Topology::torus});
    for (const glm::dvec2 dot : dots) grid.add(dot);
    // A place is covered from the load on whose discs reach it.
    std::vector<int> newly(kCoveredLoads);
    for (int i = 0; i < kPlaces; ++i) {
        const glm::dvec2 place((i + 0.5) / kPlaces, std::fmod(i * std::numbers::phi, 1.0));
        const double load = std::numbers::pi * grid.nearest2(place, 1e300) * double(dots.size());
        const auto step = std::size_t(std::ceil(load / kCoveredLoadStep));
        if (step < kCoveredLoads) ++newly[step];
    }
    std::vector<float> covered;
    int sum = 0;
    for (const int more : newly) covered.push_back(float(sum += more) / kPlaces);
    return covered;
}

std::vector<float> mean_coverage_by_load(const std::function<PlainDots(const DotsWanted&)>& method,
                                         std::size_t fewest, double factor, const std::stop_token& stop) {
    std::vector<float> mean(kCoveredLoads);
    for (int set = 0; set < kCoverageSets; ++set) {
        const auto count = std::size_t(double(fewest) * std::pow(factor, double(set) / kCoverageSets));
        const PlainDots dots = method({.count = count, .seed = std::uint64_t(set) + 1, .stop = stop});
        if (dots.empty()) return {};
        const std::vector<float> covered = coverage_by_load(dots);
        for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += covered[i] / kCoverageSets;
    }
    return mean;
}

}  // namespace dapple
