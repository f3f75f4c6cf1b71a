#pragma once
// All methods that dapple is compared with, by name.

#include <optional>
#include <span>
#include <string_view>

#include "lab/related/wanted.h"

namespace dapple {

struct RelatedMethod {
    std::string_view name;    // for the command line: "white-noise"
    std::string_view title;   // for people: "white noise"
    std::string_view source;  // its paper, in short
    PlainDots (*dots)(const DotsWanted& wanted);
    bool nested = false;  // the first n dots are the drawing with n dots, if it is made large enough
    bool has_tiles = false;
    bool pictures_only = false;  // constant it is another of these methods
    double level_factor = 4;     // times as many dots have each of the tiles' next levels
    std::string_view limits{};   // on counts, and where it departs from its paper
};

/// In the order of the paper's section 2, and then sequences.
std::span<const RelatedMethod> related_methods();

const RelatedMethod* related_method(std::string_view name);

}  // namespace dapple
