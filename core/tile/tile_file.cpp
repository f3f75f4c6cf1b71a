#include "core/tile/tile_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "core/text/text_lines.h"
#include "dapple_assets_embedded/tile_assets.h"

namespace dapple {

namespace {

struct Entry {
    BuiltInTile tile;
    std::string_view (*text)();
};

const std::vector<Entry>& entries() {
    static const std::vector<Entry> all{
        {{"paper16", "the paper's tile, Appendix A"}, tile_assets::paper16_tile},
        {{"paper20", "the fourth radius of 20 points: the paper prints it, but not the tile"},
         tile_assets::paper20_tile},
        {{"lattice24", "the best radius of 24 points, nearly a lattice"}, tile_assets::lattice24_tile},
        {{"lattice28", "the best radius of 28 points, nearly a lattice"}, tile_assets::lattice28_tile},
        {{"best32", "the best radius of 32 points, no lattice"}, tile_assets::best32_tile},
        {{"lattice36", "the best radius of 36 points, nearly a lattice"}, tile_assets::lattice36_tile},
        {{"aperiodic16", "turned copies: no period, small"}, tile_assets::aperiodic16_tile},
        {{"aperiodic64", "turned copies, 64 points"}, tile_assets::aperiodic64_tile},
        {{"aperiodic256", "turned copies, 256 points"}, tile_assets::aperiodic256_tile},
        {{"aperiodic1024", "turned copies, 1,024 points"}, tile_assets::aperiodic1024_tile},
        {{"aperiodic4096", "turned copies, 4,096 points: the evenest as placed"},
         tile_assets::aperiodic4096_tile},
        {{"kinds4096", "eight kinds of 4,096 points that fit each other: few seams, no period"},
         tile_assets::kinds4096_tile},
    };
    return all;
}

}  // namespace

const std::vector<BuiltInTile>& built_in_tiles() {
    static const std::vector<BuiltInTile> tiles = [] {
        std::vector<BuiltInTile> list;
        for (const Entry& entry : entries()) list.push_back(entry.tile);
        return list;
    }();
    return tiles;
}

std::span<const char* const> built_in_tile_names() {
    static const std::vector<const char*> names = [] {
        std::vector<const char*> list;
        for (const Entry& entry : entries()) list.push_back(entry.tile.name);
        return list;
    }();
    return names;
}

std::optional<StoredTile> built_in_tile(std::string_view name) {
    for (const Entry& entry : entries())
        if (name == entry.tile.name) return read_tile(entry.text());
    return std::nullopt;
}

std::optional<StoredTile> tile_called(std::string_view name) {
    if (looks_like_tile_integers(name)) return ranked(parse_tile_integers(name), RankingMethod::energy);
    return built_in_tile(name);
}

bool looks_like_tile_integers(std::string_view name) {
    return name.find(',') != std::string_view::npos && name.find('/') != std::string_view::npos &&
           name.find_first_not_of("0123456789,/") == std::string_view::npos;
}

bool is_tile_file_name(std::string_view name) {
    return !looks_like_tile_integers(name) &&
           std::ranges::find(built_in_tile_names(), name) == built_in_tile_names().end();
}

namespace {

constexpr std::string_view kFirstWords = "dapple tile ";
constexpr std::string_view kVersion = "1", kVersionOfKinds = "2";
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

std::string_view read_version(TextLines& lines) {
    const std::string_view line = lines.next();
    if (!line.starts_with(kFirstWords))
        lines.fail(fmt::format("it does not start with '{}{}'", kFirstWords, kVersion));
    const std::string_view version = line.substr(kFirstWords.size());
    if (version != kVersion && version != kVersionOfKinds)
        lines.fail(fmt::format("the version '{}' is not known here, only {} and {}", version, kVersion,
                               kVersionOfKinds));
    return version;
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
            if (word.find_first_not_of("0123456789") != std::string_view::npos)
                lines.fail(fmt::format("'{}' is not a rank, of which {} are expected, {} so far", word, count,
                                       ranks.size()));
            const int rank = lines.whole_number(word, "a rank", 0, last);
            if (taken[rank]) lines.fail(fmt::format("the rank {} comes twice", rank));
            taken[rank] = true;
            ranks.push_back(first + static_cast<float>(rank) + 0.5f);
        }
    }
    return ranks;
}

