#pragma once
// The numbers of the paper, worked out again: Lagae & Dutré 2006, "Generating Well-Distributed Point Sets
// with a Self-Similar Hierarchical Tile".

#include <string>
#include <string_view>
#include <vector>

namespace dapple {

/// One number that should come out, and the one that did, to the same digits.
struct ComparedNumber {
    std::string what;
    std::string expected;
    std::string ours;
    std::string source;  // where the expected one is from

    bool equal() const { return expected == ours; }
};

/// Section 4: shares of balanced sequences, the best tiles of 16 and 20 points by an exhaustive search; the
/// paper's tile and Appendix A. About a second on one core.
std::vector<ComparedNumber> compare_printed_numbers();

/// What follows from Figure 8 as printed: it places some dots twice. Counted by hand, and run.
std::vector<ComparedNumber> compare_figure8_counts();

/// What the paper's own search could not reach, 24 and 28 points: recorded when this program first did.
std::vector<ComparedNumber> compare_larger_tiles();

}  // namespace dapple
