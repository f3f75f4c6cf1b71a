#include "core/analysis/report.h"

#include <cmath>

#include "core/failure.h"

namespace dapple {
namespace {

void check_period(const ReportOptions& options) {
    if (!options.period) return;
    const glm::dvec2 period = *options.period;
    if (!(period.x > 0 && period.y > 0 && std::isfinite(period.x) && std::isfinite(period.y)))
        throw failure("{}: a period of {} x {} cannot repeat; give two positive lengths", options.name,
                      period.x, period.y);
}

}  // namespace

std::optional<PointReport> analyse(std::span<const glm::dvec2> given, const Domain& domain,
                                   const ReportOptions& options, std::stop_token stop) {
    check_period(options);
    const std::vector<glm::dvec2> points = points_inside(given, domain, options.name);

    PointReport report{.domain = domain, .count = points.size()};
    report.density = double(points.size()) / domain.area();
    if (!points.empty()) report.largest_radius = largest_radius(domain, points.size());
    report.local_density = local_density(points, domain);
    report.nearest = nearest_summary(points, domain, stop);
    report.relative_radius = report.nearest.minimum;
    if (stop.stop_requested()) return std::nullopt;

    report.spectrum = periodogram(points, domain, options.spectrum, stop);
    if (stop.stop_requested()) return std::nullopt;
    report.radial_power = radial_power(report.spectrum);
    report.power_below_03 = low_frequency_power(report.spectrum, 0.3);
    report.power_below_05 = low_frequency_power(report.spectrum, 0.5);
    report.peaks = spectral_peaks(report.spectrum);
    report.effective_nyquist = effective_nyquist(report.radial_power, options.nyquist_threshold);
    if (stop.stop_requested()) return std::nullopt;

    report.pair_correlation = pair_correlation(points, domain, options.pairs, stop);
    if (options.period)
        report.periodicity = periodicity(points, domain, *options.period, options.periodicity, stop);
    if (stop.stop_requested()) return std::nullopt;

    report.l2_star_discrepancy = l2_star_discrepancy(points, domain);
    report.star_discrepancy = star_discrepancy(points, domain, options.exact_star_discrepancy_up_to, stop);
    if (stop.stop_requested()) return std::nullopt;
    return report;
}

}  // namespace dapple