// Numbers of so many bits each, one after the other.
std::string packed(std::span<const int> numbers, int bits) {
    std::string bytes((numbers.size() * static_cast<std::size_t>(bits) + 7) / 8, '\0');
    std::size_t at = 0;
    for (const int number : numbers) {
        for (int bit = bits - 1; bit >= 0; --bit, ++at)
            if (number >> bit & 1)
                bytes[at / 8] = static_cast<char>(static_cast<unsigned char>(bytes[at / 8]) | 0x80 >> at % 8);
    }
    return base64_of(bytes);
}

std::vector<int> read_packed(TextLines& lines, std::size_t count, int bits) {
    const std::string_view line = lines.next_content();
    const std::string bytes = [&] {
        try {
            return bytes_of_base64(line);
        } catch (const std::runtime_error&) {
            lines.fail("base64 is expected here");
        }
    }();
    const std::size_t expected = (count * static_cast<std::size_t>(bits) + 7) / 8;
    if (bytes.size() != expected)
        lines.fail(fmt::format("there are {} bytes, but {} numbers of {} bits have {}", bytes.size(), count,
                               bits, expected));
    std::vector<int> numbers(count, 0);
    for (std::size_t at = 0; at < count * static_cast<std::size_t>(bits); ++at) {
        int& number = numbers[at / static_cast<std::size_t>(bits)];
        number = number << 1 | (static_cast<unsigned char>(bytes[at / 8]) >> (7 - at % 8) & 1);
    }
    return numbers;
}

NextKinds read_children(TextLines& lines, int kinds) {
    NextKinds next;
    while (next.size() < static_cast<std::size_t>(kinds)) {
        const auto words = split(lines.next_content());
        if (words.size() != 4) lines.fail("four kinds are expected, one for each quadrant");
        auto& children = next.emplace_back();
        for (std::size_t q = 0; q < 4; ++q) {
            const int kind = lines.whole_number(words[q], "a kind", 0, kinds - 1);
            children[q] = static_cast<std::uint16_t>(kind);
        }
    }
    return next;
}

// The tile of several kinds whose children are read.
Tile read_successors(TextLines& lines, const Rule& rule, const NextKinds& next, std::size_t points) {
    std::string letters;
    std::vector<std::uint32_t> successor;
    for (std::size_t k = 0; k < next.size(); ++k) {
        for (std::size_t q = 0; q < 4; ++q) {
            const std::vector<int> chosen = read_packed(lines, points, 1);
            for (std::size_t i = 0; i < points; ++i) {
                if (chosen[i] == 0) continue;
                letters += static_cast<char>('0' + q);
                successor.push_back(static_cast<std::uint32_t>(next[k][q] * points + i));
            }
        }
        if (letters.size() != (k + 1) * points)
            lines.fail(fmt::format("kind {} has {} points, but there are {} of each", k,
                                   letters.size() - std::min(letters.size(), k * points), points));
    }
    return on_line(lines, [&] { return make_tile(rule, next, letters, std::move(successor)); });
}

constexpr int kRankBits = 12, kStageBits = 4;
static_assert(1 << kRankBits == kMaxTilePoints && 1 << kStageBits == kRankStages);

std::vector<float> read_root_ranks(TextLines& lines, std::size_t points) {
    std::vector<float> ranks;
    std::vector<bool> taken(points);
    for (const int number : read_packed(lines, points, kRankBits)) {
        const auto rank = static_cast<std::size_t>(number);
        if (rank >= points) lines.fail(fmt::format("the rank {} is not below {}", rank, points));
        if (taken[rank]) lines.fail(fmt::format("the rank {} comes twice", rank));
        taken[rank] = true;
        ranks.push_back(static_cast<float>(rank) + 0.5f);
    }
    return ranks;
}

