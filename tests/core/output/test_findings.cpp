// What someone should know of a drawing before it is plotted, from the facts alone.

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/output/drawing_format.h"
#include "core/output/findings.h"

using namespace dapple;

namespace {

// 10,000 dots of a plotted drawing, with which all is well.
DrawingFacts good_facts() {
    DrawingFacts facts{.dots = 10'000,
                       .ink = {.as = DotsAs::touches, .radius_mm = 0.5, .stroke_width_mm = 0.3},
                       .page = {200, 150, 200}};
    facts.measured = Preflight{.pen_up_m = 20, .nearest_mm = 1};
    facts.machine = Machine::axidraw_v3;
    facts.plotting = {.moving_s = 600, .lifting_s = 2400};
    return facts;
}

std::vector<FindingKind> kinds_of(const DrawingFacts& facts) {
    std::vector<FindingKind> kinds;
    for (const Finding& finding : findings_of(facts)) {
        CHECK_FALSE(finding.text.empty());
        CHECK_FALSE(finding.cure.empty());
        CHECK_FALSE(name_of(finding.kind).empty());
        kinds.push_back(finding.kind);
    }
    return kinds;
}

using Kinds = std::vector<FindingKind>;

std::string sentences_of(const DrawingFacts& facts) {
    std::string all;
    for (const Finding& finding : findings_of(facts)) all += sentence_of(finding) + "\n";
    return all;
}

}  // namespace

TEST_CASE("of a drawing with which all is well nothing is said, and of one without dots neither") {
    CHECK(kinds_of(good_facts()).empty());
    DrawingFacts none = good_facts();
    none.dots = 0;
    none.has_tile_layer = true;
    CHECK(kinds_of(none).empty());
}

TEST_CASE("it is told where Grbl rests for longer than it is asked to, or needs its laser mode") {
    DrawingFacts facts = good_facts();
    for (const double kept : {0.0, 0.05, 0.1, 0.15, 0.55, 1.0}) {
        facts.dwell_s = kept;
        CHECK(kinds_of(facts).empty());
    }
    facts.dwell_s = 0.01;
    CHECK(sentences_of(facts) ==
          "Grbl will rest 0.05 s instead of 0.01 s, as it rounds up to 0.05 s. Set the dwell to 0.05 s\n");
    facts.dwell_s = 0.12;
    CHECK(findings_of(facts).at(0).amount == doctest::Approx(0.15));
    facts.dwell_s = 0;
    facts.burst_s = 0.01;
    CHECK(sentences_of(facts) ==
          "Bursts of 0.01 s will burn 0.05 mm by M4, as no G4 is that short. Turn on Grbl's laser mode "
          "($32=1)\n");
}

TEST_CASE("a line that goes straight over bare paper is told from a tenth of the page on") {
    DrawingFacts facts = good_facts();
    facts.ink.as = DotsAs::lines;
    facts.longest_link_mm = 14.9;
    CHECK(kinds_of(facts).empty());
    facts.longest_link_mm = 15.1;
    CHECK(kinds_of(facts) == Kinds{FindingKind::long_link});
    CHECK(sentences_of(facts).starts_with("The line will cross bare paper for 15 mm"));
}

TEST_CASE("dots that run into others are told from one in a hundred on, however a pen draws them") {
    for (const DotsAs as : {DotsAs::touches, DotsAs::shapes, DotsAs::lines}) {
        DrawingFacts facts = good_facts();
        facts.ink.as = as;
        facts.measured->overlapping = 99;
        CHECK(kinds_of(facts).empty());
        facts.measured->overlapping = 4000;
        CHECK(kinds_of(facts) == Kinds{FindingKind::overlap});
        CHECK(sentences_of(facts).find("40 % of the dots") != std::string::npos);
    }
    DrawingFacts printed = good_facts();
    printed.ink.as = DotsAs::printed;
    printed.measured->overlapping = 4000;
    CHECK(kinds_of(printed).empty());
}

