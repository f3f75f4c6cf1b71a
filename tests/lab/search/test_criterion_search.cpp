// The search that looks at every tile, against all orders of letters.

#include "lab/search/criterion_search.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "lab/search/exhaustive_search.h"
#include "lab/search/identity_word.h"

namespace dapple {
namespace {

// Any number that belongs to a tile, the same for all of its words.
double made_up_cost(const std::string& word) {
    double cost = 0;
    for (const char c : smallest_symmetric_word(word)) cost = cost * 0.37 + double(c - '0');
    return cost;
}

std::vector<double> costs_of(const std::vector<MeasuredTile>& tiles) {
    std::vector<double> costs;
    for (const MeasuredTile& tile : tiles) costs.push_back(tile.cost);
    return costs;
}

}  // namespace

TEST_CASE("the best tiles by any measure are the best of all orders of the letters") {
    std::map<std::string, double> all;
    std::string word = "00112233";
    do {
        if (relative_radius(word) > 0) all.emplace(smallest_symmetric_word(word), made_up_cost(word));
    } while (std::ranges::next_permutation(word).found);
    std::vector<double> costs;
    for (const auto& [tile, cost] : all) costs.push_back(cost);
    std::ranges::sort(costs);
    CHECK(costs.size() == 46);
    const auto measure = [](const std::string& one) { return MeasuredTile{one, made_up_cost(one)}; };
    for (const std::size_t top : {1, 7, 100}) {
        const CriterionResult result = search_by_criterion(8, top, measure);
        CHECK(result.finished);
        CHECK(costs_of(result.best) ==
              std::vector<double>(costs.begin(),
                                  costs.begin() + std::ptrdiff_t(std::min<std::size_t>(top, 46))));
    }
}

TEST_CASE("by radius both searches find the same tiles, on any number of threads") {
    const SearchState known = continue_exhaustive_search(start_exhaustive_search(12, 5));
    for (const int threads : {1, 3}) {
        const CriterionResult result =
            search_by_criterion(12, 5,
                                [](const std::string& word) {
                                    return MeasuredTile{word, -relative_radius(word)};
                                },
                                {.threads = threads, .stop = {}, .on_progress = {}});
        REQUIRE(result.best.size() == known.found.size());
        for (std::size_t i = 0; i < known.found.size(); ++i)
            CHECK(result.best[i].cost == -known.found[i].relative_radius);
    }
    CHECK_THROWS(search_by_criterion(10, 5, {}));
}

}  // namespace dapple
