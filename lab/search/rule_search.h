#pragma once
// Which rule suits so many points? Successive halving: all of some rules are given a short search each, the
// better half a longer one, and so on until one is left, which has the long search.
//
//      20 rules  ..  ..  ..  ..  ..  ..       each round has as many moves as the others,
//      10 rules  ....    ....    ....         shared evenly among the rules that are left
//       5 rules  ........        ........
//       2 rules  ................ ...............
//       1 rule   ................................................................................

#include <span>

#include "lab/search/relink_search.h"

namespace dapple {

/// The tile of lowest energy found for any of `rules` with settings.moves * runs moves tried in all: half of
/// them choose the rule, and `runs` searches of that rule with the seeds settings.seed, ... share the rest.
/// settings.rule is not used. On all cores; the same settings and runs, the same tile. With a clock, the
/// search lasts settings.seconds, half of them to choose the rule.
RelinkResult search_rules(const RelinkSettings& settings, std::span<const Rule> rules, int runs);

}  // namespace dapple
