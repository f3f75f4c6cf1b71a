#pragma once
// The dots of one side of the canvas: what was requested of its worker, what came back, and what of it is
// shown.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>

#include "app/viewer/background/worker.h"
#include "app/viewer/model/viewer_settings.h"
#include "app/viewer/view/camera.h"
#include "core/pens/pen.h"

namespace dapple {

// Which pens' dots are looked at. A way of looking, as the zoom is: files have all pens, and it is neither
// saved nor undone.

/// By their names, so that it stays with a pen while others come and go.
struct ShownPens {
    std::set<std::string> hidden = {};
    std::string only =
        {};  // this one alone, hidden or not; empty, or no longer there: all that are not hidden

    bool operator==(const ShownPens&) const = default;
};

/// A bit for each of the pens that is not to be seen, as Dots::pen counts them.
std::uint32_t hidden_among(std::span<const Pen> pens, const ShownPens& shown);

/// How the page is looked at.
struct Zoom {
    ZoomMode mode = ZoomMode::drawing;
    Camera camera;
    double enlargement = 1;  // how many times larger than fitted into the canvas
};

class Pane {
 public:
    /// `wake` is called from the worker's threads whenever there is an event.
    explicit Pane(std::function<void()> wake) : worker_(std::move(wake)) {}

    Worker& worker() { return worker_; }
    const Worker& worker() const { return worker_; }

    /// Requests the page or, once that is there and the zoom is so deep that the whole page would be too
    /// coarse or too much, what is in view of it. True if it requested something: nothing twice, unless
    /// `again` says so.
    bool request(DotsRequest page, const Zoom& zoom, bool again);

    /// Takes drawing and tile out of the event.
    void take(DotsPlaced& event);

    /// Forgets picture and dots and gives their memory back. The numbers below go on.
    void clear();

    /// The whole page; what is shown: that or a part of it placed for the zoom.
    const PlacedDrawing& page() const { return page_; }
    const PlacedDrawing& shown() const { return shows_close_ ? close_ : page_; }
    bool shows_close() const { return shows_close_; }

    /// What the whole page was requested with last.
    const std::optional<DotsRequest>& page_requested() const { return page_requested_; }

    /// A number that changes with what is shown, and one of drawings that came.
    std::uint64_t version() const { return version_; }
    std::uint64_t placings() const { return placings_; }

    /// The tile it is placed with; none before the first dots.
    const TileView& tile() const { return tile_; }
    /// Its size, at least 1.
    std::size_t tile_size() const { return std::max<std::size_t>(tile_.points.size(), 1); }
    /// How many tiles there have been.
    int tiles() const { return tiles_; }

    /// The dots fade in below this scale while they multiply with the zoom; 0: none does.
    double fade_scale(const Zoom& zoom) const;

 private:
    std::optional<CloseView> close_view(const DotsRequest& page, const Zoom& zoom) const;

    Worker worker_;
    std::optional<DotsRequest> page_requested_, close_requested_;
    PlacedDrawing page_, close_;
    TileView tile_;
    int tiles_ = 0;
    bool shows_close_ = false;
    std::uint64_t version_ = 0, placings_ = 0;
};

}  // namespace dapple