TEST_CASE("circles are told as rings that a plotter follows, how long they are and what else there is") {
    DrawingFacts facts = good_facts();
    facts.ink.as = DotsAs::rings;
    facts.measured->rings_m = 31.4;
    CHECK(kinds_of(facts) == Kinds{FindingKind::rings});
    CHECK(sentences_of(facts).find("A plotter would draw outlines only. Choose the dot shape point") !=
          std::string::npos);
}

TEST_CASE("where a single dot takes longer than an hour nobody is told to draw none") {
    DrawingFacts facts = good_facts();
    facts.plotting = {.dots_s = 3.0 * kLongPlottingS};
    facts.dots = 2;
    CHECK(sentences_of(facts).find("Use shorter rests and faster moves") != std::string::npos);
}

TEST_CASE("layers of an SVG that no pen is to draw are told, as most plotters' programs draw them") {
    DrawingFacts facts = good_facts();
    facts.has_tile_layer = facts.has_background = true;
    CHECK(kinds_of(facts) == Kinds{FindingKind::tile_layer, FindingKind::background});
    CHECK(sentences_of(facts).find("will plot the layer \"% Tiles\". Hide that layer") != std::string::npos);
}

TEST_CASE("hours of plotting come with how many dots take one") {
    DrawingFacts facts = good_facts();
    facts.plotting = {.moving_s = 3600, .lifting_s = 3 * 3600};
    CHECK(kinds_of(facts) == Kinds{FindingKind::hours});
    CHECK(sentences_of(facts).find("about 4 h on an AxiDraw V3, mostly raising and lowering the pen. Use "
                                   "2,500 dots to plot for about an hour, or one line") != std::string::npos);
    facts.machine.reset();
    CHECK(kinds_of(facts).empty());
}

TEST_CASE(
    "dots that programs join come with how many are far enough from each other, or how wide a page parts "
    "them") {
    DrawingFacts facts = good_facts();
    facts.is_svg = true;
    facts.measured->nearer_than_saxi = 9000;
    facts.measured->first_percentile_mm = 0.25;
    CHECK(kinds_of(facts) == Kinds{FindingKind::joined});
    // Half the distance: a quarter of the dots, and some to spare.
    CHECK(findings_of(facts)[0].amount == 2400);
    CHECK(sentences_of(facts).find("Use 2,400 dots or a page 106 % wider") != std::string::npos);
    facts.whole_page = false;  // it would be the sheet's count
    CHECK(findings_of(facts)[0].amount == 0);
    CHECK(sentences_of(facts).find("Use fewer dots or a wider page") != std::string::npos);
}

TEST_CASE("more dots than programs read, and more than are looked at, are told with what can be done") {
    DrawingFacts facts = good_facts();
    facts.is_svg = true;
    facts.dots = kMostSvgElements;
    CHECK(kinds_of(facts).empty());
    facts.dots = kMostSvgElements + 1;
    CHECK(kinds_of(facts) == Kinds{FindingKind::too_many});
    CHECK(findings_of(facts)[0].amount == kMostSvgElements);
    facts.is_svg = false;
    CHECK(kinds_of(facts).empty());
    facts.measured.reset();
    CHECK(kinds_of(facts) == Kinds{FindingKind::not_looked});
    facts.is_svg = true;
    facts.ink.as = DotsAs::lines;
    facts.dots = kMostSvgPathDots + 1;
    CHECK(kinds_of(facts) == Kinds{FindingKind::too_many, FindingKind::not_looked});
}

