// What lies over many dots: Poisson's equation against waves that solve it, discs against a slow count of
// bits, and warps by what is left of a drawing's long waves and of its error in light.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "core/image/detail.h"
#include "core/placing/stipple.h"
#include "core/relaxing/relax.h"
#include "core/relaxing/warp.h"
#include "tests/densities.h"
#include "tests/dot_pieces.h"

using namespace dapple;

namespace {

RankedTile& test_tile() {
    static RankedTile tile(make_tile(14217, 2895, 16), RankingMethod::energy);
    return tile;
}

Stippling placed(const Density& density, std::uint64_t count) {
    Stippling result;
    REQUIRE(stipple(test_tile(), density, PlacerKind::exact, {.count = count}, result));
    return result;
}

// The mean of |sum w exp(-2 pi i k x)|^2 over what as many random dots have, of waves that are at least ten
// spacings long, with a window that lets no edge be seen.
double long_waves(const Dots& dots) {
    const auto window = [](double x, double y) {
        return std::pow(std::sin(std::numbers::pi * x) * std::sin(std::numbers::pi * y), 4);
    };
    double squares = 0;
    std::vector<double> weights;
    for (std::size_t i = 0; i < dots.size(); ++i) {
        weights.push_back(window(double(dots.x[i]), double(dots.y[i])));
        squares += weights.back() * weights.back();
    }
    const double root = std::sqrt(static_cast<double>(dots.size()));
    double sum = 0;
    int waves = 0;
    for (int y = 0; y <= static_cast<int>(0.1 * root); ++y) {
        for (int x = -static_cast<int>(0.1 * root); x <= static_cast<int>(0.1 * root); ++x) {
            if (std::hypot(x, y) > 0.1 * root || std::hypot(x, y) < 4) continue;
            std::complex<double> wave = 0;
            for (std::size_t i = 0; i < dots.size(); ++i)
                wave += std::polar(weights[i],
                                   -2 * std::numbers::pi * (x * double(dots.x[i]) + y * double(dots.y[i])));
            sum += std::norm(wave) / squares;
            ++waves;
        }
    }
    return sum / waves;
}

constexpr int kSide = 1024;  // of pictures of light

// Light of discs, 1 where paper is bare: each pixel's middle against all discs around it.
Grid<float> light_of(const Dots& dots, double radius) {
    Grid<float> light(kSide, kSide, 1.0f);
    for (std::size_t i = 0; i < dots.size(); ++i) {
        const double x = kSide * double(dots.x[i]), y = kSide * double(dots.y[i]), r = kSide * radius;
        for (int row = std::max(int(y - r), 0); row <= std::min(int(y + r), kSide - 1); ++row)
            for (int column = std::max(int(x - r), 0); column <= std::min(int(x + r), kSide - 1); ++column)
                if (std::hypot(column + 0.5 - x, row + 0.5 - y) < r) light.at(column, row) = 0;
    }
    return light;
}

}  // namespace

