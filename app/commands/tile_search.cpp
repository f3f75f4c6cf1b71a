#include "app/commands/tile_search.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

#include "app/commands/options.h"
#include "app/files/atomic_file.h"
#include "app/files/text_file.h"
#include "app/files/tile_library.h"
#include "app/progress_line.h"
#include "app/stop_on_interrupt.h"
#include "core/tile/exhaustive_search.h"
#include "core/tile/identity_word.h"
#include "core/tile/relink_search.h"
#include "core/tile/rule_search.h"
#include "core/tile/rules.h"
#include "core/tile/tile_marks.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMovesPerPoint = 10'000;
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
        return read_search_state(text_of_file(file));
    } catch (const std::runtime_error& error) {
        const std::string reason = error.what();
        if (reason.starts_with(file.string())) throw;
        throw std::runtime_error(fmt::format("{}: {}", file.string(), reason));
    }
}

// Refuses to put another search where an unfinished one, or something else, lies.
void check_nothing_is_lost(const fs::path& file) {
    if (!fs::exists(file)) return;
    const std::string name = file.string();
    try {
        if (read_search_state(text_of_file(file)).finished) return;
    } catch (const std::runtime_error&) {
        throw std::runtime_error(fmt::format(
            "{}: is not a saved search, but one that is stopped would be saved there; rename or delete it",
            name));
    }
    throw std::runtime_error(fmt::format(
        "{}: holds an unfinished search; --resume {} goes on with it, and deleting it allows a new one", name,
        name));
}

void tell_found(const SearchState& state, std::ostream& out) {
    if (state.found.empty()) {
        out << "no tile found yet\n";
        return;
    }
    out << fmt::format("{:>4}  {:<15}  {:<32}  {}\n", "", "relative radius", "tile", "word");
    int place = 0;
    for (const FoundTile& found : state.found) {
        const TileIntegers integers = integers_of(found.word);
        out << fmt::format("{:>4}  {:<15.6f}  {:<32}  {}\n", ++place, found.relative_radius,
                           fmt::format("{},{}/{}", integers.a, integers.b, state.points), found.word);
    }
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
            line.show(progress.fraction,
                      fmt::format("of the tiles of radius {:.3f} and more, best so far {}", progress.floor,
                                  found.empty() ? "none" : fmt::format("{:.6f}", found[0].relative_radius)));
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
    if (options.output && !state.found.empty()) {
        const Tile best = make_tile(Rule{}, {state.found.front().word});
        save_tile(*options.output, ranked(best, RankingOrder::energy));
    }
    tell_found(state, out);
    if (state.finished) return;
    const double proven = proven_radius(state);
    out << fmt::format(
        "stopped{}; dapple tile search --resume {} goes on\n",
        std::isfinite(proven) ? fmt::format(", all tiles of radius {:.4f} and more are seen", proven) : "",
        rest.string());
}

// As many moves a run as are tried in so many seconds, all runs together.
std::uint64_t moves_in(RelinkSettings settings, double seconds, int runs, int threads) {
    std::stop_source stop;
    settings.moves = std::numeric_limits<std::uint64_t>::max();
    settings.stop = stop.get_token();
    settings.progress = {};
    const auto start = std::chrono::steady_clock::now();
    const std::jthread watch([&] {
        std::this_thread::sleep_for(std::chrono::duration<double>(std::min(0.05 * seconds, 2.0)));
        stop.request_stop();
    });
    const std::uint64_t tried = relink_search(settings).moves;
    const double spent = seconds_since(start);
    const int turns = (runs + threads - 1) / threads;
    const double rate = static_cast<double>(tried) / spent;
    return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(rate * (seconds - spent) / turns));
}

std::vector<Rule> rules_to_try() {
    std::vector<Rule> rules;
    for (const RuleMarks& marks : best_rules(kRulesTried)) rules.push_back(marks.rule);
    return rules;
}

void search_any(const TileSearchOptions& options, std::ostream& out) {
    check_can_save(*options.output);
    const int threads = options.threads > 0 ? options.threads : tbb::this_task_arena::max_concurrency();
    RelinkSettings settings;
    settings.rule = options.rule.value_or(aperiodic_rule());
    settings.points = static_cast<std::size_t>(options.points);
    settings.seed = options.seed;
    settings.moves = options.moves.value_or(kMovesPerPoint * settings.points);
    if (options.seconds) settings.moves = moves_in(settings, *options.seconds, options.runs, threads);

    RelinkResult best;
    bool interrupted = false;
    {
        const StopOnInterrupt stop;
        ProgressLine line;
        std::mutex mutex;
        double tried = 0;
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
            line.show(tried / (static_cast<double>(settings.moves) * options.runs), words);
            if (lowest.best >= saved) return;
            saver.save([&] {
                saved = lowest.best;
                save_tile(*options.output, ranked(make_tile(lowest.rule, lowest.words), RankingOrder::energy),
                          {"not finished: the best so far of a search that goes on"});
            });
        };
        tbb::task_arena arena(threads);
        arena.execute([&] {
            best = options.rule ? relink_searches(settings, options.runs).front()
                                : search_rules(settings, rules_to_try(), options.runs);
        });
        interrupted = StopOnInterrupt::interrupted();
    }
    const std::string how = fmt::format(
        "dapple tile search --points {} --rule {} --seed {} --runs {} --moves {}", options.points,
        options.rule ? text_of(settings.rule) : "any", options.seed, options.runs, settings.moves);
    std::vector<std::string> comments;
    if (!interrupted) comments.push_back("found by " + how);
    save_tile(*options.output, ranked(best.tile, RankingOrder::energy), comments);
    out << fmt::format("{} points, rule {}, energy a point {:.5f}, the lowest of {} run{}\n",
                       best.tile.size(), text_of(best.tile.rule), best.energy, options.runs,
                       options.runs == 1 ? "" : "s");
    out << fmt::format("{}\n", interrupted ? "stopped: this is the best so far, and cannot be made again"
                                           : "the same again: " + how);
}

}  // namespace

