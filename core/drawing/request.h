#pragma once
// What decides where a drawing's dots lie and how large they are, beside the picture and the tile.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/drawing/page_setup.h"
#include "core/image/mask.h"
#include "core/image/tone.h"
#include "core/pens/pen.h"
#include "core/placing/stipple.h"
#include "core/strokes/dot_shape.h"
#include "core/strokes/drawing_style.h"
#include "core/text/names.h"

namespace dapple {

/// More dots than this lie so close that the float coordinates they are kept in would move them visibly.
inline constexpr std::uint64_t kMostDots = 10'000'000'000;

enum class DotSizing {
    automatic,  // all alike, with the radius that gives the picture's tone
    fixed,      // all alike, of any radius; the tone is then lighter or darker than the picture's
    by_tone,    // from the smallest in light areas to the largest on black; how many follows from the tone
};
constexpr auto names_of(DotSizing) {
    return names("automatic", "fixed", "by_tone");
}

/// Radii in millimetres on paper, over 0; smallest <= largest.
struct DotSize {
    DotSizing sizing = DotSizing::automatic;
    double radius_mm = 0.2;                        // fixed
    double smallest_mm = 0.15, largest_mm = 0.35;  // by tone

    bool operator==(const DotSize&) const = default;
};

/// How far the largest dots reach, in millimetres; 0 where it follows from how many there are.
double reach_mm(const DotSize& size);

/// What relaxed dots are best for.
enum class SettleFor {
    pictures,  // to be seen: tones, edges, and distances between dots
    samples,   // to be summed over: the least low part of the spectrum
};
constexpr auto names_of(SettleFor) {
    return names("pictures", "samples");
}

/// What someone asks for.
struct DrawingRequest {
    /// If automatic, black point, white point, contrast, brightness and gamma are chosen for the picture;
    /// `tone` says the rest. A picture of one tone keeps its own.
    bool automatic_tone = true;
    double tone_strength = 1;  // of automatic tone, 0..1: see auto_tone()
    /// If automatic, tone.exposure is the picture's usual one: see Pipeline::set_light().
    bool automatic_exposure = true;
    Tone tone = {};
    Mask mask = {};  // over the picture's density
    PlacerKind placer = PlacerKind::exact;
    /// The placing of the whole page. Where dot sizes go by tone, neither its count nor its scale has a say.
    PlacingRequest placing = {};
    std::optional<int> relax =
        {};  // steps, 0..kMostRelaxingSteps; none: usual_steps(). Figure 8's dots stay as placed
    SettleFor settle_for = SettleFor::pictures;
    DotSize dot_size = {};
    PageSetup page = {};
    PenChoice pens = {};       // what several draw follows from the picture's colours
    glm::vec3 paper = kWhite;  // sRGB-encoded; has a say in that alone
    DrawingStyle style = DrawingStyle::dots;
    DotMark mark = {};          // each dot's shape, where the style is dots
    double pen_width_mm = 0.3;  // of the strokes that shapes and lines are drawn with

    bool operator==(const DrawingRequest&) const = default;
};

/// Whether a pen draws lines, rather than dots being filled circles.
bool draws_strokes(const DrawingRequest& request);

/// Whether dots can be finer where the mask asks for it: not lines, which are as wide everywhere, nor dots
/// that are as large as their pen is wide. What cannot is drawn as if nothing was finer.
bool can_be_finer(const DrawingRequest& request);

/// Whether dots are of several sizes, those of pens of several widths aside.
bool has_several_sizes(const DrawingRequest& request);

/// What pens do: ink spreads about a dot where the pen rests, and not along a line.
enum class PenUse { lines, touches };

/// How wide the choice's pens draw lines, or dots by touching the paper, in millimetres: their own width,
/// with the dot gain if they touch; or else pen_width_mm.
std::vector<double> stroke_widths(const PenChoice& choice, double pen_width_mm, std::span<const Pen> pens,
                                  PenUse use);

/// Whether several pens say how wide they are.
bool have_widths(const PenChoice& pens);

/// Whether each dot is a touch of the pen, and as large as what that leaves.
bool draws_touches(const DrawingRequest& request);
inline PenUse pen_use(const DrawingRequest& request) {
    return draws_touches(request) ? PenUse::touches : PenUse::lines;
}

/// The widest line that a pen draws, or the widest touch, in millimetres; 0 where dots are filled circles.
double widest_stroke(const DrawingRequest& request);

inline constexpr int kFewestUsualSteps = 7;

/// The steps after which a drawing looks as good as it needs to: 12 for 13,600 dots and fewer, from there on
/// in proportion to 1 / sqrt(dots), kFewestUsualSteps for 40,000 and more; none where dots lie closer than
/// the eye can tell apart on paper and are so many that they would be waited for.
int usual_steps(double dots, double picture_area_mm2);

}  // namespace dapple
