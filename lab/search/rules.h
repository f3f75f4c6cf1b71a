#pragma once
// The rules there are: 8^4 = 4,096, of which 570 are distinct up to the square's symmetries.

#include <cstddef>
#include <vector>

#include "core/tile/tile.h"

namespace dapple {

/// The rule of a tile that was turned as a whole: if T is a tile of `rule`, g(T) is one of turned(rule, g).
/// The child in quadrant g(q) has the orientation g h_q g^-1.
Rule turned(const Rule& rule, Orientation g);

/// A rule with the share of tiles that it turns alike, chance being 1/8; see orientation_coincidence().
struct RuleMarks {
    Rule rule;
    double coincidence = 0;  // the highest at a lag of 1..64
    int lag = 1;             // where that is
    double mean = 0;         // of the lags' highest
};

/// The `count` rules that repeat least, the lowest coincidence first; 570 are all. Rules that are the same up
/// to symmetry are there once: the first in the order of their digits.
std::vector<RuleMarks> best_rules(std::size_t count);

}  // namespace dapple
