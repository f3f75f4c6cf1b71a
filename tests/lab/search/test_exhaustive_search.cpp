#include "lab/search/exhaustive_search.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/tile/tile.h"
#include "lab/search/identity_word.h"
#include "lab/search/word_tree.h"

using namespace dapple;

namespace {

SearchState search(int points, int top, int threads = 1) {
    return continue_exhaustive_search(start_exhaustive_search(points, top),
                                      {.threads = threads, .stop = {}, .on_progress = {}});
}

// Radii without repetition, to six digits as they are printed.
std::vector<long> distinct_millionths(const SearchState& state) {
    std::vector<long> radii;
    for (const FoundTile& tile : state.found) {
        const long radius = std::lround(tile.relative_radius * 1e6);
        if (radii.empty() || radii.back() != radius) radii.push_back(radius);
    }
    return radii;
}

// The oracle: points as integers over 2^N - 1, doubled modulo it, all pairs compared, no words involved.
using IntegerPoint = std::pair<long, long>;

std::vector<IntegerPoint> cycle_through(long a, long b, int count) {
    const long period = (1L << count) - 1;
    std::vector<IntegerPoint> points;
    for (int i = 0; i < count; ++i) {
        points.emplace_back(a, b);
        a = a * 2 % period;
        b = b * 2 % period;
    }
    return points;
}

bool is_balanced(const std::vector<IntegerPoint>& points) {
    const int count = static_cast<int>(points.size());
    const long period = (1L << count) - 1;
    std::array<int, 4> inside{};
    for (const auto& [x, y] : points) ++inside[(2 * x > period) + 2 * (2 * y > period)];
    return std::all_of(inside.begin(), inside.end(), [&](int n) { return 4 * n == count; });
}

double radius_by_all_pairs(const std::vector<IntegerPoint>& points) {
    const long period = (1L << points.size()) - 1;
    long smallest = std::numeric_limits<long>::max();
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const long dx = std::abs(points[i].first - points[j].first);
            const long dy = std::abs(points[i].second - points[j].second);
            const long mx = std::min(dx, period - dx), my = std::min(dy, period - dy);
            smallest = std::min(smallest, mx * mx + my * my);
        }
    }
    const double n = static_cast<double>(points.size());
    return std::sqrt(static_cast<double>(smallest)) / static_cast<double>(period) / 2 *
           std::sqrt(2 * std::sqrt(3.0) * n);
}

// The set of points that stands for itself and its seven mirrored and turned images.
std::vector<IntegerPoint> smallest_image(const std::vector<IntegerPoint>& points) {
    const long period = (1L << points.size()) - 1;
    std::vector<IntegerPoint> smallest;
    for (int g = 0; g < 8; ++g) {
        std::vector<IntegerPoint> image;
        for (auto [x, y] : points) {
            if (g & 1) x = period - x;
            if (g & 2) y = period - y;
            if (g & 4) std::swap(x, y);
            image.emplace_back(x, y);
        }
        std::sort(image.begin(), image.end());
        if (smallest.empty() || image < smallest) smallest = image;
    }
    return smallest;
}

// Radii of all balanced tiles, distinct up to symmetry, best first, by trying every pair of integers. Only
// pairs whose first integer is the smallest of its cycle: a tile can be read from any of its points.
std::vector<double> radii_by_brute_force(int count) {
    const long period = (1L << count) - 1;
    std::set<std::vector<IntegerPoint>> seen;
    std::vector<double> radii;
    for (long a = 0; a < period; ++a) {
        bool first = std::popcount(static_cast<unsigned long>(a)) == count / 2;
        for (const auto& [x, y] : cycle_through(a, 0, count)) first = first && x >= a;
        for (long b = 0; first && b < period; ++b) {
            const std::vector<IntegerPoint> points = cycle_through(a, b, count);
            if (!is_balanced(points)) continue;
            const double radius = radius_by_all_pairs(points);
            if (radius > 0 && seen.insert(smallest_image(points)).second) radii.push_back(radius);
        }
    }
    std::sort(radii.rbegin(), radii.rend());
    return radii;
}

}  // namespace

TEST_CASE("the shares of balanced sequences are the paper's") {
    CHECK(balanced_share(16) == doctest::Approx(0.1964).epsilon(0.0003));
    CHECK(balanced_share(20) == doctest::Approx(0.1762).epsilon(0.0003));
    CHECK(balanced_share(24) == doctest::Approx(0.1612).epsilon(0.0003));
    CHECK(balanced_share(32) == doctest::Approx(0.1400).epsilon(0.0003));
}

