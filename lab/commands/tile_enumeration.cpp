#include "lab/commands/tile_enumeration.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/analysis/report.h"
#include "core/text/shown_text.h"
#include "io/files/atomic_file.h"
#include "io/files/text_file.h"
#include "io/files/tile_library.h"
#include "io/progress_line.h"
#include "io/signals.h"
#include "lab/commands/minute_saver.h"
#include "lab/commands/save_tile.h"
#include "lab/search/criterion_search.h"
#include "lab/search/cycle_search.h"
#include "lab/search/exhaustive_search.h"
#include "lab/search/identity_word.h"
#include "lab/search/symmetry.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

constexpr TextKind kSearch{.what = "saved search"};

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
        throw std::runtime_error(
            fmt::format("{}: is in the way, as this search would be saved there if it is stopped; rename or "
                        "delete that file",
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

}  // namespace

void search_cycle_sets(const TileSearchOptions& options, std::ostream& out) {
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
        out << (result.finished ? "in each such tile some points coincide\n" : "no tile found yet\n");
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

void search_by_measure(const TileSearchOptions& options, std::ostream& out) {
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

void search_by_radius(const TileSearchOptions& options, std::ostream& out, const ContinueSearch& go_on) {
    SearchState state =
        options.resume ? resumed(*options.resume) : start_exhaustive_search(options.points, options.top);
    const fs::path rest =
        options.resume.value_or(fs::path(fmt::format("dapple-search-{}.txt", state.points)));
    if (!options.resume) check_nothing_is_lost(rest);
    if (options.output) {
        check_apart({{*options.output, "the tile"}}, {{rest, "the search that can be gone on with"}});
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
        state =
            go_on(std::move(state), {.threads = options.threads, .stop = stop.token(), .on_progress = show});
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
        "stopped{}; dapple-lab tile search --resume {} goes on\n",
        std::isfinite(proven) ? fmt::format(", all tiles of radius {:.4f} and more are seen", proven) : "",
        printable(rest.native()));
}

void estimate_search(int points, std::ostream& out) {
    start_exhaustive_search(points, 1);  // throws if there is no such search
    constexpr int kProbes = 20'000;
    constexpr std::uint64_t kSeed = 1;
    constexpr double kMeasured = 0.2;  // seconds
    out << fmt::format("{:>6}  {:>12}  {:>10}  {}\n", "radius", "words", "error", "hours of one core");
    for (const double floor : {0.94, 0.91, 0.88, 0.85, 0.82, 0.79, 0.76, 0.73, 0.70, 0.67}) {
        const SearchEstimate estimate = estimate_pass(points, floor, kProbes, kSeed);
        const double rate = words_per_second(points, floor, kMeasured);
        out << fmt::format("{:>6.2f}  {:>12.3g}  {:>10.1g}  {:.3g}\n", floor, estimate.words, estimate.error,
                           rate > 0 ? estimate.words / rate / 3600 : 0);
        out.flush();
    }
}

}  // namespace dapple
