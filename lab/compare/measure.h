#pragma once
// One method measured: on a constant grey, on pictures, and how its time grows.

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/analysis/distances.h"
#include "core/analysis/periodogram.h"
#include "core/analysis/report.h"
#include "core/image/ink.h"
#include "lab/compare/cell_marks.h"
#include "lab/compare/contenders.h"
#include "lab/compare/picture_marks.h"

namespace dapple {

/// Dots asked for up to which the star discrepancy is worked out: some ten seconds.
inline constexpr std::size_t kMostForStar = 1'100'000;

/// Seconds are of processor time, all work done by one thread, so that methods compare however many threads
/// each could use and whatever else the machine does.

/// Constant grey on the unit square, all taken to go on beyond its edges: as core/analysis has it, each.
struct GreyMarks {
    std::size_t wanted = 0, count = 0;  // dots asked for, dots that came
    double seconds = 0;
    NearestSummary nearest{};
    double power_03 = 0, power_05 = 0;
    Peaks peaks{};
    double effective_nyquist = 0;
    std::optional<double> star{};  // exactly; none for more than kMostForStar dots
    double l2_star = 0;
    std::optional<double> seam{};  // the worst of lab/analysis/seams.h at kSeamLoad; of what has tiles
    std::vector<Ring> radial_power{};
    std::string dots_png{}, spectrum_png{};  // to look at; only if wanted
};

/// A picture, measured as docs/pictures.md says. Each method has the density that the overlap of its own
/// dots on constant grey asks for.
struct DrawingMarks {
    std::size_t count = 0;
    double seconds = 0;
    PictureMarks marks{};
    LocalDistances distances{};
    CellMarks cells{};
    std::string png{};  // only if wanted
};

struct Growth {
    std::size_t count = 0;
    std::optional<double> seconds{};  // none: longer than allowed
};

/// In each what was wanted, in that order; none where it took longer than allowed.
struct MeasuredMethod {
    Contender method;
    std::vector<std::optional<GreyMarks>> grey{};
    std::vector<std::optional<DrawingMarks>> drawings{};
    std::vector<Growth> growth{};
};

struct ComparedPicture {
    std::string name;
    Grid<float> light;  // linear
    std::string png{};  // only if wanted
};

struct CompareRequest {
    std::vector<std::size_t> dots{65'536};
    std::vector<ComparedPicture> pictures{};
    std::size_t picture_dots = 10'000;
    std::vector<std::size_t> growth{1'000, 10'000, 100'000, 1'000'000, 10'000'000};
    double seconds = 20;  // of processor time, that a method may take for one drawing
    std::uint64_t seed = 1;
    bool pngs = false;
    std::stop_token stop{};
    /// Told before each measurement how far all is, 0..1, and what comes; may be empty.
    std::function<void(double done, std::string_view what)> progress{};
};

/// Between density and coverage, for a method's own dots, on the mean over a level of its tiles: measured on
/// constant grey that is drawn as pictures are. None if stopped.
std::optional<InkCurve> own_ink(const Contender& method, const std::stop_token& stop = {});

/// Measures them all. What is longer than allowed is stopped then, and what is certain to be, by how the time
/// has grown, is not begun. When a stop was requested: those that were finished.
std::vector<MeasuredMethod> compare_methods(const std::vector<Contender>& methods,
                                            const CompareRequest& request);

}  // namespace dapple
