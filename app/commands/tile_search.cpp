#include "app/commands/tile_search.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/task_arena.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <mutex>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <vector>

#include "app/commands/options.h"
#include "app/files/atomic_file.h"
#include "app/files/text_file.h"
#include "app/files/tile_library.h"
#include "app/progress_line.h"
#include "app/shown_text.h"
#include "app/signals.h"
#include "core/analysis/discrepancy.h"
#include "core/tile/criterion_search.h"
#include "core/tile/cycle_search.h"
#include "core/tile/exhaustive_search.h"
#include "core/tile/identity_word.h"
#include "core/tile/kind_search.h"
#include "core/tile/relink_search.h"
#include "core/tile/rule_search.h"
#include "core/tile/rules.h"
#include "core/tile/symmetry.h"
#include "core/tile/tile_marks.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

constexpr TextKind kSearch{.what = "saved search"};
constexpr std::uint64_t kMovesPerPoint = 10'000;
constexpr int kFewestPointsOfKinds = 64;
// Of a search for several kinds, for the one tile that all of them start as.
constexpr double kShareOfStart = 0.25;
// Those under which fewer than a quarter of the tiles are turned alike at every lag; the others repeat.
constexpr std::size_t kRulesTried = 20;

// Saves what a search has at once, and again once a minute, so that whatever happens to the machine no more
// than that is lost.
class MinuteSaver {
 public:
    void save(const std::function<void()>& write) {
        const auto now = Clock::now();
        if (last_ && now - *last_ < std::chrono::minutes(1)) return;
        last_ = now;
        try {
            write();
        } catch (const std::runtime_error&) {
            // A disk that is full now may not be so at the end, when what cannot be saved is told.
        }
    }

