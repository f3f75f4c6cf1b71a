#pragma once
// dapple-lab tile search: looking for new tiles.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "core/text/names.h"
#include "core/tile/tile.h"

namespace CLI {
class App;
}

namespace dapple {

enum class SearchKind {
    identity,  // all tiles of the paper's kind, by relative radius
    any,       // tiles of a rule that does not repeat, by evenness
};
/// What the best of the tiles found is the best in.
enum class TileCriterion {
    radius,       // the largest relative radius
    discrepancy,  // the lowest star discrepancy
    symmetry,     // the highest symmetry()
};
constexpr auto names_of(TileCriterion) {
    return names("radius", "discrepancy", "symmetry");
}

struct TileSearchOptions {
    int points = 0;
    int kinds = 1;  // over 1: as many, none turned, by annealing
    SearchKind kind = SearchKind::identity;
    std::optional<Rule> rule;  // of SearchKind::any; none: the one that suits the points
    std::vector<int> cycles;   // identity: the lengths of a tile's cycles; none: one cycle of all points
    int top = 5;               // identity: so many tiles, the best ones
    TileCriterion by = TileCriterion::radius;  // identity: what they are the best in
    int runs = 0;                              // any: with the seeds seed, seed + 1, ...; 0: as many as cores
    std::optional<double> seconds;             // identity: stops then; any: ends then
    std::optional<std::uint64_t> moves;        // any: tried in each run
    std::uint64_t seed = 1;
    double tone = 1, pairs = 1, peaks = 1;        // any: weights of the objective, 1 being the usual ones
    bool estimate = false;                        // identity: tell how long it would take in place of it
    int threads = 0;                              // 0: all cores
    std::optional<std::filesystem::path> resume;  // a stopped identity search to go on with
    std::optional<std::filesystem::path> output;  // the best tile, ranked by energy
};

/// --points, --rule, --top, ...
void add_search_options(CLI::App& command, TileSearchOptions& options);

/// Throws CLI::ValidationError if options contradict each other. To be called after parsing.
void check_search_options(const CLI::App& command, const TileSearchOptions& options);

/// Searches, tells the outcome on `out` and the way there on the terminal, and saves, once a minute and at
/// the end. Ctrl+C, SIGTERM and SIGHUP stop the search and keep what was found. An identity search is saved
/// to be gone on with: in the file that was resumed, which says at last that it is finished; else in
/// dapple-search-POINTS.txt, gone at the end unless a finished search was there before. Throws
/// std::runtime_error naming what is wrong, an unfinished search in that file being so.
void search_tiles(const TileSearchOptions& options, std::ostream& out);

}  // namespace dapple
