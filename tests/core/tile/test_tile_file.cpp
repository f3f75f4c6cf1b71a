// Tile files: read back as they were written, refused with the line that is wrong.

#include <doctest/doctest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "core/tile/tile_file.h"
#include "lab/search/relink_search.h"

namespace dapple {
namespace {

Tile tile_with_tails() {
    return make_tile(aperiodic_rule(), {"0301213303211022", "1>0", "2>3", "03>17"});
}

void check_equal(const StoredTile& a, const StoredTile& b) {
    CHECK(a.tile.rule == b.tile.rule);
    CHECK(a.tile.words == b.tile.words);
    CHECK(a.tile.points == b.tile.points);
    CHECK(a.tile.successor == b.tile.successor);
    CHECK(a.method == b.method);
    CHECK(a.ranking.tile == b.ranking.tile);
    CHECK(a.ranking.newborn == b.ranking.newborn);
}

std::string reason_against(const std::string& text) {
    try {
        read_tile(text);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

// The text with one piece of it replaced.
std::string with(std::string text, const std::string& piece, const std::string& by) {
    const std::size_t at = text.find(piece);
    REQUIRE(at != std::string::npos);
    return text.replace(at, piece.size(), by);
}

// Appendix A's tile, in a file as a person would write it.
const std::string kPaperFile =
    "dapple tile 1\n"
    "# the paper's tile\n"
    "\n"
    "rule 0 0 0 0\n"
    "points 16\n"
    "words\n"
    "0011213312003223\n"
    "ranking paper\n"
    "ranks\n"
    "0 5 8 3 10 12 6 14\n"
    "1 7 13 9 4 11 2 15\n"
    "end\n";

}  // namespace

TEST_CASE("a tile file reads back as the same tile and is written again as the same text") {
    const std::vector<std::string> comments{"found somewhere", "radius 0.5"};
    for (const RankingMethod method :
         {RankingMethod::paper, RankingMethod::farthest, RankingMethod::energy}) {
        for (const Tile& tile : {make_tile(14217, 2895, 16), tile_with_tails(),
                                 make_tile(aperiodic_rule(), even_words(256, 3))}) {
            const StoredTile stored = ranked(tile, method);
            const std::string text = write_tile(stored, comments);
            const StoredTile read = read_tile(text);
            check_equal(read, stored);
            CHECK(write_tile(read, comments) == text);
        }
    }
}

TEST_CASE("a ranking that no order makes is kept under its own name") {
    StoredTile stored = ranked(make_tile(14217, 2895, 16), RankingMethod::energy);
    stored.method.reset();
    std::reverse(stored.ranking.newborn.begin(), stored.ranking.newborn.end());
    const std::string text = write_tile(stored);
    CHECK(text.find("ranking own\n") != std::string::npos);
    check_equal(read_tile(text), stored);
}

TEST_CASE("the file of the largest tile is below 100 kB and its lines are short") {
    const Tile tile = make_tile(aperiodic_rule(), even_words(kMaxTilePoints, 1));
    StoredTile stored{tile, {}, {}};
    for (std::size_t i = 0; i < 4 * tile.size(); ++i)
        (i < tile.size() ? stored.ranking.tile : stored.ranking.newborn)
            .push_back(static_cast<float>(i) + 0.5f);
    const std::string text = write_tile(stored);
    CHECK(text.size() < 100'000);
    const std::size_t ranks = text.find("ranks\n");
    std::size_t longest = 0;
    for (std::size_t at = ranks, next = 0; (next = text.find('\n', at)) != std::string::npos; at = next + 1)
        longest = std::max(longest, next - at);
    CHECK(longest <= 100);
    check_equal(read_tile(text), stored);
}

TEST_CASE("a hand-written tile file may have comments, blank lines, Windows line ends and any line lengths") {
    const StoredTile stored = read_tile(kPaperFile);
    CHECK(stored.method == RankingMethod::paper);
    CHECK(stored.tile.points == make_tile(14217, 2895, 16).points);
    CHECK(stored.ranking.tile[2] == 8.5f);
    // The first newborn point's own rank decides, three ranks for each rank.
    const Newborn first = newborns_of(stored.tile)[0];
    CHECK(stored.ranking.newborn[0] == 16 + 3 * stored.ranking.tile[first.point]);

    std::string windows;
    for (const char c : kPaperFile) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
    check_equal(read_tile(windows), stored);
    check_equal(read_tile(with(kPaperFile, "6 14\n1 7", "6\n14 1\n\n7")), stored);
    check_equal(read_tile(kPaperFile + "\n# thanks\n"), stored);
}

TEST_CASE("a malformed tile file is refused with its line and a reason") {
    struct Case {
        std::string piece, by, line, reason;
    };
    const std::vector<Case> cases{
        {"dapple", "stipple", "line 1: ", "does not start with"},
        {"tile 1", "tile 3", "line 1: ", "version '3'"},
        {"rule 0 0 0 0", "rule 0 0 0", "line 4: ", "four orientations"},
        {"rule 0 0 0 0", "rule 0 0 0 8", "line 4: ", "from 0 to 7"},
        {"rule 0 0 0 0", "rules 0 0 0 0", "line 4: ", "'rule' is expected"},
        {"points 16", "points 16.5", "line 5: ", "whole number"},
        {"points 16", "points -4", "line 5: ", "whole number"},
        {"points 16", "points 20", "line 8: ", "16 letters, but there are 20 points"},
        {"points 16", "points 12", "line 7: ", "more than the 12 letters"},
        {"words\n", "word\n", "line 6: ", "'words' is expected"},
        {"0011213312003223", "0011213312003224", "line 7: ", "'4' in a tile's word"},
        {"0011213312003223", "0011213312003223>", "line 7: ", "leads nowhere"},
        {"0011213312003223", "0011213312003223 ", "line 7: ", "' ' in a tile's word"},
        {"0011213312003223", "001121331200322>40\n3", "line 9: ", "leads to point 40"},
        {"0011213312003223", "00112133\n00112133", "line 9: ", "coincide"},
        {"ranking paper", "ranking best", "line 8: ", "'best' is not known"},
        {"ranks\n0", "0", "line 9: ", "'ranks' is expected"},
        {"0 5 8", "0 5 5", "line 10: ", "5 comes twice"},
        {"0 5 8", "0 5 16", "line 10: ", "from 0 to 15"},
        {"0 5 8", "0 -5 8", "line 10: ", "'-5' is not a rank"},
        {"2 15\n", "2\n", "line 12: ", "'end' is not a rank, of which 16 are expected, 15 so far"},
        {"2 15\n", "2 15 3\n", "line 11: ", "more than 16 ranks"},
        {"2 15\n", "2 15\n3\n", "line 12: ", "'end' is expected"},
        {"end\n", "", "line 12: ", "ends too early"},
        {"end\n", "end\nmore\n", "line 13: ", "more after 'end'"},
        {"ranking paper", "ranking energy", "line 12: ", "'newborn ranks' is expected"},
    };
    for (const Case& c : cases) {
        const std::string reason = reason_against(with(kPaperFile, c.piece, c.by));
        CAPTURE(c.by);
        CAPTURE(reason);
        CHECK(reason.starts_with(c.line));
        CHECK(reason.find(c.reason) != std::string::npos);
    }
    CHECK(reason_against("").starts_with("line 1: "));
}

TEST_CASE("no cut and no changed byte of a tile file brings the reader down") {
    const std::string text = write_tile(ranked(tile_with_tails(), RankingMethod::energy));
    for (std::size_t length = 0; length < text.size() - 1; length += 3)
        CHECK_THROWS_AS(read_tile(text.substr(0, length)), std::runtime_error);
    for (std::size_t at = 0; at < text.size(); ++at) {
        for (const char c : {'\0', '\n', '>', '9', '\xff'}) {
            std::string changed = text;
            changed[at] = c;
            std::size_t points = 20;
            try {
                points = read_tile(changed).tile.size();
            } catch (const std::runtime_error&) {
                continue;
            }
            CHECK(points == 20);
        }
    }
}

TEST_CASE("a rule with words below is a tile that is not ranked yet") {
    const Tile tile = read_words("# mine\n3760\n0301213303211022\n1>0\n\n2>3\n03>17\n");
    CHECK(tile.points == tile_with_tails().points);
    CHECK(tile.rule == aperiodic_rule());
    CHECK_THROWS_WITH_AS(read_words("3780\n0123"),
                         "line 1: the rule is expected, four digits 0..7, such as 3760", std::runtime_error);
    CHECK_THROWS_AS(read_words("3760\n01234"), std::runtime_error);
    CHECK_THROWS_AS(read_words("3760\n"), std::runtime_error);
}

}  // namespace dapple
