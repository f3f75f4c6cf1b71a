// dapple-lab tile: the tile workshop - rules, search, rank, check.

#include "lab/commands/commands.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>
#include <set>
#include <stdexcept>
#include <string>

#include "core/text/names.h"
#include "core/text/shown_text.h"
#include "io/command_line/options.h"
#include "io/command_line/program.h"
#include "io/files/atomic_file.h"
#include "io/files/text_file.h"
#include "io/files/tile_library.h"
#include "lab/analysis/seams.h"
#include "lab/commands/save_tile.h"
#include "lab/commands/tile_search.h"
#include "lab/search/ranking_search.h"
#include "lab/search/rules.h"
#include "lab/search/tile_marks.h"

namespace dapple {

/// How `tile rank` ranks points.
enum class NewRanking { paper, farthest, energy, searched, stored };
constexpr auto names_of(NewRanking) {
    return names("paper", "farthest", "energy", "searched", "stored");
}

enum class CheckFormat { text, json };

/// Which tiles `tile check` shows the words of: those whose words are few enough to look at, or all.
enum class ShownWords { of_small_tiles, of_all };

/// Writes all criteria of a tile. As text with its words, if they are shown; as JSON always with them.
void check_tile(std::ostream& out, const std::string& name, CheckFormat format,
                ShownWords words = ShownWords::of_small_tiles);

class LabTileCommand {
 public:
    explicit LabTileCommand(CLI::App& program);

 private:
    void add_rules(CLI::App& parent);
    void add_search(CLI::App& parent);
    void add_rank(CLI::App& parent);
    void add_check(CLI::App& parent);

    std::string name_;  // TILE
    std::filesystem::path output_;
    NewRanking new_ranking_ = NewRanking::energy;
    CheckFormat format_ = CheckFormat::text;
    ShownWords words_ = ShownWords::of_small_tiles;
    int rules_ = 20;  // listed
    TileSearchOptions search_;
};

namespace {

constexpr std::size_t kMostPointsInWords = 64;

// Any tile that has a name, or a file of words alone, which has no ranking.
StoredTile load_perhaps_unranked(const std::string& name) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(name, error)) return load_tile(name);
    const std::string text = text_of_file(name, kTileFile);
    try {
        if (is_tile_text(text)) return read_tile(text);
        StoredTile stored;
        stored.tile = read_words(text);
        return stored;
    } catch (const std::runtime_error& reason) {
        throw std::runtime_error(
            fmt::format("{}: neither a tile file nor a rule with words, {}", name, reason.what()));
    }
}

StoredTile ranked_anew(StoredTile stored, const std::string& name, NewRanking ranking) {
    switch (ranking) {
        case NewRanking::paper:
            return ranked(std::move(stored.tile), RankingMethod::paper);
        case NewRanking::farthest:
            return ranked(std::move(stored.tile), RankingMethod::farthest);
        case NewRanking::energy:
            return ranked(std::move(stored.tile), RankingMethod::energy);
        case NewRanking::searched:
            stored.ranking = search_ranking(stored.tile);
            stored.method.reset();
            return stored;
        case NewRanking::stored:
            if (stored.ranking.tile.empty())
                throw std::runtime_error(
                    fmt::format("{}: has no ranks to keep; choose another ranking", name));
            return stored;
    }
    return stored;
}

nlohmann::ordered_json json_of(const std::string& name, const StoredTile& stored, const TileMarks& marks,
                               const Seams& seams) {
    std::vector<int> rule;
    for (const Orientation g : stored.tile.rule.child) rule.push_back(g.index);
    nlohmann::ordered_json json{
        {"tile", name},
        {"kinds", stored.tile.kinds()},
        {"points", stored.tile.size()},
        {"rule", rule},
        {"words", stored.tile.words},
        {"integers", nullptr},
        {"ranking", name_of(stored.method)},
        {"balanced", marks.balanced},
        {"letters", marks.letters},
        {"relative_radius", marks.relative_radius},
        {"worst_relative_radius", marks.worst_relative_radius},
        {"coherent_share", marks.coherent_share},
        {"low_frequency_power", marks.low_frequency_power},
        {"lattice_share", marks.lattice_share},
        {"seam_on_black", seams.worst()},
        {marks.kinds > 1 ? "kind_coincidence" : "orientation_coincidence", marks.orientation_coincidence},
        {"coincidence_lag", marks.coincidence_lag},
        {"coincidence_at_lags_from_1", marks.coincidences}};
    if (const auto integers = paper_notation(stored.tile)) json["integers"] = *integers;
    return json;
}

// The rules that repeat least, each with those that are the same up to a turn or a reflection of the plane.
void list_rules(std::ostream& out, int count) {
    out << fmt::format("{:<6} {:>8}  {:>6}  {:>6}  {}\n", "rule", "highest", "at lag", "mean",
                       "the same turned");
    for (const RuleMarks& marks : best_rules(static_cast<std::size_t>(count))) {
        std::set<std::string> others;
        for (const Orientation g : all_orientations()) others.insert(text_of(turned(marks.rule, g)));
        others.erase(text_of(marks.rule));
        out << fmt::format("{:<6} {:>8.4f}  {:>6}  {:>6.4f}  {}\n", text_of(marks.rule), marks.coincidence,
                           marks.lag, marks.mean, fmt::join(others, " "));
    }
}

