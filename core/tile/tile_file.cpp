#include "core/tile/tile_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "core/text/text_lines.h"

namespace dapple {
namespace {

constexpr std::string_view kFirstWords = "dapple tile ";
constexpr std::string_view kVersion = "1";
constexpr std::string_view kOwn = "own";
constexpr std::size_t kLineWidth = 100;

std::vector<std::string_view> split(std::string_view line) {
    std::vector<std::string_view> words;
    for (;;) {
        line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
        if (line.empty()) return words;
        const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
        words.push_back(line.substr(0, end));
        line.remove_prefix(end);
    }
}

void expect(const TextLines& lines, std::string_view line, std::string_view expected) {
    if (line != expected) lines.fail(fmt::format("'{}' is expected", expected));
}

void read_version(TextLines& lines) {
    const std::string_view line = lines.next();
    if (!line.starts_with(kFirstWords))
        lines.fail(fmt::format("it does not start with '{}{}'", kFirstWords, kVersion));
    if (line.substr(kFirstWords.size()) != kVersion) {
        lines.fail(fmt::format("the version '{}' is not known here, only {}", line.substr(kFirstWords.size()),
                               kVersion));
    }
}

Rule read_rule(TextLines& lines) {
    const auto words = split(lines.value_of(lines.next_content(), "rule"));
    if (words.size() != 4) lines.fail("'rule' takes four orientations, one for each quadrant");
    Rule rule;
    for (std::size_t q = 0; q < 4; ++q) {
        const int index = lines.whole_number(words[q], "an orientation", 0, 7);
        rule.child[q] = Orientation{static_cast<std::uint8_t>(index)};
    }
    return rule;
}

// What `make` returns; if it throws, the line is to blame.
template <class Make>
auto on_line(const TextLines& lines, Make make) {
    try {
        return make();
    } catch (const std::runtime_error& error) {
        lines.fail(error.what());
    }
}

// Reads the words, and the line after them, which it returns.
std::string_view read_words(TextLines& lines, const Rule& rule, int points, Tile& tile) {
    std::vector<std::string> words;
    std::string_view line = lines.next_content();
    int letters = 0;
    for (; !line.starts_with("ranking"); line = lines.next_content()) {
        letters += on_line(lines, [&] { return count_letters(line); });
        if (letters > points)
            lines.fail(fmt::format("the words have more than the {} letters of {} points", points, points));
        words.emplace_back(line);
    }
    if (letters != points)
        lines.fail(fmt::format("the words above have {} letters, but there are {} points", letters, points));
    tile = on_line(lines, [&] { return make_tile(rule, std::move(words)); });
    return line;
}

std::optional<RankingMethod> read_method(const TextLines& lines, std::string_view line) {
    const std::string_view name = lines.value_of(line, "ranking");
    if (name == kOwn) return std::nullopt;
    if (const auto method = value_named<RankingMethod>(name)) return method;
    lines.fail(fmt::format("the ranking '{}' is not known; there are paper, farthest, energy, own", name));
}

// Each rank with first + 1/2 added; ranks are a permutation.
std::vector<float> read_ranks(TextLines& lines, std::size_t count, float first) {
    std::vector<float> ranks;
    std::vector<bool> taken(count);
    const int last = static_cast<int>(count) - 1;
    while (ranks.size() < count) {
        const std::string_view line = lines.next_content();
        for (const std::string_view word : split(line)) {
            if (ranks.size() == count) lines.fail(fmt::format("there are more than {} ranks", count));
            if (word.find_first_not_of("0123456789") != std::string_view::npos) {
                lines.fail(fmt::format("'{}' is not a rank, of which {} are expected, {} so far", word, count,
                                       ranks.size()));
            }
            const int rank = lines.whole_number(word, "a rank", 0, last);
            if (taken[rank]) lines.fail(fmt::format("the rank {} comes twice", rank));
            taken[rank] = true;
            ranks.push_back(first + static_cast<float>(rank) + 0.5f);
        }
    }
    return ranks;
}

void append_ranks(std::string& text, std::span<const float> ranks, float first) {
    std::size_t width = 0;
    for (const float half : ranks) {
        const std::string rank = fmt::format("{}", static_cast<int>(half - first));
        const bool fits = width > 0 && width + 1 + rank.size() <= kLineWidth;
        if (width > 0) text += fits ? ' ' : '\n';
        width = fits ? width + 1 + rank.size() : rank.size();
        text += rank;
    }
    text += '\n';
}

}  // namespace

std::string_view name_of(std::optional<RankingMethod> method) {
    return method ? name_of(*method) : kOwn;
}

StoredTile ranked(Tile tile, RankingMethod method) {
    Ranking ranking = rank(tile, method);
    return {std::move(tile), method, std::move(ranking)};
}

std::string write_tile(const StoredTile& stored, std::span<const std::string> comments) {
    const Tile& tile = stored.tile;
    std::string text = fmt::format("{}{}\n", kFirstWords, kVersion);
    for (const std::string& comment : comments) text += fmt::format("# {}\n", comment);
    text += "rule";
    for (const Orientation g : tile.rule.child) text += fmt::format(" {}", g.index);
    text += fmt::format("\npoints {}\nwords\n", tile.size());
    for (const std::string& word : tile.words) text += word + '\n';
    text += fmt::format("ranking {}\nranks\n", name_of(stored.method));
    append_ranks(text, stored.ranking.tile, 0);
    if (stored.method != RankingMethod::paper) {
        text += "newborn ranks\n";
        append_ranks(text, stored.ranking.newborn, static_cast<float>(tile.size()));
    }
    return text + "end\n";
}

StoredTile read_tile(std::string_view text) {
    TextLines lines(text);
    read_version(lines);
    const Rule rule = read_rule(lines);
    const int points = lines.whole_number(lines.value_of(lines.next_content(), "points"), "'points'", 4,
                                          static_cast<int>(kMaxTilePoints));
    expect(lines, lines.next_content(), "words");

    StoredTile stored;
    const std::string_view ranking_line = read_words(lines, rule, points, stored.tile);
    stored.method = read_method(lines, ranking_line);
    expect(lines, lines.next_content(), "ranks");
    const std::size_t count = stored.tile.size();
    stored.ranking.tile = read_ranks(lines, count, 0);
    if (stored.method == RankingMethod::paper) {
        stored.ranking.newborn = paper_newborn_ranks(stored.tile, stored.ranking.tile);
    } else {
        expect(lines, lines.next_content(), "newborn ranks");
        stored.ranking.newborn = read_ranks(lines, 3 * count, static_cast<float>(count));
    }
    expect(lines, lines.next_content(), "end");
    if (!lines.at_end()) {
        lines.next_content();
        lines.fail("there is more after 'end'");
    }
    return stored;
}

Tile read_words(std::string_view text) {
    TextLines lines(text);
    const std::string_view digits = lines.next_content();
    if (digits.size() != 4 || digits.find_first_not_of("01234567") != std::string_view::npos)
        lines.fail("the rule is expected, four digits 0..7, such as 3760");
    Rule rule;
    for (std::size_t q = 0; q < 4; ++q) rule.child[q].index = static_cast<std::uint8_t>(digits[q] - '0');
    std::vector<std::string> words;
    while (!lines.at_end()) {
        words.emplace_back(lines.next_content());
        on_line(lines, [&] { return count_letters(words.back()); });
    }
    return on_line(lines, [&] { return make_tile(rule, std::move(words)); });
}

bool is_tile_text(std::string_view text) {
    return without_byte_order_mark(text).starts_with(kFirstWords);
}

}  // namespace dapple
