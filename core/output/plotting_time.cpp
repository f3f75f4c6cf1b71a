#include "core/output/plotting_time.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dapple {
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
