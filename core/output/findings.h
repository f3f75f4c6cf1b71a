#pragma once
// What someone who is about to plot or print a drawing should know of it, each with its cure. The command,
// its --stats and the window all show this list.

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/export.h"
#include "core/image/rectangle.h"
#include "core/output/plotting_time.h"
#include "core/placing/dots.h"
#include "core/placing/page.h"
#include "core/placing/placer.h"
#include "core/text/names.h"

namespace dapple {

// What becomes of a drawing's dots on paper, measured before it is plotted: how near they are to each other
// and to the edges. core/output/findings.h says what of it someone should know.

/// Path ends nearer than this, in millimetres, are joined: the pen stays down between the two dots.
inline constexpr double kSaxiJoins = 0.5;
inline constexpr double kAxiDrawJoins = 0.152;

struct Preflight {
    double pen_up_m = 0;                 // the pen's way from dot to dot, in the order given, in metres
    double nearest_mm = 0;               // smallest distance between two dots; infinite if there are not two
    double first_percentile_mm = 0;      // one dot in a hundred has another one nearer than this; or infinite
    std::uint64_t nearer_than_saxi = 0;  // dots with another one nearer than kSaxiJoins
    std::uint64_t nearer_than_axidraw = 0;
    std::uint64_t overlapping = 0;      // dots that reach into others; of unequal radii into near ones
    double rings_m = 0;                 // all dots' outlines, in metres: what a plotter traces of circles
    std::uint64_t over_edge = 0;        // dots that reach over the page's edge, each as far as its own radius
    std::uint64_t outside_margins = 0;  // dots with a part outside of what the margins leave

    bool operator==(const Preflight&) const = default;
};

/// Dots, of that radius or of their own, in the order of plotting, as seen from `corner_mm` on the page, in
/// millimetres. The margins leave that rectangle of the page; none: all of it. For a part of a page, `paper`
/// is the whole, as seen from the part's corner. What reaches over it by less than a thousandth of a
/// millimetre, which is as much as files round to, is within. A million take a fraction of a second.
Preflight preflight(const Dots& dots, const PageSize& page, double dot_radius_mm,
                    const std::optional<Rectangle<double>>& within_margins = {},
                    glm::dvec2 corner_mm = glm::dvec2(0), const std::optional<Rectangle<double>>& paper = {});

/// How a drawing's dots come onto the paper.
enum class DotsAs {
    printed,  // pixels, or what a printer fills
    rings,    // a plotter follows the outlines of circles
    touches,  // the pen goes down and up
    shapes,   // drawn with the pen's line
    lines,    // from dot to dot
    listed,   // not at all: a table
};

/// How far the ink of dots reaches.
struct InkedDot {
    DotsAs as = DotsAs::printed;
    double radius_mm = 0;             // of dots that have none of their own
    double stroke_width_mm = 0;       // of the pen that touches, or draws shapes or lines
    std::vector<double> widths_mm{};  // of each pen, where several have widths of their own

