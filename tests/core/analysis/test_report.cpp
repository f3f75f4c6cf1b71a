#include <doctest/doctest.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <stdexcept>

#include "core/analysis/report.h"
#include "tests/point_sets.h"

using namespace dapple;

TEST_CASE("a report holds every number of a square lattice") {
    const auto points = square_lattice(32);
    const auto report = analyse(points, {}, {.period = glm::dvec2(1 / 8.0, 1 / 8.0)});
    REQUIRE(report);
    CHECK(report->count == 1024);
    CHECK(report->density == 1024);
    CHECK(report->largest_radius == doctest::Approx(std::sqrt(1 / (2 * std::sqrt(3.0) * 1024))));
    CHECK(report->local_density.deviation == doctest::Approx(0));
    CHECK(report->nearest.mean == doctest::Approx(0.9306048591));
    CHECK(report->relative_radius == doctest::Approx(0.9306048591));
    CHECK(report->power_below_03 < 1e-4);
    CHECK(report->power_below_05 < 1e-4);
    CHECK(report->peaks.highest_bin == doctest::Approx(1024).epsilon(1e-4));
    // (1,0), (0,1), (1,1) and (1,-1) lie in 0.5 < |k| < 2, (2,0) on its edge; 0.1 % of the 6,000 bins are
    // six.
    CHECK(report->peaks.top_share == doctest::Approx(1).epsilon(1e-4));
    CHECK(report->effective_nyquist == doctest::Approx(1).epsilon(0.05));
    CHECK(report->radial_power.size() == 64);
    CHECK(report->pair_correlation.g.size() == 100);
    REQUIRE(report->periodicity);
    CHECK(report->periodicity->value == doctest::Approx(1));
    CHECK(report->l2_star_discrepancy > 0);
    CHECK(report->star_discrepancy.lower == report->star_discrepancy.upper);
    CHECK_FALSE(analyse(points, {})->periodicity);
}

TEST_CASE("a report doesn't depend on the number of threads") {
    const Domain window{1.5, 1, Topology::window};
    const auto points = white_noise(30000, 17, window);
    const ReportOptions options{.period = glm::dvec2(0.1, 0.1)};
    const auto many = analyse(points, window, options);
    tbb::task_arena one_thread(1);
    one_thread.execute([&] {
        const auto one = analyse(points, window, options);
        CHECK(one->nearest.mean == many->nearest.mean);
        CHECK(one->spectrum.power == many->spectrum.power);
        CHECK(one->pair_correlation.g == many->pair_correlation.g);
        CHECK(one->periodicity->value == many->periodicity->value);
        CHECK(one->star_discrepancy.lower == many->star_discrepancy.lower);
    });
}

TEST_CASE("a stopped analysis gives no report") {
    std::stop_source source;
    source.request_stop();
    CHECK_FALSE(analyse(white_noise(1000, 1), {}, {}, source.get_token()));
}

TEST_CASE("no point, one point and coinciding points have finite reports") {
    for (const Topology topology : {Topology::torus, Topology::window})
        for (const std::size_t count : {0, 1, 2, 50}) {
            const std::vector<glm::dvec2> points(count, glm::dvec2(0.25, 0.5));
            const auto report = analyse(points, {2, 1, topology}, {.period = glm::dvec2(0.5, 0.5)});
            REQUIRE(report);
            CHECK(report->count == count);
            for (const double value : {report->nearest.minimum, report->nearest.mean, report->power_below_05,
                                       report->peaks.top_share, report->effective_nyquist,
                                       report->l2_star_discrepancy, report->star_discrepancy.upper,
                                       report->periodicity->value, report->local_density.deviation})
                CHECK(std::isfinite(value));
            for (const Ring& ring : report->radial_power) CHECK(std::isfinite(ring.anisotropy_db));
            for (const double g : report->pair_correlation.g) CHECK(std::isfinite(g));
        }
}

TEST_CASE("a report refuses points outside a window and periods of no length by name") {
    const std::vector<glm::dvec2> points{{0.5, 0.5}, {1.5, 0.5}};
    CHECK_THROWS_WITH(analyse(points, {1, 1, Topology::window}, {.name = "dots.csv"}),
                      "dots.csv: point 2 at (1.5, 0.5) lies outside the 1 x 1 window; give a larger window");
    CHECK(analyse(points, {1, 1, Topology::torus})->nearest.minimum == 0);  // wrapped onto each other
    CHECK_THROWS_AS(analyse(points, {}, {.period = glm::dvec2(0.1, 0)}), std::runtime_error);
}