 private:
    using Clock = std::chrono::steady_clock;
    std::optional<Clock::time_point> last_;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

SearchState resumed(const fs::path& file) {
    try {
        return read_search_state(text_of_file(file, kSearch));
    } catch (const std::runtime_error& error) {
        const std::string reason = error.what();
        if (reason.starts_with(printable(file.native()))) throw;
        throw std::runtime_error(fmt::format("{}: {}", file.string(), reason));
    }
}

// Refuses to put another search where an unfinished one, or something else, lies.
void check_nothing_is_lost(const fs::path& file) {
    if (!fs::exists(file)) return;
    const std::string name = file.string();
    try {
        if (read_search_state(text_of_file(file, kSearch)).finished) return;
    } catch (const std::runtime_error&) {
        throw std::runtime_error(fmt::format(
            "{}: is not a saved search, but one that is stopped would be saved there; rename or delete it",
            name));
    }
    throw std::runtime_error(fmt::format(
        "{}: holds an unfinished search; --resume {} goes on with it, and deleting it allows a new one", name,
        name));
}

std::vector<glm::dvec2> places_of(const Tile& tile) {
    std::vector<glm::dvec2> points;
    for (const BinaryPoint p : tile.points) points.push_back(to_unit_square(p));
    return points;
}

double star_discrepancy_of(const std::string& word) {
    return star_discrepancy(places_of(make_tile(Rule{}, {word})), Domain{}).upper;
}

// Boxes start in one corner of the square, so that a tile's images differ.
MeasuredTile least_discrepancy(const std::string& word) {
    MeasuredTile least{word, std::numeric_limits<double>::infinity()};
    for (const std::string& image : symmetric_words(word)) {
        const double cost = star_discrepancy_of(image);
        if (cost < least.cost) least = {image, cost};
    }
    return least;
}

MeasuredTile least_asymmetry(const std::string& word) {
    return {word, 1 - symmetry(make_tile(Rule{}, {word}))};
}

void print_found(const std::vector<std::string>& words, int points, std::ostream& out) {
    if (words.empty()) {
        out << "no tile found yet\n";
        return;
    }
    out << fmt::format("{:>4}  {:<15}  {:<11}  {:<8}  {:<32}  {}\n", "", "relative radius", "discrepancy",
                       "symmetry", "tile", "word");
    int place = 0;
    for (const std::string& word : words) {
        const TileIntegers integers = integers_of(word);
        out << fmt::format("{:>4}  {:<15.6f}  {:<11.6f}  {:<8.3f}  {:<32}  {}\n", ++place,
                           relative_radius(word), star_discrepancy_of(word),
                           symmetry(make_tile(Rule{}, {word})),
                           fmt::format("{},{}/{}", integers.a, integers.b, points), word);
    }
}

void save_first(const std::vector<std::string>& words, const std::optional<fs::path>& output) {
    if (!output || words.empty()) return;
    save_tile(*output, ranked(make_tile(Rule{}, {words.front()}), RankingMethod::energy));
}

// Several cycles together. There are few enough to be done before anyone waits.
void search_sets(const TileSearchOptions& options, std::ostream& out) {
    if (options.output) check_can_save(*options.output);
    std::optional<std::chrono::duration<double>> limit;
    if (options.seconds) limit = std::chrono::duration<double>(*options.seconds);
    CycleSearchResult result;
    {
        const StopOnInterrupt stop(limit);
        result = search_cycles(options.cycles, static_cast<std::size_t>(options.top), stop.token());
    }
    if (options.output && !result.best.empty())
        save_tile(*options.output, ranked(make_tile(Rule{}, result.best[0].words), RankingMethod::energy));
    if (result.best.empty()) {
        out << (result.finished ? "no such tile has its points apart\n" : "no tile found yet\n");
    } else {
        out << fmt::format("{:>4}  {:<15}  {:<11}  {:<8}  {}\n", "", "relative radius", "discrepancy",
                           "symmetry", "words");
    }
    int place = 0;
    for (const FoundCycles& found : result.best) {
        const Tile tile = make_tile(Rule{}, found.words);
        out << fmt::format("{:>4}  {:<15.6f}  {:<11.6f}  {:<8.3f}  {}\n", ++place, found.relative_radius,
                           star_discrepancy(places_of(tile), Domain{}).upper, symmetry(tile),
                           fmt::join(found.words, " "));
    }
    if (!result.finished) out << "stopped: there may be better ones\n";
}

// By a measure that lets no tile be left out.
void search_by(const TileSearchOptions& options, std::ostream& out) {
    if (options.output) check_can_save(*options.output);
    std::optional<std::chrono::duration<double>> limit;
    if (options.seconds) limit = std::chrono::duration<double>(*options.seconds);
    CriterionResult result;
    {
        const StopOnInterrupt stop(limit);
        ProgressLine line;
        line.restart(0);
        result = search_by_criterion(
            options.points, static_cast<std::size_t>(options.top),
            options.by == TileCriterion::discrepancy ? least_discrepancy : least_asymmetry,
            {.threads = options.threads, .stop = stop.token(), .on_progress = [&](double share) {
                 line.show(share, "of all tiles");
             }});
    }
    std::vector<std::string> words;
    for (const MeasuredTile& tile : result.best) words.push_back(tile.word);
    save_first(words, options.output);
    print_found(words, options.points, out);
    if (!result.finished)
        out << fmt::format("stopped after {} tiles: there may be better ones\n", grouped(result.tiles));
}

void search_identity(const TileSearchOptions& options, std::ostream& out) {
    SearchState state =
        options.resume ? resumed(*options.resume) : start_exhaustive_search(options.points, options.top);
    const fs::path rest =
        options.resume.value_or(fs::path(fmt::format("dapple-search-{}.txt", state.points)));
    if (!options.resume) check_nothing_is_lost(rest);
    if (options.output) {
        check_apart(*options.output, {{rest, "the search that can be gone on with"}});
        check_can_save(*options.output);
    }
    check_can_save(rest);
    const bool was_there = fs::exists(rest);
    const auto save_rest = [&](const SearchState& known) {
        const std::string text = write_search_state(known);
        save_atomically(rest, [&](std::ostream& file) { file << text; });
    };

    std::optional<std::chrono::duration<double>> limit;
    if (options.seconds) limit = std::chrono::duration<double>(*options.seconds);
    {
        const StopOnInterrupt stop(limit);
        ProgressLine line;
        MinuteSaver saver;
        double floor = -1;
        const auto show = [&](const SearchProgress& progress) {
            if (progress.floor > floor || progress.floor < floor) {
                // A lower floor is a new pass; a floor that rises within one costs the estimate nothing much.
                if (progress.floor < floor || floor < 0) line.restart(progress.fraction);
                floor = progress.floor;
            }
            const std::vector<FoundTile>& found = progress.state.found;
            const bool last = found.size() == static_cast<std::size_t>(progress.state.top);
            line.show(progress.fraction,
                      fmt::format("of the tiles of radius {:.3f} and more, best so far {}", progress.floor,
                                  found.empty() ? "none" : fmt::format("{:.6f}", found[0].relative_radius)),
                      last ? "last pass" : "this pass, longer ones follow");
            saver.save([&] { save_rest(progress.state); });
        };
        state = continue_exhaustive_search(
            std::move(state), {.threads = options.threads, .stop = stop.token(), .on_progress = show});
    }
    // All is saved before anything is told: whoever listens may have gone.
    if (!state.finished || was_there) {
        save_rest(state);
    } else {
        std::error_code error;
        fs::remove(rest, error);
    }
    std::vector<std::string> words;
    for (const FoundTile& found : state.found) words.push_back(found.word);
    save_first(words, options.output);
    print_found(words, state.points, out);
    if (state.finished) return;
    const double proven = proven_radius(state);
    out << fmt::format(
        "stopped{}; dapple tile search --resume {} goes on\n",
        std::isfinite(proven) ? fmt::format(", all tiles of radius {:.4f} and more are seen", proven) : "",
        printable(rest.native()));
}

// Energies, and with them temperatures, stay in one range: only the ratios of the weights count.
void weigh(RelinkSettings& settings, const TileSearchOptions& options) {
    const double larger = std::max(options.tone, options.pairs);
    settings.shape.tone_weight *= options.tone / larger;
    settings.shape.close_weight *= options.pairs / larger;
    settings.peak_weight *= options.peaks / larger;
}

// The options as a person gives them, for the search to be made again.
std::string command_of(const TileSearchOptions& options, int runs) {
    std::string command =
        fmt::format("dapple tile search --points {} --rule {} --seed {} --runs {}", options.points,
                    options.rule ? text_of(*options.rule) : "any", options.seed, runs);
    if (options.tone != 1) command += fmt::format(" --tone {}", options.tone);
    if (options.pairs != 1) command += fmt::format(" --pairs {}", options.pairs);
    if (options.peaks != 1) command += fmt::format(" --peaks {}", options.peaks);
    return command;
}

std::vector<Rule> rules_to_try() {
    std::vector<Rule> rules;
    for (const RuleMarks& marks : best_rules(kRulesTried)) rules.push_back(marks.rule);
    return rules;
}

void search_kinds(const TileSearchOptions& options, std::ostream& out) {
    check_can_save(*options.output);
    const auto points = static_cast<std::uint64_t>(options.points);
    const auto kinds = static_cast<std::uint64_t>(options.kinds);
    const std::uint64_t moves = options.moves.value_or(kMovesPerPoint * points * kinds);
    const auto of_start = static_cast<std::uint64_t>(kShareOfStart * static_cast<double>(moves));
    const auto start = std::chrono::steady_clock::now();
    std::function<double()> clock;
    if (options.seconds) clock = [start] { return seconds_since(start); };
    const double seconds = options.seconds.value_or(0);

    KindSearchResult found;
    std::uint64_t tried = 0;
    bool interrupted = false;
    {
        const StopOnInterrupt stop;
        ProgressLine line;
        const auto show = [&](std::uint64_t so_far, double energy) {
            line.show(clock ? clock() / seconds : static_cast<double>(so_far) / static_cast<double>(moves),
                      fmt::format("energy a point {:.5f}", energy));
        };
        RelinkSettings first;
        first.rule = Rule{};
        first.points = points;
        first.seed = options.seed;
        first.moves = std::max<std::uint64_t>(of_start, 1);
        first.clock = clock;
        first.seconds = kShareOfStart * seconds;
        first.peak_weight = 0;
        first.progress = [&](const RelinkProgress& p) { show(p.moves, p.energy); };
        first.stop = stop.token();
        const RelinkResult one = relink_search(first);

        KindSearchSettings settings;
        settings.start = one.tile;
        settings.kinds = options.kinds;
        settings.seed = options.seed;
        settings.moves = moves - std::min(moves, of_start);
        settings.clock = clock;
        settings.seconds = clock ? std::max(seconds - clock(), 0.0) : 0;
        settings.progress = [&](const KindSearchProgress& p) { show(one.moves + p.moves, p.energy); };
        settings.stop = stop.token();
        found = kind_search(settings);
        tried = one.moves + found.moves;
        interrupted = StopOnInterrupt::interrupted();
    }
    const std::string command =
        fmt::format("dapple tile search --kinds {} --points {} --seed {}", kinds, points, options.seed);
    std::string again, how;
    if (interrupted) {
        again = "stopped: this is what there was, and cannot be made again";
    } else if (options.seconds) {
        again = fmt::format(
            "timed: the same again would be another tile; about as long, and always the same: {} --moves {}",
            command, tried);
        how = fmt::format("found by {} --seconds {}; timed, so that the same again is another tile", command,
                          *options.seconds);
    } else {
        how = fmt::format("found by {} --moves {}", command, moves);
        again = fmt::format("the same again: {} --moves {}", command, moves);
    }
    std::vector<std::string> comments;
    if (!how.empty()) comments.push_back(how);
    save_tile(*options.output, ranked(std::move(found.tile), RankingMethod::energy), comments);
    out << fmt::format("{} kinds of {} points, energy a point {:.5f}\n{}\n", kinds, points, found.energy,
                       again);
}

void search_any(const TileSearchOptions& options, std::ostream& out) {
    check_can_save(*options.output);
    const int threads = options.threads > 0 ? options.threads : tbb::this_task_arena::max_concurrency();
    RelinkSettings settings;
    settings.rule = options.rule.value_or(aperiodic_rule());
    settings.points = static_cast<std::size_t>(options.points);
    settings.seed = options.seed;
    settings.moves = options.moves.value_or(kMovesPerPoint * settings.points);
    weigh(settings, options);
    const int runs = options.runs > 0 ? options.runs : threads;
    const auto start = std::chrono::steady_clock::now();
    if (options.seconds) {
        settings.clock = [start] { return seconds_since(start); };
        settings.seconds = *options.seconds;
    }

    RelinkResult best;
    double tried = 0;
    bool interrupted = false;
    {
        const StopOnInterrupt stop;
        ProgressLine line;
        std::mutex mutex;
        RelinkProgress lowest;
        lowest.best = std::numeric_limits<double>::infinity();
        MinuteSaver saver;
        double saved = lowest.best;
        settings.stop = stop.token();
        settings.progress = [&](const RelinkProgress& progress) {
            const std::lock_guard lock(mutex);
            tried += static_cast<double>(progress.new_moves);
            if (progress.best < lowest.best) lowest = progress;
            std::string words = fmt::format("lowest energy a point so far {:.5f}", lowest.best);
            if (!options.rule)
                words = fmt::format("trying rule {}; {}, with rule {}", text_of(progress.rule), words,
                                    text_of(lowest.rule));
            line.show(options.seconds ? seconds_since(start) / *options.seconds
                                      : tried / (static_cast<double>(settings.moves) * runs),
                      words);
            if (lowest.best >= saved) return;
            saver.save([&] {
                saved = lowest.best;
                save_tile(*options.output,
                          ranked(make_tile(lowest.rule, lowest.words), RankingMethod::energy),
                          {"not finished: the best so far of a search that goes on"});
            });
        };
        tbb::task_arena arena(threads);
        arena.execute([&] {
            best = options.rule ? relink_searches(settings, runs).front()
                                : search_rules(settings, rules_to_try(), runs);
        });
        interrupted = StopOnInterrupt::interrupted();
    }
    const std::string command = command_of(options, runs);
    const auto of_so_many_moves = [&](double moves) {
        return fmt::format("{} --moves {:.0f}", command, std::max(moves, 1.0));
    };
    std::string again, how;
    if (interrupted) {
        again = "stopped: this is the best so far, and cannot be made again";
    } else if (options.seconds) {
        again = "timed: the same again would be another tile; about as long, and always the same: " +
                of_so_many_moves(tried / runs);
        how = fmt::format("found by {} --seconds {}; timed, so that the same again is another tile", command,
                          *options.seconds);
    } else {
        const std::string same = of_so_many_moves(static_cast<double>(settings.moves));
        again = "the same again: " + same;
        how = "found by " + same;
    }
    std::vector<std::string> comments;
    if (!how.empty()) comments.push_back(how);
    save_tile(*options.output, ranked(best.tile, RankingMethod::energy), comments);
    out << fmt::format("{} points, rule {}, energy a point {:.5f}, the lowest of {} run{}\n{}\n",
                       best.tile.size(), text_of(best.tile.rule), best.energy, runs, runs == 1 ? "" : "s",
                       again);
}

}  // namespace

