#pragma once
// What is done in the background for one side of the canvas, on the pipeline: dots placed and relaxed for the
// screen or a file, with tiles by name, plain densities, parts of the page, outlines and colours. One thread
// at a time uses it.

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "app/viewer/background/background.h"
#include "app/viewer/background/dots_request.h"
#include "core/drawing/pipeline.h"
#include "core/placing/stipple.h"
#include "core/watch.h"
#include "io/files/picture.h"
#include "io/files/save_drawing.h"

namespace dapple {

// A tile as the window shows it.

struct TileView {
    std::string name;
    Rule rule;  // how the tile is turned in each of its quadrants
    std::vector<glm::vec2>
        points;  // in the unit square, y down, in the order in which they appear; of kind 0
    /// The same for those that its children add to it, after which all of their points are there; Figure 8
    /// has no such order, and several kinds have several.
    std::vector<glm::vec2> newborn = {};
    NextKinds next_kind = NextKinds(1);
};

/// The tile's own points in the order that the placer gives them; Figure 8 has one of its own.
TileView view_of(std::string name, RankedTile& tile, PlacerKind placer);

/// Where a drawing is while its dots are still to be relaxed further: told with the drawing as it lies then,
/// which is made when it is called. False ends it there.
using Unsettled = std::function<bool(const std::function<PlacedDrawing()>& drawing)>;

/// A picture that was opened; its light stays with the workbench.
struct OpenedPicture {
    std::filesystem::path file = {};                                // none: not from one
    std::string name = {};                                          // for the title: "cat.png"
    std::string description = {};                                   // "512 x 512 pixels, ..."
    int longer_side = 1;                                            // pixels
    std::shared_ptr<const std::vector<Grid<glm::u8vec4>>> preview;  // mipmaps_of() it
    float exposure = 0;                                             // see Picture
    std::function<Picture()> read;                                  // reads it again
    bool refines = false;  // all of a picture that came before as a first look
    /// Twice as wide as high and in parts brighter than paper, as environment maps are.
    bool looks_like_environment = false;
};

/// A new picture comes together with its first dots. A drawing whose dots are still to be relaxed comes as it
/// lies, and again when it has settled further.
struct DotsPlaced {
    PlacedDrawing drawing;
    std::optional<OpenedPicture> picture;
    std::optional<TileView> tile;  // if it is another than the one told before
    std::string error;             // why there are no dots
};

class Workbench;

/// Writes a file; false if stopped.
using WriteFile = std::function<bool(const Watch&)>;
/// Places what is to be written. Empty if stopped.
using PrepareFile = std::function<WriteFile(Workbench&, std::stop_token)>;

class Workbench {
 public:
    /// Shows another picture from now on.
    void set_picture(Picture picture) {
        dapple::set_picture(pipeline_, std::move(picture));
        unedited_.forget();
    }
    /// The same, and comes with its first dots on the screen: of `about`, file, name and way to read it are
    /// told.
    void open(Picture picture, OpenedPicture about);
    bool has_picture() const { return pipeline_.has_picture(); }

    /// Places into `drawing`, using its memory again, and relaxes. False if stopped. Throws
    /// std::runtime_error as Pipeline::draw() and tile_named() do. Needs a picture.
    bool place(const DotsRequest& request, PlacedDrawing& drawing, std::stop_token stop = {},
               const Unsettled& unsettled = {});

    /// The same for the screen, where a drawing that takes longer is seen on its way. Nothing if stopped.
    /// What goes wrong is in DotsPlaced::error.
    std::optional<DotsPlaced> place_for_screen(const DotsRequest& request,
                                               const Background<DotsPlaced>::Task& task);

    /// What a request comes to: the pipeline is then ready for it.
    DrawingPlan plan(const DotsRequest& request);
    Pipeline& pipeline() { return pipeline_; }

    /// A drawing whose memory may be used again. Takes no time, however large it is.
    void give_back(PlacedDrawing drawing) { spare_.push_back(std::move(drawing)); }
    /// Frees those that no longer will be.
    void sort_spare();

    /// Forgets picture and dots and gives their memory back.
    void clear();

 private:
    bool draw(const DotsRequest& request, const DrawingPlan& plan, Stippling& drawn,
              const DrawingWatch& watch);
    DotsPlaced ready_for_screen(const DotsRequest& request, PlacedDrawing drawing, LineWay way,
                                const std::stop_token& stop);

    Pipeline pipeline_;
    Cached<DotsRequest, Stippling> unedited_;  // the last dots, if they are few: other edits come at once
    DensityChoice choice_;
    std::optional<std::pair<std::string, std::optional<RankingMethod>>> tile_;  // its name and ranking
    std::atomic<float>* share_ = nullptr;  // of the dots placed: see Placer::report_share()

    std::optional<OpenedPicture> arrived_;  // waits for its dots
    std::vector<PlacedDrawing> spare_;      // that the window no longer shows: their memory is used again
    std::size_t last_size_ = 0;             // dots of the last drawing
    std::optional<DotsRequest> settled_;    // the request placed last, to its end, as if it was not held
    std::optional<DotsRequest> tile_published_;  // the request whose tile was told last
};

/// What the exception being handled says, in words for people.
std::string words_of_exception();

}  // namespace dapple
