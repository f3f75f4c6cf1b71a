#pragma once
// Which dots the window asks for.

#include <optional>
#include <string>

#include "app/viewer/background/dot_blocks.h"
#include "app/viewer/background/shown_strokes.h"
#include "core/drawing/settings.h"
#include "core/image/density.h"
#include "core/text/names.h"

namespace dapple {

// What the window's dots are placed on: the photograph, or a plain density that shows what the tile does.

enum class DensitySource { photograph, grey, ramp };
constexpr auto names_of(DensitySource) {
    return names("photograph", "grey", "ramp");
}

struct DensityChoice {
    DensitySource source = DensitySource::photograph;
    double grey = 0.5;  // density of the grey, 0..1

    bool operator==(const DensityChoice&) const = default;
};

/// The grey: a square page of one density. The ramp: twice as wide as high, from bare paper on the left to
/// density 1 on the right. The tone has no part in either. Not for the photograph.
Density plain_density(const DensityChoice& choice);

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
