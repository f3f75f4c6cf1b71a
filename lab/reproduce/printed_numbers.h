#pragma once
// The numbers of the paper, worked out again: Lagae & Dutré 2006, "Generating Well-Distributed Point Sets
// with a Self-Similar Hierarchical Tile".

#include <string>
#include <string_view>
#include <vector>

#include "core/text/names.h"

namespace dapple {

/// Where the number that should come out is from.
enum class Origin {
    printed,  // the paper prints it, to the digits given
    ours,     // recorded from this program, or counted by hand: the paper does not print it
};
constexpr auto names_of(Origin) {
    return names("printed", "ours");
}

/// One number that should come out, and the one that did, to the same digits.
struct ComparedNumber {
    std::string what;
    std::string expected;
    std::string ours;
    std::string source;  // where the expected one is from
    Origin origin = Origin::printed;
    std::string known{};  // why the two differ, if that is known: no error then

    bool equal() const { return expected == ours; }
};

/// Section 5: shares of balanced sequences, and the radii of the best tiles of 16 and 20 points that the
/// paper gives, by an exhaustive search. Under a second on one core.
std::vector<ComparedNumber> compare_printed_numbers();

/// Table 1, Appendix A: the tile's 16 points in the order of their ranks, as whole numbers of 1/65535 and to
/// eight digits.
std::vector<ComparedNumber> compare_table1();

/// What the paper's tile is, beside what the paper says of it: its place among all, self-similarity.
std::vector<ComparedNumber> compare_own_numbers();

/// How many dots Figure 8 as printed places twice. Counted by hand, and run.
std::vector<ComparedNumber> compare_figure8_counts();

/// What the paper's own search could not reach, 24 to 36 points: recorded when this program first did. The
/// best of 32 points is not searched for again, but measured. And 16 to 24 points in cycles of 4.
std::vector<ComparedNumber> compare_larger_tiles();

}  // namespace dapple
