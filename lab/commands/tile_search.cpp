#include "lab/commands/tile_search.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <numeric>
#include <sstream>

#include "io/command_line/options.h"
#include "io/files/atomic_file.h"
#include "lab/commands/tile_annealing.h"
#include "lab/commands/tile_enumeration.h"
#include "lab/search/criterion_search.h"
#include "lab/search/cycle_search.h"
#include "lab/search/identity_word.h"

namespace dapple {
namespace {

constexpr int kFewestPointsOfKinds = 64;

}  // namespace

void add_search_options(CLI::App& command, TileSearchOptions& options) {
    add_whole_number(command, "--points", options.points, {.least = 4, .most = kMaxTilePoints},
                     "Points of the tile, a multiple of 4; up to 60 for identity")
        ->default_str("");
    add_whole_number(command, "--kinds", options.kinds, {.least = 1, .most = static_cast<int>(kMaxKinds)},
                     "Searches for a tile of this many kinds, each with --points points and none turned: "
                     "they are compatible without seams, and more kinds repeat less");
    const auto read_rule = [&options](const std::string& text) {
        options.rule.reset();
        options.kind = text == "identity" ? SearchKind::identity : SearchKind::any;
        if (text == "identity" || text == "any") return;
        std::string digits = text;
        std::erase_if(digits, [](char c) { return c == ' ' || c == ','; });
        if (digits.size() != 4 || digits.find_first_not_of("01234567") != std::string::npos)
            throw std::runtime_error(text +
                                     " is not known; there are identity, any, and four digits such as 3760");
        Rule rule;
        for (std::size_t q = 0; q < 4; ++q) rule.child[q].index = static_cast<std::uint8_t>(digits[q] - '0');
        options.rule = rule;
    };
    add_text(command, "--rule", "identity|any|RULE", read_rule,
             "identity: every tile of the paper's kind, by radius; any: tiles with turned copies that do not "
             "repeat, by annealing, the rule that suits them best among them; or a rule of four "
             "orientations, such as 3760, for that alone")
        ->default_str("identity");
    const auto read_cycles = [&options](const std::string& text) {
        options.cycles.clear();
        std::istringstream parts(text);
        for (std::string part; std::getline(parts, part, ',');)
            options.cycles.push_back(static_cast<int>(count_in(part, kMostCycleLength)));
    };
    add_text(
        command, "--cycles", "N,N,...", read_cycles,
        fmt::format("identity: instead of --points, look at tiles of several cycles, each of the number of "
                    "points given for it, {} at most; 4,4,4,4 is the paper's 16 points from four tiles of 4",
                    kMostCycleLength));
    add_whole_number(command, "--top", options.top, {.least = 1, .most = 10'000},
                     "identity: how many of the best tiles to keep; mirrored and turned copies count as one");
    add_choice(command, "--by", options.by,
               "identity: what the best tiles have: the largest radius, the lowest star discrepancy, or the "
               "most symmetry, which is likeness to their own turned and moved copies. For the latter two "
               "every tile is looked at, which takes seconds for 12 points, minutes for 16 and hours for 20, "
               "the most there may be");
    add_number(command, "--seconds", options.seconds, {.least = 0.001, .most = 1e7}, "S",
               "identity: stop after this many seconds, to go on later; any and kinds: search for this many. "
               "Which tile is found then depends on the machine's speed; with --moves it is the same on all");
    add_count(command, "--moves", options.moves, 1'000'000'000'000'000,
              fmt::format("any and kinds: moves to try; any tries this many in each run, half of them to "
                          "choose the rule. Without it, {} a point",
                          kMovesPerPoint));
    add_whole_number(command, "--runs", options.runs, {.least = 0, .most = 10'000},
                     "any: how many independent runs, of which the best is kept; 0 for one on each core");
    add_seed(command, options.seed,
             "any and kinds: the same seed, moves and runs give the same tile; to make it again on another "
             "machine, give "
             "--runs too");
    add_whole_number(command, "--threads", options.threads, {.least = 0, .most = 1024},
                     "Processor cores to use, 0 for all; with --runs given, the tiles are the same");
    const NumberRange weights{.least = 0, .most = 1000};
    add_number(
        command, "--tone", options.tone, weights, "W",
        "any and kinds: how much an even tone counts; this and the next two are relative to each other");
    add_number(command, "--pairs", options.pairs, weights, "W",
               "any and kinds: how much it counts that no two points lie close together");
    add_number(command, "--peaks", options.peaks, weights, "W",
               "any and kinds: how much it counts that pictures don't repeat, peaks of the spectrum being "
               "low, and that kinds differ");
    command.add_flag("--estimate", options.estimate,
                     "identity: guess how many words a search by radius looks at, and for how long, by how "
                     "good the last of its tiles is");
    command
        .add_option("--resume", options.resume,
                    "identity: go on with a stopped search, which stays saved in that file")
        ->type_name("FILE");
    command.add_option("-o,--output", options.output, "Save the best tile, ranked by energy")
        ->type_name("FILE");
    command.footer(
        "Ctrl+C or closing the terminal stops the search and keeps what was found. A search for identity "
        "is\nsaved once a minute and when it stops, in dapple-search-POINTS.txt or the file it was resumed "
        "from.\nA file that holds another search is left as it is.\n\n"
        "Examples:\n"
        "  dapple-lab tile search --points 20                      the paper took three and a half days for "
        "it\n"
        "  dapple-lab tile search --points 32 --top 1 -o best32.tile\n"
        "  dapple-lab tile search --points 12 --by discrepancy\n"
        "  dapple-lab tile search --cycles 4,4,4,4                 farther apart than 16 points in one "
        "cycle\n"
        "  dapple-lab tile search --resume dapple-search-32.txt    after Ctrl+C\n"
        "  dapple-lab tile search --points 64 --rule any --seconds 60 -o mine.tile\n"
        "  dapple-lab tile search --points 1024 --rule 3760 --seconds 60 -o mine.tile\n"
        "  dapple-lab tile search --points 256 --rule 3760 --pairs 5 -o apart.tile    points farther apart, "
        "less "
        "even\n"
        "  dapple-lab tile search --kinds 8 --points 1024 --seconds 300 -o kinds.tile");
}

void check_search_options(const CLI::App& command, const TileSearchOptions& options) {
    const auto refuse = [&](const std::string& option, const std::string& why) {
        if (command.count(option) > 0) throw CLI::ValidationError(option, why);
    };
    if (options.tone == 0 && options.pairs == 0) {
        throw CLI::ValidationError(
            "--tone", "0 and --pairs 0 leave points anywhere; give one of them a weight above 0");
    }
    if (options.kinds > 1) {
        for (const char* option :
             {"--rule", "--cycles", "--top", "--by", "--runs", "--threads", "--resume", "--estimate"})
            refuse(option, "does not go with --kinds");
        if (options.seconds) refuse("--moves", "and --seconds exclude each other");
        if (!options.output) throw CLI::ValidationError("--output", "is needed: name the file for the tile");
        if (options.points % 4 != 0 || options.points < kFewestPointsOfKinds) {
            throw CLI::ValidationError(
                "--points", fmt::format("{} is not possible with --kinds; give a multiple of 4 from {} to {}",
                                        options.points, kFewestPointsOfKinds, kMaxTilePoints));
        }
        return;
    }
    if (options.kind == SearchKind::identity) {
        for (const char* option : {"--moves", "--runs", "--seed", "--tone", "--pairs", "--peaks"})
            refuse(option,
                   "belongs to a search with --rule any; the one for identity leaves nothing to chance");
        if (options.by != TileCriterion::radius)
            for (const char* option : {"--resume", "--estimate"})
                refuse(option, "is for a search by radius; leave --by out");
        if (options.estimate)
            for (const char* option : {"--resume", "--output", "--top", "--seconds"})
                refuse(option, "is for the search itself; leave --estimate out");
        if (options.resume) {
            refuse("--points", "is known from the search that goes on; leave it out");
            refuse("--top", "is known from the search that goes on; leave it out");
        }
        if (!options.cycles.empty()) {
            refuse("--points", "is the sum of --cycles; leave it out");
            for (const char* option : {"--by", "--resume", "--estimate"})
                refuse(option, "does not go with --cycles");
        }
    } else {
        for (const char* option : {"--top", "--by", "--resume", "--cycles", "--estimate"})
            refuse(option, "belongs to a search with --rule identity");
        if (options.seconds) refuse("--moves", "and --seconds exclude each other");
        if (!options.output) throw CLI::ValidationError("--output", "is needed: name the file for the tile");
    }
    if (options.resume) return;
    if (!options.cycles.empty()) {
        const int points = std::accumulate(options.cycles.begin(), options.cycles.end(), 0);
        if (points % 4 == 0) return;
        throw CLI::ValidationError(
            "--cycles",
            fmt::format("have {} points together; give lengths whose sum is a multiple of 4", points));
    }
    if (options.points == 0)
        throw CLI::ValidationError("--points", "is needed: how many points the tile has");
    const bool identity = options.kind == SearchKind::identity;
    if (options.points % 4 != 0 || (identity && options.points > kMaxIdentityWord)) {
        throw CLI::ValidationError(
            "--points", fmt::format("{} is not possible; give a multiple of 4 up to {}", options.points,
                                    identity ? static_cast<std::size_t>(kMaxIdentityWord) : kMaxTilePoints));
    }
    if (options.by != TileCriterion::radius && options.points > kMostCriterionPoints) {
        throw CLI::ValidationError(
            "--by",
            fmt::format("{} looks at every tile, and of {} points there are too many; give {} or fewer",
                        name_of(options.by), options.points, kMostCriterionPoints));
    }
}

void search_tiles(const TileSearchOptions& options, std::ostream& out) {
    if (options.estimate) {
        estimate_search(options.points, out);
    } else if (options.kinds > 1) {
        check_can_save(*options.output);
        search_kinds(options, out);
    } else if (!options.cycles.empty()) {
        search_cycle_sets(options, out);
    } else if (options.kind == SearchKind::identity && options.by != TileCriterion::radius) {
        search_by_measure(options, out);
    } else if (options.kind == SearchKind::identity) {
        search_by_radius(options, out);
    } else {
        search_turned(options, out);
    }
}

}  // namespace dapple
