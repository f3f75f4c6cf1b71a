// Light samples of a 1,024 x 512 map, one thread: the paper took 30 ms for 8,000 to 34,000 of them in 2006
// (Lagae & Dutré 2006, section 7). exact_dots and figure8_dots are the placing alone, from the same density;
// all_of_it goes from the map to samples with weights.

#include <benchmark/benchmark.h>

#include "core/image/environment.h"
#include "core/lights/light_samples.h"

using namespace dapple;

namespace {

constexpr std::uint64_t kSamples = 30'000;

RankedTile paper_tile() {
    return {make_tile(14217, 2895, 16), RankingMethod::energy};
}

void count(benchmark::State& state, std::size_t dots, std::uint64_t duplicates) {
    state.counters["distinct"] = static_cast<double>(dots - duplicates);
    state.counters["distinct_per_second"] = benchmark::Counter(static_cast<double>(dots - duplicates),
                                                               benchmark::Counter::kIsIterationInvariantRate);
}

void figure8_dots(benchmark::State& state) {
    const Density density = light_density(sky_map());
    const RankedTile tile = paper_tile();
    Figure8Result placed;
    for (auto _ : state)
        placed = place_figure8(density, tile.tile(), tile.own_ranks(), scale_for(density, kSamples));
    count(state, placed.dots.size(), placed.duplicates);
}

void exact_dots(benchmark::State& state) {
    const Density density = light_density(sky_map());
    RankedTile tile = paper_tile();
    DotPieces dots;
    for (auto _ : state) tile.placer().place(density, {.scale = scale_for(density, kSamples)}, dots);
    count(state, dots.size(), 0);
}

void density_of_map(benchmark::State& state) {
    const EnvironmentMap map = sky_map();
    for (auto _ : state) benchmark::DoNotOptimize(light_density(map).mean());
}

void all_of_it(benchmark::State& state) {
    const EnvironmentMap map = sky_map();
    RankedTile tile = paper_tile();
    for (auto _ : state)
        benchmark::DoNotOptimize(light_samples(map, tile, {.count = kSamples}).samples.size());
    count(state, kSamples, 0);
}

}  // namespace

BENCHMARK(figure8_dots)->Unit(benchmark::kMillisecond);
BENCHMARK(exact_dots)->Unit(benchmark::kMillisecond);
BENCHMARK(density_of_map)->Unit(benchmark::kMillisecond);
BENCHMARK(all_of_it)->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