TEST_CASE("the share of balanced sequences is what counting them gives") {
    for (int length = 1; length <= 16; ++length) {
        long balanced = 0;
        for (unsigned bits = 0; bits < 1U << length; ++bits) balanced += 2 * std::popcount(bits) == length;
        const double share = static_cast<double>(balanced) / std::ldexp(1.0, length);
        CHECK(balanced_share(length) == doctest::Approx(share).epsilon(1e-14));
    }
}

TEST_CASE("a word's radius is that of its points, and its integers are the paper's") {
    CHECK(integers_of("0011213312003223") == TileIntegers{14217, 2895});
    for (const std::string word : {"0011213312003223", "00123220313321011302", "0123", "00132231"}) {
        const auto [a, b] = integers_of(word);
        CHECK(make_tile(a, b, static_cast<int>(word.size())).words == std::vector{word});
        const auto points =
            cycle_through(static_cast<long>(a), static_cast<long>(b), static_cast<int>(word.size()));
        CHECK(relative_radius(word) == doctest::Approx(radius_by_all_pairs(points)).epsilon(1e-12));
    }
    CHECK(relative_radius("01230123") == 0);
}

TEST_CASE("two words are symmetric exactly if their sets of points are") {
    std::map<std::vector<IntegerPoint>, std::string> word_of_set;
    std::set<std::string> words;
    std::string word = "00112233";
    do {
        const auto [a, b] = integers_of(word);
        const auto set = smallest_image(cycle_through(static_cast<long>(a), static_cast<long>(b), 8));
        const std::string smallest = smallest_symmetric_word(word);
        CHECK(word_of_set.emplace(set, smallest).first->second == smallest);
        words.insert(smallest);
    } while (std::next_permutation(word.begin(), word.end()));
    CHECK(words.size() == word_of_set.size());
}

TEST_CASE("the search finds every tile of few points that trying all pairs of integers finds") {
    for (const int points : {4, 8}) {
        const std::vector<double> expected = radii_by_brute_force(points);
        const SearchState state = search(points, 100000);
        REQUIRE(state.found.size() == expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i)
            CHECK(state.found[i].relative_radius == doctest::Approx(expected[i]).epsilon(1e-12));
        CHECK(state.finished);
        CHECK(proven_radius(state) == 0);
    }
}

TEST_CASE("the best tiles of 12 points are those among all balanced words") {
    // All words, each weighed by the number of words that make a tile like it.
    std::map<long, int> words_of_radius;
    std::string word = "000111222333";
    const double least = 0.55;
    do {
        const auto [a, b] = integers_of(word);
        const double radius =
            radius_by_all_pairs(cycle_through(static_cast<long>(a), static_cast<long>(b), 12));
        if (radius >= least) ++words_of_radius[std::lround(radius * 1e9)];
    } while (std::next_permutation(word.begin(), word.end()));
    REQUIRE(words_of_radius.size() > 5);

    std::map<long, int> found;
    for (const FoundTile& tile : search(12, 100).found) {
        if (tile.relative_radius < least) continue;
        std::set<std::string> alike;
        for (const Orientation g : all_orientations()) {
            std::string image;
            for (const char c : tile.word) image += static_cast<char>('0' + apply_to_quadrant(g, c - '0'));
            for (int i = 0; i < 12; ++i) {
                std::rotate(image.begin(), image.begin() + 1, image.end());
                alike.insert(image);
            }
        }
        found[std::lround(tile.relative_radius * 1e9)] += static_cast<int>(alike.size());
    }
    CHECK(found == words_of_radius);
}

TEST_CASE("the best tiles of 16 points have the published radii, and the paper's tile is the second") {
    const SearchState state = search(16, 5);
    const std::vector<long> radii = distinct_millionths(state);
    REQUIRE(radii.size() == 5);
    CHECK(std::vector(radii.begin(), radii.begin() + 4) == std::vector<long>{696594, 652788, 640257, 638781});
    CHECK(state.found[1].word == smallest_symmetric_word(make_tile(14217, 2895, 16).words[0]));
    CHECK(proven_radius(state) == state.found[4].relative_radius);
}

TEST_CASE("the best tiles of 20 points have the published radii") {
    const std::vector<long> radii = distinct_millionths(search(20, 6));
    CHECK(radii == std::vector<long>{832358, 714068, 671330, 658781, 649963});
}

