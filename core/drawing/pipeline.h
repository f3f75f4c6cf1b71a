#pragma once
// From a picture to its dots: the one way that window, commands, tests and benchmarks go.
//
//      light ──► tone ──► density, under its mask ──► placed dots ──► relaxed dots, each with its size
//                                              tile ──────────┘
//
// A stage is done again only if something that it depends on has changed.

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/drawing/edits.h"
#include "core/drawing/page_setup.h"
#include "core/drawing/pen_plan.h"
#include "core/drawing/settings.h"
#include "core/export.h"
#include "core/image/density.h"
#include "core/image/detail.h"
#include "core/image/histogram.h"
#include "core/image/ink.h"
#include "core/lines/inking.h"
#include "core/placing/page.h"
#include "core/placing/placer.h"
#include "core/placing/stipple.h"

namespace dapple {

// A value beside what it was made of, made again only where that has changed.

template <class Key, class Value>
class Cached {
 public:
    /// The value for that key. If another one is kept, it is given up, so that its memory can be used, and
    /// then make() makes this one.
    template <class Make>
    const Value& of(const Key& key, const Make& make) {
        if (!find(key)) {
            forget();
            keep(key, make());
        }
        return *value_;
    }

    /// Null if none is kept for that key.
    const Value* find(const Key& key) const { return key_ && *key_ == key ? &*value_ : nullptr; }

    /// The one that is kept, whatever its key; there has to be one.
    const Value& value() const { return *value_; }

    void keep(Key key, Value value) {
        value_ = std::move(value);
        key_ = std::move(key);
    }

    void forget() {
        key_.reset();
        value_.reset();
    }

 private:
    std::optional<Key> key_;
    std::optional<Value> value_;
};

/// What a request comes to on a picture: all that is known before a dot is placed.
struct DrawingPlan {
    Tone tone;        // as drawn, with the values that were chosen automatically
    Tone usual_tone;  // as it is with automatic tone, black and all; without a picture neutral
    std::shared_ptr<const Density> density;      // shared with streams; never changes
    std::shared_ptr<const Histogram> histogram;  // of the light as exposed; none without a picture
    PlacerKind placer = PlacerKind::exact;
    PlacingRequest placing;  // a count or a scale within the limits
    bool lowered = false;    // more was asked for
    int steps = 0;           // of relaxation
    SettleFor settle_for = SettleFor::pictures;
    int usual_steps = 0;  // see usual_steps(); 0 of Figure 8
    DotSize size;
    bool joined = false;         // by lines: see InkedDots
    double stroke_width_mm = 0;  // of lines that reach half as far beyond; 0: filled dots, or no margins
    PageSize page;               // of the picture
    InkedDots ink;               // that the tone's density is of
    double full_load = 0;        // see InkCurve
    Palette pens;                // several, in the order in which they draw; none: one
    PenDensities by_pen;         // whose sum is the density above
    Refinement finer;            // where there are more dots for it, and smaller ones
    std::shared_ptr<const Inking> inking;  // lines and solid blacks among the dots; none: null
    std::vector<Edit> edits;               // by hand; the largest radius that they give a dot, in mm;
    double largest_edit_mm = 0;            // 0: all are as large as the others. On the page of a
    std::optional<double> edits_scale;     // drawing that came to that scale; none: of this one
    PageSetup setup;
    glm::ivec2 pixels{1, 1};  // of the picture, framed
    Framing framing;          // of the picture that was opened,
    glm::ivec2 opened{1, 1};  // which has so many pixels

    /// The scale that is asked for, or at which a count ends once Pipeline::find_scale() found that.
    DAPPLE_API double scale() const;
    /// How many dots: exactly so many if a count is asked for, else about as many.
    DAPPLE_API double dots() const;

    /// The radius of all dots, or of the largest ones, in page units, in a drawing that came to that scale;
    /// where dots are finer, of those that are not.
    double radius(double scale) const;
    /// That of the largest dots that there are in millimetres, on the page as it is then laid out.
    DAPPLE_API double radius_mm(double scale) const;

    /// The radius of the largest dots over that of dots that are not finer.
    double largest_share() const { return 1 / std::sqrt(double{finer.least_times()}); }

    /// The page, and where on it the picture lies, of a drawing that came to that scale.
    DAPPLE_API PageLayout layout(double scale) const;

    /// Where dots have a fixed radius: about so many of them give the picture's tone.
    double dots_for_tone() const;
    /// And the radius, in page units, with which a drawing that came to that scale gives it.
    double radius_for_its_tone(double scale) const { return radius_for_tone(scale, full_load); }

