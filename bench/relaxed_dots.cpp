#include "bench/relaxed_dots.h"

#include <chrono>
#include <stdexcept>

namespace dapple {
namespace {

void relax(DotPieces&, const Density&, double /*scale*/, int steps) {
    if (steps > 0) throw std::runtime_error("relaxing is not there yet; measure 0 steps");
}

}  // namespace

RelaxedDots relaxed_dots(RankedTile& tile, const Density& density, std::size_t count, int steps) {
    Stippling placed;
    stipple(tile, density, {.count = count, .threads = 0}, placed);
    const auto start = std::chrono::steady_clock::now();
    relax(placed.dots, density, placed.scale, steps);
    const std::chrono::duration<double, std::milli> relaxing = std::chrono::steady_clock::now() - start;
    RelaxedDots result{.scale = placed.scale, .ms = placed.place_ms + relaxing.count()};
    result.dots.reserve(placed.dots.size());
    for_each_position(placed.dots, [&](float x, float y) { result.dots.emplace_back(x, y); });
    return result;
}

}  // namespace dapple