TEST_CASE("neither threads nor the number of tiles asked for change what is found") {
    const SearchState one = search(16, 40);
    CHECK(search(16, 40, 2) == one);
    CHECK(search(16, 40, 3) == one);
    const SearchState few = search(16, 7, 2);
    CHECK(few.found == std::vector(one.found.begin(), one.found.begin() + 7));
}

TEST_CASE("the best few tiles are the first of the best many, also where the next ones are nearly as good") {
    for (const int points : {8, 12}) {
        const std::vector<FoundTile> all = search(points, 100'000).found;
        std::size_t ties = 0, near = 0;
        for (std::size_t top = 1; top < all.size() && std::min(ties, near) < 12; ++top) {
            const double last = all[top - 1].relative_radius, dropped = all[top].relative_radius;
            const bool is_tie = dropped == last, is_near = !is_tie && dropped > 0.999 * last;
            if (!(is_tie && ties < 12) && !(is_near && near < 12)) continue;
            ties += is_tie;
            near += is_near;
            CAPTURE(points);
            CAPTURE(top);
            // With the next one too, which a bound that is a little too high would drop.
            for (const std::size_t count : {top, top + 1}) {
                const std::vector<FoundTile> best = search(points, static_cast<int>(count)).found;
                CHECK(best == std::vector(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)));
            }
        }
        CHECK(ties >= 12);
        if (points == 12) CHECK(near >= 12);
    }
}

TEST_CASE("a tile of just the radius that is asked for is not passed over") {
    // The best of 28 points, and of 36: nearly lattices, each point with several at the least distance.
    for (const int points : {28, 36}) {
        CAPTURE(points);
        const FoundTile best = search(points, 1).found.at(0);
        const RadiusBound bound(points, best.relative_radius);
        bool found = false;
        WordTree(points).complete("", bound, {}, [&](const std::string& word) {
            found = found || smallest_symmetric_word(word) == best.word;
        });
        CHECK(found);
    }
}

TEST_CASE("a stopped search keeps what it found and goes on to the same end, through text") {
    const SearchState whole = search(16, 8);
    SearchState state = start_exhaustive_search(16, 8);
    int rounds = 0;
    std::size_t found_before = 0;
    double proven = proven_radius(state);
    for (; !state.finished; ++rounds) {
        REQUIRE(rounds < 1000);
        std::stop_source source;
        int parts = 0;
        state = continue_exhaustive_search(
            std::move(state),
            {.threads = 2, .stop = source.get_token(), .on_progress = [&](const SearchProgress&) {
                 if (++parts == 777) source.request_stop();
             }});
        CHECK(state.found.size() >= found_before);
        CHECK(proven_radius(state) <= proven);
        found_before = state.found.size();
        proven = proven_radius(state);
        const SearchState read = read_search_state(write_search_state(state));
        CHECK(read == state);
        state = read;
    }
    CHECK(rounds > 3);
    CHECK(state == whole);
}

TEST_CASE("parts that are searched one by one, in any order, come to what the search finds, to the byte") {
    // The 15th, 17th and 27th of 12 points have a radius that the next one has too.
    const std::vector<std::pair<int, int>> asked{{12, 3}, {12, 15}, {12, 17}, {12, 27}, {16, 5}, {8, 100}};
    for (const std::pair<int, int>& each : asked)
        for (const bool from_the_end : {false, true}) {
            const int points = each.first, top = each.second;
            CAPTURE(points);
            CAPTURE(top);
            SearchState state = start_exhaustive_search(points, top);
            while (!state.finished) {
                const PartSearch pass(state);
                const int number = state.pass;
                begin_pass(state, pass.parts());
                for (std::size_t i = 0; i < pass.parts(); ++i) {
                    REQUIRE(state.pass == number);
                    const std::size_t part = from_the_end ? pass.parts() - 1 - i : pass.in_turn(i);
                    CHECK_FALSE(state.done[part]);
                    take_part(state, part, pass.search(part, radius_wanted(state)));
                }
                REQUIRE((state.finished || state.pass == number + 1));
            }
            CHECK(write_search_state(state) == write_search_state(search(points, top)));
        }
}

TEST_CASE("how long a search takes is guessed about right, by Knuth's random ways down") {
    constexpr int kPoints = 16;
    constexpr double kFloor = 0.5;
    const RadiusBound bound(kPoints, kFloor);
    WordTree tree(kPoints);
    const std::vector<std::string> endings = tree.endings(10, bound);
    const std::uint64_t before = tree.steps();
    for (const std::string& ending : endings) tree.complete(ending, bound, {}, [](const std::string&) {});
    const auto words = static_cast<double>(tree.steps() - before);
    REQUIRE(words > 500);
    // Down each part, or down some of them for all.
    for (const std::size_t probes : {200 * endings.size(), endings.size()}) {
        const SearchEstimate estimate = estimate_pass(kPoints, kFloor, static_cast<int>(probes), 1);
        CHECK(estimate.error > 0);
        CHECK(estimate.error < 0.3 * words);
        CHECK(std::abs(estimate.words - words) < 4 * estimate.error);
    }
}

