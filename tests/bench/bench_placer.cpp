// The exact placer beside the paper's Figure 8 and beside plainly writing as many numbers, one thread unless
// the name says otherwise. `distinct/s` is comparable across rows. The picture named "given" is the file in
// DAPPLE_BENCH_PICTURE.

#include <benchmark/benchmark.h>
#include <tbb/parallel_invoke.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "core/image/density.h"
#include "core/image/tone.h"
#include "core/placing/page.h"
#include "core/placing/stipple.h"
#include "io/files/picture.h"
#include "io/files/tile_library.h"

using namespace dapple;

namespace {

// The sample with its middle tones lifted until its density has a mean of 0.16, as a light drawing has.
Density light_picture() {
    Tone tone;
    Density density = page_density(density_of(sample_picture().light, tone));
    while (density.mean() > 0.16) {
        tone.gamma *= 1.05f;
        density = page_density(density_of(sample_picture().light, tone));
    }
    return density;
}

void report(benchmark::State& state, std::uint64_t distinct) {
    state.counters["dots"] = static_cast<double>(distinct);
    state.counters["distinct/s"] =
        benchmark::Counter(static_cast<double>(distinct), benchmark::Counter::kIsIterationInvariantRate);
}

void exact(benchmark::State& state, const Density& density, const std::string& tile, int threads) {
    RankedTile ranked = tile_named(tile, RankingMethod::energy);
    PlacingRequest request;
    request.scale = scale_for(density, static_cast<double>(state.range(0)));
    request.threads = threads;
    DotPieces dots;
    ranked.placer().place(density, request, dots);  // the memory that a program has after its first frame
    for (auto _ : state) {
        ranked.placer().place(density, request, dots);
        benchmark::DoNotOptimize(dots.pieces.data());
        benchmark::ClobberMemory();
    }
    report(state, dots.size());
}

// Two drawings beside each other: the most that a second thread can bring on this machine.
void two_at_once(benchmark::State& state, const Density& density, const std::string& tile) {
    RankedTile ranked[] = {tile_named(tile, RankingMethod::energy), tile_named(tile, RankingMethod::energy)};
    PlacingRequest request;
    request.scale = scale_for(density, static_cast<double>(state.range(0)));
    DotPieces dots[2];
    const auto place = [&] {
        tbb::parallel_invoke([&] { ranked[0].placer().place(density, request, dots[0]); },
                             [&] { ranked[1].placer().place(density, request, dots[1]); });
    };
    place();
    for (auto _ : state) {
        place();
        benchmark::DoNotOptimize(dots[0].pieces.data());
        benchmark::DoNotOptimize(dots[1].pieces.data());
        benchmark::ClobberMemory();
    }
    report(state, dots[0].size() + dots[1].size());
}

void exact_count(benchmark::State& state, const Density& density, const std::string& tile) {
    RankedTile ranked = tile_named(tile, RankingMethod::energy);
    const PlacingRequest request{.count = static_cast<std::uint64_t>(state.range(0))};
    DotPieces dots;
    ranked.placer().place(density, request, dots);
    for (auto _ : state) {
        ranked.placer().place(density, request, dots);
        benchmark::DoNotOptimize(dots.pieces.data());
    }
    report(state, dots.size());
}

void figure8(benchmark::State& state, const Density& density) {
    RankedTile ranked = tile_named("paper16", RankingMethod::paper);
    std::uint64_t distinct = 0;
    for (auto _ : state) {
        const Figure8Result result = place_figure8(density, ranked.tile(), ranked.own_ranks(),
                                                   scale_for(density, static_cast<double>(state.range(0))));
        distinct = result.dots.size() - result.duplicates;
        benchmark::DoNotOptimize(result.dots.x.data());
    }
    report(state, distinct);
}

// The least that any placer does: x and y, into memory that is there.
void write_floats(benchmark::State& state) {
    const auto count = static_cast<std::size_t>(state.range(0));
    Dots dots;
    dots.resize(count, false);
    float value = 0;
    for (auto _ : state) {
        value += 1;
        for (std::size_t i = 0; i < count; ++i) {
            dots.x[i] = value;
            dots.y[i] = value + 1;
        }
        benchmark::DoNotOptimize(dots.x.data());
        benchmark::ClobberMemory();
    }
    report(state, count);
}

void build_pyramid(benchmark::State& state, const Grid<float>& light) {
    for (auto _ : state) {
        const Density density = page_density(density_of(light, Tone{}));
        benchmark::DoNotOptimize(density.mean());
    }
    state.counters["megapixels/s"] = benchmark::Counter(static_cast<double>(light.values.size()) / 1e6,
                                                        benchmark::Counter::kIsIterationInvariantRate);
}

void add_picture(const std::string& name, const Density& density) {
    // One thread's rows count processor time, which other work on the machine disturbs less.
    const auto counts = [](benchmark::internal::Benchmark* b, int threads) {
        b->RangeMultiplier(10)->Range(10'000, 10'000'000)->Unit(benchmark::kMillisecond);
        if (threads != 1) b->UseRealTime();
    };
    const auto add = [&](const std::string& what, auto function, int threads = 1) {
        counts(benchmark::RegisterBenchmark((what + "/" + name).c_str(), function), threads);
    };
    add("figure8", [&density](benchmark::State& s) { figure8(s, density); });
    for (const std::string tile : {"paper16", "aperiodic16", "aperiodic1024", "aperiodic4096", "kinds4096"})
        add("exact_" + tile, [&density, tile](benchmark::State& s) { exact(s, density, tile, 1); });
    for (const std::string tile : {"paper16", "kinds4096"}) {
        add(
            "exact_" + tile + "_all_cores",
            [&density, tile](benchmark::State& s) { exact(s, density, tile, 0); }, 0);
        add(
            "two_at_once_" + tile, [&density, tile](benchmark::State& s) { two_at_once(s, density, tile); },
            2);
        add("exact_count_" + tile, [&density, tile](benchmark::State& s) { exact_count(s, density, tile); });
    }
}

}  // namespace

int main(int argc, char** argv) {
    const Grid<float> light = sample_picture().light;
    const Density sample = page_density(density_of(light, Tone{}));
    const Density pale = light_picture();
    const Density grey(Grid<float>(512, 512, 0.5f));
    std::optional<Density> given;
    if (const char* path = std::getenv("DAPPLE_BENCH_PICTURE"))
        given.emplace(page_density(density_of(read_picture(path).light, Tone{})));

    add_picture("sample", sample);
    add_picture("light", pale);
    add_picture("grey", grey);
    if (given) add_picture("given", *given);
    benchmark::RegisterBenchmark("write_floats", write_floats)
        ->RangeMultiplier(10)
        ->Range(10'000, 10'000'000)
        ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark("tone_and_pyramid/sample",
                                 [&light](benchmark::State& s) { build_pyramid(s, light); })
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();

    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
