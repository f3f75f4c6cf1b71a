#pragma once
// Everything that decides how a drawing looks, beside the picture. One value: the viewer's panels edit it,
// the command line fills it, and the same settings give the same dots in both.

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/drawing/page_setup.h"
#include "core/image/colour.h"
#include "core/image/detail.h"
#include "core/image/mask.h"
#include "core/image/tone.h"
#include "core/output/gcode.h"
#include "core/output/plotting_time.h"
#include "core/output/sheet.h"
#include "core/pens/pen.h"
#include "core/placing/dot_order.h"
#include "core/placing/stipple.h"
#include "core/strokes/dot_shape.h"
#include "core/strokes/drawing_style.h"
#include "core/text/names.h"
#include "core/tile/ranking.h"

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

inline constexpr std::uint64_t kDefaultDots = 40'000;

/// The built-in tile whose pictures look best.
inline constexpr const char* kDefaultTile = "kinds4096";

/// The strength at which automatic tone keeps most of both what is dark and what is light: in eleven
/// photographs, drawings follow the darkest and the lightest third of a photograph better with it than
/// without.
inline constexpr double kUsualToneStrength = 0.6;

/// What someone asks for.
struct DrawingSettings {
    /// If automatic, black point, white point, contrast, brightness and gamma are chosen for the picture;
    /// `tone` says the rest. A picture of one tone keeps its own.
    bool automatic_tone = true;
    double tone_strength = kUsualToneStrength;  // of automatic tone, 0..1: see auto_tone()
    /// If automatic, tone.exposure is the picture's usual one: see Pipeline::set_light().
    bool automatic_exposure = true;
    Tone tone = {.detail = kAutoDetail};
    Mask mask = {};  // over the picture's density

    std::string tile = kDefaultTile;            // a name for tile_named()
    std::optional<RankingMethod> ranking = {};  // none: the tile's own
    PlacerKind placer = PlacerKind::exact;
    /// The placing of the whole page. Where dot sizes go by tone, neither its count nor its scale has a say.
    PlacingRequest placing = {.count = kDefaultDots, .threads = 0};
    /// Steps, 0..kMostRelaxingSteps; none: usual_steps(). Figure 8's dots stay as placed.
    std::optional<int> relax = {};
    SettleFor settle_for = SettleFor::pictures;
    DotSize dot_size = {};

    PageSetup page = {};
    Sheet sheets = {};  // all of these are saved, each in a file of its own, rather than the page

    PenChoice pens = {};        // what several draw follows from the picture's colours
    bool registration = false;  // several pens draw crosses too: see registration_marks()
    glm::vec3 ink = kBlack;     // sRGB-encoded, 0..1; several pens have colours of their own
    glm::vec3 paper = kWhite;   // sRGB-encoded; where dots lie follows from it for several pens alone
    bool background = false;    // paint the paper under an SVG's dots
    bool show_tiles = false;    // the boundaries of the tiles, coloured by level

    /// How much of the picture's contours is drawn as lines among the dots, 0..1; 0: none.
    double contours = 0;
    /// What is darker than that becomes a solid shape, 0..1 from white to black; 1: nothing does.
    double solid = 1;
    DrawingStyle style = DrawingStyle::dots;
    DotMark mark = {};          // each dot's shape, where the style is dots
    double pen_width_mm = 0.3;  // of the strokes that shapes and lines are drawn with

    std::string edits = {};  // by hand: see parse_edits(); empty: none

    bool operator==(const DrawingSettings&) const = default;
};

/// Whether lines or solid blacks are drawn among the dots.
inline bool has_inking(const DrawingSettings& settings) {
    return settings.contours > 0 || settings.solid < 1;
}

/// Whether a pen draws lines, rather than dots being filled circles.
bool draws_strokes(const DrawingSettings& settings);

/// Whether dots can be finer where the mask asks for it: not lines, which are as wide everywhere, nor dots
/// that are as large as their pen is wide. What cannot is drawn as if nothing was finer.
bool can_be_finer(const DrawingSettings& settings);

