// How long a machine plots, against planners that are not ours: one that goes through what was written in
// small steps, and the figures that the AxiDraw's own program gives.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <random>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "core/drawing/write_drawing.h"
#include "core/output/pen_figures.h"
#include "core/output/plotting_time.h"
#include "core/output/test_sheet.h"
#include "core/placing/dot_order.h"
#include "core/routing/short_way.h"

namespace dapple {
namespace {

Dots scattered_dots(int count) {
    Dots dots;
    std::mt19937 random(8);
    std::uniform_real_distribution<float> place(0.1f, 0.9f);
    for (int i = 0; i < count; ++i) {
        dots.x.push_back(place(random));
        dots.y.push_back(place(random));
    }
    sort_dots(dots, DotOrder::space);
    shorten_way(dots);
    return dots;
}

// A machine that reads G-code and goes from place to place in steps of a hundredth of a millimetre: at none
// of them faster than its feed, than a corner lets it, than it can have become since it stood and can lose
// until it stands.
class SteppedMachine {
 public:
    SteppedMachine(double feed_mm_per_min, double acceleration)
        : rapid_(feed_mm_per_min / 60), feed_(rapid_), acceleration_(acceleration) {}

    double seconds_for(const std::string& gcode) {
        std::istringstream lines(gcode);
        for (std::string line; std::getline(lines, line);)
            read(std::regex_replace(line, std::regex(R"(\(.*\)|;.*)"), ""));
        stand();
        return seconds_;
    }

 private:
    void read(const std::string& line) {
        static const std::regex word(R"(([A-Z])\s*([-0-9.]+))");
        glm::dvec3 to = place_;
        bool dwell = false;
        for (std::sregex_iterator it(line.begin(), line.end(), word), end; it != end; ++it) {
            const char letter = (*it)[1].str()[0];
            const double number = std::stod((*it)[2]);
            if (letter == 'G' && number <= 1) fast_ = number == 0;
            if (letter == 'G' && number >= 90 && number <= 91) relative_ = number == 91;
            dwell |= letter == 'G' && number == 4;
            if (letter == 'M' || dwell) stand();
            if (letter == 'P' && dwell) seconds_ += 0.05 * std::ceil(number / 0.05 - 1e-9);  // as Grbl rounds
            if (letter == 'F') feed_ = number / 60;
            if (letter >= 'X' && letter <= 'Z')
                to[letter - 'X'] = number + (relative_ ? to[letter - 'X'] : 0);
        }
        go(to);
    }

    void go(glm::dvec3 to) {
        const double mm = glm::distance(place_, to), top = fast_ ? rapid_ : feed_;
        if (mm == 0) return;
        const glm::dvec3 direction = (to - place_) / mm;
        place_ = to;
        if (most_.empty())
            most_.push_back(0);
        else {
            // A circle that comes as near to the corner as 0.01 mm, followed at the acceleration.
            const double half =
                (std::numbers::pi - std::acos(std::clamp(glm::dot(direction, last_), -1.0, 1.0))) / 2;
            const double radius = 0.01 * std::sin(half) / (1 - std::sin(half));
            most_.back() = std::min({most_.back(), top, std::sqrt(acceleration_ * radius)});
        }
        const int steps = static_cast<int>(std::ceil(mm / 0.01));
        step_.insert(step_.end(), static_cast<std::size_t>(steps), mm / steps);
        most_.insert(most_.end(), static_cast<std::size_t>(steps), top);
        last_ = direction;
    }

    void stand() {
        if (most_.empty()) return;
        most_.back() = 0;
        const auto reached = [&](double from, double mm) {
            return std::sqrt(from * from + 2 * acceleration_ * mm);
        };
        for (std::size_t i = 0; i < step_.size(); ++i)
            most_[i + 1] = std::min(most_[i + 1], reached(most_[i], step_[i]));
        for (std::size_t i = step_.size(); i-- > 0;)
            most_[i] = std::min(most_[i], reached(most_[i + 1], step_[i]));
        for (std::size_t i = 0; i < step_.size(); ++i) seconds_ += 2 * step_[i] / (most_[i] + most_[i + 1]);
        most_.clear();
        step_.clear();
    }

