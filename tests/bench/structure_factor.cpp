// How far the long waves of many dots vanish: the structure factor S(k) = |sum exp(-2 pi i k x)|^2 / n on one
// grey, the mean over rings of |k| / sqrt(n), in Markdown. 1 for dots at random; what is called stealthy has
// 0.001 to 0.0001 and less.
//
//      structure_factor [--steps N] DOTS...    after N steps, or the usual ones
//
// Waves go once and more over the page as over a torus, which it is not: its edges have a share in them that
// grows with how many dots lie along them. Windowed, w = (sin pi x sin pi y)^4 for each dot, and over the
// mean of w^2, they do not.

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <CLI/CLI.hpp>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <glm/vec2.hpp>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include "core/drawing/pipeline.h"
#include "core/drawing/settings.h"
#include "core/placing/page.h"
#include "io/files/tile_library.h"

namespace {

using namespace dapple;

constexpr std::array kRings{0.005, 0.03, 0.1, 0.2, 0.3, 0.5};
constexpr int kWavesOfRing = 48;

struct Sums {
    double plain = 0, windowed = 0;
};

// Of one wave.
Sums structure_factor(const Dots& dots, glm::ivec2 wave) {
    double re = 0, im = 0, windowed_re = 0, windowed_im = 0, weights = 0;
    for (std::size_t i = 0; i < dots.size(); ++i) {
        const auto x = static_cast<double>(dots.x[i]), y = static_cast<double>(dots.y[i]);
        const double phase = 2 * std::numbers::pi * (wave.x * x + wave.y * y), c = std::cos(phase),
                     s = std::sin(phase);
        const double w = std::pow(std::sin(std::numbers::pi * x) * std::sin(std::numbers::pi * y), 4);
        re += c, im += s;
        windowed_re += w * c, windowed_im += w * s;
        weights += w * w;
    }
    return {(re * re + im * im) / static_cast<double>(dots.size()),
            (windowed_re * windowed_re + windowed_im * windowed_im) / weights};
}

void measure(Pipeline& pipeline, std::uint64_t count, std::optional<int> steps) {
    const DrawingPlan plan = pipeline.plan(
        {.placing = {.count = count, .threads = 0}, .relax = steps, .page = {.width_mm = 5000}});
    const auto start = std::chrono::steady_clock::now();
    Stippling drawn;
    pipeline.draw(plan, drawn);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    Dots dots;
    for (const Dots& piece : drawn.dots.pieces) append(dots, piece);
    fmt::print("| {} | {} | {:.2f} s |", dots.size(), plan.steps, seconds);
    const double root = std::sqrt(static_cast<double>(dots.size()));
    std::mt19937 random(1);
    std::string windowed;
    for (std::size_t ring = 0; ring + 1 < kRings.size(); ++ring) {
        std::vector<glm::ivec2> waves;
        while (waves.size() < kWavesOfRing) {
            const auto number = [&] {
                return (static_cast<double>(random()) / 0x1p31 - 1) * kRings[ring + 1] * root;
            };
            const glm::ivec2 wave = glm::round(glm::dvec2(number(), number()));
            const double length = std::hypot(wave.x, wave.y) / root;
            if (length >= kRings[ring] && length < kRings[ring + 1] && std::hypot(wave.x, wave.y) >= 1)
                waves.push_back(wave);
        }
        std::vector<Sums> sums(waves.size());
        tbb::parallel_for(std::size_t{0}, waves.size(),
                          [&](std::size_t i) { sums[i] = structure_factor(dots, waves[i]); });
        Sums mean;
        for (const Sums& one : sums) {
            mean.plain += one.plain / kWavesOfRing;
            mean.windowed += one.windowed / kWavesOfRing;
        }
        fmt::print(" {:.5f} |", mean.plain);
        windowed += fmt::format(" {:.5f} |", mean.windowed);
    }
    fmt::print("{}\n", windowed);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        std::vector<std::uint64_t> counts{1'000'000};
        std::optional<int> steps;
        CLI::App app("How far the long waves of many dots vanish.");
        app.add_option("DOTS", counts);
        app.add_option("--steps", steps);
        CLI11_PARSE(app, argc, argv);
        Pipeline pipeline;
        pipeline.set_tile(tile_named(kDefaultTile));
        pipeline.set_plain(page_density(Grid<float>(1000, 1000, 0.5f)));
        fmt::print("| dots | steps | time |");
        for (const char* window : {"", " windowed"})
            for (std::size_t ring = 0; ring + 1 < kRings.size(); ++ring)
                fmt::print(" {} to {}{} |", kRings[ring], kRings[ring + 1], window);
        fmt::print("\n|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
        for (const std::uint64_t count : counts) measure(pipeline, count, steps);
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "structure_factor: {}\n", error.what());
        return 1;
    }
}
