// How long a machine plots, against the laws of motion step by step.

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "core/output/plotting_time.h"
#include "core/placing/dot_order.h"
#include "core/routing/short_way.h"

namespace dapple {

TEST_CASE("a move's time is what small steps of acceleration, top speed and braking come to") {
    const MachineSpeeds speeds{.top_speed = 50, .acceleration = 400};
    for (const double mm : {0.5, 3.0, 6.25, 40.0}) {
        double place = 0, speed = 0, time = 0;
        const double step = 1e-5;
        while (place < mm && speed >= 0) {
            const bool brake = speed * speed / (2 * speeds.acceleration) >= mm - place;
            speed = std::min(speeds.top_speed, speed + (brake ? -1 : 1) * speeds.acceleration * step);
            place += speed * step;
            time += step;
        }
        CHECK(move_time(mm, speeds) == doctest::Approx(time).epsilon(0.01));
    }
    CHECK(move_time(0, speeds) == 0);
}

TEST_CASE(
    "a drawing takes the time of its moves, lifts and dots, and about what is expected before its order") {
    Dots dots;
    std::mt19937 random(8);
    std::uniform_real_distribution<float> place;
    for (int i = 0; i < 5000; ++i) {
        dots.x.push_back(place(random));
        dots.y.push_back(place(random));
    }
    sort_dots(dots, DotOrder::space);
    shorten_way(dots);
    for (const Machine machine : {Machine::axidraw_v3, Machine::grbl_pen, Machine::grbl_laser}) {
        const MachineSpeeds speeds = speeds_of(machine);
        const PlottingTime time = plotting_time(dots, 200, speeds);
        CHECK(time.lifting_s == doctest::Approx(5000 * (speeds.lower_s + speeds.raise_s)));
        CHECK(expected_plotting_time(5000, 200 * 200, speeds).total_s() ==
              doctest::Approx(time.total_s()).epsilon(0.1));
    }
    CHECK(what_takes_longest(plotting_time(dots, 200, speeds_of(Machine::axidraw_v3))) ==
          "mostly pen raising and lowering");
}

TEST_CASE("a time is told as people say it") {
    CHECK(time_in_words(0) == "about 1 s");
    CHECK(time_in_words(40) == "about 40 s");
    CHECK(time_in_words(12 * 60 + 10) == "about 12 min");
    CHECK(time_in_words(3 * 3600 + 19 * 60) == "about 3 h 20 min");
    CHECK(time_in_words(7199) == "about 2 h");
}

}  // namespace dapple
