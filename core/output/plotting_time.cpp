#include "core/output/plotting_time.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/text/length.h"

namespace dapple {
namespace {

// Seconds that an AxiDraw's servo takes over 30 % of its travel, at a rate in percent.
double axidraw_lift_s(double rate) {
    const double travel = 30, servo_ms = 2.69 * travel + 45, sweep_ms = 200 * travel / rate;
    return std::pow(std::pow(servo_ms, 4) + std::pow(sweep_ms, 4), 0.25) / 1000;
}

}  // namespace

std::string_view words_for(Machine machine) {
    switch (machine) {
        case Machine::axidraw_v3:
            return "an AxiDraw V3";
        case Machine::axidraw_se_a3:
            return "an AxiDraw SE/A3";
        case Machine::idraw:
            return "an iDraw";
        case Machine::grbl_pen:
            return "a pen plotter that runs Grbl";
        case Machine::grbl_laser:
            return "a laser that runs Grbl";
    }
    return "";
}

MachineSpeeds speeds_of(Machine machine) {
    const double grbl_speed = 500.0 / 60, grbl_acceleration = 10;
    switch (machine) {
        case Machine::axidraw_v3:
        case Machine::axidraw_se_a3:
            return {.top_speed = 75.0 / 110 * 8.6979 * kMmPerInch,
                    .acceleration = 0.75 * 60 * kMmPerInch,
                    .lower_s = axidraw_lift_s(50),
                    .raise_s = axidraw_lift_s(75),
                    .drawing_speed = 25.0 / 110 * 8.6979 * kMmPerInch,
                    .drawing_acceleration = 0.75 * 40 * kMmPerInch};
        case Machine::idraw: {
            const double full = 24950 / 2032.0 * kMmPerInch / 110, ramp_s = 0.2, lift_s = 20 / 150.0;
            return {.top_speed = 75 * full,
                    .acceleration = 75 * full / ramp_s,
                    .lower_s = lift_s,
                    .raise_s = lift_s,
                    .drawing_speed = 25 * full,
                    .drawing_acceleration = 25 * full / ramp_s};
        }
        case Machine::grbl_pen:
            return {.top_speed = grbl_speed,
                    .acceleration = grbl_acceleration,
                    .lower_s = axidraw_lift_s(100),
                    .raise_s = axidraw_lift_s(100),
                    .drawing_speed = grbl_speed,
                    .drawing_acceleration = grbl_acceleration};
        case Machine::grbl_laser:
            return {.top_speed = grbl_speed,
                    .acceleration = grbl_acceleration,
                    .dot_s = 0.1,
                    .drawing_speed = grbl_speed,
                    .drawing_acceleration = grbl_acceleration};
    }
    return {};
}

double move_time(double mm, const MachineSpeeds& speeds) {
    const double v = speeds.top_speed, a = speeds.acceleration;
    return mm * a < v * v ? 2 * std::sqrt(mm / a) : mm / v + v / a;
}

PlottingTime plotting_time(const Dots& dots, double mm_per_page_unit, const MachineSpeeds& speeds) {
    const auto count = static_cast<double>(dots.size());
    PlottingTime time{.lifting_s = count * (speeds.lower_s + speeds.raise_s), .dots_s = count * speeds.dot_s};
    for (std::size_t i = 1; i < dots.size(); ++i) {
        const double way = std::hypot(double(dots.x[i]) - dots.x[i - 1], double(dots.y[i]) - dots.y[i - 1]);
        time.moving_s += move_time(way * mm_per_page_unit, speeds);
    }
    return time;
}

PlottingTime expected_plotting_time(double dots, double area_mm2, const MachineSpeeds& speeds) {
    if (dots < 1) return {};
    return {.moving_s = dots * move_time(0.75 * std::sqrt(area_mm2 / dots), speeds),
            .lifting_s = dots * (speeds.lower_s + speeds.raise_s),
            .dots_s = dots * speeds.dot_s};
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
    if (time.lifting_s >= std::max(time.moving_s, time.dots_s)) return "mostly pen raising and lowering";
    return time.moving_s >= time.dots_s ? "mostly moves between the dots" : "mostly resting at the dots";
}

}  // namespace dapple
