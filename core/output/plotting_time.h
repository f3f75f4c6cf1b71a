#pragma once
// How long a machine plots, and how that is said.

#include <array>
#include <cstdint>
#include <deque>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/output/sheet.h"
#include "core/placing/placer.h"
#include "core/text/names.h"

namespace dapple {

enum class Machine { axidraw_v3, axidraw_se_a3, idraw, grbl_pen, grbl_laser };

constexpr auto names_of(Machine) {
    return names("axidraw-v3", "axidraw-se-a3", "idraw", "grbl-pen", "grbl-laser");
}

/// "an AxiDraw V3".
std::string_view words_for(Machine machine);

struct PlottingTime {
    double moving_s = 0;
    double lifting_s = 0;  // raising and lowering
    double dots_s = 0;     // on the paper
    double drawing_s = 0;  // lines, pen down

    double total_s() const { return moving_s + lifting_s + dots_s + drawing_s; }
    PlottingTime operator+(const PlottingTime& more) const {
        return {moving_s + more.moving_s, lifting_s + more.lifting_s, dots_s + more.dots_s,
                drawing_s + more.drawing_s};
    }
    bool operator==(const PlottingTime&) const = default;
};

/// "about 3 h 20 min", "about 12 min", "about 40 s"; from a year on "years".
std::string time_in_words(double seconds);

/// "mostly pen raising and lowering", or what else takes the most.
std::string_view what_takes_longest(const PlottingTime& time);

// How long a machine takes, by following what it does: each of its moves, planned as its own program plans
// them.

/// One thing that a machine does, as a line of G-code says it: what is not given stays as it was.
struct MachineStep {
    enum class To : std::uint8_t { stays, number, point_x, point_y };
    struct Axis {
        To to = To::stays;
        double mm = 0;  // where it is a number
    };
    std::array<Axis, 3> axes = {};                         // x, y and z that it moves to
    std::optional<double> speed = {};                      // mm/s, of this move and later ones
    std::optional<bool> rapid = {};                        // rather at the top speed
    std::optional<bool> relative = {};                     // its numbers count from where the machine stands
    std::optional<double> rest_s = {};                     // once all moves have ended
    double PlottingTime::*part = &PlottingTime::moving_s;  // that its time is counted as
};
using MachineSteps = std::vector<MachineStep>;

/// What a machine does for a drawing, and how it moves.
///
/// Where a line turns into the next the machine goes on at the speed at which it could follow a circle that
/// touches both and comes as near to the corner as `corner_mm`: v^2 = a d s / (1 - s), with s the sine of
/// half the angle between them. Grbl 1.1 (planner.c, plan_buffer_line()) has that rule, and the AxiDraw's
/// program (motion.py, plan_trajectory()) the same one.
struct MachineProgram {
    MachineSteps start = {}, end = {};
    MachineSteps dot = {};                                  // from the one before, with the move there
    MachineSteps move = {}, down = {}, line = {}, up = {};  // of a stroke; line for each point but the first
    MachineSteps pen = {};                                  // before each pen, where there are several
    double top_speed = 0;                                   // mm/s
    double acceleration = 0, drawing_acceleration = 0;      // mm/s^2; the other one of lines
    double corner_mm = 0;
    std::size_t look_ahead = 0;  // so many moves are planned at a time; 0: all until the machine rests
    double slice_s = 0;          // moves are made of so long pieces of even speed; 0: they are smooth
    bool from_origin = false;    // it begins at 0, 0, 0; otherwise the way to the first dot is not counted
    double grid_mm = 0;          // to which its places are rounded; 0: they are not
    double page_height_mm = 0;   // its y counts upwards from there; 0: downwards
    std::vector<CutMark> registration = {};  // that each pen draws first
    bool several_pens = false;
};

/// The program of each machine for what is no G-code.
///
/// AxiDraw V3 and SE/A3, from axidraw_conf.py of Evil Mad Scientist's AxiDraw software (version 3): pen-up
/// speed 75/110 of speed_lim_xy_hr = 8.6979 in/s, acceleration 75 % of accel_rate_pu = 60 in/s^2; pen
/// positions 60 and 30 %, raised at a rate of 75 % and lowered at 50 %. A lift takes the fourth-power mean of
/// servo_move_slope (2.69 ms per %) x 30 + servo_move_min (45 ms) and servo_sweep_time (200 ms) x 30 / rate.
/// The two sizes share all of these, so they take the same time. Lines: 25/110 of that speed, and 75 % of
/// accel_rate = 40 in/s^2; cornering 10 / 5000 in; speeds change every 25 ms (time_slice).
///
/// iDraw, whose program was made from the AxiDraw's first version (1.0): that one's axidraw_conf.py (1.3) has
/// 24,950 steps/s of 1/2032 in as the speed of 110 %, of which 75 % with the pen up and 25 % down, reached in
/// 0.2 s on moves below an inch; pen positions 60 and 40 % at a rate of 150 % a second; cornering 2 / 1000
/// in.
///
/// GRBL as it comes, from its own settings in defaults.h, DEFAULTS_GENERIC: 500 mm/min ($110), 10 mm/s^2
/// ($120), a junction deviation of 0.01 mm ($11), and 15 moves ahead (BLOCK_BUFFER_SIZE). Most machines are
/// tuned to be faster; a file of G-code says how fast (see program_for()). A pen's servo is taken as the
/// AxiDraw's with full rates (its program has no figure); a laser has no lift and burns a dot for 0.1 s,
/// which is our assumption.
MachineProgram program_of(Machine machine);

inline constexpr double kGrblCornerMm = 0.01;
inline constexpr std::size_t kGrblLookAhead = 15;

/// Follows a program. The program must outlive it.
class MachineClock {
 public:
    explicit MachineClock(const MachineProgram& program);

    /// Places in millimetres from the page's upper left corner.
    void dot(glm::dvec2 place);
    /// A touch where it has one point.
    void stroke(std::span<const glm::dvec2> points);
    /// Draws with that pen from now on.
    void take(int pen);
    /// Brings the machine to its end.
    PlottingTime finish();
    /// Of the moves that have ended.
    const PlottingTime& time() const { return time_; }

 private:
    struct Move {
        glm::dvec3 direction{0};  // of length 1
        double mm = 0, top = 0, acceleration = 0;
        double most_at_begin = 0;  // speed squared that its corner allows
        double PlottingTime::*part = nullptr;
    };

    void run(const MachineSteps& steps, glm::dvec2 point = {});
    void go(const MachineStep& step, glm::dvec2 point);
    void make(std::size_t moves);
    double seconds_for(const Move& move, double from, double to) const;

    const MachineProgram& program_;
    PlottingTime time_;
    std::deque<Move> ahead_;    // planned, not made
    std::vector<double> most_;  // speeds squared at their begins
    double now_ = 0;            // speed squared at the first one's begin
    glm::dvec3 place_{0};
    bool known_ = false;  // where it stands
    double speed_ = 0;
    bool rapid_ = false, relative_ = false;
    int pen_ = -1;
};

/// The sum over the dots in their order.
PlottingTime plotting_time(const DotStream& dots, double mm_per_page_unit, const MachineProgram& program);

/// Where the order is not known yet, from a way of 0.75 sqrt(dots x area) in equal moves: what a short way
/// through dots all over a page comes to (Beardwood, Halton and Hammersley 1959 have 0.71 for the shortest).
PlottingTime expected_plotting_time(double dots, double area_mm2, const MachineProgram& program);

}  // namespace dapple