void add_tile_name(CLI::App& command, std::string& name, const std::string& more = "") {
    command
        .add_option("tile", name,
                    "A built-in tile's name, a tile file, or two integers as in 14217,2895/16" + more)
        ->type_name("TILE")
        ->required();
}

}  // namespace

void check_tile(std::ostream& out, const std::string& name, CheckFormat format, ShownWords words) {
    const StoredTile stored = load_tile(name);
    const TileMarks marks = marks_of(stored.tile, stored.ranking);
    RankedTile drawn(stored.tile, stored.ranking);
    const Seams seams = seams_on_black(drawn);
    if (format == CheckFormat::json) {
        // File names need not be UTF-8, JSON has to be.
        out << json_of(name, stored, marks, seams)
                   .dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)
            << '\n';
        return;
    }
    out << fmt::format("{}: {}, ranking {}\n\n", printable(name), headline(stored.tile),
                       name_of(stored.method));
    for (const TileMark& mark : in_words(marks))
        out << fmt::format("  {:<24} {:<9} {}\n", mark.name, mark.value, mark.meaning);
    out << fmt::format("  {:<24} {:<9.2f} {}\n", "seam on black", seams.worst(),
                       "bare paper along borders of tiles over the page's, as placed; 1 is no seam");
    if (stored.tile.kinds() > 1) return;
    if (stored.tile.size() > kMostPointsInWords && words == ShownWords::of_small_tiles) {
        out << fmt::format("\n{} words; --words shows them\n", stored.tile.words.size());
        return;
    }
    out << "\nwords\n";
    for (const std::string& word : stored.tile.words) out << "  " << word << '\n';
}

LabTileCommand::LabTileCommand(CLI::App& program) {
    CLI::App* const tile =
        program.add_subcommand("tile", "List rules, search for tiles, rank and check them");
    tile->require_subcommand(1);
    tile->footer(
        "TILE is a built-in tile's name, a tile file, or the paper's two integers.\n"
        "For more, see dapple-lab tile COMMAND --help.\n\n"
        "Examples:\n"
        "  dapple-lab tile search --points 20                 the best tiles of 20 points\n"
        "  dapple-lab tile search --points 256 --rule any --seconds 60 -o mine.tile\n"
        "  dapple render cat.jpg -o cat.svg --tile mine.tile");
    add_rules(*tile);
    add_search(*tile);
    add_rank(*tile);
    add_check(*tile);
}

void LabTileCommand::add_rules(CLI::App& parent) {
    CLI::App* const command = parent.add_subcommand("rules", "The rules that turn copies, the best first");
    add_whole_number(*command, "--top", rules_, {.least = 1, .most = 570},
                     "How many of the 570 rules to list");
    command->footer(
        "A rule says how the tile is turned in each quadrant, 0..7: turned by 0, 90, 180, 270 degrees, or\n"
        "reflected and then turned. Highest: of tiles of one size, the share that is turned alike, at the "
        "distance (1 to 64\ntiles) where it is highest; chance is 0.125. The lower it is, the less a picture "
        "repeats. 0000, the\npaper's, has 1. Turned copies have seams instead, which show on black with dots "
        "as\n"
        "placed: dapple tile check tells how much.");
    command->callback([this] { list_rules(std::cout, rules_); });
}

void LabTileCommand::add_rank(CLI::App& parent) {
    CLI::App* const command =
        parent.add_subcommand("rank", "Rank a tile's points anew and save it as a tile file");
    add_tile_name(*command, name_, ", or a file with a rule such as 3760 on its first line and words below");
    add_choice(*command, "--ranking", new_ranking_,
               "paper: as printed; farthest: each point in the widest gap left; energy: each where the tone "
               "stays evenest; searched: evener between levels too, takes a minute for 4,096 points; stored: "
               "as in the file");
    command->add_option("-o,--output", output_, "The tile file")->type_name("FILE")->required();
    command->callback([this, command] {
        check_apart(*command, {"--output"}, {{output_, "the tile file"}});
        check_can_save(output_);
        const StoredTile stored = ranked_anew(load_perhaps_unranked(name_), name_, new_ranking_);
        save_tile(output_, stored);
    });
}

void LabTileCommand::add_check(CLI::App& parent) {
    CLI::App* const command = parent.add_subcommand("check", "Show how good a tile is");
    add_tile_name(*command, name_);
    command->add_flag_callback(
        "--json", [this] { format_ = CheckFormat::json; }, "As JSON, for programs");
    command->add_flag_callback(
        "--words", [this] { words_ = ShownWords::of_all; },
        "Show the words of a tile of more than 64 points too");
    command->callback([this] { check_tile(std::cout, name_, format_, words_); });
}

void LabTileCommand::add_search(CLI::App& parent) {
    CLI::App* const command = parent.add_subcommand("search", "Search for new tiles");
    add_search_options(*command, search_);
    command->callback([this, command] {
        check_search_options(*command, search_);
        search_tiles(search_, std::cout);
    });
}

Command add_lab_tile_command(CLI::App& program) {
    return std::make_shared<LabTileCommand>(program);
}

}  // namespace dapple