void add_search_options(CLI::App& command, TileSearchOptions& options) {
    add_whole_number(command, "--points", options.points, {.least = 4, .most = kMaxTilePoints},
                     "Points of the tile, a multiple of 4; up to 60 for identity")
        ->default_str("");
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
        ->type_name("NAME")
        ->default_str("identity");
    add_whole_number(command, "--top", options.top, {.least = 1, .most = 10'000},
                     "identity: so many tiles, distinct up to symmetry");
    add_number(command, "--seconds", options.seconds,
               {.least = 0, .most = 1e7, .at_least = NumberRange::Least::excluded}, "S",
               "identity: stop then, to go on later; any: as long a search as that allows");
    command
        .add_option_function<std::string>(
            "--moves",
            [&options](const std::string& text) {
                double moves = 0;
                if (!CLI::detail::lexical_cast(text, moves) || !(moves >= 1) || !(moves <= 1e15)) {
                    throw CLI::ValidationError("--moves", text + " is not a number of moves; give 1 or more");
                }
                options.moves = static_cast<std::uint64_t>(moves);
            },
            fmt::format("any: so many moves tried in each run, {} a point without it; half of them to choose "
                        "the rule",
                        kMovesPerPoint))
        ->type_name("N");
    add_whole_number(command, "--runs", options.runs, {.least = 1, .most = 10'000},
                     "any: independent runs, the best is kept");
    command.add_option("--seed", options.seed, "any: the same seed and moves give the same tile")
        ->type_name("N")
        ->default_str("1");
    add_whole_number(command, "--threads", options.threads, {.least = 0, .most = 1024},
                     "Processor cores to use, 0 for all; the tiles are the same");
    command
        .add_option("--resume", options.resume, "identity: go on with a stopped search, and keep it there")
        ->type_name("FILE");
    command.add_option("-o,--output", options.output, "Save the best tile, ranked by energy")
        ->type_name("FILE");
    command.footer(
        "Ctrl+C, and closing the terminal, stops and keeps what was found. A search for identity is saved "
        "as\n"
        "dapple-search-POINTS.txt, or where it was resumed, once a minute and when it stops; what is left "
        "of\n"
        "another there is never replaced.\n\n"
        "Examples:\n"
        "  dapple tile search --points 20                      the paper took three and a half days for it\n"
        "  dapple tile search --points 32 --top 1 -o best32.tile\n"
        "  dapple tile search --resume dapple-search-32.txt    after Ctrl+C\n"
        "  dapple tile search --points 64 --rule any --seconds 60 --runs 2 -o mine.tile\n"
        "  dapple tile search --points 1024 --rule 3760 --seconds 60 --runs 2 -o mine.tile");
}

void check_search_options(const CLI::App& command, const TileSearchOptions& options) {
    const auto refuse = [&](const std::string& option, const std::string& why) {
        if (command.count(option) > 0) throw CLI::ValidationError(option, why);
    };
    if (options.kind == SearchKind::identity) {
        for (const char* option : {"--moves", "--runs", "--seed"})
            refuse(option,
                   "belongs to a search with --rule any; the one for identity leaves nothing to chance");
        if (options.resume) {
            refuse("--points", "is known from the search that goes on; leave it out");
            refuse("--top", "is known from the search that goes on; leave it out");
        }
    } else {
        refuse("--top", "belongs to a search with --rule identity");
        refuse("--resume", "belongs to a search with --rule identity");
        if (options.seconds) refuse("--moves", "and --seconds exclude each other");
        if (!options.output) throw CLI::ValidationError("--output", "is needed: name the file for the tile");
    }
    if (options.resume) return;
    if (options.points == 0)
        throw CLI::ValidationError("--points", "is needed: how many points the tile has");
    const bool identity = options.kind == SearchKind::identity;
    if (options.points % 4 != 0 || (identity && options.points > kMaxIdentityWord)) {
        throw CLI::ValidationError(
            "--points", fmt::format("{} is not possible; give a multiple of 4 up to {}", options.points,
                                    identity ? static_cast<std::size_t>(kMaxIdentityWord) : kMaxTilePoints));
    }
}

void search_tiles(const TileSearchOptions& options, std::ostream& out) {
    if (options.kind == SearchKind::identity) {
        search_identity(options, out);
    } else {
        search_any(options, out);
    }
}

}  // namespace dapple
