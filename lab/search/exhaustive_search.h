#pragma once
// The best of all balanced tiles with the identity rule and one word, found without looking at all of them.
//
// The paper's search (Lagae & Dutré 2006, section 5) for the largest relative radius, by branch and bound:
// see word_tree.h for the walk. It goes in passes. Each pass looks at every tile above a floor, 0.97 at first
// and 0.03 lower each time, until the tiles asked for are found; a high floor cuts almost everything, and a
// pass costs two to three times the one before it. Within a pass the floor rises to the last of the best
// tiles as soon as there are enough. A pass is cut into parts, by the last letters of the word, which go to
// the threads and are what a stopped search remembers.
//
//      SearchState state = start_exhaustive_search(20, 5);
//      while (!state.finished) state = continue_exhaustive_search(std::move(state), {.threads = 2});
//      state.found[0].word;  // "0010322..."
//
// The outcome depends on neither threads nor interruptions.
//
// The radius of the last tile asked for decides the time, more than the number of points: on one core the
// best of 32 points (0.716) takes a quarter of a minute, the best of 36 (0.918, nearly a lattice) a quarter
// of a second.

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace dapple {

struct FoundTile {
    std::string word;  // the smallest of all rotations of its eight images
    double relative_radius = 0;
    bool operator==(const FoundTile&) const = default;
};

/// A search as far as it has come: a plain value, to be kept, written and gone on with.
struct SearchState {
    int points = 16;
    int top = 5;
    int pass = 0;                  // from 0
    std::vector<bool> done;        // the parts of this pass that are done; empty if it has not begun
    std::vector<FoundTile> found;  // best first, at most `top`, equal radii by word; distinct up to symmetry
    bool finished = false;         // found is final
    bool operator==(const SearchState&) const = default;
};

/// A search for the `top` best tiles of `points` points, balanced: each quadrant holds a quarter of them.
/// Throws std::runtime_error unless points is a multiple of 4 from 4 to 60 and top is at least 1.
SearchState start_exhaustive_search(int points, int top);

/// Every tile of at least this relative radius has been seen (though only the best `top` are kept): infinity
/// at first, the last tile's radius when finished, 0 if there are fewer tiles than asked for.
double proven_radius(const SearchState& state);

struct SearchProgress {
    double floor = 0;     // this pass looks for relative radii from here on
    double fraction = 0;  // of this pass, 0..1; parts take similar times on average, in the order taken
    const SearchState&
        state;  // what a search that is stopped now would return; to be looked at during the call
};

struct SearchControl {
    int threads = 0;       // 0: as many as the machine has
    std::stop_token stop;  // leaves unfinished parts for next time; their tiles are kept
    /// Called after each part, by one thread at a time, and not to throw.
    std::function<void(const SearchProgress&)> on_progress;
};

/// Goes on until the search is finished or stopped. Throws std::runtime_error if the state does not fit its
/// own points and pass.
SearchState continue_exhaustive_search(SearchState state, const SearchControl& control = {});

/// The parts of a pass, for whoever hands them out to others. What a part comes to is the same wherever it is
/// searched, as long as the radius asked for is no more than the last tile's that will be kept.
class PartSearch {
 public:
    /// Of that pass of the search.
    explicit PartSearch(const SearchState& state);
    std::size_t parts() const { return endings_.size(); }
    double floor() const { return floor_; }
    /// The part to be searched as the i-th, so that the share of parts that are done tells the share of time.
    std::size_t in_turn(std::size_t i) const;
    /// The best tiles of a part, at most SearchState::top, of at least that relative radius. Unfinished when
    /// a stop was requested.
    std::vector<FoundTile> search(std::size_t part, double radius, const std::stop_token& stop = {}) const;

 private:
    int points_;
    std::size_t top_;
    double floor_;
    std::vector<std::string> endings_;
};

/// The state's pass begins, if it has not begun; without a part it ends at once. `parts` is how many it has.
void begin_pass(SearchState& state, std::size_t parts);

/// A part was searched: its tiles are among the state's if they are good enough, and with the last part the
/// pass ends.
void take_part(SearchState& state, std::size_t part, std::vector<FoundTile> found);

/// The radius below which no tile of the pass is of interest any more.
double radius_wanted(const SearchState& state);

/// How many words a pass with that floor looks at, guessed by `probes` random ways down its parts.
struct SearchEstimate {
    double words = 0, error = 0;  // one standard error of it
};
SearchEstimate estimate_pass(int points, double floor, int probes, std::uint64_t seed);

/// How many words one core looks at in a second, measured for so many seconds.
double words_per_second(int points, double floor, double seconds);

/// A state as a few lines of text, and back. Reading throws std::runtime_error naming the line that is wrong.
std::string write_search_state(const SearchState& state);
SearchState read_search_state(std::string_view text);

}  // namespace dapple