    /// Of the picture, in page units.
    glm::dvec2 picture_size() const {
        return glm::dvec2(pixels) / static_cast<double>(std::max(pixels.x, pixels.y));
    }
};

/// For someone who watches. Both may be left empty.
struct DrawingWatch {
    std::stop_token stop;
    /// Told after placing and after every step but the last, with `drawn` as it is without the dots, which
    /// are copied on request. False ends the drawing there; several pens then share the dots as they lie.
    std::function<bool(const Stippling& drawn, const std::function<DotPieces()>& dots)> step;
};

/// A plan with its dots, which are placed for whichever part of the page is asked for, in any thread, while
/// the pipeline goes on with other drawings. Never changes.
struct PlannedDrawing {
    DrawingPlan plan;
    double scale = 0;  // that it came to
    /// Those of a part, seen from its corner, handed over in pieces and without holding all of them, except
    /// for Figure 8's, those of several pens and edited ones. Equal to the whole page's to the bit, and in
    /// their order. The stream owns what it needs. Throws as stream() does. If stopped, none.
    std::function<DotStream(const PagePart& part, const std::stop_token& stop)> dots;
    /// The tiles of the whole page that the placer goes through.
    std::function<std::vector<PlacedTile>()> outlines;
    std::size_t tile_size = 16;  // N

    double radius_mm() const { return plan.radius_mm(scale); }
    PageLayout layout() const { return plan.layout(scale); }
};

class Pipeline {
 public:
    /// Draws another picture from now on, of linear light: see Picture. `usual_exposure` is what automatic
    /// exposure comes to, in stops. Crops are in pixels of the file; `pixels_in_one` by as many of these
    /// became one value of the light.
    void set_light(Grid<float> light, float usual_exposure = 0, int pixels_in_one = 1);
    /// The same picture's colours, for several pens; without them it is drawn as a grey one.
    void set_colours(ColourGrid colours);
    /// A density in the picture's place, which no tone changes; none: the picture again.
    void set_plain(std::optional<Density> density);
    bool has_picture() const { return plain_ || !light_.empty(); }
    /// The light of the picture as it was opened. framed_light() is it as the last plan() framed it.
    const Grid<float>& light() const { return light_; }
    /// The size of that light in pixels of the file. It may end beyond the file's last pixel by less than a
    /// value.
    glm::ivec2 pixels() const { return pixels_in_one_ * glm::ivec2(light_.width, light_.height); }
    const Framing& framing() const { return framing_; }
    const Grid<float>& framed_light() const { return framed_ ? *framed_ : light_; }

    void set_tile(RankedTile tile) { tile_.emplace(std::move(tile)); }
    void forget_tile() { tile_.reset(); }
    bool has_tile() const { return tile_.has_value(); }
    RankedTile& tile() { return *tile_; }

    /// Needs a picture and a tile. Throws what density_of(), Density, framing_of() and layout_of() throw.
    /// Touches are as large as the pen's line is wide. Where several pens draw lines or shapes, dots are as
    /// large as one pen's would be; a pen's width is then its lines'. A count or a scale that asks for more
    /// than `most_dots` is lowered.
    DrawingPlan plan(const DrawingSettings& asked, std::uint64_t most_dots = kMostDots);

    /// The scale that stream() comes to; a count's end is found now and kept in the plan.
    double find_scale(DrawingPlan& plan);

    /// All dots of the page into `drawn`, using its memory again. Figure 8 given a count places about so
    /// many. False if stopped. Throws as stipple() does.
    bool draw(const DrawingPlan& plan, Stippling& drawn, const DrawingWatch& watch = {});
    /// The same in two parts: the dots settled, and then their sizes, and the edits.
    bool settle(const DrawingPlan& plan, Stippling& drawn, const DrawingWatch& watch = {});
    static void finish(const DrawingPlan& plan, Stippling& drawn);

    /// Where the dots are needed at once, they are drawn now. Nothing if stopped. Throws as stipple() does.
    std::optional<PlannedDrawing> drawing(DrawingPlan plan, const std::stop_token& stop = {});
    /// The dots alone, of one part.
    DotStream stream(const DrawingPlan& plan, const PagePart& part = {}) {
        return drawing(plan)->dots(part, {});
    }

    /// The tiles that the placer goes through at that scale: those that Figure 8 visits, or the exact
    /// placer's.
    std::vector<PlacedTile> outlines(const DrawingPlan& plan, double scale) const {
        return outlines_of(plan, scale)();
    }

