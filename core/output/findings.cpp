#include "core/output/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "core/analysis/distances.h"
#include "core/output/gcode.h"
#include "core/routing/near_dots.h"
#include "core/text/number_words.h"

namespace dapple {

namespace {

std::uint64_t overlapping_unequal(const Dots& dots) {
    const std::vector<std::uint32_t> near = near_dots(dots.x, dots.y);
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < dots.size(); ++i) {
        const auto first = near.begin() + static_cast<long>(i * kNearDots);
        count += std::any_of(first, first + static_cast<long>(kNearDots), [&](std::uint32_t k) {
            const double across = double(dots.x[i]) - dots.x[k], down = double(dots.y[i]) - dots.y[k];
            return k != i && std::hypot(across, down) < double(dots.radius[i]) + dots.radius[k];
        });
    }
    return count;
}

constexpr double kRounding = 1e-3;  // mm

double least_inside(const Rectangle<double>& area, glm::dvec2 p) {
    return std::min({p.x - area.low.x, p.y - area.low.y, area.high.x - p.x, area.high.y - p.y});
}

}  // namespace

Preflight preflight(const Dots& dots, const PageSize& page, double dot_radius_mm,
                    const std::optional<Rectangle<double>>& within_margins, glm::dvec2 corner_mm,
                    const std::optional<Rectangle<double>>& paper) {
    std::vector<glm::dvec2> places(dots.size());
    glm::dvec2 low(0), high(page.width_mm, page.height_mm);
    for (std::size_t i = 0; i < dots.size(); ++i) {
        places[i] = glm::dvec2(dots.x[i], dots.y[i]) * page.mm_per_page_unit + corner_mm;
        low = glm::min(low, places[i]);
        high = glm::max(high, places[i]);
    }
    constexpr double kNone = std::numeric_limits<double>::infinity();
    Preflight result{.nearest_mm = kNone, .first_percentile_mm = kNone};
    for (std::size_t i = 1; i < places.size(); ++i)
        result.pen_up_m += glm::distance(places[i - 1], places[i]) / 1000;
    const Rectangle<double> whole =
                                paper.value_or(Rectangle<double>{{0, 0}, {page.width_mm, page.height_mm}}),
                            within = within_margins.value_or(whole);
    double radii_mm = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double radius = dots.radius.empty() ? dot_radius_mm : dots.radius[i] * page.mm_per_page_unit;
        result.over_edge += least_inside(whole, places[i]) < radius - kRounding;
        result.outside_margins += least_inside(within, places[i]) < radius - kRounding;
        radii_mm += radius;
    }
    // Dots reach in from beyond a part, and one can lie a hair beyond a page.
    for (glm::dvec2& place : places) place -= low;
    const Domain domain{high.x - low.x, high.y - low.y, Topology::window};
    std::vector<double> nearest = nearest_distances(places, domain);
    for (const double distance : nearest) {
        result.nearest_mm = std::min(result.nearest_mm, distance);
        if (dots.radius.empty()) result.overlapping += distance < 2 * dot_radius_mm;
        result.nearer_than_saxi += distance < kSaxiJoins;
        result.nearer_than_axidraw += distance < kAxiDrawJoins;
    }
    if (nearest.size() > 1) {
        const auto first_percentile = nearest.begin() + static_cast<long>(nearest.size() / 100);
        std::nth_element(nearest.begin(), first_percentile, nearest.end());
        result.first_percentile_mm = *first_percentile;
    }
    if (!dots.radius.empty()) result.overlapping = overlapping_unequal(dots);
    result.rings_m = 2 * std::numbers::pi * radii_mm / 1000;
    return result;
}

double InkedDot::reach_mm(double own_radius_mm, int pen) const {
    const auto i = static_cast<std::size_t>(pen);
    const double half = (i < widths_mm.size() ? widths_mm[i] : stroke_width_mm) / 2;
    if (as == DotsAs::touches || as == DotsAs::lines) return half;
    return as == DotsAs::shapes ? std::max(own_radius_mm, half) : own_radius_mm;
}

Dots inked_dots(const DotStream& dots, const InkedDot& inked, const PageSize& page) {
    const double unit = page.mm_per_page_unit, usual = inked.reach_mm(inked.radius_mm, 0);
    Dots all;
    all.reserve(dots.count, false);
    bool alike = true;
    std::vector<float> reaches;
    dots.for_each_piece([&](const Dots& piece) {
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const double own = piece.radius.empty() ? inked.radius_mm : piece.radius[i] * unit;
            const double reach = inked.reach_mm(own, piece.pen);
            all.x.push_back(piece.x[i]);
            all.y.push_back(piece.y[i]);
            reaches.push_back(static_cast<float>(reach / unit));
            // Radii are kept as floats.
            alike = alike && std::abs(reach - usual) < 1e-6 * usual;
        }
        return true;
    });
    if (!alike) all.radius.assign(reaches.begin(), reaches.end());
    return all;
}

