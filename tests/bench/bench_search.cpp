// The exhaustive search for tiles with the identity rule, one thread: the paper took 8 minutes for 16 points
// and three and a half days for 20 (Lagae & Dutré 2006, section 4). Arguments: points, and how many of the
// best tiles are asked for, all of them proven.

#include <benchmark/benchmark.h>

#include "lab/search/exhaustive_search.h"

using namespace dapple;

namespace {

void exhaustive_search(benchmark::State& state) {
    SearchState search;
    for (auto _ : state) {
        search = start_exhaustive_search(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
        search = continue_exhaustive_search(std::move(search), {.threads = 1, .stop = {}, .on_progress = {}});
    }
    state.counters["best_radius"] = search.found.front().relative_radius;
    state.counters["last_radius"] = search.found.back().relative_radius;
}

}  // namespace

BENCHMARK(exhaustive_search)
    ->ArgNames({"points", "top"})
    ->ArgsProduct({{16, 20, 24, 28}, {1, 5}})
    ->Args({32, 1})
    ->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
