#pragma once
// The best of all balanced tiles with the identity rule and one word, by any measure: each is looked at.
//
// The paper's search is for the radius alone (see exhaustive_search.h), which can leave most tiles out; other
// measures have no such bound. There are 46 tiles of 8 points up to symmetry, 3,892 of 12, about half a
// million of 16 and 73 million of 20.

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

namespace dapple {

/// More points make too many tiles.
inline constexpr int kMostCriterionPoints = 20;

struct MeasuredTile {
    std::string word;
    double cost = 0;  // the lower, the better
    bool operator==(const MeasuredTile&) const = default;
};

/// The tile's cost, and by which word: of its images under the square's symmetries, whichever is best. Given
/// the word of one of them. Called by all threads.
using MeasureTile = std::function<MeasuredTile(const std::string& word)>;

struct CriterionControl {
    int threads = 0;  // 0: as many as the machine has
    std::stop_token stop;
    /// Called after each part of the work with the share that is done, by one thread at a time; not to throw.
    std::function<void(double share)> on_progress;
};

struct CriterionResult {
    std::vector<MeasuredTile> best;  // best first, equal ones by word; distinct up to symmetry
    std::uint64_t tiles = 0;         // looked at, some of them twice
    bool finished = false;           // none is left out
};

/// The `top` best tiles of `points` points. The same for any number of threads. Throws std::runtime_error
/// unless points is a multiple of 4 from 4 to kMostCriterionPoints.
CriterionResult search_by_criterion(int points, std::size_t top, const MeasureTile& measure,
                                    const CriterionControl& control = {});

}  // namespace dapple
