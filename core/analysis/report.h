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
#include "core/analysis/distances.h"
#include "core/analysis/domain.h"
#include "core/analysis/periodogram.h"
#include "core/export.h"

namespace dapple {

// Discrepancy: how far the share of points in a box [0, x) x [0, y) is from its area, over all boxes that
// start in the domain's lower corner. Domains are scaled to the unit square, and edges don't meet.

/// L2 star discrepancy, the root of the mean square over all boxes, by Warnock's formula (1972)
///      1/9 - 2/n sum (1 - x^2)(1 - y^2) / 4 + 1/n^2 sum sum (1 - max(x, x'))(1 - max(y, y')),
/// the double sum in O(n log n) by a sweep over x (the two-dimensional case of Heinrich 1996). Accurate to
/// about 1e-8. White noise of n points has sqrt(5 / (36 n)) in the mean square. 0 for no points.
double l2_star_discrepancy(std::span<const glm::dvec2> points, const Domain& domain);

/// The star discrepancy, the greatest deviation over all boxes, lies within [lower, upper].
struct StarDiscrepancy {
    double lower = 0;
    double upper = 0;
};

/// Exact (lower = upper) for up to `exact_up_to` points: a sweep over x that keeps the counts of all y in
/// blocks with their convex hulls, O(n sqrt(n)), about 0.1 s for 65,536 points. For more points a bracket
/// from a grid of 1024 x 1024 boxes (Thiémard 2001): what a box between two corners of the grid can hold is
/// between what those hold; it is at most about 2/1024 wide. {0, 0} for no points. Unfinished when a stop was
/// requested.
StarDiscrepancy star_discrepancy(std::span<const glm::dvec2> points, const Domain& domain,
                                 std::size_t exact_up_to = 131072, std::stop_token stop = {});

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
