#pragma once
// Self-similar tiles (Lagae & Dutré 2006, section 4), with oriented children.
//
// A tile is a set of N points in the unit square such that the tile scaled by 1/2 onto any quadrant covers
// the points of that quadrant. It is written as a rule h, one orientation for each child, and words over the
// quadrants 0..3, a letter for each point:
//
//      point i = S_q( h_q( its successor ) ),   q = letter i,
//
// S_q being the half-scale map onto quadrant q and the successor the point of the next letter. A word of
// digits alone is a cycle: its last point is followed by its first. A word that ends in '>' and a number is a
// tail: its last point is followed by the point of that number, counting letters over all words from 0. Two
// points may have the same successor if they lie in different quadrants.
//
//      "0301"       0 -> 3 -> 0 -> 1 -+        "0301", "22>1"      2 -> 2 -+
//                   ^-----------------+                                    v
//                                                             0 -> 3 -> 0 -> 1 -+   (1 is the point 3)
//                                                             ^-----------------+
//
// With h = (identity x 4) and one cycle this is the paper's tile: the cycle of f(x) = 2x mod 1 through
// (a, b) / (2^N - 1), letter = bit of a + 2 * bit of b, most significant first. Tails are ours: they leave
// the children free to share points or not, so that each quadrant chooses the best of the tile's points for
// itself.
//
// A tile may be of several kinds, sets of N points each, none of which contains smaller copies of itself
// alone: the child in quadrant q of kind k is of the kind s(k, q), and the successor of a point of kind k in
// quadrant q is a point of that one. All kinds have one rule; the root of a subdivision is of kind 0. Several
// compatible tiles are the paper's own way out of periodicity (section 7). They have no words: successors are
// said point by point.

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/export.h"

namespace dapple {

// The eight symmetries of the square, the group D4, acting about the square's centre.
//
// Index 0..3: rotations by 0, 90, 180, 270 degrees, (x, y) -> (-y, x) being 90. Index 4+i: first mirror x,
// then rotation i. Quadrants: 0 = (-,-), 1 = (+,-), 2 = (-,+), 3 = (+,+), that is, xbit + 2 ybit.

/// A position in the unit square as two binary fractions, x / 2^64 and y / 2^64, rounded down. The k-th bits
/// from the top name the quadrant at depth k, so subdividing is shifting, and nothing is lost on the way.
struct BinaryPoint {
    std::uint64_t x = 0, y = 0;
    bool operator==(const BinaryPoint&) const = default;
};

struct Orientation {
    std::uint8_t index = 0;  // 0..7
    bool operator==(const Orientation&) const = default;
};

/// An orientation taken apart: swap the axes or not, then negate each or not.
struct SwapAndSigns {
    bool swap, negate_x, negate_y;
};
SwapAndSigns steps_of(Orientation g);

/// Every orientation, the identity first.
std::array<Orientation, 8> all_orientations();

/// The orientation that applies `first`, then `second`.
Orientation compose(Orientation second, Orientation first);
Orientation inverse(Orientation g);

/// The quadrant on which g puts quadrant q.
int apply_to_quadrant(Orientation g, int q);

/// The vector g(v) of a vector v from the square's centre.
glm::dvec2 apply(Orientation g, glm::dvec2 v);

/// The point g(p) of a point p in the unit square, exact: mirroring a binary fraction is flipping its digits.
BinaryPoint apply(Orientation g, BinaryPoint p);

/// x and y in [0, 1).
DAPPLE_API glm::dvec2 to_unit_square(BinaryPoint p);

/// The quadrant p lies in, and p blown up from that quadrant to the unit square, f(p) = 2p mod 1.
int quadrant_of(BinaryPoint p);
BinaryPoint enlarge_quadrant(BinaryPoint p);

/// The half-scale map S_q of the unit square onto its quadrant q.
BinaryPoint shrink_to_quadrant(int q, BinaryPoint p);

/// The orientation that the child in each quadrant has within its parent.
struct Rule {
    std::array<Orientation, 4> child;
    bool operator==(const Rule&) const = default;
};

inline constexpr std::size_t kMaxTilePoints = 4096;
inline constexpr std::size_t kMaxKinds = 64;

/// For each kind the kinds of its children, by quadrant.
using NextKinds = std::vector<std::array<std::uint16_t, 4>>;

struct Tile {
    Rule rule;
    std::vector<std::string> words;        // of one kind: cycles and tails, together N letters
    std::vector<BinaryPoint> points;       // N of each kind, kind after kind; word after word
    std::vector<std::uint32_t> successor;  // the point that point i is the half-size image of
    NextKinds next_kind = NextKinds(1);

