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
    std::string cure = fmt::format("Use {} dots to plot for about an hour", about(amount));
    const bool lifts = facts.plotting.lifting_s > seconds / 2;
    if (facts.ink.as == DotsAs::lines) {
        cure = "Use fewer dots for a shorter line";
        amount = 0;
    } else if (amount < 2) {
        cure = "Use shorter rests and faster moves";
        amount = 0;
    } else if (lifts)
        cure += ", or one line through all dots, which lifts the pen once";
    tell(found, FindingKind::hours,
         fmt::format("Plotting takes {} on {}, {}", time_in_words(seconds), words_for(*facts.machine),
                     what_takes_longest(facts.plotting)),
         std::move(cure), amount);
}

void add_tone(std::vector<Finding>& found, const DrawingFacts& facts) {
    if (!facts.for_tone || facts.dots == 0 || !facts.whole_page) return;
    const double ratio = facts.for_tone->dots / static_cast<double>(facts.dots);
    if (!far_from_tone(ratio)) return;
    const double own = facts.ink.reach_mm(facts.ink.radius_mm, 0);
    tell(found, FindingKind::tone,
         fmt::format("The drawing will look {} than the picture", ratio > 1 ? "paler" : "darker"),
         fmt::format("Use {} dots {} wide, or make these dots {} wide", about(facts.for_tone->dots),
                     millimetres_in_words(2 * own), millimetres_in_words(2 * facts.for_tone->radius_mm)),
         in_two_digits(facts.for_tone->dots));
}

void add_ink(std::vector<Finding>& found, const DrawingFacts& facts) {
    const Preflight& measured = *facts.measured;
    if (facts.ink.as == DotsAs::rings && facts.dots > 0)
        tell(found, FindingKind::rings, "A plotter would draw outlines only",
             "Choose the dot shape point, or fill with a spiral or hatch");
    const double share = share_of(measured.overlapping, facts);
    if (is_drawn_by_pen(facts) && share >= kTold) {
        const bool lines = facts.ink.as == DotsAs::lines;
        tell(found, FindingKind::overlap,
             fmt::format("{:.0f} % of the dots will {}, with ink up to {} wide",
                         std::ceil(100 * share - 1e-9), lines ? "make lines run together" : "overlap others",
                         millimetres_in_words(2 * facts.ink.reach_mm(facts.ink.radius_mm, 0))),
             lines || facts.ink.as == DotsAs::touches ? "Use fewer dots, a wider page or a finer pen"
                                                      : "Use fewer dots, a wider page or smaller dots");
    }
}

void add_pens(std::vector<Finding>& found, const DrawingFacts& facts) {
    constexpr double kFew = 0.005;  // of all dots
    for (const DrawingFacts::OfPen& pen : facts.pens) {
        if (pen.nearer > 0)
            tell(found, FindingKind::gap,
                 fmt::format(
                     "{} of {}'s dots are closer than its smallest gap of {:g} mm and will run together",
                     grouped(pen.nearer), pen.name, pen.gap_mm),
                 "Use fewer dots or a wider page");
        const bool draws_few = pen.dots > 0 && share_of(pen.dots, facts) < kFew;
        if (draws_few && facts.whole_page && is_drawn_by_pen(facts))
            tell(found, FindingKind::few,
                 fmt::format("{} draws only {} of the dots", pen.name, grouped(pen.dots)),
                 "Remove that pen to save a pen change; the drawing will look nearly the same");
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
         fmt::format("{} {} closer than {:g} mm; saxi would join them",
                     dots_in_words(measured.nearer_than_saxi), measured.nearer_than_saxi == 1 ? "is" : "are",
                     kSaxiJoins),
         apart >= 1 ? fmt::format("Use {} dots or a page {:.0f} % wider", about(apart), 100 * (wider - 1))
                    : std::string("Use fewer dots or a wider page"),
         apart);
}

void add_long_link(std::vector<Finding>& found, const DrawingFacts& facts) {
    if (facts.longest_link_mm < kLongLink * std::min(facts.page.width_mm, facts.page.height_mm)) return;
    if (facts.ink.as == DotsAs::listed || facts.dots < 100) return;
    tell(found, FindingKind::long_link,
         fmt::format("The line will cross bare paper for {:.0f} mm", facts.longest_link_mm),
         "Use more dots, or darken the lightest areas, for shorter steps");
}

