#pragma once
// Which dots the window asks for.

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <vector>

#include "app/viewer/background/dot_blocks.h"
#include "core/drawing/page_setup.h"
#include "core/drawing/pipeline.h"
#include "core/drawing/settings.h"
#include "core/image/density.h"
#include "core/image/ink.h"
#include "core/placing/stipple.h"
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

/// What the drawing on the screen depends on: it is placed anew where a request is another than the last.
struct DotsRequest {
    DrawingSettings drawing = {};  // what neither dots nor outlines depend on is as usual: see dots_request()
    std::uint64_t most_dots = kMostDots;
    std::optional<CloseView> close = {};  // instead of the whole page, as placed; the exact placer only
    DensityChoice density = {};
    DotColourChoice colours = {};
    bool settled_only = false;                // nothing is shown on the way
    bool in_part = true;                      // preview_dots() may be shown for a while
    bool held = false;                        // by a hand that may move on: not relaxed to the end
    std::optional<DotOrder> line_order = {};  // of one line through all dots; none: the shortest

    bool operator==(const DotsRequest&) const = default;
};
DotsRequest dots_request(const DrawingSettings& settings, const DensityChoice& density = {});

// A drawing as the window has it: its dots, and what is to be known of them.

struct PlacedDrawing : Stippling {
    std::optional<DotsRequest> request;  // that it was placed for; none: nothing was
    DrawingPlan plan;                    // what that came to; without its densities, which take much memory
    PageLayout layout;                   // of the whole page
    InkedDots ink;                       // how the dots cover the paper
    double dots_for_tone = 0;            // that would give the picture's, of a fixed size; 0: they do
    glm::dvec2 tile_corner{0, 0};        // on the page, see Density; Figure 8's is the page's own
    std::vector<PlacedTile> outlines;
    std::vector<DotBlock> blocks;      // dot_blocks(), where it goes to the screen
    ShownStrokes strokes;              // instead of the dots, where a pen draws them on the screen
    ShownStrokes inking;               // beside either
    std::vector<glm::u8vec4> colours;  // one a dot; empty: all in ink, or their pens'
    double tone_ms = 0;                // density and its pyramid, 0 if they were still there

    bool settled() const { return steps == plan.steps; }
    /// False before anything was placed, and where it could not be: there is neither a page nor a dot.
    bool is_there() const { return layout.page.mm_per_page_unit > 0; }

    /// The part of the page that the dots are of; they and the outlines are relative to its corner.
    const PageWindow& window() const { return plan.placing.window; }
    /// Of all dots, or of the largest ones, in page units.
    double dot_radius() const { return is_there() ? plan.largest_share() * plan.radius(scale) : 0; }
    double dot_radius_mm() const { return dot_radius() * layout.page.mm_per_page_unit; }
    /// That with which these dots would give the picture's tone.
    double radius_for_tone_mm() const {
        return plan.radius_for_its_tone(scale) * layout.page.mm_per_page_unit;
    }
};

}  // namespace dapple