    double rapid_, feed_, acceleration_, seconds_ = 0;
    bool fast_ = false, relative_ = false;
    glm::dvec3 place_{0}, last_{0};
    std::vector<double> most_, step_;  // speeds between the steps, and their lengths
};

struct Times {
    double told = 0, taken = 0;
};

DrawingFile gcode_file(const DrawingSettings& settings, const SavingChoice& saving) {
    return {.format = DrawingFormat::gcode, .settings = settings, .saving = saving};
}

Times times_of(const DrawingToSave& drawing) {
    const auto strokes = strokes_of(drawing);
    const MachineProgram program = program_for(Machine::grbl_pen, drawing).program;
    const PlottingTime told = strokes ? figures_of(*strokes, program).time
                                      : plotting_time(drawing.dots, drawing.page.mm_per_page_unit, program);
    std::ostringstream written;
    write_as(DrawingFormat::gcode, written, ink_page(drawing));
    const SavingChoice& saving = drawing.file.saving;
    SteppedMachine machine(saving.feed_mm_per_min, saving.acceleration_mm_per_s2);
    return {told.total_s(), machine.seconds_for(written.str())};
}

struct Tried {
    std::string name;
    SavingChoice saving = {};
};

std::vector<Tried> tried_machines() {
    return {{"pen", {.tool = GcodeTool::pen}},
            {"servo", {.tool = GcodeTool::servo, .feed_mm_per_min = 6000, .acceleration_mm_per_s2 = 800}},
            {"laser", {.tool = GcodeTool::laser, .acceleration_mm_per_s2 = 500}},
            {"short bursts", {.tool = GcodeTool::laser, .dwell_s = 0.01, .acceleration_mm_per_s2 = 500}}};
}

}  // namespace

TEST_CASE("the time told for G-code is what a machine takes that goes through the file in small steps") {
    const Dots dots = scattered_dots(150);
    const PageSize page{60, 60, 60};
    std::vector<std::pair<std::string, DrawingSettings>> drawings(6);
    drawings[0].first = "dots";
    drawings[1] = {"line", {}};
    drawings[1].second.style = DrawingStyle::line;
    drawings[2] = {"nearest", {}};
    drawings[2].second.style = DrawingStyle::nearest;
    const std::array shapes{DotShape::ring, DotShape::spiral, DotShape::hatch};
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        drawings[3 + i].first = names_of(DotShape{})[static_cast<std::size_t>(shapes[i])];
        drawings[3 + i].second.mark.shape = shapes[i];
    }
    for (auto& [name, settings] : drawings) settings.pen_width_mm = 0.4;
    for (const Tried& machine : tried_machines()) {
        CAPTURE(machine.name);
        for (const auto& drawn : drawings) {
            CAPTURE(drawn.first);
            const Times times = times_of({.file = gcode_file(drawn.second, machine.saving),
                                          .dots = stream_of(dots),
                                          .page = page,
                                          .dot_radius_mm = 1.5});
            CHECK(times.told == doctest::Approx(times.taken).epsilon(0.01));
        }
    }
}

TEST_CASE("the time told for sheets and for several pens with their crosses is what such a machine takes") {
    const PageSize page{210, 150, 210};
    const Palette pens = parse_pens("A:#000:0.3,B:#f00:0.5").own;
    TestSheet sheet = test_sheet(pens, page);
    DrawingSettings settings;
    settings.registration = true;
    for (const Tried& machine : tried_machines()) {
        CAPTURE(machine.name);
        DrawingToSave drawing{
            .file = gcode_file(settings, machine.saving), .dots = {}, .page = page, .pens = pens};
        drawing.strokes = stream_of(sheet.strokes, 0.3);
        const Times whole = times_of(drawing);
        CHECK(whole.told == doctest::Approx(whole.taken).epsilon(0.01));
        const Strokes part = cut_to({{70, 0}, {140, 150}}, stream_of(sheet.strokes, 0.3));
        drawing.strokes = stream_of(part, 0.3);
        drawing.page = {70, 150, 210};
        const Times of_sheet = times_of(drawing);
        CHECK(of_sheet.told == doctest::Approx(of_sheet.taken).epsilon(0.01));
        CHECK(of_sheet.told < whole.told);
    }
}