TEST_CASE("a page that the machine does not reach is told, lying or upright, and A4 is not") {
    DrawingFacts facts = good_facts();
    for (const PageSize& page : {PageSize{297, 210, 297}, PageSize{210, 297, 297}}) {
        facts.page = page;
        CHECK(kinds_of(facts).empty());
    }
    facts.page = {297, 420, 420};
    CHECK(kinds_of(facts) == Kinds{FindingKind::too_large});
    facts.machine = Machine::axidraw_se_a3;
    CHECK(kinds_of(facts).empty());
    facts.machine = Machine::grbl_pen;  // which may be of any size
    facts.page = {5000, 5000, 5000};
    CHECK(kinds_of(facts).empty());
    facts.reach_mm = kHpglReachMm;
    CHECK(sentences_of(facts) ==
          "The page, 5000 x 5000 mm, is larger than the 819 mm that HPGL plotters can read. Use a smaller "
          "page or several sheets\n");
}

TEST_CASE("dots over the page's edge and in its margins are told, of a sheet too") {
    DrawingFacts facts = good_facts();
    facts.ink = {.as = DotsAs::printed, .radius_mm = 0.44};
    facts.measured->over_edge = 1;
    facts.measured->outside_margins = 7;
    CHECK(kinds_of(facts) == Kinds{FindingKind::over_edge});
    CHECK(sentences_of(facts) == "1 dot reaches over the page's edge. Use automatic margins, or 0.5 mm\n");
    facts.has_margins = true;
    CHECK(kinds_of(facts) == Kinds{FindingKind::over_edge, FindingKind::in_margins});
    facts.whole_page = false;
    CHECK(kinds_of(facts) == Kinds{FindingKind::over_edge, FindingKind::in_margins});
}

TEST_CASE("near dots are told where programs join them, and a pen's where its gap says so") {
    DrawingFacts facts = good_facts();
    facts.measured->nearer_than_saxi = 300;
    facts.measured->nearer_than_axidraw = 20;
    CHECK(kinds_of(facts).empty());
    facts.is_svg = true;
    CHECK(kinds_of(facts) == Kinds{FindingKind::joined});
    CHECK(sentences_of(facts).find("300 dots are closer than 0.5 mm; saxi would join them") !=
          std::string::npos);
    facts.pens = {{"Gel", 5000, 1.2, 45}, {"Fine", 5000, 0.3, 0}};
    CHECK(kinds_of(facts) == Kinds{FindingKind::gap, FindingKind::joined});
    CHECK(sentences_of(facts).find("45 of Gel's dots are closer than its smallest gap of 1.2 mm") !=
          std::string::npos);
}

TEST_CASE("a pen that draws hardly any of the dots is told, where a pen draws them") {
    DrawingFacts facts = good_facts();
    facts.pens = {{"Cyan", 49}, {"Magenta", 50}, {"Yellow", 0}, {"Black", 9901}};
    CHECK(kinds_of(facts) == Kinds{FindingKind::few});
    CHECK(sentences_of(facts).find("Cyan draws only 49 of the dots. Remove that pen") == 0);
    facts.ink.as = DotsAs::printed;
    CHECK(kinds_of(facts).empty());
    facts.ink.as = DotsAs::touches;
    facts.whole_page = false;  // another sheet may have more of them
    CHECK(kinds_of(facts).empty());
}

TEST_CASE("a drawing far from the picture's tone is told with the dots, or the radius, that would reach it") {
    DrawingFacts facts = good_facts();
    facts.for_tone = DrawingFacts::Tone{14'000, 0.2};
    CHECK(kinds_of(facts).empty());
    facts.for_tone = DrawingFacts::Tone{80'000, 0.42};
    CHECK(sentences_of(facts) ==
          "The drawing will look paler than the picture. Use 80,000 dots 0.3 mm wide, or make these dots "
          "0.84 mm wide\n");
}

TEST_CASE("dots finer than a pixel are told with the resolution that shows each") {
    DrawingFacts facts = good_facts();
    facts.ink = {.as = DotsAs::printed, .radius_mm = 0.1};
    facts.machine.reset();
    facts.dpi = 150;
    CHECK(kinds_of(facts).empty());
    facts.dpi = 100;
    CHECK(kinds_of(facts) == Kinds{FindingKind::fine_pixels});
    CHECK(sentences_of(facts).find("260 pixels per inch") != std::string::npos);
}