namespace {

void tell(std::vector<Finding>& found, FindingKind kind, std::string text, std::string cure,
          double amount = 0) {
    found.push_back({kind, std::move(text), std::move(cure), amount});
}

constexpr double kTold = 0.01;  // of the dots: what befalls fewer is not worth a word

double share_of(std::uint64_t some, const DrawingFacts& facts) {
    return static_cast<double>(some) / std::max(static_cast<double>(facts.dots), 1.0);
}

bool is_drawn_by_pen(const DrawingFacts& facts) {
    return facts.ink.as != DotsAs::printed && facts.ink.as != DotsAs::listed;
}

std::string dots_that(std::uint64_t count, const char* one, const char* many) {
    return fmt::format("{} {}", dots_in_words(count), count == 1 ? one : many);
}

void add_hours(std::vector<Finding>& found, const DrawingFacts& facts) {
    const double seconds = facts.plotting.total_s();
    if (!facts.machine || seconds < kLongPlottingS) return;
    double amount = in_two_digits(static_cast<double>(facts.dots) * 3600 / seconds);
    std::string cure = fmt::format("{} dots take about an hour", about(amount));
    const bool lifts = facts.plotting.lifting_s > seconds / 2;
    if (facts.ink.as == DotsAs::lines) {
        cure = "fewer dots make a shorter line";
        amount = 0;
    } else if (amount < 2) {
        cure = "shorter rests and faster moves take less";
        amount = 0;
    } else if (lifts)
        cure += ", and one line through all dots lifts the pen once";
    tell(found, FindingKind::hours,
         fmt::format("plotting takes {} on {}, {}", time_in_words(seconds), words_for(*facts.machine),
                     what_takes_longest(facts.plotting)),
         std::move(cure), amount);
}

void add_tone(std::vector<Finding>& found, const DrawingFacts& facts) {
    if (!facts.for_tone || facts.dots == 0 || !facts.whole_page) return;
    const double ratio = facts.for_tone->dots / static_cast<double>(facts.dots);
    if (!far_from_tone(ratio)) return;
    const double own = facts.ink.reach_mm(facts.ink.radius_mm, 0);
    tell(
        found, FindingKind::tone,
        fmt::format("the drawing is {} than the picture", ratio > 1 ? "paler" : "darker"),
        fmt::format("{} dots {} wide would give its tone, or these dots {} wide", about(facts.for_tone->dots),
                    millimetres_in_words(2 * own), millimetres_in_words(2 * facts.for_tone->radius_mm)),
        in_two_digits(facts.for_tone->dots));
}

void add_ink(std::vector<Finding>& found, const DrawingFacts& facts) {
    const Preflight& measured = *facts.measured;
    if (facts.ink.as == DotsAs::rings && facts.dots > 0)
        tell(found, FindingKind::rings,
             fmt::format("a plotter follows the circles' outlines: {} of rings",
                         way_in_words(measured.rings_m)),
             "with the dot shape point it touches the paper once for each, and a spiral or a hatch fills "
             "them");
    const double share = share_of(measured.overlapping, facts);
    if (is_drawn_by_pen(facts) && share >= kTold) {
        const bool lines = facts.ink.as == DotsAs::lines;
        tell(found, FindingKind::overlap,
             fmt::format("{:.0f} % of the dots {}, with ink up to {} wide", std::ceil(100 * share - 1e-9),
                         lines ? "are so near to others that the lines run together" : "overlap others",
                         millimetres_in_words(2 * facts.ink.reach_mm(facts.ink.radius_mm, 0))),
             lines || facts.ink.as == DotsAs::touches ? "fewer dots, a wider page or a finer pen part them"
                                                      : "fewer dots, a wider page or smaller dots part them");
    }
}

void add_pens(std::vector<Finding>& found, const DrawingFacts& facts) {
    constexpr double kFew = 0.005;  // of all dots
    for (const DrawingFacts::OfPen& pen : facts.pens) {
        if (pen.nearer > 0)
            tell(found, FindingKind::gap,
                 fmt::format("{} of {}'s dots are nearer to each other than its smallest gap of {:g} mm, and "
                             "run together",
                             grouped(pen.nearer), pen.name, pen.gap_mm),
                 "fewer dots or a wider page part them");
        const bool draws_few = pen.dots > 0 && share_of(pen.dots, facts) < kFew;
        if (draws_few && facts.whole_page && is_drawn_by_pen(facts))
            tell(found, FindingKind::few,
                 fmt::format("{} draws only {} of the dots", pen.name, grouped(pen.dots)),
                 "without that pen the drawing looks nearly the same, and one change of pens is saved");
    }
}

void add_joined(std::vector<Finding>& found, const DrawingFacts& facts) {
    const Preflight& measured = *facts.measured;
    if (!facts.is_svg || facts.ink.as == DotsAs::lines) return;
    if (share_of(measured.nearer_than_saxi, facts) <= kTold) return;
    // Distances go with the square root of the room that a dot has; the last of them, a little less.
    const double wider = 1.03 * kSaxiJoins / std::max(measured.first_percentile_mm, 1e-9);
    const double apart =
        facts.whole_page ? in_two_digits(static_cast<double>(facts.dots) / (wider * wider)) : 0;
    tell(found, FindingKind::joined,
         fmt::format("{} {} nearer to others than {:g} mm, which saxi joins by a line, and {} nearer than "
                     "{:g} mm, which AxiDraw's program does",
                     dots_in_words(measured.nearer_than_saxi), measured.nearer_than_saxi == 1 ? "is" : "are",
                     kSaxiJoins, grouped(measured.nearer_than_axidraw), kAxiDrawJoins),
         apart >= 1 ? fmt::format("{} dots or a page {:.1f} times as wide part them", about(apart), wider)
                    : std::string("fewer dots or a wider page part them"),
         apart);
}

void add_long_link(std::vector<Finding>& found, const DrawingFacts& facts) {
    if (facts.longest_link_mm < kLongLink * std::min(facts.page.width_mm, facts.page.height_mm)) return;
    if (facts.ink.as == DotsAs::listed || facts.dots < 100) return;
    tell(found, FindingKind::long_link,
         fmt::format("the line goes {:.0f} mm straight over bare paper from one dot to another",
                     facts.longest_link_mm),
         "more dots, or less white in the lightest parts, lead it there in short steps");
}

void add_edges(std::vector<Finding>& found, const DrawingFacts& facts) {
    if (facts.ink.as == DotsAs::listed) return;
    const Preflight& measured = *facts.measured;
    const double reach = std::ceil(facts.ink.reach_mm(facts.ink.radius_mm, 0) * 10) / 10;
    if (measured.over_edge > 0)
        tell(found, FindingKind::over_edge,
             dots_that(measured.over_edge, "reaches", "reach") + " over the page's edge",
             fmt::format("a margin of {:.1f} mm or an automatic one keeps them on it", reach), reach);
    if (facts.has_margins && measured.outside_margins > 0)
        tell(found, FindingKind::in_margins,
             dots_that(measured.outside_margins, "reaches", "reach") + " into the margins",
             fmt::format("margins wider by {:.1f} mm keep them out", reach), reach);
}

// How far a machine's pen reaches, the longer side first; nothing where machines of its kind differ. AxiDraws
// by axidraw_conf.py.
struct MachineTravel {
    double longer_mm = 0, shorter_mm = 0;
};
std::optional<MachineTravel> travel_of(Machine machine) {
    if (machine == Machine::axidraw_v3) return MachineTravel{11.81 * kMmPerInch, 8.58 * kMmPerInch};
    if (machine == Machine::axidraw_se_a3) return MachineTravel{16.93 * kMmPerInch, 11.69 * kMmPerInch};
    return std::nullopt;
}

void add_travel(std::vector<Finding>& found, const DrawingFacts& facts) {
    const double longest = std::max(facts.page.width_mm, facts.page.height_mm);
    if (facts.reach_mm > 0 && longest > facts.reach_mm)
        tell(found, FindingKind::too_large,
             fmt::format("the page, {:.0f} x {:.0f} mm, is larger than the {:.0f} mm up to which pen "
                         "plotters read HPGL's numbers",
                         facts.page.width_mm, facts.page.height_mm, std::floor(facts.reach_mm)),
             "a smaller page or several sheets fit");
    if (!facts.machine) return;
    const auto travel = travel_of(*facts.machine);
    if (!travel) return;
    const double width = facts.page.width_mm, height = facts.page.height_mm;
    // What the machine is said to reach is rounded; half a millimetre is no reason to worry anyone.
    if (std::max(width, height) <= travel->longer_mm + 0.5 &&
        std::min(width, height) <= travel->shorter_mm + 0.5)
        return;
    tell(found, FindingKind::too_large,
         fmt::format("the page, {:.0f} x {:.0f} mm, is larger than the {:.0f} x {:.0f} mm that {} reaches",
                     width, height, travel->longer_mm, travel->shorter_mm, words_for(*facts.machine)),
         "a smaller page or several sheets fit");
}

void add_numbers(std::vector<Finding>& found, const DrawingFacts& facts) {
    if (facts.is_svg) {
        const bool lines = facts.ink.as == DotsAs::lines;
        const std::uint64_t most = lines ? kMostSvgPathDots : kMostSvgElements;
        if (facts.dots > most)
            tell(found, FindingKind::too_many,
                 fmt::format("rsvg-convert and the many programs that show an SVG as it does refuse {}",
                             lines ? fmt::format("a line through more than about {} dots", grouped(most))
                                   : fmt::format("more than {} dots", grouped(most))),
                 "they do read fewer dots, a region, sheets or a PDF",
                 facts.whole_page ? static_cast<double>(most) : 0);
    }
    if (!facts.measured && facts.ink.as != DotsAs::listed)
        tell(found, FindingKind::not_looked,
             "there are too many dots to check how near they are to each other and to the edges",
             "a region of the page can be checked");
}

void add_pixels(std::vector<Finding>& found, const DrawingFacts& facts) {
    const double width = 2 * facts.ink.reach_mm(facts.ink.radius_mm, 0);
    if (!(facts.dpi > 0) || !(width > 0) || width * facts.dpi >= kMmPerInch) return;
    const double dpi = std::ceil(2 * kMmPerInch / width / 10) * 10;
    tell(found, FindingKind::fine_pixels,
         fmt::format("dots {} wide are finer than a pixel, and come out as greys",
                     millimetres_in_words(width)),
         fmt::format("{:.0f} dots per inch or more show each", dpi), dpi);
}

void add_dwell(std::vector<Finding>& found, const DrawingFacts& facts) {
    const double rest = grbl_rest_s(facts.dwell_s);
    if (rest > 1.01 * facts.dwell_s)
        tell(found, FindingKind::dwell,
             fmt::format("Grbl rests {:g} s where {:g} s are asked for, as it rounds up to {:g} s", rest,
                         facts.dwell_s, kGrblRestStepS),
             fmt::format("with a dwell of {:g} s the file says what the machine does", rest), rest);
    if (facts.burst_s > 0)
        tell(found, FindingKind::dwell,
             fmt::format("bursts of {:g} s are burned by M4 along {:g} mm, as no G4 is that short",
                         facts.burst_s, kBurstMm),
             "Grbl needs its laser mode for that, which $32=1 turns on");
}

void add_gcode(std::vector<Finding>& found, const DrawingFacts& facts) {
    const DrawingFacts::Gcode& gcode = facts.gcode;
    if (gcode.no_time)
        tell(found, FindingKind::no_time,
             "at each dot the tool is turned there and back at once: a servo has no time to lower the pen, "
             "and a laser none to burn",
             "a rest between the two, such as G4 P{dwell} with a dwell above 0, gives it some");
    if (gcode.milliseconds)
        tell(found, FindingKind::milliseconds,
             "M280 is Marlin's, which reads the number after G4 P as milliseconds, and {dwell} is in seconds",
             "G4 S{dwell} rests as long as it says");
    if (gcode.lines_per_s > gcode.most_lines_per_s)
        tell(found, FindingKind::serial,
             fmt::format(
                 "the machine wants {} lines of G-code a second, and a serial line of {} baud carries {}",
                 about(gcode.lines_per_s), grouped(kSerialBaud), about(gcode.most_lines_per_s)),
             "a lower --feed or a file on the machine's own card keeps it from waiting at each");
    for (const std::string& word : gcode.uncounted)
        tell(found, FindingKind::uncounted,
             fmt::format("the time does not count what {} of the template takes", word),
             "G0, G1 and G4 are counted");
}

}  // namespace

std::string sentence_of(const Finding& finding) {
    return finding.text + "; " + finding.cure;
}

std::vector<Finding> findings_of(const DrawingFacts& facts) {
    std::vector<Finding> found;
    if (facts.dots == 0) return found;
    add_hours(found, facts);
    add_tone(found, facts);
    if (facts.measured) {
        add_ink(found, facts);
        add_pens(found, facts);
        add_joined(found, facts);
        add_edges(found, facts);
    }
    add_long_link(found, facts);
    add_travel(found, facts);
    add_numbers(found, facts);
    add_pixels(found, facts);
    if (facts.has_tile_layer)
        tell(found, FindingKind::tile_layer,
             "the layer \"% Tiles\" has lines, which AxiDraw's software skips and other programs plot",
             "hide that layer, or leave the tile boundaries out");
    if (facts.has_background)
        tell(found, FindingKind::background,
             "the layer \"% Background\" is a shape as large as the page, which AxiDraw's software skips and "
             "other programs plot",
             "hide that layer, or leave the background out");
    add_dwell(found, facts);
    add_gcode(found, facts);
    return found;
}

}  // namespace dapple
