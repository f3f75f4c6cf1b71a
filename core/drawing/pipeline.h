#pragma once
// From a picture to its dots: the one line that window, commands, tests and benchmarks go along.
//
//      light ──► tone ──► density ──► placed dots ──► relaxed dots, each with its size
//                            tile ───────┘
//
// A stage is done again only if something that it depends on has changed.

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/dot_stream.h"
#include "core/drawing/request.h"
#include "core/image/density.h"
#include "core/image/ink.h"
#include "core/page.h"
#include "core/relaxing/relax.h"
#include "core/stipple.h"

namespace dapple {

/// What a request comes to on a picture: all that is known before a dot is placed.
struct DrawingPlan {
    Tone tone;                               // as drawn, the automatic one's values included
    std::shared_ptr<const Density> density;  // shared with streams; never changes
    StippleRequest stipple;                  // a scale or a count that can be placed
    int steps = 0;                           // of relaxation
    DotSize size;
    PageSize page;                           // of the picture
    double full_load = 0;                    // see InkCurve

    /// Of all dots, or of the largest ones, in page units, of a drawing that came to that scale.
    double radius(double scale) const;
};

/// The dots of a whole page, kept.
struct Drawn {
    Stippling stippling;
    int steps = 0;          // of relaxation done
    double relax_ms = 0;    // wall time of them
};

/// For someone who watches. Both may be left empty.
struct DrawingWatch {
    std::stop_token stop;
    /// Told after placing (0 steps) and after every step but the last, with the dots as they lie then: a copy is
    /// made on request only.
    std::function<void(int steps, const std::function<DotPieces()>& dots)> step;
};

class Pipeline {
 public:
    /// Draws another picture from now on, of linear light: see Picture.
    void set_light(Grid<float> light);
    /// Or a plain density, which no tone changes.
    void set_density(Density density);
    bool has_picture() const { return plain_ || !light_.empty(); }
    const Grid<float>& light() const { return light_; }

    void set_tile(RankedTile tile) { tile_.emplace(std::move(tile)); }
    const RankedTile& tile() const { return *tile_; }
    RankedTile& tile() { return *tile_; }
    bool has_tile() const { return tile_.has_value(); }

    /// Needs a picture and a tile. Throws std::runtime_error if the picture has nothing to draw (no message names
    /// it), as stipple() does, and if a scale or dot sizes ask for more than kMostDots.
    DrawingPlan plan(const DrawingRequest& request);

    /// All dots of the page into `drawn`, using its memory again. False if stopped.
    bool draw(const DrawingPlan& plan, Drawn& drawn, const DrawingWatch& watch = {});

    /// The dots of a part of the page, seen from its corner, without holding them: drawn anew for each pass. The
    /// stream owns all that it needs. Equal to the whole page's to the bit, and in their order.
    DotStream stream(const DrawingPlan& plan, const PagePart& part = {});

    /// The tiles that the placer goes through at that scale: Figure 8's visits, or the exact placer's.
    std::vector<PlacedTile> outlines(const DrawingPlan& plan, double scale);

    /// Wall time that the last plan() took for the tone, 0 if nothing had changed.
    double tone_ms() const { return tone_ms_; }

 private:
    struct Toned {
        Tone tone;
        InkedDots ink;
        bool operator==(const Toned&) const = default;
    };

    Grid<float> light_;
    bool plain_ = false;
    std::optional<Toned> toned_;  // what density_ was made with
    std::shared_ptr<const Density> density_;
    std::optional<RankedTile> tile_;
    double tone_ms_ = 0;
};

}  // namespace dapple
