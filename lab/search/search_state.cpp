#include <fmt/format.h>

#include <algorithm>

#include "core/text/text_lines.h"
#include "lab/search/exhaustive_search.h"
#include "lab/search/identity_word.h"

// The text of a search state:
//
//      dapple exhaustive search 1
//      points 20
//      top 5
//      pass 9
//      finished no
//      parts 2843
//      done 0f3a...            hexadecimal, four parts a digit, the first part the lowest bit of the first
//      tile 00103220331133202112
//      end

namespace dapple {

namespace {

constexpr std::string_view kFirstLine = "dapple exhaustive search 1";
constexpr int kMostPasses = 1000;
constexpr int kMostParts = 1 << 24;
constexpr int kMostTiles = 1 << 24;

// What follows "key " on the next line.
std::string_view value(TextLines& lines, std::string_view key) {
    return lines.value_of(lines.next(), key);
}

int number(TextLines& lines, std::string_view key, int least, int most) {
    return lines.whole_number(value(lines, key), fmt::format("'{}'", key), least, most);
}

std::string hexadecimal(const std::vector<bool>& bits) {
    std::string text((bits.size() + 3) / 4, '0');
    for (std::size_t i = 0; i < text.size(); ++i) {
        int digit = 0;
        for (std::size_t k = 0; k < 4 && 4 * i + k < bits.size(); ++k) digit |= int{bits[4 * i + k]} << k;
        text[i] = "0123456789abcdef"[digit];
    }
    return text;
}

std::vector<bool> read_bits(TextLines& lines, int count) {
    const std::string_view text = value(lines, "done");
    std::vector<bool> bits(static_cast<std::size_t>(count));
    if (text.size() != (bits.size() + 3) / 4) lines.fail("'done' must have a digit for every four parts");
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::size_t digit = std::string_view("0123456789abcdef").find(text[i]);
        if (digit == std::string_view::npos) lines.fail("'done' must be hexadecimal");
        for (std::size_t k = 0; k < 4; ++k) {
            const bool set = (digit >> k & 1) != 0;
            if (4 * i + k < bits.size())
                bits[4 * i + k] = set;
            else if (set)
                lines.fail("'done' has more parts than there are");
        }
    }
    return bits;
}

FoundTile read_tile(const TextLines& lines, std::string_view word, int points) {
    const bool letters = word.find_first_not_of("0123") == std::string_view::npos;
    if (!letters || word.size() != static_cast<std::size_t>(points))
        lines.fail(fmt::format("a tile must be {} letters 0, 1, 2, 3", points));
    for (const char q : {'0', '1', '2', '3'}) {
        if (std::count(word.begin(), word.end(), q) != points / 4)
            lines.fail("a tile must have each of its letters equally often");
    }
    FoundTile tile{smallest_symmetric_word(word), relative_radius(word)};
    if (tile.word != word) lines.fail("a tile must be the smallest of its symmetric words");
    if (tile.relative_radius == 0) lines.fail("points of a tile coincide");
    return tile;
}

bool in_order(const FoundTile& a, const FoundTile& b) {
    return a.relative_radius > b.relative_radius ||
           (a.relative_radius == b.relative_radius && a.word < b.word);
}

}  // namespace

std::string write_search_state(const SearchState& state) {
    std::string text = fmt::format("{}\npoints {}\ntop {}\npass {}\nfinished {}\n", kFirstLine, state.points,
                                   state.top, state.pass, state.finished ? "yes" : "no");
    text += fmt::format("parts {}\ndone {}\n", state.done.size(), hexadecimal(state.done));
    for (const FoundTile& tile : state.found) text += fmt::format("tile {}\n", tile.word);
    return text + "end\n";
}

SearchState read_search_state(std::string_view text) {
    TextLines lines(text, "the saved search cannot be read, ");
    if (lines.next() != kFirstLine) lines.fail(fmt::format("it does not start with '{}'", kFirstLine));
    SearchState state;
    state.points = number(lines, "points", 4, kMaxIdentityWord);
    if (state.points % 4 != 0) lines.fail("'points' must be a multiple of 4");
    state.top = number(lines, "top", 1, kMostTiles);
    state.pass = number(lines, "pass", 0, kMostPasses);
    const std::string_view finished = value(lines, "finished");
    if (finished != "yes" && finished != "no") lines.fail("'finished' must be yes or no");
    state.finished = finished == "yes";
    state.done = read_bits(lines, number(lines, "parts", 0, kMostParts));
    for (std::string_view line = lines.next(); line != "end"; line = lines.next()) {
        if (!line.starts_with("tile ")) lines.fail("'tile' or 'end' is expected");
        FoundTile tile = read_tile(lines, line.substr(5), state.points);
        if (!state.found.empty() && !in_order(state.found.back(), tile))
            lines.fail("tiles must come best first, each once");
        state.found.push_back(std::move(tile));
        if (state.found.size() > static_cast<std::size_t>(state.top))
            lines.fail("there are more tiles than 'top'");
    }
    return state;
}

}  // namespace dapple