/// Whether dots are of several sizes, those of pens of several widths aside.
bool has_several_sizes(const DrawingSettings& settings);

/// What pens do: ink spreads about a dot where the pen rests, and not along a line.
enum class PenUse { lines, touches };

/// How wide the choice's pens draw lines, or dots by touching the paper, in millimetres: their own width,
/// with the dot gain if they touch; or else pen_width_mm.
std::vector<double> stroke_widths(const PenChoice& choice, double pen_width_mm, std::span<const Pen> pens,
                                  PenUse use);

/// Whether several pens say how wide they are.
bool have_widths(const PenChoice& pens);

/// Whether each dot is a touch of the pen, and as large as what that leaves.
bool draws_touches(const DrawingSettings& settings);
inline PenUse pen_use(const DrawingSettings& settings) {
    return draws_touches(settings) ? PenUse::touches : PenUse::lines;
}

/// The widest line that a pen draws, or the widest touch, in millimetres; 0 where dots are filled circles.
double widest_stroke(const DrawingSettings& settings);

inline constexpr int kFewestUsualSteps = 7;

/// The steps after which a drawing looks as good as it needs to: 12 for 13,600 dots and fewer, from there on
/// in proportion to 1 / sqrt(dots), kFewestUsualSteps for 40,000 and more; none where dots lie closer than
/// the eye can tell apart on paper and are so many that they would be waited for.
int usual_steps(double dots, double picture_area_mm2);

/// The longest side of a page, 100 m: a longer one is a slip of the keyboard, or comes of a picture one pixel
/// wide.
inline constexpr double kLongestSideMm = 100'000;
/// The shortest side of a page, of a region, or of what margins leave: finer than any pen.
inline constexpr double kShortestSideMm = 0.01;

/// The range of a dot's radius.
inline constexpr double kSmallestRadiusMm = 1e-6, kLargestRadiusMm = 1000;

/// A template of one's own for G-code. Its text, so that a drawing needs no other file.
struct OwnTemplate {
    std::string text = {};  // as parse_gcode_template() reads it; empty: there is none
    std::string file = {};  // that it was read from, to be shown

    bool operator==(const OwnTemplate&) const = default;
};

/// How the drawing is saved, beside how it looks.
struct SavingChoice {
    std::optional<DotOrder> order = {};   // none: the usual one; pixels have none
    double dpi = 300;                     // of pixels
    GcodeTool tool = GcodeTool::pen;      // that G-code is for
    std::optional<Machine> machine = {};  // that plotting times are told for; none: usual_machine()
    int bits = 8;                         // a channel of them: 8 or 16
    OwnTemplate gcode_template = {};      // instead of the tool's
    // For G-code. The first two are written into it; the third only serves to tell how long it takes.
    double feed_mm_per_min = 3000, dwell_s = 0.1, acceleration_mm_per_s2 = 10;
    std::optional<double> pen_up = {}, pen_down = {};  // as GcodeHeights; none: usual_heights()
    double laser_power = 250;                          // the S of G-code for a laser
    // For several pens, see separations.h:
    bool separations = false;  // in pixels: a grey picture for each too
    bool pen_files = false;    // as lines: a file for each in place of one for all
    // A part of the page, in mm from its upper left corner; none: all of it. Several sheets are of the whole.
    std::optional<Rectangle<double>> region = {};

    bool operator==(const SavingChoice&) const = default;
};

/// All of them: how a drawing looks, and how it is saved.
struct Settings {
    DrawingSettings drawing = {};
    SavingChoice saving = {};
    std::string embedded = {};  // what files keep of them, as read_json() has it; empty: none
};

/// The tile drawn with: settings.tile. But in place of the default one, which is of several kinds, it is the
/// paper's own where the placer is the paper's, and the turned one of as many points where the ranking is for
/// a tile of one kind.
std::string tile_in_use(const DrawingSettings& settings);

}  // namespace dapple
