#include "lab/related/quasi_random.h"

#include <algorithm>
#include <utility>

#include "core/lights/sampler_comparison.h"
#include "lab/related/bent_square.h"

namespace dapple {
namespace {

template <class Point>
PlainDots warped(const DotsWanted& wanted, const Point& point_of) {
    const BentSquare warp(wanted.density);
    PlainDots dots;
    dots.reserve(wanted.count);
    for (std::size_t i = 0; i < wanted.count; ++i) {
        if ((i & 0xffff) == 0 && wanted.stop.stop_requested()) return {};
        dots.push_back(warp(point_of(i)));
    }
    return dots;
}

struct LatticeVector {
    std::int64_t x, y;

    std::int64_t squared() const { return x * x + y * y; }
};

// The square of the shortest vector of the lattice of (1, g) and (0, n). Gives up, with a smaller number,
// where that is no more than `enough`.
std::int64_t shortest2(std::int64_t g, std::int64_t n, std::int64_t enough) {
    LatticeVector a{0, n}, b{1, g};
    while (true) {
        if (a.squared() < b.squared()) std::swap(a, b);
        const std::int64_t dot = a.x * b.x + a.y * b.y, length = b.squared();
        if (length <= enough) return length;
        const std::int64_t twice = 2 * dot + length;
        const std::int64_t times =
            twice >= 0 ? twice / (2 * length) : -((2 * length - 1 - twice) / (2 * length));
        if (times == 0) return length;
        a.x -= times * b.x;
        a.y -= times * b.y;
    }
}

}  // namespace

double radical_inverse(std::uint32_t base, std::uint64_t i) {
    std::uint64_t mirrored = 0, power = 1;
    for (; i > 0; i /= base) {
        mirrored = mirrored * base + i % base;
        power *= base;
    }
    return double(mirrored) / double(power);
}

PlainDots halton(const DotsWanted& wanted) {
    return warped(wanted,
                  [](std::size_t i) { return glm::dvec2(radical_inverse(2, i), radical_inverse(3, i)); });
}

PlainDots hammersley(const DotsWanted& wanted) {
    const double n = double(wanted.count);
    return warped(wanted, [n](std::size_t i) { return glm::dvec2(double(i) / n, radical_inverse(2, i)); });
}

PlainDots sobol(const DotsWanted& wanted) {
    // In the order of the sequence as it is printed, by Gray code (Antonov & Saleev 1979), which permutes
    // each block of 2^k points.
    return warped(wanted, [](std::size_t i) { return sobol_point(std::uint32_t(i ^ (i >> 1))); });
}

std::uint32_t best_generator(std::uint32_t n) {
    std::int64_t best = 0;
    std::uint32_t generator = 1;
    for (std::uint32_t g = 1; g <= n / 2; ++g) {
        const std::int64_t squared = shortest2(g, n, best);
        if (squared > best) {
            best = squared;
            generator = g;
        }
    }
    return generator;
}

PlainDots rank1_lattice(const DotsWanted& wanted) {
    const std::uint64_t n = wanted.count;
    if (n == 0 || wanted.stop.stop_requested()) return {};
    const std::uint64_t generator = best_generator(std::uint32_t(n));
    return warped(wanted, [=](std::size_t i) {
        return glm::dvec2(double(i) / double(n), double(generator * i % n) / double(n));
    });
}

}  // namespace dapple
