#pragma once
// How long a machine plots, and how that is said.

#include <string>
#include <string_view>

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
    bool operator==(const PlottingTime&) const = default;
};

/// "about 3 h 20 min", "about 12 min", "about 40 s"; from a year on "years".
std::string time_in_words(double seconds);

/// "mostly pen raising and lowering", or what else takes the most.
std::string_view what_takes_longest(const PlottingTime& time);

}  // namespace dapple
