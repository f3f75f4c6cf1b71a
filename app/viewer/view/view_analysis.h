#pragma once
// What is measured of the dots on screen: few enough of them that the answer is there in a moment.

#include <cstddef>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "app/viewer/background/background.h"
#include "app/viewer/background/dot_blocks.h"
#include "core/analysis/autocorrelation.h"
#include "core/analysis/distances.h"
#include "core/analysis/domain.h"
#include "core/analysis/periodogram.h"
#include "core/image/grid.h"
#include "core/image/rectangle.h"
#include "core/placing/dots.h"

namespace dapple {

inline constexpr std::size_t kMostAnalysed = 50'000;

/// The dots to measure: all in view or, of too many, those in the middle. A thinned set would have another
/// spectrum; a cut-out has the same.
struct PointsInView {
    std::vector<glm::dvec2> points;  // from the domain's corner
    Domain domain{1, 1, Topology::window};
    bool all = true;  // nothing was left away
};

/// In a part of the page, in the frame and unit of the dots; no points if that is empty. With the dots'
/// blocks only those in view are looked at, which takes some milliseconds however many dots there are;
/// without them, as long a million.
PointsInView points_in_view(const DotPieces& dots, const Rectangle<double>& view,
                            std::size_t most = kMostAnalysed, std::span<const DotBlock> blocks = {});

/// How near to each other two of so many dots are one: placed along two paths, they differ by roundings.
double same_place(const Domain& domain, std::size_t points);

enum class Measure {
    everything,
    repetition,  // ViewAnalysis::periodicity alone, which is quicker
};

struct ViewAnalysisRequest {
    PointsInView view;
    std::size_t tile_size = 16;   // points
    bool has_duplicates = false;  // as Figure 8 emits them: each dot is to count once
    Measure measure = Measure::everything;
};

struct ViewAnalysis {
    std::size_t dots = 0;       // measured
    bool all = true;            // in view
    Grid<glm::u8vec4> picture;  // the spectrum, see spectrum_picture()
    std::vector<Ring> radial_power;
    double low_frequency_power = 0;  // mean power below half a wave a spacing
    Peaks peaks{};
    NearestSummary nearest{};
    /// Over the tiles that the mean density makes: their side is 2^-level, of the last level whose tiles are
    /// all there. None if fewer than two such tiles fit into the view.
    std::optional<Periodicity> periodicity{};
    std::string error{};  // why nothing could be measured
};

/// "repeats itself" .. "no repetition", for a periodicity.
const char* repetition_in_words(double periodicity);

/// Uses one processor, about a third of a second for kMostAnalysed dots. Nothing if stopped.
std::optional<ViewAnalysis> analyse_view(ViewAnalysisRequest request, std::stop_token stop = {});

/// The same for Background: what it throws comes back as ViewAnalysis::error.
Background<ViewAnalysis>::Work analysis_work(ViewAnalysisRequest request);

}  // namespace dapple