TEST_CASE("the time told for a template of one's own is what its words take") {
    const Dots dots = scattered_dots(40);
    const auto times = [&](const std::string& text) {
        DrawingToSave drawing{
            .file = gcode_file({}, {}), .dots = stream_of(dots), .page = {60, 60, 60}, .dot_radius_mm = 0.5};
        drawing.file.saving.gcode_template.text = text;
        drawing.file.saving.acceleration_mm_per_s2 = 200;
        return times_of(drawing);
    };
    for (const char* const text :
         {"move G1 X{x} Y{y}\ndot M3 S90\ndot G4 P5\ndot M5\n",
          "start G1 F900\nmove G0 X{x}Y{y}\ndot G1 Z-3 F60\ndot G4 P0.11\ndot G0 Z5\nend G0 X0 Y0\n",
          "move G1 X{x} Y{y} F1200 (there G4 P100) ; and back\ndot G91 G1 X0.4 F100\ndot G90\n"}) {
        CAPTURE(std::string(text));
        const Times found = times(text);
        CHECK(found.told == doctest::Approx(found.taken).epsilon(0.01));
    }
    // Marlin's words, by hand: 40 rests of 300 ms and 40 of half a second.
    const double moves = times("move G1 X{x} Y{y}\ndot M5\n").told;
    CHECK(times("move G1 X{x} Y{y}\ndot M280 P0 S40\ndot G4 P300\ndot M280 P0 S90\ndot G4 S0.5\n").told ==
          doctest::Approx(moves + 40 * 0.8));
}

TEST_CASE("what a template leaves out or another machine reads otherwise is told") {
    const auto kinds = [](const std::string& text, double segments = 0, double drawing_s = 1) {
        SavingChoice saving{.dwell_s = 0};
        if (text == "servo" || text == "laser")
            saving.tool = text == "servo" ? GcodeTool::servo : GcodeTool::laser;
        else
            saving.gcode_template.text = text;
        const GcodeProgram gcode = program_for(
            Machine::grbl_pen, {.file = gcode_file({}, saving), .dots = {}, .page = {60, 60, 60}});
        std::vector<FindingKind> found;
        for (const Finding& finding :
             findings_of({.dots = 9, .gcode = gcode_facts(gcode, segments, drawing_s)}))
            if (finding.kind != FindingKind::not_looked) found.push_back(finding.kind);
        return found;
    };
    using enum FindingKind;
    using Kinds = std::vector<FindingKind>;
    CHECK(kinds("servo") == Kinds{no_time});
    CHECK(kinds("laser") == Kinds{no_time});
    CHECK(kinds("move G1 X{x} Y{y}\ndot M3 S90\ndot M3 S20\n") == Kinds{no_time});
    CHECK(kinds("move G1 X{x} Y{y}\ndot M3 S90\ndot G4 P0.2\ndot M3 S20\n").empty());
    CHECK(kinds("move G1 X{x} Y{y}\ndot M4 S90\ndot G1 X1\ndot M5\n").empty());
    const std::string marlin = "move G1 X{x} Y{y}\ndot M280 P0 S9\ndot G4 P{dwell}\n";
    CHECK(kinds(marlin) == Kinds{milliseconds});
    CHECK(kinds("move G1 X{x} Y{y}\ndot M280 P0 S9\ndot G4 S{dwell}\n").empty());
    CHECK(kinds("start G28\nmove G1 X{x} Y{y}\ndot G2 X1 Y1 I1\n") == Kinds{uncounted, uncounted});
    // 11,520 bytes a second, and a line is "G1 X123.456 Y123.456 F3000" or a little less.
    const std::string lines = "move G0 X{x} Y{y}\ndot M5\ndown M3\nline G1 X{x} Y{y} F3000\nup M5\n";
    CHECK(kinds(lines, 450, 1) == Kinds{serial});
    CHECK(kinds(lines, 400, 1).empty());
    CHECK_THROWS_WITH(kinds("start g20\nmove G1 X{x} Y{y}\n"),
                      "line 1: G20 says that numbers are inches, but {x} and {y} are millimetres; write G21");
    CHECK(kinds("start M200\nmove G1 X{x} Y{y} ;G20\n").empty());
}

