#pragma once
// All that is known about one point set, in one value: for `dapple-lab analyse`, for the window, for a table.

#include <cstddef>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/analysis/autocorrelation.h"
#include "core/analysis/discrepancy.h"
#include "core/analysis/distances.h"
#include "core/analysis/domain.h"
#include "core/analysis/periodogram.h"
#include "core/export.h"

namespace dapple {

struct ReportOptions {
    std::string name = "points";  // for messages: what the points are, or their file
    PeriodogramOptions spectrum{};
    PairCorrelationOptions pairs{};
    double nyquist_threshold = 0.1;
    std::optional<glm::dvec2> period{};  // of the tile, in the domain's unit; without it no periodicity
    PeriodicityOptions periodicity{};
    std::size_t exact_star_discrepancy_up_to = 131072;  // points; a bracket for more
};

/// Each field is explained where its type or function is declared.
struct PointReport {
    Domain domain{};
    std::size_t count = 0;
    double density = 0;         // count / area
    double largest_radius = 0;  // r_max, in the domain's unit; 0 for no points
    LocalDensity local_density{};

    NearestSummary nearest{};    // over 2 r_max
    double relative_radius = 0;  // half the smallest distance over r_max: nearest.minimum by its other name

    Periodogram spectrum{};
    std::vector<Ring> radial_power{};
    double power_below_03 = 0;  // mean P over 0 < |k| < 0.3 sqrt(n)
    double power_below_05 = 0;  // and below 0.5 sqrt(n)
    Peaks peaks{};              // highest bin, share of the top 0.1 %
    double effective_nyquist = 0;

    PairCorrelation pair_correlation{};
    std::optional<Periodicity> periodicity{};  // if a period was given

    double l2_star_discrepancy = 0;
    StarDiscrepancy star_discrepancy{};
};

/// Analyses a point set. Points beyond a torus are wrapped. 65,536 points take a few tenths of a second.
/// Returns nothing if a stop was requested before all was done. The same to the bit for any number of
/// threads. Throws std::runtime_error as points_inside() and periodogram() do, and if the period is not
/// positive.
DAPPLE_API std::optional<PointReport> analyse(std::span<const glm::dvec2> points, const Domain& domain,
                                              const ReportOptions& options = {}, std::stop_token stop = {});

}  // namespace dapple
