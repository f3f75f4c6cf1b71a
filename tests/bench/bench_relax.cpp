// What a step of relaxation of each kind costs: microseconds a dot, on one core and on two. The picture is
// the built-in sample in its automatic tone, or the file in DAPPLE_BENCH_PICTURE; and a constant grey.

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "core/drawing/pipeline.h"
#include "core/drawing/settings.h"
#include "core/relaxing/relax.h"
#include "io/files/picture.h"
#include "io/files/tile_library.h"

using namespace dapple;

namespace {

void step(benchmark::State& state, Pipeline& pipeline, RelaxingStep::Kind kind, int threads) {
    const auto count = static_cast<std::uint64_t>(state.range(0));
    const DrawingPlan plan = pipeline.plan(
        {.tone_strength = 1, .tone = {}, .placing = {.count = count, .threads = 0}, .relax = 0});
    Stippling drawn;
    pipeline.draw(plan, drawn);
    const RelaxingRequest relaxing{
        .scale = drawn.scale, .threads = threads, .light = std::make_shared<const InkCurve>(plan.ink)};
    Relaxation relaxation(drawn.dots, *plan.density, relaxing);
    for (auto _ : state) relaxation.step({.kind = kind, .stride = 0.6f});
    state.counters["us/dot"] =
        benchmark::Counter(static_cast<double>(count) * 1e-6,
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void add(const std::string& name, Pipeline& pipeline, const std::string& kind_name, RelaxingStep::Kind kind) {
    for (const int threads : {1, 2}) {
        const std::string whole = kind_name + "/" + name + (threads == 1 ? "/one_core" : "/two_cores");
        benchmark::RegisterBenchmark(
            whole.c_str(),
            [&pipeline, kind, threads](benchmark::State& s) { step(s, pipeline, kind, threads); })
            ->Arg(40'000)
            ->Arg(200'000)
            ->Arg(1'000'000)
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime();
    }
}

}  // namespace

int main(int argc, char** argv) {
    Pipeline picture, grey;
    const char* path = std::getenv("DAPPLE_BENCH_PICTURE");
    picture.set_light((path ? read_picture(path) : sample_picture()).light);
    grey.set_plain(Density(Grid<float>(1000, 1000, 0.5f)));
    for (Pipeline* pipeline : {&picture, &grey}) pipeline->set_tile(tile_named(kDefaultTile));
    using Kind = RelaxingStep::Kind;
    for (const auto& [name, kind] : std::map<std::string, Kind>{
             {"lloyd", Kind::lloyd}, {"energy", Kind::energy}, {"warp", Kind::warp}}) {
        add("picture", picture, name, kind);
        add("grey", grey, name, kind);
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
