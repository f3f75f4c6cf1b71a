// How long a pen's way is, and how long it takes to find: along a Hilbert curve, shortened, and by plain
// 2-opt run to its end, for 10^4 to 10^6 random dots. Lengths are in sqrt(dots * area), of which the shortest
// way has about 0.7124. Prints a table; a count given as an argument is the only one.

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

#include "core/placing/dot_order.h"
#include "core/routing/short_way.h"
#include "tests/bench/plain_two_opt.h"

namespace {

using namespace dapple;

Dots random_dots(std::size_t count) {
    Dots dots;
    std::mt19937 random(1);
    std::uniform_real_distribution<float> place;
    for (std::size_t i = 0; i < count; ++i) {
        dots.x.push_back(place(random));
        dots.y.push_back(place(random));
    }
    return dots;
}

void print_row(std::size_t count) {
    Dots dots = random_dots(count);
    auto start = std::chrono::steady_clock::now();
    const auto lap = [&] {
        const auto now = std::chrono::steady_clock::now();
        return std::chrono::duration<double>(now - std::exchange(start, now)).count();
    };
    const double unit = std::sqrt(static_cast<double>(count));
    sort_dots(dots, DotOrder::space);
    const double sorting = lap();
    fmt::print("{:>9}  Hilbert   {:.4f} {:8.2f} s\n", count, way_length(dots.x, dots.y) / unit, sorting);
    lap();
    const std::vector<std::uint32_t> order = short_way(dots.x, dots.y);
    const double shortening = lap();
    fmt::print("{:>9}  short way {:.4f} {:8.2f} s\n", count, way_length(dots.x, dots.y, order) / unit,
               shortening);
    if (count > 20'000) return;
    lap();
    const std::vector<std::uint32_t> plain = plain_two_opt(dots);
    const double turning = lap();
    fmt::print("{:>9}  2-opt     {:.4f} {:8.2f} s\n", count, way_length(dots.x, dots.y, plain) / unit,
               turning);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc > 1) {
        print_row(static_cast<std::size_t>(std::max(2L, std::atol(argv[1]))));
        return 0;
    }
    for (const std::size_t count : {10'000, 100'000, 1'000'000}) print_row(count);
}
