#pragma once
// How long a machine will plot a drawing of dots.

#include <optional>
#include <string>
#include <string_view>

#include "core/placing/dots.h"
#include "core/text/names.h"

namespace dapple {

enum class Machine { axidraw_v3, axidraw_se_a3, idraw, grbl_pen, grbl_laser };

constexpr auto names_of(Machine) {
    return names("axidraw-v3", "axidraw-se-a3", "idraw", "grbl-pen", "grbl-laser");
}

/// "an AxiDraw V3".
std::string_view words_for(Machine machine);

/// How a machine moves from dot to dot: from rest to rest, with constant acceleration up to a top speed.
struct MachineSpeeds {
    double top_speed = 0;     // pen up, mm/s
    double acceleration = 0;  // pen up, mm/s^2
    double lower_s = 0, raise_s = 0;
    double dot_s = 0;                                    // on the paper, or the laser burning
    double drawing_speed = 0, drawing_acceleration = 0;  // of lines, pen down
};

/// The defaults of each machine's own program.
///
/// AxiDraw V3 and SE/A3, from axidraw_conf.py of Evil Mad Scientist's AxiDraw software (version 3): pen-up
/// speed 75/110 of speed_lim_xy_hr = 8.6979 in/s, acceleration 75 % of accel_rate_pu = 60 in/s^2; pen
/// positions 60 and 30 %, raised at a rate of 75 % and lowered at 50 %. A lift takes the fourth-power mean of
/// servo_move_slope (2.69 ms per %) x 30 + servo_move_min (45 ms) and servo_sweep_time (200 ms) x 30 / rate.
/// The two sizes share all of these, so they take the same time. Lines: 25/110 of that speed, and 75 % of
/// accel_rate = 40 in/s^2.
///
/// iDraw, whose program was made from the AxiDraw's first version (1.0): that one's axidraw_conf.py (1.3) has
/// 24,950 steps/s of 1/2032 in as the speed of 110 %, of which 75 % with the pen up and 25 % down, reached in
/// 0.2 s on moves below an inch; pen positions 60 and 40 % at a rate of 150 % a second.
///
/// GRBL as it comes, from its own settings in defaults.h, DEFAULTS_GENERIC: 500 mm/min ($110) and 10 mm/s^2
/// ($120). Most machines are tuned to be faster; a file of G-code says how fast (see speeds_for()). A pen's
/// servo is taken as the AxiDraw's with full rates (its program has no figure); a laser has no lift and burns
/// a dot for 0.1 s, which is our assumption.
MachineSpeeds speeds_of(Machine machine);

struct PlottingTime {
    double moving_s = 0;
    double lifting_s = 0;  // raising and lowering
    double dots_s = 0;     // on the paper
    double drawing_s = 0;  // lines, pen down

    double total_s() const { return moving_s + lifting_s + dots_s + drawing_s; }
    bool operator==(const PlottingTime&) const = default;
};

/// Seconds for a straight move from rest to rest: a trapezium of speed over time, or a triangle where the top
/// speed is not reached.
double move_time(double mm, const MachineSpeeds& speeds);

/// The sum over the dots in their order.
PlottingTime plotting_time(const Dots& dots, double mm_per_page_unit, const MachineSpeeds& speeds);

/// Where the order is not known yet, from a way of 0.75 sqrt(dots x area) in equal moves: what a short way
/// through dots all over a page comes to (Beardwood, Halton and Hammersley 1959 have 0.71 for the shortest).
PlottingTime expected_plotting_time(double dots, double area_mm2, const MachineSpeeds& speeds);

/// "about 3 h 20 min", "about 12 min", "about 40 s"; from a year on "years".
std::string time_in_words(double seconds);

/// "mostly pen raising and lowering", or what else takes the most.
std::string_view what_takes_longest(const PlottingTime& time);

}  // namespace dapple