TEST_CASE("progress rises from 0 to 1 within each pass, and floors fall from pass to pass") {
    double floor = 2, fraction = 1;
    const auto watch = [&](const SearchProgress& progress) {
        if (progress.floor != floor) {
            CHECK(fraction == 1);
            CHECK(progress.floor < floor);
            floor = progress.floor;
            fraction = 0;
        }
        CHECK(progress.fraction > fraction);
        CHECK(progress.fraction <= 1);
        fraction = progress.fraction;
    };
    continue_exhaustive_search(start_exhaustive_search(16, 1),
                               {.threads = 2, .stop = {}, .on_progress = watch});
    CHECK(floor < 0.7);
    CHECK(fraction == 1);
}

TEST_CASE("a search that cannot be is refused in words") {
    for (const int points : {0, 6, 64, -4})
        CHECK_THROWS_WITH_AS(start_exhaustive_search(points, 5), doctest::Contains("multiple of 4"),
                             std::runtime_error);
    CHECK_THROWS_AS(start_exhaustive_search(16, 0), std::runtime_error);
}

TEST_CASE("a damaged saved search is refused with its line") {
    const std::string good =
        "dapple exhaustive search 1\npoints 16\ntop 5\npass 3\nfinished no\nparts 5\ndone f1\n"
        "tile 0030112133032212\ntile 0011213312003223\nend\n";
    CHECK(write_search_state(read_search_state(good)) == good);
    const auto damaged = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        text.replace(text.find(from), from.size(), to);
        return text;
    };
    const std::vector<std::array<std::string, 3>> cases{
        {"dapple", "apple", "line 1"},
        {"points 16", "points 17", "line 2"},
        {"top 5", "top 1", "line 9"},
        {"pass 3", "pass -1", "line 4"},
        {"no", "perhaps", "line 5"},
        {"parts 5", "parts 50", "line 7"},
        {"f1", "f8", "line 7"},
        {"f1", "g1", "line 7"},
        {"tile 0030", "tile 0", "line 8"},
        {"tile 0030", "tile 0031", "line 8"},
        {"tile 0011213312003223", "tile 0112133120032230", "line 9"},
        {"tile 0011213312003223", "tile 0030112133032212", "line 9"},
        {"end\n", "", "line 10"},
    };
    for (const auto& each : cases) {
        const std::string &from = each[0], &to = each[1], &line = each[2];
        CAPTURE(from);
        CAPTURE(to);
        CHECK_THROWS_WITH_AS(read_search_state(damaged(from, to)), doctest::Contains(line.c_str()),
                             std::runtime_error);
    }
    // Parts are known only to the search itself.
    CHECK_THROWS_WITH_AS(continue_exhaustive_search(read_search_state(good)), doctest::Contains("parts"),
                         std::runtime_error);
}

TEST_CASE("the best tile of 24 points has the published radius") {
    CHECK(distinct_millionths(search(24, 1)) == std::vector<long>{782220});
}

TEST_CASE("the best tile of 28 points has the published radius") {
    CHECK(distinct_millionths(search(28, 1)) == std::vector<long>{914419});
}

TEST_CASE("the best tile of 36 points has the radius that another program found") {
    CHECK(distinct_millionths(search(36, 1)) == std::vector<long>{917943});
}

TEST_CASE("the best tile of 32 points is found where it ends, and no other as good beside it") {
    // The search through all endings takes minutes here.
    const std::string best = "00103113012321220213233121003302";
    CHECK(std::lround(relative_radius(best) * 1e6) == 715878);
    std::set<std::string> endings, found;
    for (std::string word : symmetric_words(best))
        for (std::size_t i = 0; i < best.size(); ++i) {
            std::rotate(word.begin(), word.begin() + 1, word.end());
            endings.insert(word.substr(25));
        }
    for (const std::string& ending : endings)
        WordTree(32).complete(ending, RadiusBound(32, 0.715878), {}, [&](const std::string& word) {
            if (relative_radius(word) >= 0.715878) found.insert(smallest_symmetric_word(word));
        });
    CHECK(found == std::set{best});
}