    double reach_mm(double own_radius_mm, int pen) const;
    bool operator==(const InkedDot&) const = default;
};

/// All dots of a stream, each as large as the disc that its ink lies in: `radius` is left empty where all are
/// alike, and InkedDot::reach_mm() is theirs.
Dots inked_dots(const DotStream& dots, const InkedDot& inked, const PageSize& page);

/// What is known of a drawing and of the file that it goes into.
struct DrawingFacts {
    std::uint64_t dots = 0;
    InkedDot ink = {};
    std::optional<Preflight> measured = {};  // none: there are too many dots to look at each
    bool is_svg = false;                     // which programs read path by path, and join near ones
    bool has_tile_layer = false;             // with the tiles' outlines
    bool has_background = false;             // a shape as large as the page
    bool whole_page = true;                  // rather than a sheet or a region
    bool has_margins = false;
    PageSize page = {};
    double dpi = 0;                       // of pixels; 0: there are none
    double reach_mm = 0;                  // of the places that the file can name; 0: far enough
    std::optional<Machine> machine = {};  // none: it is not plotted
    PlottingTime plotting = {};
    struct OfPen {
        std::string name;
        std::uint64_t dots = 0;
        double gap_mm = 0;         // its smallest,
        std::uint64_t nearer = 0;  // and how many of its dots are nearer to each other
    };
    std::vector<OfPen> pens = {};  // those that draw, of several
    struct Tone {
        double dots = 0;       // that would give the picture's tone with their radius,
        double radius_mm = 0;  // and the radius that would with these dots
    };
    std::optional<Tone> for_tone = {};  // of round dots with a fixed radius
    double dwell_s = 0;                 // that G-code asks for where it rests; 0: it does not
    double burst_s = 0;                 // of a laser that moves for it; 0: it does not
    struct Gcode {
        std::vector<std::string> uncounted = {};  // see GcodeProgram
        bool no_time = false;                     // at a dot the tool is turned there and back at once
        bool milliseconds = false;                // {dwell} is read as that, and in seconds it is written
        double lines_per_s = 0,
               most_lines_per_s = 0;  // of lines; that a serial line carries. 0: there are none
    };
    Gcode gcode = {};
    double longest_link_mm = 0;  // from dot to dot of one line through all; 0: there is none
};

enum class FindingKind {
    hours,         // plotting takes long
    tone,          // paler or darker than the picture
    rings,         // a plotter follows outlines
    overlap,       // dots run into others
    gap,           // a pen's dots are nearer than its smallest gap
    few,           // a pen has hardly any dots
    joined,        // programs draw a line between near dots
    long_link,     // the line crosses bare paper
    over_edge,     // dots reach over the page's edge
    in_margins,    // or into the margins
    too_large,     // a page that the machine or the file's numbers do not reach
    too_many,      // for programs that read the file
    not_looked,    // too many to look at each
    fine_pixels,   // dots finer than a pixel
    tile_layer,    // its lines might be plotted
    background,    // its outline might be
    dwell,         // Grbl rests longer, or needs its laser mode
    no_time,       // a tool is turned and turned back at once
    milliseconds,  // a rest is read in other units
    serial,        // more lines a second than a serial line carries
    uncounted,     // of a template's words some take a time that is not known
};
constexpr auto names_of(FindingKind) {
    return names("hours", "tone", "rings", "overlap", "gap", "few", "joined", "long_link", "over_edge",
                 "in_margins", "too_large", "too_many", "not_looked", "fine_pixels", "tile_layer",
                 "background", "dwell", "no_time", "milliseconds", "serial", "uncounted");
}

/// Whether it is about plotters, lasers and their programs, rather than about what is seen.
constexpr bool is_about_machines(FindingKind kind) {
    using enum FindingKind;
    return kind >= tile_layer || kind == hours || kind == rings || kind == overlap || kind == few ||
           kind == joined || kind == too_large;
}

struct Finding {
    FindingKind kind{};
    std::string text, cure;  // each a sentence without its full stop
    double amount = 0;       // that the cure speaks of: dots, millimetres or dots per inch; 0: none

    bool operator==(const Finding&) const = default;
};

/// "40 % of the dots will overlap others. Use fewer dots"
DAPPLE_API std::string sentence_of(const Finding& finding);

/// From this many seconds on plotting is said to take long.
inline constexpr double kLongPlottingS = 2 * 3600;

/// From this share of the page's shorter side on a line from dot to dot is told: it is seen as a line where
/// the others are seen as a tone.
inline constexpr double kLongLink = 0.1;

/// Of the serial line over which Grbl 1.1 is sent its lines, as it comes (BAUD_RATE in its config.h).
inline constexpr int kSerialBaud = 115'200;

/// So many elements, and no more, are read by librsvg, which rsvg-convert and many desktops show an SVG by
/// ("cannot load more than 1000000 XML elements"); and by libxml2 no attribute longer than ten million
/// letters, which a path through more dots than the other number is.
inline constexpr std::uint64_t kMostSvgElements = 1'000'000, kMostSvgPathDots = 600'000;

/// The most important first; nothing where all is well.
std::vector<Finding> findings_of(const DrawingFacts& facts);

}  // namespace dapple
