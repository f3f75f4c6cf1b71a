#pragma once
// The pipeline as the window uses it: with tiles by name, plain densities, parts of the page, outlines and
// colours.

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/drawing_settings.h"
#include "app/viewer/model/density_choice.h"
#include "app/viewer/model/dot_blocks.h"
#include "app/viewer/model/dot_colours.h"
#include "core/drawing/pipeline.h"

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
    std::string tile;
    std::optional<RankingMethod> ranking;
    bool outlines = false;                // the tiles too
    std::optional<CloseView> close = {};  // instead of the whole page, as placed; the exact placer only
    DensityChoice density = {};
    DotColourChoice colours = {};
    bool settled_only = false;  // nothing is shown on the way

    bool operator==(const DotsRequest&) const = default;
};
DotsRequest dots_request(const DrawingSettings& settings, const DensityChoice& density = {});

struct PlacedDrawing {
    Stippling stippling;
    Tone tone;                                   // as drawn, with the values that were chosen automatically
    std::shared_ptr<const Histogram> histogram;  // of the picture's light as exposed; none without one
    int steps = 0, all_steps = 0;                // of relaxation: done, and to be done
    double dot_radius = 0;                       // page units: of all, or of the largest ones
    std::vector<PlacedTile> outlines;
    std::vector<DotBlock> blocks;      // dot_blocks(), where it goes to the screen
    std::vector<glm::u8vec4> colours;  // one a dot; empty: all in ink
    glm::dvec2 page_size{1, 1};        // of the picture, page units
    PageLayout layout;                 // of the whole page
    Framing framing;                   // of the picture that was opened,
    glm::ivec2 picture_pixels{1, 1};   // which has so many
    PageWindow window;                 // dots and outlines are relative to its corner
    double tone_ms = 0;                // density and its pyramid, 0 if they were still there
    double relax_ms = 0;

    bool settled() const { return steps == all_steps; }
};

/// Where a drawing is while its dots are still to be relaxed further: told with the drawing as it lies then,
/// which is made on request. False ends it there.
using Unsettled = std::function<bool(const std::function<PlacedDrawing()>& drawing)>;

class Workbench {
 public:
    /// Shows another picture from now on.
    void set_picture(Grid<float> light, float usual_exposure = 0);
    bool has_picture() const { return pipeline_.has_picture(); }

    /// Places into `drawing`, using its memory again, and relaxes. False if stopped. Throws
    /// std::runtime_error as Pipeline::draw() and tile_named() do. Needs a picture.
    bool place(const DotsRequest& request, PlacedDrawing& drawing, std::stop_token stop = {},
               const Unsettled& unsettled = {});
    /// Where place() says how far it has come with the exact placer's dots: see Placer::report_share().
    void report_share(std::atomic<float>* share) { share_ = share; }

    /// What that order comes to: the pipeline is then ready for it.
    DrawingPlan plan(const DotsRequest& request);
    Pipeline& pipeline() { return pipeline_; }

 private:
    struct TileKey {
        std::string name;
        std::optional<RankingMethod> ranking;
        bool operator==(const TileKey&) const = default;
    };

    Pipeline pipeline_;
    DensityChoice choice_;
    std::optional<TileKey> tile_key_;
    std::atomic<float>* share_ = nullptr;
};

}  // namespace dapple