void add_search_options(CLI::App& command, TileSearchOptions& options) {
    add_whole_number(command, "--points", options.points, {.least = 4, .most = kMaxTilePoints},
                     "Points of the tile, a multiple of 4; up to 60 for identity")
        ->default_str("");
    add_whole_number(command, "--kinds", options.kinds, {.least = 1, .most = static_cast<int>(kMaxKinds)},
                     "Look for a tile of so many kinds, with --points of each, none of them turned: they fit "
                     "each other without seams, and a picture repeats less the more there are");
    command
        .add_option_function<std::string>(
            "--rule",
            [&options](const std::string& text) {
                options.rule.reset();
                options.kind = text == "identity" ? SearchKind::identity : SearchKind::any;
                if (text == "identity" || text == "any") return;
                std::string digits = text;
                std::erase_if(digits, [](char c) { return c == ' ' || c == ','; });
                if (digits.size() != 4 || digits.find_first_not_of("01234567") != std::string::npos) {
                    throw CLI::ValidationError(
                        "--rule",
                        text + " is not known; there are identity, any, and four digits such as 3760");
                }
                Rule rule;
                for (std::size_t q = 0; q < 4; ++q)
                    rule.child[q].index = static_cast<std::uint8_t>(digits[q] - '0');
                options.rule = rule;
            },
            "identity: every tile of the paper's kind, by radius; any: tiles with turned copies that do not "
            "repeat, by annealing, the rule that suits them best among them; or a rule of four orientations, "
            "such as 3760, for that alone")
        ->type_name("identity|any|RULE")
        ->default_str("identity");
    command
        .add_option_function<std::string>(
            "--cycles",
            [&options](const std::string& text) {
                options.cycles.clear();
                std::istringstream parts(text);
                for (std::string part; std::getline(parts, part, ',');)
                    options.cycles.push_back(static_cast<int>(count_in("--cycles", part, kMostCycleLength)));
            },
            fmt::format("identity: instead of --points, look at tiles of several cycles, of so many points "
                        "each, {} at "
                        "most; 4,4,4,4 is the paper's 16 points from four tiles of 4",
                        kMostCycleLength))
        ->type_name("N,N,...");
    add_whole_number(command, "--top", options.top, {.least = 1, .most = 10'000},
                     "identity: how many of the best tiles to keep; mirrored and turned copies count as one");
    add_choice(command, "--by", options.by,
               "identity: what the best tiles have: the largest radius, the lowest star discrepancy, or the "
               "most symmetry, which is likeness to their own turned and moved copies. For the latter two "
               "every tile is looked at, which takes seconds for 12 points, minutes for 16 and hours for 20, "
               "the most there may be");
    add_number(command, "--seconds", options.seconds, {.least = 0.001, .most = 1e7}, "S",
               "identity: stop after so many seconds, to go on later; any: search for so many. Which tile is "
               "found then depends on the machine's speed; with --moves it is the same on all");
    command
        .add_option_function<std::string>(
            "--moves",
            [&options](const std::string& text) {
                options.moves = count_in("--moves", text, 1'000'000'000'000'000);
            },
            fmt::format("any: how many moves to try in each run, half of them to choose the rule; without "
                        "it, {} a point",
                        kMovesPerPoint))
        ->type_name("N");
    add_whole_number(command, "--runs", options.runs, {.least = 0, .most = 10'000},
                     "any: how many independent runs, of which the best is kept; 0 for one on each core");
    add_seed(
        command, options.seed,
        "any: the same seed, moves and runs give the same tile; to make it again on another machine, give "
        "--runs too");
    add_whole_number(command, "--threads", options.threads, {.least = 0, .most = 1024},
                     "Processor cores to use, 0 for all; with --runs given, the tiles are the same");
    const NumberRange weights{.least = 0, .most = 1000};
    add_number(command, "--tone", options.tone, weights, "W",
               "any: how much an even tone counts; this and the next two are relative to each other");
    add_number(command, "--pairs", options.pairs, weights, "W",
               "any: how much it counts that no two points lie close together");
    add_number(command, "--peaks", options.peaks, weights, "W",
               "any: how much it counts that pictures don't repeat, peaks of the spectrum being low");
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
        "  dapple tile search --points 20                      the paper took three and a half days for it\n"
        "  dapple tile search --points 32 --top 1 -o best32.tile\n"
        "  dapple tile search --points 12 --by discrepancy\n"
        "  dapple tile search --cycles 4,4,4,4                 farther apart than 16 points in one cycle\n"
        "  dapple tile search --resume dapple-search-32.txt    after Ctrl+C\n"
        "  dapple tile search --points 64 --rule any --seconds 60 -o mine.tile\n"
        "  dapple tile search --points 1024 --rule 3760 --seconds 60 -o mine.tile\n"
        "  dapple tile search --points 256 --rule 3760 --pairs 5 -o apart.tile    points farther apart, less "
        "even\n"
        "  dapple tile search --kinds 8 --points 1024 --seconds 300 -o kinds.tile");
}

void check_search_options(const CLI::App& command, const TileSearchOptions& options) {
    const auto refuse = [&](const std::string& option, const std::string& why) {
        if (command.count(option) > 0) throw CLI::ValidationError(option, why);
    };
    if (options.kinds > 1) {
        for (const char* option : {"--rule", "--cycles", "--top", "--by", "--runs", "--threads", "--tone",
                                   "--pairs", "--peaks", "--resume"})
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
            refuse("--resume", "goes on with a search by radius; leave --by out");
        if (options.resume) {
            refuse("--points", "is known from the search that goes on; leave it out");
            refuse("--top", "is known from the search that goes on; leave it out");
        }
        if (!options.cycles.empty()) {
            refuse("--points", "is the sum of --cycles; leave it out");
            for (const char* option : {"--by", "--resume"}) refuse(option, "does not go with --cycles");
        }
    } else {
        for (const char* option : {"--top", "--by", "--resume", "--cycles"})
            refuse(option, "belongs to a search with --rule identity");
        if (options.seconds) refuse("--moves", "and --seconds exclude each other");
        if (options.tone == 0 && options.pairs == 0) {
            throw CLI::ValidationError(
                "--tone", "0 and --pairs 0 leave points anywhere; give one of them a weight above 0");
        }
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
    if (options.kinds > 1) {
        search_kinds(options, out);
    } else if (!options.cycles.empty()) {
        search_sets(options, out);
    } else if (options.kind == SearchKind::identity && options.by != TileCriterion::radius) {
        search_by(options, out);
    } else if (options.kind == SearchKind::identity) {
        search_identity(options, out);
    } else {
        search_any(options, out);
    }
}

}  // namespace dapple
