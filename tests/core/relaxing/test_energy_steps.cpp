// Steps down the energy of Gaussian kernels, against slow references in double precision.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>
#include <vector>

#include "core/placing/stipple.h"
#include "core/relaxing/blurred_density.h"
#include "core/relaxing/energy_steps.h"
#include "core/relaxing/relax.h"
#include "tests/densities.h"
#include "tests/dot_pieces.h"

using namespace dapple;

namespace {

RankedTile& test_tile() {
    static RankedTile tile(make_tile(14217, 2895, 16), RankingMethod::energy);
    return tile;
}

Grid<float> hills(int width, int height) {
    Grid<float> grid(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            grid.at(x, y) =
                static_cast<float>(0.5 + 0.4 * std::sin(11.0 * x / width) * std::cos(8.0 * y / height));
    return grid;
}

std::vector<glm::dvec2> positions(const Dots& dots) {
    std::vector<glm::dvec2> result;
    for (std::size_t i = 0; i < dots.size(); ++i) result.emplace_back(dots.x[i], dots.y[i]);
    return result;
}

// The density's integral over the page with a Gaussian about p, and that of the slope; in pixels. Beyond its
// edges lie mirror images.
struct Seen {
    double value = 0;
    glm::dvec2 slope{0};
};

Seen seen_through(const Density& density, glm::dvec2 p, double variance) {
    Seen seen;
    constexpr int kParts = 4;  // of a pixel
    const int reach = static_cast<int>(6 * std::sqrt(variance)) * kParts + 8;
    const auto mirrored = [](double x, double length) {
        x = std::abs(x);
        return x > length ? 2 * length - x : x;
    };
    for (int j = -reach; j <= reach; ++j) {
        for (int i = -reach; i <= reach; ++i) {
            const glm::dvec2 away = glm::dvec2(i, j) / double(kParts);
            const double weight = std::exp(-glm::dot(away, away) / (2 * variance)) /
                                  (2 * std::numbers::pi * variance * kParts * kParts);
            const glm::dvec2 at(mirrored(p.x + away.x, density.width() - 1e-9),
                                mirrored(p.y + away.y, density.height() - 1e-9));
            const double d = density.at(at / double(density.longer_side()));
            seen.value += weight * d;
            seen.slope += weight * d / variance * away;
        }
    }
    return seen;
}

}  // namespace

TEST_CASE("Gaussians without the C library come near its own") {
    for (float z = -4; z <= 5; z += 0.01f) {
        const BlurredStep step(z);
        CHECK(step.value == doctest::Approx(0.5 * std::erfc(-z / std::numbers::sqrt2)).epsilon(1e-3));
        CHECK(std::abs(step.value - 0.5 * std::erfc(-z / std::numbers::sqrt2)) < 1e-5);
        CHECK(std::abs(step.slope - std::exp(-0.5 * z * z) / std::sqrt(2 * std::numbers::pi)) < 1e-5);
    }
    for (float t = -8; t <= 0; t += 0.01f) {
        float power = t;
        take_exponential(power);
        CHECK(std::abs(power - std::exp(double(t))) < 1e-5);
    }
    for (float t = -120; t < -8; t += 0.1f) {
        float power = t;
        take_exponential(power);
        CHECK(std::isfinite(power));
    }
}

TEST_CASE("a blurred density is the density through Gaussians, as is its slope") {
    const Density density(hills(61, 40));
    const BlurredDensity blurred(density.values(), 0.8, 60);
    for (const double variance : {0.8, 1.5, 3.0, 7.0, 20.0, 60.0}) {
        CAPTURE(variance);
        double steepest = 0, error = 0;
        for (const glm::dvec2 p : {glm::dvec2(30.2, 20.7), glm::dvec2(12.9, 8.1), glm::dvec2(45.5, 30.5),
                                   glm::dvec2(1.2, 3.3), glm::dvec2(60.9, 39.9), glm::dvec2(0, 20)}) {
            const Seen right = seen_through(density, p, variance);
            const BlurredDensity::Slope found = blurred.at(p.x, p.y, static_cast<float>(variance));
            CHECK(found.value == doctest::Approx(right.value).epsilon(0.02));
            steepest = std::max(steepest, glm::length(right.slope));
            error = std::max(error, glm::distance(right.slope, glm::dvec2(found.x, found.y)));
        }
        CHECK(error < 0.12 * steepest);
    }
    const Seen sharp = seen_through(density, {30.2, 20.7}, 0.5);
    CHECK(blurred.sharpest(30.2, 20.7) == doctest::Approx(sharp.value).epsilon(0.02));
}

TEST_CASE("a step goes down the energy of all dots' ink and the wanted ink, as a slow sum over both has it") {
    struct Case {
        int width;
        double smallest;  // dot's area, over the largest's
    };
    for (const auto& [width, smallest] : {Case{30, 1}, Case{150, 1}, Case{150, 0.1}}) {
        CAPTURE(width);
        CAPTURE(smallest);
        const Density density(hills(width, width));
        const auto area = [smallest](double d) { return smallest + (1 - smallest) * d; };
        Grid<float> inks = density.values();
        for (float& value : inks.values) value *= static_cast<float>(area(value));
        const Density ink(std::move(inks));
        Stippling placed;
        REQUIRE(stipple(test_tile(), density, PlacerKind::exact, {.count = 600}, placed));
        Relaxation relaxation(placed.dots, density,
                              {.scale = placed.scale, .areas = {.smallest = static_cast<float>(smallest)}});
        const std::vector<glm::dvec2> dots = positions(joined(placed.dots));
        REQUIRE(relaxation.step({RelaxingStep::Kind::energy, 0.5f, kPictureKernel}));
        const std::vector<glm::dvec2> after = positions(relaxation.dots_as_taken());
        const double black = 16 * placed.scale;  // dots on an area of 1
        const double least = 2 * 0.45 * 0.45 / black * width * width;
        double way = 0, error = 0, most = 0;
        int inner = 0;
        for (std::size_t i = 0; i < dots.size(); ++i) {
            const glm::dvec2 dot = dots[i];
            const double ink_around = seen_through(ink, dot * double(width), std::max(0.25, least)).value;
            double around = 0, above = 1;  // the density that has so much ink
            for (int half = 0; half < 40; ++half) {
                const double middle = (around + above) / 2;
                (middle * area(middle) < ink_around ? around : above) = middle;
            }
            const double apart = 1 / std::sqrt(black * around), variance = 2 * 0.45 * 0.45 * apart * apart;
            const double edge = std::min({dot.x, dot.y, 1 - dot.x, 1 - dot.y});
            if (edge < 5.6 * std::sqrt(variance)) continue;
            // F = sum a_j (x - x_j) s^-2 exp(-d^2 / 2 s) + 2 pi grad, of which 2 sigma^4 F / a = s^2 / 2 F /
            // a is gone, a being the dot's own area.
            glm::dvec2 force(0);
            for (const glm::dvec2 other : dots)
                force += area(density.at(other)) * (dot - other) *
                         std::exp(-glm::dot(dot - other, dot - other) / (2 * variance));
            const Seen seen = seen_through(ink, dot * double(width), variance * width * width);
            force += 2 * std::numbers::pi * variance * variance * black * double(width) * seen.slope;
            glm::dvec2 step = 0.5 / area(density.at(dot)) * force;
            step *= std::min(1.0, 0.35 * apart / std::max(glm::length(step), 1e-12));
            const double off = glm::distance(after[i], dot + step) / apart;
            way += glm::length(step) / apart;
            error += off;
            most = std::max(most, off);
            ++inner;
        }
        REQUIRE(inner > 150);
        CHECK(way / inner > 0.04);
        CHECK(error / inner < 0.004);
        CHECK(most < 0.02);
    }
}

TEST_CASE("on one grey the low part of the spectrum all but vanishes") {
    // |sum w exp(-2 pi i k x)|^2 over what as many random dots have in the mean, of k within a ring, with a
    // window that lets no edge be seen.
    const auto low_spectrum = [](const std::vector<glm::dvec2>& dots) {
        const auto window = [](glm::dvec2 p) {
            return std::pow(std::sin(std::numbers::pi * p.x) * std::sin(std::numbers::pi * p.y), 4);
        };
        double squares = 0;
        for (const glm::dvec2 dot : dots) squares += window(dot) * window(dot);
        const double root = std::sqrt(static_cast<double>(dots.size()));
        double sum = 0;
        int waves = 0;
        for (int y = 0; y <= static_cast<int>(0.3 * root); ++y) {
            for (int x = -static_cast<int>(0.3 * root); x <= static_cast<int>(0.3 * root); ++x) {
                const double k = std::hypot(x, y) / root;
                if (k < 0.15 || k > 0.3) continue;
                std::complex<double> wave = 0;
                for (const glm::dvec2 dot : dots)
                    wave += std::polar(window(dot), -2 * std::numbers::pi * (x * dot.x + y * dot.y));
                sum += std::norm(wave) / squares;
                ++waves;
            }
        }
        return sum / waves;
    };
    const Density grey(Grid<float>(64, 64, 0.5f));
    Stippling placed;
    REQUIRE(stipple(test_tile(), grey, PlacerKind::exact, {.count = 2000}, placed));
    const auto after = [&](int lloyd, int energy, float kernel = kPictureKernel) {
        Relaxation relaxation(placed.dots, grey, {.scale = placed.scale});
        for (int i = 0; i < lloyd; ++i) REQUIRE(relaxation.step());
        for (int i = 0; i < energy; ++i) REQUIRE(relaxation.step({RelaxingStep::Kind::energy, 0.5f, kernel}));
        return low_spectrum(positions(joined(relaxation.dots())));
    };
    const double lloyd = after(20, 0);
    CHECK(lloyd > 0.002);
    CHECK(after(4, 16) < 0.1 * lloyd);
    CHECK(after(4, 56, kSampleKernel) < 0.1 * after(4, 56));
}

TEST_CASE("there are steps at any scale, also where there is no dot") {
    const Density density(hills(40, 30));
    for (const double scale : {1e-300, 1e-12, 1e-3, 1.0, 1e3}) {
        CAPTURE(scale);
        DotPieces dots = in_one_piece([] {
            Dots two;
            two.x = {0.25f, 0.75f};
            two.y = {0.5f, 0.25f};
            return two;
        }());
        REQUIRE(relax(dots, density, 20, {.scale = scale}));
        for_each_position(dots, [](float x, float y) {
            CHECK((x >= 0 && x < 1));
            CHECK((y >= 0 && y < 0.75f));
        });
    }
}
