#pragma once
// Several kinds of a tile whose successors are being exchanged: where the points are, and their energy.
//
// All kinds have the identity orientation, and any two can lie side by side. So one pairing of edges is left,
// right with left and top with bottom, and what lies beyond an edge is a mean over the kinds: a field that
// all of them share. A point has the energy, in spacings, the side of a tile being sqrt(N),
//
//      sum over the points of its kind of pair_energy() + the field of the neighbours
//      + apart * sum over the points of all kinds of (1 - d^2 / (4 w)^2)^8,   w = 0.5 / sqrt(kinds),
//
// the last for points that lie in the same place of different tiles: where all kinds together are even, their
// mean, which alone repeats, has no pattern. It fades out towards the border, which all kinds have to fit.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/tile/random.h"
#include "core/tile/tile.h"
#include "lab/search/pair_energy.h"

namespace dapple {

/// Points on sheets, each cut into cells as wide as a pair's energy reaches.
class SheetGrid {
 public:
    SheetGrid(int sheets, float side, const PairShape& shape);

    void clear();
    /// Throws std::runtime_error if its cell is full.
    void insert(std::uint32_t sheet, glm::vec2 p, float weight, std::uint32_t name);
    /// Whether there is room for it, and for some more, as points shift a little when they are put right.
    bool fits(std::uint32_t sheet, glm::vec2 p) const;
    /// p must have been inserted under that name, to the bit.
    void remove(std::uint32_t sheet, glm::vec2 p, std::uint32_t name);
    /// The energy of a point at p among all points of the sheet, itself included if it is there.
    float energy(std::uint32_t sheet, glm::vec2 p) const;
    float pair(float squared_distance) const;
    float reach() const { return reach_; }
    /// The names of the points within a radius of p, which is at most the reach.
    void find_near(std::uint32_t sheet, glm::vec2 p, float radius, std::vector<std::uint32_t>& names) const;

 private:
    static constexpr int kLanes = 8, kBlocks = 3;
    struct Cell {
        std::array<std::array<float, kLanes>, kBlocks> x, y, weight;
        std::array<std::uint32_t, std::size_t{kLanes} * kBlocks> name;
        std::int32_t count = 0;
    };
    std::size_t cell_of(std::uint32_t sheet, glm::vec2 p) const;

    int side_;  // cells a side, without the ring of empty ones around them
    float half_, cells_per_unit_, reach_;
    float tone_, close_, tone_weight_, close_weight_;
    std::vector<Cell> cells_;
};

class KindLinks {
 public:
    /// `letters` and `successors` of all points, kind after kind; for each quadrant `next` is a permutation.
    /// At first it counts nothing that kinds differ.
    KindLinks(const NextKinds& next, std::span<const char> letters, std::span<const std::uint32_t> successors,
              const PairShape& shape);

    std::size_t size() const { return successor_.size(); }
    const std::vector<std::uint32_t>& successors() const { return successor_; }

    /// From now on it counts so much that kinds differ, if they differ enough for that already: copies of one
    /// tile lie too close in one place. Returns whether they do.
    bool set_apart(double apart);

    /// The energy at the last refresh() and the changes since, of all points, each pair counted once.
    double energy() const { return energy_; }
    /// Puts every point exactly where its successors say, and sums the energy afresh.
    void refresh();

    /// Tries one move and takes it if the energy rises by less than temperature * log(1 / chance).
    bool step(Random& random, double temperature, double radius);

 private:
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};
    struct Moved {
        std::uint32_t point;
        glm::vec2 from;
    };

    std::uint32_t kind_of(std::uint32_t point) const { return point / points_; }
    glm::vec2 image_of_successor(std::uint32_t i) const;
    float weight_at(glm::vec2 p) const;
    float field_at(glm::vec2 p) const;
    bool near_border(glm::vec2 p) const;
    void add_to_field(glm::vec2 p, float sign);
    double change_of(std::uint32_t p, glm::vec2 to) const;
    void put(std::uint32_t p, glm::vec2 to);
    void link(std::uint32_t a, std::uint32_t from, std::uint32_t to);
    bool undo(std::uint32_t a, std::uint32_t from, std::uint32_t to);

    std::uint32_t points_;  // of a kind
    std::uint32_t kinds_;
    float side_;     // of a tile, in spacings
    float stretch_;  // of a spacing where all kinds lie in one place
    float apart_ = 0;
    SheetGrid own_, all_;
    int field_side_;
    std::vector<float> field_;
    std::vector<glm::vec2> in_field_;
    std::vector<std::uint32_t> successor_;
    std::vector<std::array<std::uint32_t, 4>> predecessors_;  // the one in each quadrant
    std::vector<std::uint8_t> quadrant_;
    std::vector<glm::vec2> position_;
    double energy_ = 0;
    std::vector<Moved> journal_;
    std::vector<std::uint32_t> near_, queue_;
};

}  // namespace dapple
