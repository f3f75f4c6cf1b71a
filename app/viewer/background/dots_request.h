#pragma once
// Which dots the window asks for.

#include <optional>
#include <string>

#include "app/viewer/background/density_choice.h"
#include "app/viewer/background/dot_colours.h"
#include "app/viewer/background/shown_strokes.h"
#include "core/drawing/settings.h"

namespace dapple {

/// What the canvas shows of the page, placed at a scale that goes with the zoom.
struct CloseView {
    PageWindow window;
    double scale = 0;

    bool operator==(const CloseView&) const = default;
};

/// Those of the settings that dots depend on.
struct DotsRequest {
    DrawingRequest drawing;
    std::uint64_t most_dots = kMostDots;
    std::string tile;
    std::optional<RankingMethod> ranking;
    bool outlines = false;                // the tiles too
    std::optional<CloseView> close = {};  // instead of the whole page, as placed; the exact placer only
    DensityChoice density = {};
    DotColourChoice colours = {};
    bool settled_only = false;  // nothing is shown on the way
    bool in_part = true;        // preview_dots() may be shown for a while
    StrokeChoice strokes = {};  // how dots come onto the screen

    bool operator==(const DotsRequest&) const = default;
};
DotsRequest dots_request(const DrawingSettings& settings, const DensityChoice& density = {});

}  // namespace dapple
