#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "core/analysis/distances.h"
#include "core/analysis/periodogram.h"
#include "core/tile/tile.h"
#include "tests/point_sets.h"

using namespace dapple;

namespace {

std::vector<glm::dvec2> paper_tile_repeated(int times) {
    std::vector<glm::dvec2> tile;
    for (const BinaryPoint p : make_tile(14217, 2895, 16).points) tile.push_back(to_unit_square(p));
    return repeated(tile, times);
}

}  // namespace

TEST_CASE("white noise is flat, isotropic and without peaks") {
    const Periodogram spectrum = periodogram(white_noise(20000, 9), {});
    const Peaks peaks = spectral_peaks(spectrum);
    CHECK(peaks.top_share == doctest::Approx(0.001 * (1 + std::log(1000.0))).epsilon(0.05));
    CHECK(peaks.highest_bin < 25);  // of 118,000 exponentially distributed values: 11.7 + 1.3 expected
    CHECK(low_frequency_power(spectrum, 0.5) == doctest::Approx(1).epsilon(0.05));
    const auto rings = radial_power(spectrum);
    REQUIRE(rings.size() == 282);
    for (std::size_t r = 50; r < 282; ++r) {
        CHECK(rings[r].frequency == doctest::Approx(double(r + 1) / std::sqrt(20000.0)));
        CHECK(rings[r].power == doctest::Approx(1).epsilon(0.4));
        CHECK(std::abs(rings[r].anisotropy_db) < 3);
    }
    CHECK(effective_nyquist(rings) < 0.02);
}

TEST_CASE("a ring holds the frequencies whose length rounds to it, one of k and -k") {
    const auto rings = radial_power(periodogram(white_noise(400, 1), {}));
    REQUIRE(rings.size() == 40);
    CHECK(rings[0].bins == 4);  // (1,0) (0,1) (1,1) (1,-1)
    CHECK(rings[1].bins == 6);  // (2,0) (0,2) (2,+-1) (1,+-2)
    CHECK(rings[2].bins == 8);  // (3,0) (0,3) (2,+-2) (3,+-1) (1,+-3)
    CHECK(rings[39].frequency == doctest::Approx(2));
}

TEST_CASE("a square lattice is all peaks, anisotropic and usable to its Nyquist frequency") {
    const Periodogram spectrum = periodogram(square_lattice(60), {});
    const Peaks peaks = spectral_peaks(spectrum);
    CHECK(peaks.highest_bin == doctest::Approx(3600).epsilon(1e-4));
    CHECK(peaks.highest_x % 60 == 0);
    CHECK(peaks.highest_y % 60 == 0);
    CHECK(peaks.top_share == doctest::Approx(1).epsilon(1e-4));
    CHECK(low_frequency_power(spectrum, 0.999) < 1e-4);
    const auto rings = radial_power(spectrum);
    // Ring 60 has the two peaks (60, 0) and (0, 60) among its bins: mean 2 n / bins, variance about
    // n^2 2 / bins, the ratio bins / 2.
    CHECK(rings[59].power == doctest::Approx(2 * 3600.0 / double(rings[59].bins)).epsilon(1e-4));
    CHECK(rings[59].anisotropy_db ==
          doctest::Approx(10 * std::log10(double(rings[59].bins) / 2)).epsilon(0.01));
    CHECK(effective_nyquist(rings) == doctest::Approx(1).epsilon(0.02));
}

TEST_CASE("the effective Nyquist frequency of a step is at least its edge and grows with the threshold") {
    std::vector<Ring> step(200);
    for (std::size_t r = 0; r < step.size(); ++r)
        step[r] = {.frequency = double(r + 1) / 100, .bins = 1, .power = r + 1 > 56 ? 1.0 : 0.0};
    CHECK(effective_nyquist(step, 1e-9) == doctest::Approx(0.56).epsilon(0.01));
    // The part of the disc of radius f about f beyond the edge 0.56 is a tenth at 2 f = 0.674:
    // by the integral of 2 acos(r / 2 f) r dr.
    CHECK(effective_nyquist(step, 0.1) > 0.6);
    CHECK(effective_nyquist(step, 0.1) < 0.75);
}

TEST_CASE("the paper's tile repeated 64 x 64 times has the spectrum of its sixteen points") {
    const auto points = paper_tile_repeated(64);
    REQUIRE(points.size() == 65536);
    const Periodogram spectrum = periodogram(points, {});
    const Periodogram tile = periodogram(paper_tile_repeated(1), {}, {.route = FourierRoute::exact});
    for (int i = -8; i <= 8; ++i)
        for (int j = -8; j <= 8; ++j)
            CHECK(double(spectrum.at(64 * i, 64 * j)) ==
                  doctest::Approx(4096 * double(tile.at(i, j))).epsilon(1e-4));
    const Peaks peaks = spectral_peaks(spectrum);
    CHECK(std::round(peaks.highest_bin) == 27717);
    CHECK(peaks.highest_x == 64);
    CHECK(std::abs(peaks.highest_y) == 5 * 64);
    CHECK(peaks.top_share > 0.9999);
    CHECK(std::round(low_frequency_power(spectrum, 0.3) * 1000) == 34);
    CHECK(std::round(low_frequency_power(spectrum, 0.5) * 1000) == 88);
}

TEST_CASE("the paper's tile on a raster of 2048 x 2048 has the spectrum that a plain FFT finds there") {
    // Computed with an FFT of that raster, apart from this program. The raster moves the points by up to
    // 1/32 of a tile's side, so the spectrum is another one.
    auto points = paper_tile_repeated(64);
    for (glm::dvec2& p : points) p = {std::floor(p.x * 2048) / 2048, std::floor(p.y * 2048) / 2048};
    const Periodogram spectrum = periodogram(points, {});
    CHECK(std::round(spectral_peaks(spectrum).highest_bin) == 23301);
    CHECK(spectral_peaks(spectrum).top_share > 0.9999);
    CHECK(std::round(low_frequency_power(spectrum, 0.3) * 1000) == 26);
    CHECK(std::round(low_frequency_power(spectrum, 0.5) * 1000) == 93);
}

TEST_CASE("the paper's tile repeated 64 x 64 times has known nearest distances") {
    const auto points = paper_tile_repeated(64);
    const NearestSummary torus = nearest_summary(points, {});
    CHECK(torus.minimum == doctest::Approx(0.652788).epsilon(1e-6));
    CHECK(std::round(torus.p1 * 1000) == 653);
    CHECK(torus.mean == doctest::Approx(0.7650460236).epsilon(1e-9));  // of sixteen points, by all pairs
    const NearestSummary window = nearest_summary(points, {1, 1, Topology::window});
    CHECK(std::round(window.minimum * 1000) == 653);
    CHECK(std::round(window.p1 * 1000) == 653);
    CHECK(std::round(window.mean * 1000) == 766);  // points along the edge have fewer neighbours
}