std::vector<float> read_stages(TextLines& lines, std::size_t points, std::size_t kinds) {
    std::vector<int> stages;
    for (std::size_t k = 0; k < kinds; ++k) {
        const std::vector<int> of_kind = read_packed(lines, 3 * points, kStageBits);
        std::size_t born = 0;
        for (int stage = 0; stage < kRankStages; ++stage) {
            born += static_cast<std::size_t>(std::ranges::count(of_kind, stage));
            if (born == born_until(points, stage)) continue;
            lines.fail(fmt::format("by the end of stage {} there are {} newborn points, not {}", stage, born,
                                   born_until(points, stage)));
        }
        stages.insert(stages.end(), of_kind.begin(), of_kind.end());
    }
    return ranks_of_stages(points, stages);
}

std::string rule_line(const Rule& rule) {
    std::string text = "rule";
    for (const Orientation g : rule.child) text += fmt::format(" {}", g.index);
    return text;
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

std::string text_of_kinds(const StoredTile& stored) {
    const Tile& tile = stored.tile;
    std::string text = fmt::format("kinds {}\npoints {}\nchildren\n", tile.kinds(), tile.size());
    for (const auto& children : tile.next_kind) text += fmt::format("{}\n", fmt::join(children, " "));
    text += "successors\n";
    std::vector<std::vector<int>> chosen(4 * tile.kinds(), std::vector<int>(tile.size(), 0));
    for (std::size_t i = 0; i < tile.points.size(); ++i) {
        const auto q = static_cast<std::size_t>(quadrant_of(tile.points[i]));
        chosen[4 * tile.kind_of(i) + q][tile.successor[i] % tile.size()] = 1;
    }
    for (const std::vector<int>& bits : chosen) text += packed(bits, 1) + '\n';
    text += fmt::format("ranking {}\nranks\n", name_of(stored.method));
    const std::vector<int> ranks(stored.ranking.tile.begin(), stored.ranking.tile.end());
    text += packed(ranks, kRankBits) + "\nnewborn stages\n";
    const std::vector<int> stages = stages_of_ranks(tile.size(), stored.ranking.newborn);
    for (std::size_t k = 0; k < tile.kinds(); ++k) {
        const std::size_t newborns = 3 * tile.size();
        text += packed(std::span(stages).subspan(k * newborns, newborns), kStageBits) + '\n';
    }
    return text + "end\n";
}

void read_end(TextLines& lines) {
    expect(lines, lines.next_content(), "end");
    if (lines.at_end()) return;
    lines.next_content();
    lines.fail("there is more after 'end'");
}

StoredTile read_kinds(TextLines& lines) {
    const Rule rule = read_rule(lines);
    const int kinds = lines.whole_number(lines.value_of(lines.next_content(), "kinds"), "'kinds'", 2,
                                         static_cast<int>(kMaxKinds));
    const auto points = static_cast<std::size_t>(lines.whole_number(
        lines.value_of(lines.next_content(), "points"), "'points'", 4, static_cast<int>(kMaxTilePoints)));
    expect(lines, lines.next_content(), "children");
    const NextKinds next = read_children(lines, kinds);
    expect(lines, lines.next_content(), "successors");

    StoredTile stored;
    stored.tile = read_successors(lines, rule, next, points);
    stored.method = read_method(lines, lines.next_content());
    expect(lines, lines.next_content(), "ranks");
    stored.ranking.tile = read_root_ranks(lines, points);
    expect(lines, lines.next_content(), "newborn stages");
    stored.ranking.newborn = read_stages(lines, points, next.size());
    read_end(lines);
    return stored;
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
    const bool one_kind = tile.kinds() == 1;
    std::string text = fmt::format("{}{}\n", kFirstWords, one_kind ? kVersion : kVersionOfKinds);
    for (const std::string& comment : comments) text += fmt::format("# {}\n", comment);
    text += rule_line(tile.rule) + '\n';
    if (!one_kind) return text + text_of_kinds(stored);
    text += fmt::format("points {}\nwords\n", tile.size());
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
    if (read_version(lines) == kVersionOfKinds) return read_kinds(lines);
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
    read_end(lines);
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
