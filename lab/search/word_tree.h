#pragma once
// Branch and bound over the words of identity-rule tiles: the walk itself, for one thread.
//
// A word is built from its end. Putting a letter in front of a word adds one point, whose digits are all the
// letters so far,
//
//      2 1 3 0 2 ...        the point 0.2130.. (base 4), a square of side 2^-5 that surely holds it
//    3 2 1 3 0 2 ...        one letter more: a new point, a square of side 2^-6
//
// and leaves the squares of the older points as they are. So each letter is tested once, against the points
// before it, and is dropped when the new square and an older one are certain to hold points that are too
// close. (Built from its front, the word's last points are always the unknown ones and all are to be tested
// anew for each letter.)
//
// A tile is a word read from any of its letters and seen through any of the eight symmetries. Of these only
// the smallest, as read backwards, is wanted: a word is dropped as soon as some stretch of it, through some
// symmetry, is smaller than its beginning.

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/tile/random.h"
#include "lab/search/identity_word.h"

namespace dapple {

/// The smallest distance that is still of interest, shared by threads that raise it. Held squared and rounded
/// down a little, so that a tile of exactly this radius is never dropped.
class RadiusBound {
 public:
    /// For tiles of `points` points and at least this relative radius.
    RadiusBound(int points, double relative_radius);
    void raise_to(double relative_radius);
    float squared_distance() const { return squared_distance_.load(std::memory_order_relaxed); }

 private:
    float squared(double relative_radius) const;
    int points_;
    std::atomic<float> squared_distance_;
};

class WordTree {
 public:
    /// Words of `points` letters, each letter points / 4 times. points: a multiple of 4, 4..kMaxIdentityWord.
    explicit WordTree(int points);

    /// The ends of words, `length` letters each, that the bound leaves open, in the walk's order. Together
    /// they are where all tiles within the bound end.
    std::vector<std::string> endings(int length, const RadiusBound& bound);

    /// Calls on_word for the words with this ending that the bound leaves: all that reach it, and a few that
    /// do not. A tile may come twice, by different words. False if stopped before the end.
    bool complete(std::string_view ending, const RadiusBound& bound, const std::stop_token& stop,
                  const std::function<void(const std::string&)>& on_word);

    /// A guess at how many ends of words complete() would add letters to: a random way down, each step of
    /// which stands for all that were open there (Knuth 1975, "Estimating the efficiency of backtrack
    /// programs"). Right on the mean of many.
    double probe(std::string_view ending, const RadiusBound& bound, Random& random);

    /// How many ends of words had letters added so far.
    std::uint64_t steps() const { return steps_; }

 private:
    struct Branch {
        std::uint32_t x = 0, y = 0;              // lowest corner of the last point's square, in 2^-32
        std::array<std::uint64_t, 8> matches{};  // see smaller_elsewhere
    };
    /// How many letters of the ending the bound leaves, all of them unless it does not; to be undone.
    int begin(std::string_view ending, Branch& branch);
    void undo_all(int length);
    bool walk(int length, const Branch& branch);
    bool step(int length, int letter, const Branch& branch, Branch& next);
    void undo(int length, int letter);
    bool smaller_elsewhere(int letter, const Branch& branch, Branch& next) const;
    bool too_close(int length, const Branch& next);

    static constexpr int kSlots = 64;  // points, rounded up for whole vectors
    int points_;
    int target_ = 0;  // letters at which the walk reports
    const RadiusBound* bound_ = nullptr;
    std::stop_token stop_;
    std::function<void(const std::string&)> on_word_;
    std::uint64_t steps_ = 0;

    std::array<std::array<std::uint8_t, 4>, 8> image_{};  // of each letter under each symmetry
    std::array<std::uint8_t, kSlots> letters_{};          // the word so far, backwards
    std::array<int, 4> left_{};                           // how often each letter may still come
    std::array<std::uint64_t, 4> equal_{}, greater_{};  // per letter: where the word has it, or a greater one
    std::array<float, kSlots> half_side_{};  // of the square of a new point, by the letters before it
    alignas(64) std::array<float, kSlots> x_{}, y_{};  // centres of the points' squares
    alignas(64) std::array<float, kSlots> reach_{};    // half the squares' sides
};

}  // namespace dapple
