#include "core/tile/tile.h"

#include <fmt/format.h>

#include <numeric>
#include <set>
#include <stdexcept>

#include "core/failure.h"
#include "core/text/number_words.h"

namespace dapple {

namespace {

// How often each relative orientation of each kind occurs at each offset from each kind; the centre holds the
// tile itself.
class Table {
 public:
    explicit Table(std::size_t kinds) : kinds_(kinds), chances_(9 * 8 * kinds * kinds, 0.0) {}

    double& at(std::size_t of, glm::ivec2 offset, std::size_t kind, Orientation g) {
        const auto place = static_cast<std::size_t>(3 * (offset.x + 1) + offset.y + 1);
        return chances_[((of * 9 + place) * kinds_ + kind) * 8 + g.index];
    }
    double at(std::size_t of, glm::ivec2 offset, std::size_t kind, Orientation g) const {
        return const_cast<Table&>(*this).at(of, offset, kind, g);
    }
    std::size_t kinds() const { return kinds_; }
    void add(const Table& other) {
        for (std::size_t i = 0; i < chances_.size(); ++i) chances_[i] += other.chances_[i];
    }

 private:
    std::size_t kinds_;
    std::vector<double> chances_;
};

// All that have a place in a table, in its order.
template <class Visit>
void for_each_entry(std::size_t kinds, Visit visit) {
    for (std::size_t of = 0; of < kinds; ++of) {
        for (int ox = -1; ox <= 1; ++ox) {
            for (int oy = -1; oy <= 1; ++oy) {
                for (std::size_t kind = 0; kind < kinds; ++kind)
                    for (const Orientation g : all_orientations()) visit(of, glm::ivec2(ox, oy), kind, g);
            }
        }
    }
}

constexpr int kSettlingRounds =
    200;  // far beyond the few rounds in which the chance of each neighbour settles

glm::ivec2 turn(Orientation g, glm::ivec2 v) {
    return glm::ivec2(apply(g, glm::dvec2(v)));
}

// Where the child in quadrant q lies in a tile with the given orientation, as 0 or 1 on each axis.
glm::ivec2 child_cell(Orientation g, int q) {
    const int placed = apply_to_quadrant(g, q);
    return {placed & 1, placed >> 1};
}

// One subdivision: from the neighbours that tiles have to those that their children have.
Table subdivide(const Rule& rule, const NextKinds& next_kind, const Table& parents) {
    Table children(parents.kinds());
    for_each_entry(parents.kinds(), [&](std::size_t of, glm::ivec2 o, std::size_t kind, Orientation other) {
        const double weight = parents.at(of, o, kind, other);
        if (weight == 0) return;
        for (std::size_t q = 0; q < 4; ++q) {
            const Orientation frame = inverse(rule.child[q]);
            for (std::size_t r = 0; r < 4; ++r) {
                const glm::ivec2 between = 2 * o + child_cell(other, static_cast<int>(r)) -
                                           child_cell(Orientation{}, static_cast<int>(q));
                if (between.x * between.x > 1 || between.y * between.y > 1) continue;
                const Orientation seen = compose(frame, compose(other, rule.child[r]));
                children.at(next_kind[of][q], turn(frame, between), next_kind[kind][r], seen) += weight / 4;
            }
        }
    });
    return children;
}

}  // namespace

std::vector<Neighbour> legal_neighbours(const Rule& rule, const NextKinds& next_kind) {
    const std::size_t kinds = next_kind.size();
    Table table(kinds), occurred(kinds), settled(kinds);
    table.at(0, {0, 0}, 0, {}) = 1;  // a lone tile
    for (int round = 0; round < kSettlingRounds; ++round) {
        table = subdivide(rule, next_kind, table);
        occurred.add(table);
        // The chances may alternate from level to level: average over the later half.
        if (round >= kSettlingRounds / 2) settled.add(table);
    }

    std::vector<Neighbour> neighbours;
    std::vector<double> sums(9 * kinds, 0.0);  // of a kind and an offset
    const auto sum_at = [&](std::size_t of, glm::ivec2 o) -> double& {
        return sums[of * 9 + static_cast<std::size_t>(3 * (o.x + 1) + o.y + 1)];
    };
    for_each_entry(kinds, [&](std::size_t of, glm::ivec2 o, std::size_t kind, Orientation g) {
        sum_at(of, o) += settled.at(of, o, kind, g);
    });
    for_each_entry(kinds, [&](std::size_t of, glm::ivec2 o, std::size_t kind, Orientation g) {
        if (o == glm::ivec2(0) || occurred.at(of, o, kind, g) == 0) return;
        const double sum = sum_at(of, o);
        neighbours.push_back({o, g, sum > 0 ? settled.at(of, o, kind, g) / sum : 0,
                              static_cast<std::uint16_t>(of), static_cast<std::uint16_t>(kind)});
    });
    return neighbours;
}

std::vector<std::vector<Neighbour>> copies_of_kinds(const Tile& tile) {
    std::vector<std::vector<Neighbour>> copies(tile.kinds());
    for (const Neighbour& n : legal_neighbours(tile.rule, tile.next_kind)) copies[n.kind].push_back(n);
    return copies;
}

glm::dvec2 position_in(const Neighbour& neighbour, glm::dvec2 p) {
    return glm::dvec2(neighbour.offset) + apply(neighbour.orientation, p - 0.5) + 0.5;
}

namespace {

constexpr std::array<SwapAndSigns, 8> kElements{{
    {false, false, false},  // 0
    {true, true, false},    // 90: (-y, x)
    {false, true, true},    // 180
    {true, false, true},    // 270: (y, -x)
    {false, true, false},   // mirror x
    {true, true, true},     // mirror x, then 90: (-y, -x)
    {false, false, true},   // mirror x, then 180: (x, -y)
    {true, false, false},   // mirror x, then 270: (y, x)
}};

}  // namespace

SwapAndSigns steps_of(Orientation g) {
    return kElements[g.index];
}

std::array<Orientation, 8> all_orientations() {
    std::array<Orientation, 8> all;
    for (std::uint8_t i = 0; i < 8; ++i) all[i] = {i};
    return all;
}

Orientation compose(Orientation second, Orientation first) {
    // A rotation that comes before a mirroring turns back after it.
    const bool mirrored = second.index & 4;
    const int turns = mirrored ? second.index - first.index : second.index + first.index;
    return {static_cast<std::uint8_t>(((second.index ^ first.index) & 4) | (turns & 3))};
}

Orientation inverse(Orientation g) {
    // Rotations by 90 and 270 undo each other; everything else is its own inverse.
    return g.index == 1 || g.index == 3 ? Orientation{static_cast<std::uint8_t>(4 - g.index)} : g;
}

int apply_to_quadrant(Orientation g, int q) {
    const auto [swap, negate_x, negate_y] = kElements[g.index];
    const int x = swap ? q >> 1 : q & 1, y = swap ? q & 1 : q >> 1;
    return (x ^ static_cast<int>(negate_x)) + 2 * (y ^ static_cast<int>(negate_y));
}

glm::dvec2 apply(Orientation g, glm::dvec2 v) {
    const auto [swap, negate_x, negate_y] = kElements[g.index];
    if (swap) v = {v.y, v.x};
    return {negate_x ? -v.x : v.x, negate_y ? -v.y : v.y};
}

BinaryPoint apply(Orientation g, BinaryPoint p) {
    const auto [swap, negate_x, negate_y] = kElements[g.index];
    if (swap) p = {p.y, p.x};
    return {negate_x ? ~p.x : p.x, negate_y ? ~p.y : p.y};
}

glm::dvec2 to_unit_square(BinaryPoint p) {
    // The top 53 bits are what a double holds; more would round up to 1 at the far edge.
    return glm::dvec2(static_cast<double>(p.x >> 11), static_cast<double>(p.y >> 11)) * 0x1p-53;
}

int quadrant_of(BinaryPoint p) {
    return static_cast<int>(p.x >> 63) + 2 * static_cast<int>(p.y >> 63);
}

BinaryPoint enlarge_quadrant(BinaryPoint p) {
    return {p.x << 1, p.y << 1};
}

BinaryPoint shrink_to_quadrant(int q, BinaryPoint p) {
    constexpr std::uint64_t top = std::uint64_t{1} << 63;
    return {(p.x >> 1) | (q & 1 ? top : 0), (p.y >> 1) | (q & 2 ? top : 0)};
}

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
    if (wrong != std::string::npos)
        throw failure("'{}' in a tile's word is not a quadrant 0, 1, 2 or 3", parsed.letters[wrong]);
    if (mark == word.size()) return parsed;
    parsed.end = number_of<std::uint32_t>(word.substr(mark + 1));
    if (!parsed.end) {
        throw failure("'{}' at the end of a tile's word leads nowhere; write > and a point's number",
                      word.substr(mark));
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

void check_size(std::size_t points) {
    if (points == 0 || points % 4 != 0 || points > kMaxTilePoints) {
        throw failure("a tile of {} points cannot be made; use a multiple of 4 up to {}", points,
                      kMaxTilePoints);
    }
}

// The points of each kind by their letters and those of the points that follow.
std::vector<std::uint32_t> order_of_letters(std::span<const char> letters,
                                            std::span<const std::uint32_t> successor, std::size_t size) {
    std::vector<std::array<std::uint64_t, 2>> keys;
    for (std::uint32_t i = 0; i < letters.size(); ++i) {
        std::array<std::uint64_t, 2> key{};
        std::uint32_t point = i;
        for (std::size_t k = 0; k < 64; ++k, point = successor[point])
            key[k / 32] = key[k / 32] << 2 | static_cast<std::uint64_t>(letters[point] - '0');
        keys.push_back(key);
    }
    std::vector<std::uint32_t> order(letters.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, {}, [&](std::uint32_t i) { return std::pair(i / size, keys[i]); });
    return order;
}

// Finds the points of a tile that has everything else.
void locate_all(Tile& tile, std::string_view letters) {
    const std::size_t size = letters.size() / tile.kinds();
    std::set<Key> seen;
    for (std::uint32_t i = 0; i < letters.size(); ++i) {
        if (i % size == 0) seen.clear();
        tile.points.push_back(locate(tile, letters, i));
        if (seen.insert(key_of(tile.points.back())).second) continue;
        throw failure("two points of the tile coincide; {} ({} points)",
                      tile.words.empty() ? "no two of a kind may be followed by the same letters on and on"
                                         : "a word must not repeat itself or be given twice",
                      size);
    }
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
    check_size(count);
    for (const std::uint32_t next : tile.successor)
        if (next >= count)
            throw failure("a tile's word leads to point {}, but the points' numbers end at {}", next,
                          count - 1);

    locate_all(tile, letters);
    return tile;
}

Tile make_tile(const Rule& rule, NextKinds next_kind, std::span<const char> letters,
               std::vector<std::uint32_t> successor) {
    const std::size_t kinds = next_kind.size(), count = letters.size();
    if (kinds == 0 || kinds > kMaxKinds) {
        throw failure("a tile of {} kinds cannot be made; use up to {}", kinds, kMaxKinds);
    }
    if (count % kinds != 0 || successor.size() != count)
        throw failure("{} points cannot be shared out to {} kinds", count, kinds);
    check_size(count / kinds);
    for (const auto& children : next_kind) {
        for (const std::size_t child : children)
            if (child >= kinds)
                throw failure("a child is of kind {}, but the kinds end at {}", child, kinds - 1);
    }
    const std::size_t size = count / kinds;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t child = next_kind[i / size][static_cast<std::size_t>(letters[i] - '0')];
        if (successor[i] / size != child)
            throw failure("the successor of point {} is not of kind {}", i, child);
    }
    if (kinds == 1) return make_tile(rule, words_along(letters, successor));

    const std::vector<std::uint32_t> order = order_of_letters(letters, successor, size);
    std::vector<std::uint32_t> number(count);
    for (std::uint32_t i = 0; i < count; ++i) number[order[i]] = i;
    Tile tile{rule, {}, {}, {}, std::move(next_kind)};
    std::string sorted;
    for (const std::uint32_t i : order) {
        sorted += letters[i];
        tile.successor.push_back(number[successor[i]]);
    }
    locate_all(tile, sorted);
    return tile;
}

int count_letters(std::string_view word) {
    return static_cast<int>(parse_word(word).letters.size());
}

Tile make_tile(std::uint64_t a, std::uint64_t b, int count) {
    if (count < 4 || count > 62 || count % 4 != 0) {
        throw failure("two integers cannot give a tile of {} points; use a multiple of 4 from 4 to 60",
                      count);
    }
    const std::uint64_t limit = (std::uint64_t{1} << count) - 1;
    if (a >= limit || b >= limit) {
        throw failure("the tile {},{}/{} is out of range; both integers must be below {}", a, b, count,
                      limit);
    }
    std::string word;
    for (int bit = count - 1; bit >= 0; --bit)
        word += static_cast<char>('0' + (a >> bit & 1) + 2 * (b >> bit & 1));
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

TileIntegers integers_of(std::string_view word) {
    assert(!word.empty() && word.size() <= kMaxIdentityWord);
    TileIntegers integers;
    for (const char c : word) {
        const auto letter = static_cast<std::uint64_t>(c - '0');
        integers.a = integers.a << 1 | (letter & 1);
        integers.b = integers.b << 1 | letter >> 1;
    }
    return integers;
}

Tile parse_tile_integers(std::string_view text) {
    const auto numbers = numbers_of<std::uint64_t, 3>(text, ",/");
    if (!numbers) {
        throw failure("'{}' is not a tile; write A,B/N, for example 14217,2895/16", text);
    }
    const auto [a, b, size] = *numbers;
    return make_tile(a, b, static_cast<int>(std::min<std::uint64_t>(size, 1000)));
}

std::vector<Newborn> newborns_of(const Tile& tile) {
    // The child in quadrant q repeats those of its points that succeed a point in quadrant q.
    const std::size_t size = tile.size();
    std::vector<Newborn> newborns;
    newborns.reserve(3 * tile.points.size());
    for (std::size_t k = 0; k < tile.kinds(); ++k) {
        std::array<std::vector<bool>, 4> inherited;
        inherited.fill(std::vector<bool>(size));
        for (std::size_t i = k * size; i < (k + 1) * size; ++i)
            inherited[static_cast<std::size_t>(quadrant_of(tile.points[i]))][tile.successor[i] % size] = true;
        for (int q = 0; q < 4; ++q) {
            const Orientation turn = tile.rule.child[static_cast<std::size_t>(q)];
            const std::size_t first = tile.next_kind[k][static_cast<std::size_t>(q)] * size;
            for (std::size_t i = 0; i < size; ++i) {
                if (inherited[static_cast<std::size_t>(q)][i]) continue;
                const auto point = static_cast<std::uint32_t>(first + i);
                newborns.push_back({q, point, shrink_to_quadrant(q, apply(turn, tile.points[point]))});
            }
        }
    }
    return newborns;
}

std::string text_of(const Rule& rule) {
    std::string digits;
    for (const Orientation h : rule.child) digits += static_cast<char>('0' + h.index);
    return digits;
}

std::optional<std::string> paper_notation(const Tile& tile) {
    const bool one_cycle = tile.words.size() == 1 && tile.words[0].size() == tile.size();
    if (tile.rule != Rule{} || !one_cycle || tile.size() > kMaxIdentityWord) return std::nullopt;
    const TileIntegers integers = integers_of(tile.words[0]);
    return fmt::format("{},{}/{}", integers.a, integers.b, tile.size());
}

std::string headline(const Tile& tile) {
    if (tile.kinds() > 1)
        return fmt::format("{} kinds of {} points, rule {}", tile.kinds(), tile.size(), text_of(tile.rule));
    std::string text = fmt::format("{} points, rule {}, {} word{}", tile.size(), text_of(tile.rule),
                                   tile.words.size(), tile.words.size() == 1 ? "" : "s");
    if (const auto integers = paper_notation(tile))
        text += fmt::format(", {} in the paper's notation", *integers);
    return text;
}

}  // namespace dapple