    /// Wall time that the last plan() took for tone and density; 0 if they were still there.
    double tone_ms() const { return tone_ms_; }

 private:
    std::function<std::vector<PlacedTile>()> outlines_of(const DrawingPlan& plan, double scale) const;

    // What each stage is made of, beside the picture.
    struct Usual {  // what automatic tone comes to
        Tone own;
        double strength = 1;
        float exposure = 0;
        bool operator==(const Usual&) const = default;
    };
    struct Detailed {  // light, before it becomes a density
        float exposure = 0, amount = 0;
        double sigma = 0;  // pixels
        bool operator==(const Detailed&) const = default;
    };
    struct Separated {  // pens' shares of each colour
        Palette pens;
        glm::vec3 paper = kWhite;
        double black = kUsualBlack;  // see Separation
        bool operator==(const Separated&) const = default;
    };
    struct Toned {  // densities
        Tone tone;
        InkedDots ink;
        double detail_sigma = 0;  // pixels
        Separated pens = {};
        bool operator==(const Toned&) const = default;
    };
    struct Masked {  // the density under its mask
        std::shared_ptr<const Density> density;
        Mask mask;
        bool operator==(const Masked&) const = default;
    };
    struct LitForLines {  // lines and blacks are found on
        float exposure = 0;
        bool invert = false;
        bool operator==(const LitForLines&) const = default;
    };
    struct Blackened {  // solid shapes
        Tone tone;
        double solid = 1;
        Mask mask = {};
        bool operator==(const Blackened&) const = default;
    };
    struct Inked {  // the density beside lines and blacks
        std::shared_ptr<const Density> density;
        double contours = 0, solid = 1;
        DotsAmongLines dots;
        bool operator==(const Inked&) const = default;
    };
    struct Room {
        std::shared_ptr<const Inking> inking;
        Grid<float> times;
        std::shared_ptr<const Density> density;
    };
    struct Scaled {   // how many dots a scale comes to, which black and steps follow from and decide about
        Toned toned;  // as the histogram has it
        Mask mask;
        double scale = 0;
        bool operator==(const Scaled&) const = default;
    };

    void forget_light();
    void forget_densities();
    /// Under the mask, if there is one.
    std::shared_ptr<const Density> density_for(const Toned& toned, const Mask& mask);
    const PenDensities& toned_densities(const Toned& toned);
    Grid<float> detailed_light(const Detailed& detailed);
    PenDensities toned_by_pen(const Toned& toned, Grid<float> light);
    PenDensities by_pen_under(const Mask& mask) const;  // of the density made last
    std::shared_ptr<const Histogram> histogram(float exposure);
    Tone usual_tone(const Histogram& histogram, const Tone& own, double strength);
    void tone_for(DrawingPlan& plan, const DrawingSettings& settings);
    std::shared_ptr<const Density> plain_for(double dots);
    void add_inking(DrawingPlan& plan, const DrawingSettings& request);

    void frame(const PageSetup& setup);
    /// The framing in values of the light: those that have a pixel of it.
    Framing framing_of_light() const;

    const ColourGrid& framed_colours() const { return framed_colours_ ? *framed_colours_ : colours_; }

    Grid<float> light_;
    std::optional<Grid<float>> framed_;  // none: all of it as it is
    ColourGrid colours_;                 // empty: not known
    std::optional<ColourGrid> framed_colours_;
    Framing framing_;
    int pixels_in_one_ = 1;
    float usual_exposure_ = 0;
    std::shared_ptr<const Density> plain_;
    Cached<int, std::shared_ptr<const Density>> finer_cells_;  // of the plain one, by how many pixels to one
    Cached<float, std::shared_ptr<const Histogram>> histogram_;  // by exposure
    Cached<Usual, Tone> usual_;
    Cached<Detailed, Grid<float>> detailed_;  // none of a large picture
    Cached<Separated, std::shared_ptr<const Separation>> separation_;
    Cached<Toned, PenDensities> toned_;
    Cached<Masked, std::shared_ptr<const Density>> masked_;
    Cached<Scaled, double> dots_by_scale_;
    Cached<LitForLines, std::vector<InkLine>> lines_;
    Cached<Blackened, std::vector<InkArea>> blacks_;
    Cached<Inked, Room> room_;
    std::optional<RankedTile> tile_;
    double tone_ms_ = 0;
};

}  // namespace dapple
