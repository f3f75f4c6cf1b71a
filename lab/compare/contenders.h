#pragma once
// What dapple-lab compare measures: dapple itself, the paper's tile, and the methods of lab/related.

#include <functional>
#include <string>
#include <vector>

#include "lab/related/wanted.h"

namespace dapple {

struct Contender {
    std::string name;   // for the command line
    std::string title;  // for people
    std::string source;
    std::string limits;   // on counts, and where it departs from its source
    bool nested = false;  // the first n dots are the drawing with n dots
    bool ours = false;
    bool has_tiles = false;
    bool pictures_only = false;  // constant it is another of these
    double level_factor = 4;     // times as many dots has each of its levels, if it has some
    std::function<PlainDots(const DotsWanted& wanted)> dots;  // on the calling thread, but for what uses TBB
};

/// All, in the order of the tables: dapple's own first. Tiles are loaded when their dots are first asked for,
/// which is not for several threads at once.
std::vector<Contender> all_contenders();

/// The names of all, with commas between.
std::string contender_names();

/// Those of these names, in that order. Throws std::runtime_error saying which there are.
std::vector<Contender> contenders_named(const std::vector<std::string>& names);

}  // namespace dapple
