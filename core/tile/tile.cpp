#include "core/tile/tile.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>

#include "core/text/numbers.h"

namespace dapple {

namespace {

// The digits of a point are the quadrants of the squares that contain it; each letter is seen through all the
// orientations above it.
BinaryPoint locate(const Tile& tile, std::string_view letters, std::uint32_t point) {
    BinaryPoint p;
    Orientation frame;
    for (std::size_t depth = 0; depth < 64; ++depth) {
        const int letter = letters[point] - '0';
        const int quadrant = apply_to_quadrant(frame, letter);
        p.x = p.x << 1 | static_cast<std::uint64_t>(quadrant & 1);
        p.y = p.y << 1 | static_cast<std::uint64_t>(quadrant >> 1);
        frame = compose(frame, tile.rule.child[letter]);
        point = tile.successor[point];
    }
    return p;
}

// A word's letters, and where its last point leads if it is a tail.
struct ParsedWord {
    std::string_view letters;
    std::optional<std::uint32_t> end;
};

ParsedWord parse_word(std::string_view word) {
    const std::size_t mark = std::min(word.find('>'), word.size());
    ParsedWord parsed{word.substr(0, mark), {}};
    if (parsed.letters.empty())
        throw std::runtime_error("a tile's word is empty; write its letters 0, 1, 2, 3");
    const auto wrong = parsed.letters.find_first_not_of("0123");
    if (wrong != std::string::npos) {
        throw std::runtime_error(
            fmt::format("'{}' in a tile's word is not a quadrant 0, 1, 2 or 3", parsed.letters[wrong]));
    }
    if (mark == word.size()) return parsed;
    parsed.end = number_of<std::uint32_t>(word.substr(mark + 1));
    if (!parsed.end) {
        throw std::runtime_error(
            fmt::format("'{}' at the end of a tile's word leads nowhere; write > and a point's number",
                        word.substr(mark)));
    }
    return parsed;
}

// Where a cyclic word's smallest rotation starts (Booth's two candidates racing each other).
std::size_t smallest_rotation(std::string_view word) {
    const std::size_t n = word.size();
    std::size_t a = 0, b = 1, same = 0;
    while (a < n && b < n && same < n) {
        const char x = word[(a + same) % n], y = word[(b + same) % n];
        if (x == y) {
            ++same;
            continue;
        }
        (x > y ? a : b) += same + 1;
        if (a == b) ++b;
        same = 0;
    }
    return std::min(a, b);
}

// Binary points are rounded down, so a point found by going down one digit may differ in the last ones.
constexpr int kComparedBits = 40;
using Key = std::pair<std::uint64_t, std::uint64_t>;
Key key_of(BinaryPoint p) {
    return {p.x >> (64 - kComparedBits), p.y >> (64 - kComparedBits)};
}

}  // namespace

Tile make_tile(const Rule& rule, std::vector<std::string> words) {
    Tile tile{rule, std::move(words), {}, {}};
    std::string letters;
    for (const std::string& word : tile.words) {
        const ParsedWord parsed = parse_word(word);
        const auto first = static_cast<std::uint32_t>(letters.size());
        letters += parsed.letters;
        for (std::uint32_t i = first + 1; i < letters.size(); ++i) tile.successor.push_back(i);
        tile.successor.push_back(parsed.end.value_or(first));
    }
    const std::size_t count = letters.size();
    if (count == 0 || count % 4 != 0 || count > kMaxTilePoints) {
        throw std::runtime_error(fmt::format(
            "a tile of {} points cannot be made; use a multiple of 4 up to {}", count, kMaxTilePoints));
    }
    for (const std::uint32_t next : tile.successor) {
        if (next >= count) {
            throw std::runtime_error(fmt::format(
                "a tile's word leads to point {}, but the points' numbers end at {}", next, count - 1));
        }
    }

    std::set<Key> seen;
    for (std::uint32_t i = 0; i < count; ++i) {
        tile.points.push_back(locate(tile, letters, i));
        if (!seen.insert(key_of(tile.points.back())).second) {
            throw std::runtime_error(
                fmt::format("two points of the tile coincide; a word must not repeat itself or be given "
                            "twice ({} points)",
                            count));
        }
    }
    return tile;
}

int count_letters(std::string_view word) {
    return static_cast<int>(parse_word(word).letters.size());
}

Tile make_tile(std::uint64_t a, std::uint64_t b, int count) {
    if (count < 4 || count > 62 || count % 4 != 0) {
        throw std::runtime_error(fmt::format(
            "two integers cannot give a tile of {} points; use a multiple of 4 from 4 to 60", count));
    }
    const std::uint64_t limit = (std::uint64_t{1} << count) - 1;
    if (a >= limit || b >= limit) {
        throw std::runtime_error(fmt::format(
            "the tile {},{}/{} is out of range; both integers must be below {}", a, b, count, limit));
    }
    std::string word;
    for (int bit = count - 1; bit >= 0; --bit) {
        word += static_cast<char>('0' + (a >> bit & 1) + 2 * (b >> bit & 1));
    }
    return make_tile(Rule{}, {word});
}

std::vector<std::string> words_along(std::span<const char> letters,
                                     std::span<const std::uint32_t> successor) {
    const std::size_t count = letters.size();
    std::vector<int> predecessors(count, 0);
    for (const std::uint32_t next : successor) ++predecessors[next];

    // What is left after stripping the points without predecessor, again and again, are the cycles.
    std::vector<bool> on_cycle(count, true);
    std::vector<std::uint32_t> leaves;
    std::vector<int> left = predecessors;
    for (std::uint32_t start = 0; start < count; ++start) {
        if (predecessors[start] == 0) leaves.push_back(start);
        for (std::uint32_t i = start; on_cycle[i] && left[i] == 0; i = successor[i]) {
            on_cycle[i] = false;
            --left[successor[i]];
        }
    }

    struct Cycle {
        std::string word;
        std::vector<std::uint32_t> points;
    };
    std::vector<Cycle> cycles;
    std::vector<bool> visited(count);
    for (std::uint32_t start = 0; start < count; ++start) {
        if (!on_cycle[start] || visited[start]) continue;
        Cycle cycle;
        for (std::uint32_t i = start; !visited[i]; i = successor[i]) {
            visited[i] = true;
            cycle.word += letters[i];
            cycle.points.push_back(i);
        }
        const auto turn = static_cast<std::ptrdiff_t>(smallest_rotation(cycle.word));
        std::rotate(cycle.word.begin(), cycle.word.begin() + turn, cycle.word.end());
        std::rotate(cycle.points.begin(), cycle.points.begin() + turn, cycle.points.end());
        cycles.push_back(std::move(cycle));
    }
    std::sort(cycles.begin(), cycles.end(), [](const Cycle& a, const Cycle& b) { return a.word < b.word; });

    std::vector<std::string> words;
    std::vector<std::uint32_t> number(count);
    std::uint32_t next_number = 0;
    for (const Cycle& cycle : cycles) {
        words.push_back(cycle.word);
        for (const std::uint32_t i : cycle.points) number[i] = next_number++;
    }
    for (const std::uint32_t leaf : leaves) {
        std::string word;
        std::uint32_t i = leaf;
        for (; !visited[i]; i = successor[i]) {
            visited[i] = true;
            word += letters[i];
            number[i] = next_number++;
        }
        words.push_back(word + fmt::format(">{}", number[i]));
    }
    return words;
}

std::vector<std::string> words_of(const std::vector<BinaryPoint>& points, const Rule& rule) {
    std::map<Key, std::uint32_t> index;
    for (const BinaryPoint p : points) index[key_of(p)] = 0;
    std::uint32_t count = 0;
    for (auto& entry : index) entry.second = count++;

    std::string letters(count, '0');
    std::vector<std::uint32_t> successor(count);
    for (const BinaryPoint p : points) {
        const std::uint32_t i = index[key_of(p)];
        const int q = quadrant_of(p);
        letters[i] = static_cast<char>('0' + q);
        const auto found = index.find(key_of(apply(inverse(rule.child[q]), enlarge_quadrant(p))));
        if (found == index.end()) throw std::runtime_error("the points are not self-similar under the rule");
        successor[i] = found->second;
    }
    return words_along(letters, successor);
}

Tile parse_tile_integers(std::string_view text) {
    const auto numbers = numbers_of<std::uint64_t, 3>(text, ",/");
    if (!numbers) {
        throw std::runtime_error(
            fmt::format("'{}' is not a tile; write A,B/N, for example 14217,2895/16", text));
    }
    const auto [a, b, size] = *numbers;
    return make_tile(a, b, static_cast<int>(std::min<std::uint64_t>(size, 1000)));
}

std::vector<Newborn> newborns_of(const Tile& tile) {
    // The child in quadrant q repeats those of its points that succeed a point in quadrant q.
    std::vector<std::array<bool, 4>> inherited(tile.size(), std::array<bool, 4>{});
    for (std::size_t i = 0; i < tile.size(); ++i)
        inherited[tile.successor[i]][quadrant_of(tile.points[i])] = true;

    std::vector<Newborn> newborns;
    newborns.reserve(3 * tile.size());
    for (int q = 0; q < 4; ++q) {
        for (std::uint32_t i = 0; i < tile.size(); ++i) {
            if (inherited[i][q]) continue;
            newborns.push_back({q, i, shrink_to_quadrant(q, apply(tile.rule.child[q], tile.points[i]))});
        }
    }
    return newborns;
}

}  // namespace dapple
