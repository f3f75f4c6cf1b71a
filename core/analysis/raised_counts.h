#pragma once
// Counts over ascending places that are raised from some place to the end, and their greatest deviation from
// a line: the inner part of the sweep for the star discrepancy.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace dapple {

/// Counts c_k at places y_k, all 0 at first, and the greatest of sign * (c_k - slope y_k) over all k.
///
/// In blocks of about sqrt(n) / 2: raising the counts from k on changes one block and a number for each later
/// one. The greatest of a block is on its convex hull, further along for a greater slope. Slopes never
/// decrease, so the search of each block goes on where it stopped; hulls are made anew only when they are
/// asked.
class RaisedCounts {
 public:
    /// `places` ascend; sign is +1 (how far counts are above the line) or -1 (below).
    RaisedCounts(std::vector<double> places, int sign);

    /// Adds 1 to c_k, c_{k+1}, ...; nothing if k is beyond the last place.
    void raise_from(std::size_t k);

    /// The greatest deviation. `slope` is not smaller than in earlier calls.
    double greatest(double slope);

 private:
    struct Block {
        std::vector<std::uint32_t> hull;  // in the order that growing slopes visit
        std::size_t at = 0;
        bool changed = true;
    };

    void rebuild(std::size_t block);
    void stand_at(std::size_t block, std::size_t at);

    std::vector<double> y_;
    double sign_;
    std::vector<double> count_;  // without what is in raised_
    std::size_t block_size_;
    std::vector<Block> blocks_;
    // For each block, side by side for speed:
    std::vector<double> raised_;  // added to all its counts
    std::vector<double> best_y_;  // of the hull's corner where the search stands
    std::vector<double> best_count_;
    std::vector<double> next_slope_;  // from which on the hull's next corner is better
};

}  // namespace dapple
