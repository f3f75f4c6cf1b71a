#include "lab/commands/tile_annealing.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <limits>
#include <mutex>
#include <string>
#include <vector>

#include "io/files/atomic_file.h"
#include "io/files/tile_library.h"
#include "io/progress_line.h"
#include "io/signals.h"
#include "lab/commands/minute_saver.h"
#include "lab/commands/save_tile.h"
#include "lab/search/kind_search.h"
#include "lab/search/relink_search.h"
#include "lab/search/rule_search.h"
#include "lab/search/rules.h"
#include "lab/search/tile_marks.h"

namespace dapple {
namespace {

// The share of a search for several kinds that goes into the one tile that all of them start as.
constexpr double kShareOfStart = 0.25;
// Those under which fewer than a quarter of the tiles are turned alike at every lag; the others repeat.
constexpr std::size_t kRulesTried = 20;

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Energies, and with them temperatures, stay in one range: only the ratios of the weights count.
void weigh(const TileSearchOptions& options, PairShape& shape, double& peaks) {
    const double larger = std::max(options.tone, options.pairs);
    shape.tone_weight *= options.tone / larger;
    shape.close_weight *= options.pairs / larger;
    peaks *= options.peaks / larger;
}

// Saves the tile with how it was found, and tells how to find it again: by so many moves in each run. `what`
// has the options as a person gives them, without the weights.
void finish(const TileSearchOptions& options, std::string what, std::uint64_t moves, bool interrupted,
            Tile tile, const std::string& found, std::ostream& out) {
    if (options.tone != 1) what += fmt::format(" --tone {}", options.tone);
    if (options.pairs != 1) what += fmt::format(" --pairs {}", options.pairs);
    if (options.peaks != 1) what += fmt::format(" --peaks {}", options.peaks);
    const std::string same = fmt::format("{} --moves {}", what, std::max<std::uint64_t>(moves, 1));
    std::string again = "the same again: " + same;
    std::vector<std::string> comments{"found by " + same};
    if (interrupted) {
        again = "stopped: this is the best so far, and cannot be made again";
        comments.clear();
    } else if (options.seconds) {
        again =
            "timed, so running it again finds another tile; this takes about as long and always finds the "
            "same one: " +
            same;
        comments = {fmt::format("found by {} --seconds {}; timed, so running it again finds another tile",
                                what, *options.seconds)};
    }
    save_tile(*options.output, ranked(std::move(tile), RankingMethod::energy), comments);
    out << found << "\n" << again << "\n";
}

std::vector<Rule> rules_to_try() {
    std::vector<Rule> rules;
    for (const RuleMarks& marks : best_rules(kRulesTried)) rules.push_back(marks.rule);
    return rules;
}

}  // namespace

void search_kinds(const TileSearchOptions& options, std::ostream& out, const IslandSearch& side_by_side) {
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
        first.seed = options.seed + static_cast<std::uint64_t>(side_by_side.island);
        first.moves = std::max<std::uint64_t>(of_start, 1);
        first.clock = clock;
        first.seconds = kShareOfStart * seconds;
        KindSearchSettings settings;
        weigh(options, settings.shape, settings.apart);
        first.shape = settings.shape;
        first.peak_weight = 0;
        first.progress = [&](const RelinkProgress& p) { show(p.moves, p.energy); };
        first.stop = stop.token();
        const RelinkResult one = relink_search(first);

        settings.start = one.tile;
        settings.island = side_by_side.island;
        settings.best = side_by_side.best;
        if (settings.best) {
            const Island best = settings.best(island_of(one.tile, one.energy));
            settings.start = make_tile(Rule{}, NextKinds(1), best.letters, best.successors);
        }
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
    if (side_by_side.island > 0) return;
    const std::string program =
        side_by_side.best ? fmt::format("mpirun -n {} dapple-mpi", side_by_side.islands) : "dapple-lab";
    finish(
        options,
        fmt::format("{} tile search --kinds {} --points {} --seed {}", program, kinds, points, options.seed),
        options.seconds ? tried : moves, interrupted, std::move(found.tile),
        fmt::format("{} kinds of {} points, energy a point {:.5f}", kinds, points, found.energy), out);
}

void search_turned(const TileSearchOptions& options, std::ostream& out) {
    check_can_save(*options.output);
    const int threads = options.threads > 0 ? options.threads : tbb::this_task_arena::max_concurrency();
    RelinkSettings settings;
    settings.rule = options.rule.value_or(aperiodic_rule());
    settings.points = static_cast<std::size_t>(options.points);
    settings.seed = options.seed;
    settings.moves = options.moves.value_or(kMovesPerPoint * settings.points);
    weigh(options, settings.shape, settings.peak_weight);
    const int runs = options.runs > 0 ? options.runs : threads;
    const auto start = std::chrono::steady_clock::now();
    if (options.seconds) {
        settings.clock = [start] { return seconds_since(start); };
        settings.seconds = *options.seconds;
    }

    RelinkResult best;
    std::uint64_t tried = 0;
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
            tried += progress.new_moves;
            if (progress.best < lowest.best) lowest = progress;
            std::string words = fmt::format("lowest energy a point so far {:.5f}", lowest.best);
            if (!options.rule)
                words = fmt::format("trying rule {}; {}, with rule {}", text_of(progress.rule), words,
                                    text_of(lowest.rule));
            line.show(options.seconds
                          ? seconds_since(start) / *options.seconds
                          : static_cast<double>(tried) / (static_cast<double>(settings.moves) * runs),
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
    finish(options,
           fmt::format("dapple-lab tile search --points {} --rule {} --seed {} --runs {}", options.points,
                       options.rule ? text_of(*options.rule) : "any", options.seed, runs),
           options.seconds ? tried / static_cast<std::uint64_t>(runs) : settings.moves, interrupted,
           best.tile,
           fmt::format("{} points, rule {}, energy a point {:.5f}, the lowest of {} run{}", best.tile.size(),
                       text_of(best.tile.rule), best.energy, runs, runs == 1 ? "" : "s"),
           out);
}

}  // namespace dapple