TEST_CASE("an AxiDraw's moves take what its own program sends them in") {
    const MachineProgram program = program_of(Machine::axidraw_v3);
    // Seconds of millimetres, by compute_segment() of motion.py, version 3.9; it rounds to milliseconds.
    const std::array up{glm::dvec2(0.5, 0.084), glm::dvec2(1, 0.118),  glm::dvec2(2, 0.167),
                        glm::dvec2(4, 0.237),   glm::dvec2(6, 0.290),  glm::dvec2(7, 0.130),
                        glm::dvec2(10, 0.156),  glm::dvec2(20, 0.252), glm::dvec2(50, 0.464),
                        glm::dvec2(200, 1.460)};
    for (const glm::dvec2 known : up) {
        const double mm = known.x, seconds = known.y;
        CAPTURE(mm);
        MachineClock clock(program);
        clock.dot({0, 0});
        clock.dot({mm, 0});
        CHECK(clock.finish().moving_s == doctest::Approx(seconds).epsilon(0.03));
    }
    // By plan_trajectory(): a zigzag, a spiral, a circle of 60 sides and a small one of 16.
    std::vector<glm::dvec2> zigzag, spiral, circle, small;
    const auto around = [](double turns) {
        return glm::dvec2(std::cos(2 * std::numbers::pi * turns), std::sin(2 * std::numbers::pi * turns));
    };
    for (int i = 0; i <= 40; ++i) zigzag.emplace_back(2 * i, i % 2 * 3);
    for (int i = 0; i < 200; ++i)
        spiral.push_back(0.01 * i * glm::dvec2(std::cos(0.3 * i), std::sin(0.3 * i)));
    for (int i = 0; i <= 60; ++i) circle.push_back(10.0 * around(i / 60.0));
    for (int i = 0; i <= 16; ++i) small.push_back(0.4 * around(i / 16.0));
    const auto drawn = [&](const std::vector<glm::dvec2>& points) {
        MachineClock clock(program);
        clock.stroke(points);
        return clock.finish().drawing_s;
    };
    CHECK(drawn(zigzag) == doctest::Approx(8.264).epsilon(0.03));
    CHECK(drawn(spiral) == doctest::Approx(1.221).epsilon(0.03));
    CHECK(drawn(circle) == doctest::Approx(1.296).epsilon(0.03));
    CHECK(drawn(small) == doctest::Approx(0.090).epsilon(0.03));
}

TEST_CASE("the time expected before the order is known is about that of a short way") {
    const Dots dots = scattered_dots(5000);
    for (const Machine machine :
         {Machine::axidraw_v3, Machine::idraw, Machine::grbl_pen, Machine::grbl_laser}) {
        const MachineProgram program = program_of(machine);
        const PlottingTime time = plotting_time(stream_of(dots), 200, program);
        CHECK(expected_plotting_time(5000, 160 * 160, program).total_s() ==
              doctest::Approx(time.total_s()).epsilon(0.1));
    }
    CHECK(what_takes_longest(plotting_time(stream_of(dots), 200, program_of(Machine::axidraw_v3))) ==
          "mostly raising and lowering the pen");
}

TEST_CASE("a time is told as people say it") {
    CHECK(time_in_words(0) == "about 1 s");
    CHECK(time_in_words(40) == "about 40 s");
    CHECK(time_in_words(12 * 60 + 10) == "about 12 min");
    CHECK(time_in_words(3 * 3600 + 19 * 60) == "about 3 h 20 min");
    CHECK(time_in_words(7199) == "about 2 h");
}

}  // namespace dapple