    std::size_t kinds() const { return next_kind.size(); }
    /// N, the points of one kind.
    std::size_t size() const { return points.size() / kinds(); }
    /// The kind of a point: each kind has size() of them, kind after kind.
    std::size_t kind_of(std::size_t point) const { return point / size(); }
};

/// The tile of a rule and words. Throws std::runtime_error if a letter is not 0..3, a word is empty, a tail
/// leads to no point, N is not a multiple of 4 or over kMaxTilePoints, or two points coincide (a cycle that
/// is a repetition of a shorter one, say).
Tile make_tile(const Rule& rule, std::vector<std::string> words);

/// The tile of several kinds whose points, kind after kind, have these letters '0'..'3' and successors. Its
/// points come sorted: those of a kind by their letters, then by their successors. One kind alone gets words,
/// and its points come in their order. Throws std::runtime_error if there are not equally many points of each
/// kind, N is not as above, there are over kMaxKinds kinds, a kind does not exist, a successor is not of the
/// kind that it has to be, or two points of a kind coincide.
Tile make_tile(const Rule& rule, NextKinds next_kind, std::span<const char> letters,
               std::vector<std::uint32_t> successor);

/// How many letters a word has, the number at the end of a tail not counted. Throws as make_tile() does if it
/// is no word.
int count_letters(std::string_view word);

/// The paper's tile: `count` points, 4..62 and a multiple of 4, the first at (a, b) / (2^count - 1). Ranges
/// as above.
Tile make_tile(std::uint64_t a, std::uint64_t b, int count);

/// The words of points given by their letters '0'..'3' and successors: cycles first, each the smallest of
/// its rotations and in ascending order, then tails in the order of the points without predecessor.
std::vector<std::string> words_along(std::span<const char> letters, std::span<const std::uint32_t> successor);

/// Letters of the longest word for which a tile's distances can be compared as whole numbers of 128 bits.
inline constexpr int kMaxIdentityWord = 60;

/// The paper's pair of integers for a word of 1..kMaxIdentityWord letters: its tile is
/// make_tile(a, b, word.size()).
struct TileIntegers {
    std::uint64_t a = 0, b = 0;
    bool operator==(const TileIntegers&) const = default;
};
TileIntegers integers_of(std::string_view word);

/// "14217,2895/16", the paper's way to write a tile. Throws std::runtime_error saying what is wrong.
Tile parse_tile_integers(std::string_view text);

/// The paper's pair of integers, "14217,2895/16", if it can write the tile: identity rule, one cycle.
std::optional<std::string> paper_notation(const Tile& tile);

/// "3760": how the tile is turned in each quadrant.
std::string text_of(const Rule& rule);

/// "16 points, rule 0000, 1 word, 14217,2895/16 in the paper's notation", "4 kinds of 64 points, rule 0000".
std::string headline(const Tile& tile);

/// A child's point that its parent does not have.
struct Newborn {
    int quadrant = 0;         // the child's, in the parent's frame
    std::uint32_t point = 0;  // the index of the child's point
    BinaryPoint position;     // in the parent's frame
};

/// The 3 N points that the four children of a tile add to it, by quadrant, then by point; of several kinds
/// kind after kind. The other N points of the children coincide with the tile's own.
std::vector<Newborn> newborns_of(const Tile& tile);

// Which tiles can lie beside a tile when children are oriented by a rule, and of which kinds.

/// A tile that touches another one of the same size, seen from that one's frame.
struct Neighbour {
    glm::ivec2 offset;        // in tiles, -1..1 on each axis, not (0, 0)
    Orientation orientation;  // relative to the frame
    double probability = 0;  // how often, of all at that offset of one kind in a large subdivision; sums to 1
    std::uint16_t of = 0;    // the kind whose neighbour it is
    std::uint16_t kind = 0;  // its own
};

/// All neighbours that occur, by the kind whose they are, offset, kind, then orientation. Found as a
/// fixpoint: the four siblings touch each other, and where two tiles touch so do some of their children. The
/// identity rule and one kind give eight, the torus.
std::vector<Neighbour> legal_neighbours(const Rule& rule, const NextKinds& next_kind = NextKinds(1));

/// For each kind of a tile the legal neighbours that are of it: where else its points are seen.
std::vector<std::vector<Neighbour>> copies_of_kinds(const Tile& tile);

/// The position, in the frame's tile units, of point p of a neighbour.
glm::dvec2 position_in(const Neighbour& neighbour, glm::dvec2 p);

/// Calls visit(place, probability, kind) for a point of a tile of some kind and those of its copies that lie
/// within a radius of another tile, with that one's kind; `copies` is its kind's of copies_of_kinds().
template <class Visit>
void for_copies(glm::dvec2 p, std::size_t kind, const std::vector<Neighbour>& copies, double radius,
                Visit visit) {
    visit(p, 1.0, kind);
    if (p.x > radius && p.y > radius && p.x < 1 - radius && p.y < 1 - radius) return;
    for (const Neighbour& n : copies) {
        const glm::dvec2 copy = position_in(n, p);
        const glm::dvec2 d = copy - glm::dvec2(std::clamp(copy.x, 0.0, 1.0), std::clamp(copy.y, 0.0, 1.0));
        if (d.x * d.x + d.y * d.y <= radius * radius) visit(copy, n.probability, std::size_t{n.of});
    }
}

}  // namespace dapple
