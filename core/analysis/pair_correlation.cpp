#include "core/analysis/pair_correlation.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/analysis/point_grid.h"

namespace dapple {

PairCorrelation pair_correlation(std::span<const glm::dvec2> points, const Domain& domain,
                                 const PairCorrelationOptions& options, std::stop_token stop) {
    const std::size_t bins = std::size_t(std::ceil(options.highest_distance / options.bin_width - 1e-9));
    PairCorrelation result{options.bin_width, std::vector<double>(bins)};
    if (points.size() < 2) return result;

    const double n = double(points.size());
    const double width = options.bin_width * std::sqrt(domain.area() / n);  // of a bin, in the domain's unit
    const PointGrid grid(points, domain);
    const std::span<const PointGrid::Entry> entries = grid.entries();

    // A fixed cut into parts, added up in order, so that the sums don't depend on the threads.
    constexpr std::size_t kPart = 8192;
    std::vector<std::vector<double>> parts((entries.size() + kPart - 1) / kPart);
    tbb::parallel_for(std::size_t(0), parts.size(), [&](std::size_t part) {
        std::vector<double>& sum = parts[part];
        sum.resize(bins);
        const std::size_t end = std::min(entries.size(), (part + 1) * kPart);
        for (std::size_t i = part * kPart; i < end && !stop.stop_requested(); ++i)
            grid.for_each_within(
                entries[i].position, double(bins) * width, [&](std::uint32_t index, glm::dvec2 offset) {
                    if (index == entries[i].index) return;
                    const std::size_t bin =
                        std::size_t(std::sqrt(offset.x * offset.x + offset.y * offset.y) / width);
                    if (bin >= bins) return;
                    sum[bin] += domain.topology == Topology::torus
                                    ? 1
                                    : domain.area() / ((domain.width - std::abs(offset.x)) *
                                                       (domain.height - std::abs(offset.y)));
                });
    });
    for (std::size_t bin = 0; bin < bins; ++bin) {
        double sum = 0;
        for (const std::vector<double>& part : parts) sum += part[bin];
        const double ring = std::numbers::pi * width * width * (2 * double(bin) + 1);
        result.g[bin] = sum * domain.area() / (n * (n - 1) * ring);
    }
    return result;
}

}  // namespace dapple
