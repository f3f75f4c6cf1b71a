#pragma once
// Everything that decides how a drawing looks. One value: the viewer's panels edit it, the command line fills
// it, and the same settings give the same dots in both.

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "core/drawing/page_setup.h"
#include "core/drawing/request.h"
#include "core/image/colour.h"
#include "core/image/detail.h"
#include "core/image/mask.h"
#include "core/output/gcode.h"
#include "core/output/plotting_time.h"
#include "core/output/sheet.h"
#include "core/placing/dot_order.h"
#include "core/tile/ranking.h"

namespace dapple {

inline constexpr std::uint64_t kDefaultDots = 40'000;

/// The built-in tile whose pictures look best.
inline constexpr const char* kDefaultTile = "kinds4096";

/// The strength at which automatic tone keeps most of both what is dark and what is light: in eleven
/// photographs, drawings follow the darkest and the lightest third of a photograph better with it than
/// without.
inline constexpr double kUsualToneStrength = 0.6;

/// The longest side of a page, 100 m: a longer one is a slip of the keyboard, or comes of a picture one pixel
/// wide.
inline constexpr double kLongestSideMm = 100'000;
/// The shortest side of a page, of a region, or of what margins leave: finer than any pen.
inline constexpr double kShortestSideMm = 0.01;

/// The range of a dot's radius.
inline constexpr double kSmallestRadiusMm = 1e-6, kLargestRadiusMm = 1000;

/// Which tile dots are placed with, and in which colours and parts they are drawn.
struct DrawnWith {
    std::string tile = kDefaultTile;       // a name for tile_named()
    std::optional<RankingMethod> ranking;  // none: the tile's own
    Sheet sheets;               // all of these are saved, each in a file of its own, rather than the page
    bool registration = false;  // several pens draw crosses too: see registration_marks()
    glm::vec3 ink = kBlack;     // sRGB-encoded, 0..1; several pens have colours of their own
    bool background = false;    // paint the paper under an SVG's dots
    bool show_tiles = false;    // the boundaries of the tiles, coloured by level

    bool operator==(const DrawnWith&) const = default;
};

struct DrawingSettings : DrawingRequest, DrawnWith {
    DrawingSettings() {
        tone_strength = kUsualToneStrength;
        tone.detail = kAutoDetail;
        placing = {.count = kDefaultDots, .threads = 0};
    }

    bool operator==(const DrawingSettings&) const = default;
};

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

/// The tile drawn with: settings.tile. But in place of the default one, which is of several kinds, it is the
/// paper's own where the placer is the paper's, and the turned one of as many points where the ranking is for
/// a tile of one kind.
std::string tile_in_use(const DrawingSettings& settings);

}  // namespace dapple
