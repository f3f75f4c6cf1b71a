#include "core/output/plotting_time.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/text/number_words.h"

namespace dapple {

namespace {

constexpr double PlottingTime::*kMoving = &PlottingTime::moving_s;
constexpr double PlottingTime::*kLifting = &PlottingTime::lifting_s;
constexpr double PlottingTime::*kDots = &PlottingTime::dots_s;
constexpr double PlottingTime::*kDrawing = &PlottingTime::drawing_s;

// Seconds that an AxiDraw's servo takes over 30 % of its travel, at a rate in percent.
double axidraw_lift_s(double rate) {
    const double travel = 30, servo_ms = 2.69 * travel + 45, sweep_ms = 200 * travel / rate;
    return std::pow(std::pow(servo_ms, 4) + std::pow(sweep_ms, 4), 0.25) / 1000;
}

struct Speeds {
    double up = 0, down = 0;  // mm/s, of moves and of lines
    double lower_s = 0, raise_s = 0, dot_s = 0;
};

// Goes to a place, rests, draws from rest to rest.
MachineProgram program_with(const Speeds& speeds, MachineProgram motion) {
    using enum MachineStep::To;
    const auto to_point = [](double speed, double PlottingTime::*part) {
        return MachineStep{.axes = {{{point_x}, {point_y}}}, .speed = speed, .part = part};
    };
    const MachineStep lower{.rest_s = speeds.lower_s, .part = kLifting},
        raise{.rest_s = speeds.raise_s, .part = kLifting}, rest{.rest_s = speeds.dot_s, .part = kDots};
    motion.move = {to_point(speeds.up, kMoving)};
    motion.down = {lower};
    motion.line = {to_point(speeds.down, kDrawing)};
    motion.up = {raise};
    motion.dot = {motion.move[0], lower, rest, raise};
    motion.top_speed = speeds.up;
    return motion;
}

// As the AxiDraw's program makes a move of pieces that last `slice`: short ones begin at half of the speed
// that they could reach and slow down from there, and the shortest have one speed (compute_segment()).
double sliced_seconds(double mm, double from, double to, double top, double acceleration, double slice) {
    const double gaining = (top * top - from * from) / (2 * acceleration),
                 losing = (top * top - to * to) / (2 * acceleration), ramps = gaining + losing;
    if (mm > ramps + slice * top && mm > 4 * slice * top)
        return (2 * top - from - to) / acceleration + (mm - ramps) / top;
    if (ramps <= 0) return mm / top;
    const double used = std::min(0.9 * ramps / mm, 1.0) * acceleration;
    double gain_s = (std::sqrt(2 * from * from + 2 * to * to + 4 * used * mm) - 2 * from) / (2 * used);
    const double peak = from + used * gain_s;
    if (gain_s < slice) gain_s = 0;
    const double lose_s = gain_s - (to - from) / used;
    const auto pieces = [&](double seconds) { return std::floor(seconds / slice); };
    if (pieces(gain_s) + pieces(lose_s) > 4) return gain_s + (lose_s < slice ? 0 : lose_s);
    const double first = (peak + from) / 2, change = (to * to - first * first) / (2 * mm);
    const double ramp_s = change == 0 ? 0 : (to - first) / std::clamp(change, -acceleration, acceleration);
    if (pieces(ramp_s) > 1) return ramp_s;
    return mm / std::max(change == 0 ? first : peak, to);
}

}  // namespace

MachineProgram program_of(Machine machine) {
    const double grbl_speed = 500.0 / 60;
    MachineProgram motion{.acceleration = 10,
                          .drawing_acceleration = 10,
                          .corner_mm = kGrblCornerMm,
                          .look_ahead = kGrblLookAhead};
    switch (machine) {
        case Machine::axidraw_v3:
        case Machine::axidraw_se_a3: {
            const double full = 8.6979 * kMmPerInch / 110;
            motion = {.acceleration = 0.75 * 60 * kMmPerInch,
                      .drawing_acceleration = 0.75 * 40 * kMmPerInch,
                      .corner_mm = 10 / 5000.0 * kMmPerInch,
                      .slice_s = 0.025};
            return program_with({75 * full, 25 * full, axidraw_lift_s(50), axidraw_lift_s(75)}, motion);
        }
        case Machine::idraw: {
            const double full = 24950 / 2032.0 * kMmPerInch / 110, ramp_s = 0.2, lift_s = 20 / 150.0;
            motion = {.acceleration = 75 * full / ramp_s,
                      .drawing_acceleration = 25 * full / ramp_s,
                      .corner_mm = 2 / 1000.0 * kMmPerInch};
            return program_with({75 * full, 25 * full, lift_s, lift_s}, motion);
        }
        case Machine::grbl_pen:
            return program_with({grbl_speed, grbl_speed, axidraw_lift_s(100), axidraw_lift_s(100)}, motion);
        case Machine::grbl_laser:
            return program_with({.up = grbl_speed, .down = grbl_speed, .dot_s = 0.1}, motion);
    }
    return {};
}

MachineClock::MachineClock(const MachineProgram& program)
    : program_(program), known_(program.from_origin), speed_(program.top_speed) {
    run(program.start);
}

void MachineClock::dot(glm::dvec2 place) {
    run(program_.dot, place);
}

void MachineClock::stroke(std::span<const glm::dvec2> points) {
    if (points.size() == 1) return dot(points[0]);
    run(program_.move, points[0]);
    run(program_.down, points[0]);
    for (const glm::dvec2 point : points.subspan(1)) run(program_.line, point);
    run(program_.up, points.back());
}

void MachineClock::take(int pen) {
    if (pen == pen_) return;
    pen_ = pen;
    if (program_.several_pens) run(program_.pen);
    for (const CutMark& mark : program_.registration) stroke(std::array{mark.from, mark.to});
}

PlottingTime MachineClock::finish() {
    run(program_.end);
    make(ahead_.size());
    return time_;
}

void MachineClock::run(const MachineSteps& steps, glm::dvec2 point) {
    for (const MachineStep& step : steps) {
        if (step.speed) speed_ = *step.speed;
        if (step.rapid) rapid_ = *step.rapid;
        if (step.relative) relative_ = *step.relative;
        if (step.rest_s) {
            make(ahead_.size());
            time_.*step.part += *step.rest_s;
        }
        go(step, point);
    }
}

void MachineClock::go(const MachineStep& step, glm::dvec2 point) {
    if (program_.page_height_mm > 0) point.y = program_.page_height_mm - point.y;
    glm::dvec3 to = place_;
    bool moves = false;
    for (int axis = 0; axis < 3; ++axis) {
        const MachineStep::Axis& given = step.axes[static_cast<std::size_t>(axis)];
        if (given.to == MachineStep::To::stays) continue;
        moves = true;
        const double mm = given.to == MachineStep::To::number    ? given.mm
                          : given.to == MachineStep::To::point_x ? point.x
                                                                 : point.y;
        to[axis] = relative_ ? place_[axis] + mm : mm;
        if (program_.grid_mm > 0) to[axis] = std::round(to[axis] / program_.grid_mm) * program_.grid_mm;
    }
    if (!moves) return;
    const glm::dvec3 way = to - place_;
    place_ = to;
    if (!known_) {
        known_ = true;
        return;
    }
    Move move{.mm = glm::length(way),
              .top = rapid_ ? program_.top_speed : speed_,
              .acceleration = step.part == kDrawing ? program_.drawing_acceleration : program_.acceleration,
              .part = step.part};
    if (!(move.mm > 0) || !(move.top > 0)) return;
    move.direction = way / move.mm;
    if (!ahead_.empty()) {
        const Move& last = ahead_.back();
        const double cosine = std::clamp(glm::dot(last.direction, move.direction), -1.0, 1.0);
        const double sine = std::sqrt((1 + cosine) / 2);  // of half the angle between the two
        const double corner = sine < 1 ? move.acceleration * program_.corner_mm * sine / (1 - sine)
                                       : std::numeric_limits<double>::infinity();
        move.most_at_begin = std::min({corner, move.top * move.top, last.top * last.top});
    }
    ahead_.push_back(move);
    if (program_.look_ahead > 0 && ahead_.size() > program_.look_ahead) make(1);
}

// Those that come first. All that are planned end at rest.
void MachineClock::make(std::size_t moves) {
    if (moves == 0) return;
    most_.assign(ahead_.size() + 1, 0.0);
    for (std::size_t i = ahead_.size(); i-- > 1;) {
        const Move& move = ahead_[i];
        most_[i] = std::min(move.most_at_begin, most_[i + 1] + 2 * move.acceleration * move.mm);
    }
    for (std::size_t i = 0; i < moves; ++i) {
        const Move& move = ahead_[i];
        const double end = std::min(most_[i + 1], now_ + 2 * move.acceleration * move.mm);
        time_.*move.part += seconds_for(move, std::sqrt(now_), std::sqrt(end));
        now_ = end;
    }
    ahead_.erase(ahead_.begin(), ahead_.begin() + static_cast<std::ptrdiff_t>(moves));
    // Whatever follows begins a plan of its own, or the corner of what is left.
    if (ahead_.empty()) now_ = 0;
}

// From one speed to another, both of which can be reached: faster in between, as far as there is room.
double MachineClock::seconds_for(const Move& move, double from, double to) const {
    const auto& [direction, mm, top, acceleration, most, part] = move;
    if (program_.slice_s > 0) return sliced_seconds(mm, from, to, top, acceleration, program_.slice_s);
    const double peak = std::min(top, std::sqrt((2 * acceleration * mm + from * from + to * to) / 2));
    const double gaining = (peak * peak - from * from) / (2 * acceleration),
                 losing = (peak * peak - to * to) / (2 * acceleration);
    return (peak - from) / acceleration + (peak - to) / acceleration +
           std::max(mm - gaining - losing, 0.0) / peak;
}

PlottingTime plotting_time(const DotStream& dots, double mm_per_page_unit, const MachineProgram& program) {
    MachineClock clock(program);
    dots.for_each_piece([&](const Dots& piece) {
        if (piece.size() > 0) clock.take(piece.pen);
        for (std::size_t i = 0; i < piece.size(); ++i)
            clock.dot(glm::dvec2(piece.x[i], piece.y[i]) * mm_per_page_unit);
        return true;
    });
    return clock.finish();
}

PlottingTime expected_plotting_time(double dots, double area_mm2, const MachineProgram& program) {
    if (dots < 1) return {};
    // Around a square, as the way turns all the time.
    const double mm = 0.75 * std::sqrt(area_mm2 / dots);
    MachineClock clock(program);
    clock.dot({0, 0});
    const PlottingTime before = clock.time();
    const int kDotsTimed = 8;
    for (int i = 1; i <= kDotsTimed; ++i) clock.dot({(i + 1) / 2 % 2 * mm, i / 2 % 2 * mm});
    const auto of_each = [&](double PlottingTime::*part) {
        return dots * (clock.time().*part - before.*part) / kDotsTimed;
    };
    return {of_each(kMoving), of_each(kLifting), of_each(kDots), of_each(kDrawing)};
}

std::string_view words_for(Machine machine) {
    // In the order of Machine.
    constexpr std::array kWords{"an AxiDraw V3", "an AxiDraw SE/A3", "an iDraw",
                                "a pen plotter that runs Grbl", "a laser that runs Grbl"};
    static_assert(kWords.size() == names_of(Machine()).size());
    return kWords[static_cast<std::size_t>(machine)];
}

std::string time_in_words(double seconds) {
    if (seconds < 59.5) return fmt::format("about {:.0f} s", std::max(seconds, 1.0));
    constexpr double kYear = 365.0 * 24 * 3600;
    if (!(seconds < kYear)) return "years";  // also what is no number
    // To ten minutes from two hours on: it is an estimate.
    const double step = seconds < 2 * 3600 ? 1 : 10;
    const auto minutes = static_cast<long>(std::round(seconds / 60 / step) * step);
    if (minutes < 60) return fmt::format("about {} min", minutes);
    if (minutes % 60 == 0) return fmt::format("about {} h", minutes / 60);
    return fmt::format("about {} h {} min", minutes / 60, minutes % 60);
}

std::string_view what_takes_longest(const PlottingTime& time) {
    if (time.drawing_s > std::max({time.moving_s, time.dots_s, time.lifting_s})) return "mostly drawing";
    if (time.lifting_s >= std::max(time.moving_s, time.dots_s)) return "mostly raising and lowering the pen";
    return time.moving_s >= time.dots_s ? "mostly moving between dots" : "mostly resting at dots";
}

}  // namespace dapple
