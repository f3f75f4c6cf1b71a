#include "core/analysis/periodogram.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "core/analysis/fourier_sums.h"

namespace dapple {

Periodogram periodogram(std::span<const glm::dvec2> points, const Domain& domain,
                        const PeriodogramOptions& options, std::stop_token stop) {
    Periodogram result{.domain = domain,
                       .points = points.size(),
                       .highest_frequency = options.highest_frequency,
                       .power = {0}};
    if (points.empty()) return result;

    const double n = double(points.size());
    const double highest = options.highest_frequency * std::sqrt(n / domain.area());
    const double columns = std::floor(highest * domain.width * (1 + 1e-12));
    const double rows = std::floor(highest * domain.height * (1 + 1e-12));
    if (!((columns + 1) * (2 * rows + 1) < 0x1p28))
        throw std::runtime_error(fmt::format(
            "a spectrum of {} points up to {} times the square root of their number is too large; "
            "ask for a lower frequency",
            points.size(), options.highest_frequency));
    result.max_x = int(columns);
    result.max_y = int(rows);

    const double terms = n * (columns + 1) * (2 * rows + 1);
    const bool exact =
        options.route == FourierRoute::exact || (options.route == FourierRoute::automatic && terms < 1e7);
    const auto sums = exact ? exact_fourier_sums : fast_fourier_sums;
    const FourierSums f = sums(points, {domain.width, domain.height}, result.max_x, result.max_y, stop);
    result.power.resize(f.sum.size());
    for (std::size_t k = 0; k < f.sum.size(); ++k) result.power[k] = float(double(std::norm(f.sum[k])) / n);
    return result;
}

}  // namespace dapple