void add_edges(std::vector<Finding>& found, const DrawingFacts& facts) {
    if (facts.ink.as == DotsAs::listed) return;
    const Preflight& measured = *facts.measured;
    const double reach = std::ceil(facts.ink.reach_mm(facts.ink.radius_mm, 0) * 10) / 10;
    if (measured.over_edge > 0)
        tell(found, FindingKind::over_edge,
             dots_that(measured.over_edge, "reaches", "reach") + " over the page's edge",
             fmt::format("Use automatic margins, or {:.1f} mm", reach), reach);
    if (facts.has_margins && measured.outside_margins > 0)
        tell(found, FindingKind::in_margins,
             dots_that(measured.outside_margins, "reaches", "reach") + " into the margins",
             fmt::format("Widen the margins by {:.1f} mm", reach), reach);
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
             fmt::format(
                 "The page, {:.0f} x {:.0f} mm, is larger than the {:.0f} mm that HPGL plotters can read",
                 facts.page.width_mm, facts.page.height_mm, std::floor(facts.reach_mm)),
             "Use a smaller page or several sheets");
    if (!facts.machine) return;
    const auto travel = travel_of(*facts.machine);
    if (!travel) return;
    const double width = facts.page.width_mm, height = facts.page.height_mm;
    // What the machine is said to reach is rounded; half a millimetre is no reason to worry anyone.
    if (std::max(width, height) <= travel->longer_mm + 0.5 &&
        std::min(width, height) <= travel->shorter_mm + 0.5)
        return;
    tell(found, FindingKind::too_large,
         fmt::format("The page, {:.0f} x {:.0f} mm, is larger than the {:.0f} x {:.0f} mm that {} reaches",
                     width, height, travel->longer_mm, travel->shorter_mm, words_for(*facts.machine)),
         "Use a smaller page or several sheets");
}

void add_numbers(std::vector<Finding>& found, const DrawingFacts& facts) {
    if (facts.is_svg) {
        const bool lines = facts.ink.as == DotsAs::lines;
        const std::uint64_t most = lines ? kMostSvgPathDots : kMostSvgElements;
        if (facts.dots > most)
            tell(found, FindingKind::too_many,
                 fmt::format("Many SVG programs, such as rsvg-convert, will refuse {}",
                             lines ? fmt::format("a line through more than about {} dots", grouped(most))
                                   : fmt::format("more than {} dots", grouped(most))),
                 "Use fewer dots, a region, sheets or a PDF",
                 facts.whole_page ? static_cast<double>(most) : 0);
    }
    if (!facts.measured && facts.ink.as != DotsAs::listed)
        tell(found, FindingKind::not_looked,
             "There are too many dots to check how close they are to each other and to the edges",
             "Export a region to have it checked");
}

void add_pixels(std::vector<Finding>& found, const DrawingFacts& facts) {
    const double width = 2 * facts.ink.reach_mm(facts.ink.radius_mm, 0);
    if (!(facts.dpi > 0) || !(width > 0) || width * facts.dpi >= kMmPerInch) return;
    const double dpi = std::ceil(2 * kMmPerInch / width / 10) * 10;
    tell(found, FindingKind::fine_pixels,
         fmt::format("Dots {} wide are finer than a pixel and will come out as greys",
                     millimetres_in_words(width)),
         fmt::format("Use {:.0f} pixels per inch or more", dpi), dpi);
}

void add_dwell(std::vector<Finding>& found, const DrawingFacts& facts) {
    const double rest = grbl_rest_s(facts.dwell_s);
    if (rest > 1.01 * facts.dwell_s)
        tell(found, FindingKind::dwell,
             fmt::format("Grbl will rest {:g} s instead of {:g} s, as it rounds up to {:g} s", rest,
                         facts.dwell_s, kGrblRestStepS),
             fmt::format("Set the dwell to {:g} s", rest), rest);
    if (facts.burst_s > 0)
        tell(found, FindingKind::dwell,
             fmt::format("Bursts of {:g} s will burn {:g} mm by M4, as no G4 is that short", facts.burst_s,
                         kBurstMm),
             "Turn on Grbl's laser mode ($32=1)");
}

void add_gcode(std::vector<Finding>& found, const DrawingFacts& facts) {
    const DrawingFacts::Gcode& gcode = facts.gcode;
    if (gcode.no_time)
        tell(found, FindingKind::no_time,
             "The tool will turn there and back at once: a servo has no time to lower the pen, nor a laser "
             "to burn",
             "Add a rest between the two, such as G4 P{dwell} with a dwell above 0");
    if (gcode.milliseconds)
        tell(found, FindingKind::milliseconds,
             "M280 is Marlin's, which will read the number after G4 P as milliseconds; {dwell} is in seconds",
             "Use G4 S{dwell}");
    if (gcode.lines_per_s > gcode.most_lines_per_s)
        tell(found, FindingKind::serial,
             fmt::format(
                 "The machine will wait at dots: it needs {} lines of G-code a second, and {} baud carry {}",
                 about(gcode.lines_per_s), grouped(kSerialBaud), about(gcode.most_lines_per_s)),
             "Use a lower --feed, or run the file from the machine's card");
    for (const std::string& word : gcode.uncounted)
        tell(found, FindingKind::uncounted, fmt::format("The time leaves out {} of the template", word),
             "Use G0, G1 and G4, which are counted");
}

}  // namespace

std::string sentence_of(const Finding& finding) {
    return finding.text + ". " + finding.cure;
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
        tell(found, FindingKind::tile_layer, "Programs other than AxiDraw's will plot the layer \"% Tiles\"",
             "Hide that layer, or the tile boundaries");
    if (facts.has_background)
        tell(found, FindingKind::background,
             "Programs other than AxiDraw's will plot the layer \"% Background\", a shape as large as the "
             "page",
             "Hide that layer, or leave out the background");
    add_dwell(found, facts);
    add_gcode(found, facts);
    return found;
}

}  // namespace dapple