TEST_CASE("waves that solve Poisson's equation on a page come out, of any size and shape") {
    struct Case {
        int width, height, across, down;
    };
    for (const auto& [width, height, across, down] :
         {Case{64, 64, 1, 0}, Case{64, 64, 3, 5}, Case{640, 96, 2, 1}, Case{40, 384, 1, 7}, Case{7, 5, 1, 1},
          Case{96, 1, 4, 0}}) {
        CAPTURE(width);
        CAPTURE(height);
        CAPTURE(across);
        const glm::vec2 cell(0.5f, 0.7f);
        const double kx = std::numbers::pi * across / width / double(cell.x);
        const double ky = std::numbers::pi * down / height / double(cell.y);
        const auto wave = [&](int x, int y) {
            return std::cos(kx * (x + 0.5) * double(cell.x)) * std::cos(ky * (y + 0.5) * double(cell.y));
        };
        Grid<float> excess(width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) excess.at(x, y) = static_cast<float>(wave(x, y));
        const Grid<float> phi = poisson(excess, cell, 8);
        const double height_of = -1 / (kx * kx + ky * ky);
        double sum = 0, error = 0;
        for (const float v : phi.values) sum += double(v) / (double(width) * height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                error = std::max(error, std::abs(double(phi.at(x, y)) - sum - height_of * wave(x, y)));
        // Of which a grid of so few cells to a wave has most.
        const double cells =
            std::min(across ? double(width) / across : 1e9, down ? double(height) / down : 1e9);
        CHECK(error < (0.02 + 1.0 / (cells * cells)) * std::abs(height_of));
    }
}

TEST_CASE("a number of cells is near the length, and can be halved until few are left") {
    for (double length = 0.2; length < 3000; length *= 1.07) {
        int cells = cells_along(length);
        CHECK(std::abs(cells - std::max(length, 1.0)) < 0.13 * length + 0.5);
        while (cells > 8) {
            CHECK(cells % 2 == 0);
            cells /= 2;
        }
    }
}

TEST_CASE("bits are covered that lie in a disc, wherever discs overlap or reach beyond the page") {
    constexpr int kCells = 21;
    CoveredBits bits(kCells, 5);
    std::vector<glm::vec4> discs;
    std::mt19937 random(7);
    const auto number = [&](float most) { return most * static_cast<float>(random() % 10'000) / 10'000; };
    for (int i = 0; i < 40; ++i) discs.emplace_back(number(200) - 15, number(60) - 10, number(9), number(9));
    discs.emplace_back(90, 20, 80, 3);  // over whole words
    for (const glm::vec4& d : discs) bits.cover({d.x, d.y}, {d.z, d.w});
    for (int row = 0; row < 5; ++row) {
        std::vector<float> bare(kCells);
        bits.bare(row, bare.data());
        for (int cell = 0; cell < kCells; ++cell) {
            int covered = 0;
            for (int i = 0; i < 64; ++i) {
                const glm::vec2 p(static_cast<float>(8 * cell + i % 8) + 0.5f,
                                  static_cast<float>(8 * row + i / 8) + 0.5f);
                covered += std::ranges::any_of(discs, [&](const glm::vec4& d) {
                    const glm::vec2 from = (p - glm::vec2(d)) / glm::vec2(d.z, d.w);
                    return glm::dot(from, from) <= 1;
                });
            }
            // A bit whose middle lies on the rim may be on either side.
            CHECK(std::abs(static_cast<float>(64 - covered) / 64 - bare[static_cast<std::size_t>(cell)]) <
                  1.5f / 64);
        }
    }
}

TEST_CASE("on one grey no long wave is left, and dots stay as far apart") {
    const Density grey(Grid<float>(64, 64, 0.5f));
    const Stippling from = placed(grey, 5000);
    const RelaxingRequest request{.scale = from.scale};
    const auto after = [&](bool warps) {
        Relaxation relaxation(from.dots, grey, request);
        for (const RelaxingStep& how : relaxing_steps(7, request))
            if (warps || how.kind != RelaxingStep::Kind::warp) REQUIRE(relaxation.step(how));
        return joined(relaxation.dots());
    };
    const double without = long_waves(after(false)), with = long_waves(after(true));
    CAPTURE(without);
    CAPTURE(with);
    CHECK(without > 0.0001);
    CHECK(with < 0.02 * without);
}

TEST_CASE("carried before the first step, dots have no long waves either") {
    const Density grey(Grid<float>(64, 64, 0.5f));
    const Stippling from = placed(grey, 5000);
    RelaxingRequest request{.scale = from.scale};
    const Warp warp(grey, {.scale = from.scale, .dots = 5000});
    Warp::Count counted(warp);
    const auto rows = static_cast<float>(1 / relaxing_row(from.scale));
    for_each_position(from.dots, [&](float x, float y) { counted.add(rows * x, rows * y); });
    DotPieces plain = from.dots, carried = from.dots;
    REQUIRE(relax(plain, grey, 7, {.scale = from.scale, .carried = std::make_shared<const Displacement>()}));
    request.carried = std::make_shared<const Displacement>(counted.displacement());
    REQUIRE(relax(carried, grey, 7, request));
    CHECK(long_waves(joined(carried)) < 0.5 * long_waves(joined(plain)));
}

TEST_CASE("a picture's light is the wanted one within a third of the error that steps alone leave") {
    Grid<float> grid(128, 128);
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x)
            grid.at(x, y) = static_cast<float>(0.45 + 0.4 * std::sin(0.1 * x) * std::cos(0.13 * y));
    const InkedDots inked{.relaxing_steps = 7};
    const auto ink = std::make_shared<const InkCurve>(inked);
    const Density density(grid);
    const Stippling from = placed(density, 6000);
    const double spacing = kSide / std::sqrt(6000.0);
    Grid<float> wanted(kSide, kSide);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            wanted.at(x, y) =
                1 -
                ink->coverage(static_cast<float>(density.at(glm::dvec2(x + 0.5, y + 0.5) / double(kSide))));
    wanted = blurred(wanted, spacing);
    const auto error = [&](bool warps) {
        const RelaxingRequest request{.scale = from.scale, .light = ink};
        Relaxation relaxation(from.dots, density, request);
        for (const RelaxingStep& how : relaxing_steps(7, request))
            if (warps || how.kind != RelaxingStep::Kind::warp) REQUIRE(relaxation.step(how));
        const Grid<float> light = blurred(
            light_of(joined(relaxation.dots()), radius_for_tone(from.scale, ink->full_load())), spacing);
        double squares = 0, mean = 0;
        constexpr int kEdge = 40;  // where dots are cut off
        constexpr double kPixels = double(kSide - 2 * kEdge) * (kSide - 2 * kEdge);
        for (int pass = 0; pass < 2; ++pass)
            for (int y = kEdge; y < kSide - kEdge; ++y)
                for (int x = kEdge; x < kSide - kEdge; ++x) {
                    const double off = double(light.at(x, y)) - double(wanted.at(x, y));
                    if (pass == 0)
                        mean += off / kPixels;
                    else
                        squares += (off - mean) * (off - mean) / kPixels;
                }
        return std::sqrt(squares);
    };
    const double without = error(false), with = error(true);
    CAPTURE(without);
    CAPTURE(with);
    CHECK(with < without / 3);
}

TEST_CASE("no dot is carried farther than half a distance to the next, and none over a white gap") {
    // Far too many dots on the left, for all that a warp knows, and white in the middle.
    Grid<float> grid(90, 30, 0.2f);
    for (int y = 0; y < 30; ++y)
        for (int x = 40; x < 50; ++x) grid.at(x, y) = 0;
    const Density density(grid);
    Dots dots;
    std::mt19937 random(3);
    for (int i = 0; i < 900; ++i) {
        dots.x.push_back(0.4f * static_cast<float>(random() % 4096) / 4096);
        dots.y.push_back(0.33f * static_cast<float>(random() % 4096) / 4096);
    }
    const double scale = scale_for(density, 900);
    const double apart = 1 / std::sqrt(kDotsPerScale * scale * 0.2);
    Relaxation relaxation(in_one_piece(dots), density, {.scale = scale});
    for (int i = 0; i < 8; ++i) {
        const Dots before = relaxation.dots_as_taken();
        REQUIRE(relaxation.step({RelaxingStep::Kind::warp}));
        const Dots after = relaxation.dots_as_taken();
        double farthest = 0;
        for (std::size_t k = 0; k < dots.size(); ++k) {
            farthest = std::max(
                farthest, std::hypot(double(after.x[k] - before.x[k]), double(after.y[k] - before.y[k])));
            CHECK(after.x[k] < 0.5f);
        }
        CHECK(farthest < 0.501 * apart);
        if (i == 0) CHECK(farthest > 0.3 * apart);
    }
}
