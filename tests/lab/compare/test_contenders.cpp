// What dapple-lab compare compares, and how it judges who is first.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "lab/compare/columns.h"
#include "lab/compare/contenders.h"
#include "lab/compare/measure.h"
#include "lab/compare/tables.h"
#include "lab/related/covered.h"
#include "lab/related/white_noise.h"
#include "tests/run_in_shell.h"

using namespace dapple;

namespace {

MeasuredMethod measured(std::string title, bool ours, const GreyMarks& marks) {
    MeasuredMethod one;
    one.method.title = std::move(title);
    one.method.ours = ours;
    one.grey = {marks};
    return one;
}

// Larger in every number.
GreyMarks marks_of(double value) {
    GreyMarks marks{.wanted = 100, .count = 100, .seconds = value};
    marks.nearest = {.minimum = value, .p1 = value, .mean = value};
    marks.power_03 = marks.power_05 = value;
    marks.peaks.highest_bin = 1000 * value;
    marks.peaks.top_share = value;
    marks.effective_nyquist = value;
    marks.star = value;
    marks.l2_star = value;
    marks.seam = value;
    return marks;
}

}  // namespace

TEST_CASE("help of compare names every method that there is") {
    const std::string help = run_lab("compare --help").out;
    const std::string list = help.substr(help.find("Methods: "));
    for (const Contender& method : all_contenders()) {
        CAPTURE(method.name);
        CHECK((list.find(" " + method.name + ",") != std::string::npos ||
               list.find("\n" + method.name + ",") != std::string::npos ||
               list.find(method.name + ".") != std::string::npos));
    }
}

TEST_CASE("who is first has the largest distances and finest waves, and the least of everything else") {
    const std::vector<MeasuredMethod> both{measured("small", false, marks_of(0.25)),
                                           measured("large", true, marks_of(0.5))};
    const std::map<std::string, std::string> by_hand{
        {"time", "small"},
        {"nearest: minimum", "large"},
        {"nearest: 1st percentile", "large"},
        {"nearest: mean", "large"},
        {"power below 0.3", "small"},
        {"power below 0.5", "small"},
        {"highest bin", "small"},
        {"top 0.1 %", "small"},
        {"effective Nyquist", "large"},
        {"star discrepancy", "small"},
        {"L2 star discrepancy", "small"},
        {"seam", "small"},
    };
    const std::vector<Place> places = grey_places(both);
    CHECK(places.size() == by_hand.size());
    for (const Place& place : places) {
        CAPTURE(place.what);
        REQUIRE(by_hand.contains(std::string(place.what)));
        CHECK(place.first_title == by_hand.at(std::string(place.what)));
        CHECK(place.dapple_first == (place.first_title == "large"));
    }

    std::vector<MeasuredMethod> drawn{measured("small", false, {}), measured("large", true, {})};
    for (MeasuredMethod& one : drawn) {
        const double value = one.method.ours ? 0.5 : 0.25;
        one.drawings = {DrawingMarks{
            .count = 100,
            .seconds = value,
            .marks = {.ssim = value, .gradients = value, .tone_error = value, .mean_error = value},
            .distances = {.p1 = value, .mean = value, .count = 100},
            .cells = {.energy = value, .capacity = value, .displacement = value}}};
    }
    std::string firsts;
    for (const Place& place : drawing_places(drawn, 0))
        firsts += std::string(place.what) + " " + place.first_title + "\n";
    CHECK(firsts ==
          "time small\nSSIM large\ngradients large\ntone error small\n"
          "nearest: 1st percentile large\nnearest: mean large\n"
          "CVT energy small\ncapacity deviation small\ncentroid displacement small\n");
}

TEST_CASE("what is a little behind is not first, though the digits in the table are the same") {
    const std::vector<MeasuredMethod> close{measured("other", false, marks_of(0.50001)),
                                            measured("ours", true, marks_of(0.50002))};
    const std::vector<Place> places = grey_places(close);
    const auto power = std::ranges::find(places, "power below 0.3", &Place::what);
    CHECK(power->first_value == power->dapple_value);
    CHECK_FALSE(power->dapple_first);
    const std::vector<MeasuredMethod> same{measured("other", false, marks_of(0.5)),
                                           measured("ours", true, marks_of(0.5))};
    for (const Place& place : grey_places(same)) CHECK(place.dapple_first);
}

TEST_CASE("a discrepancy that was not worked out is a dash, and nobody is first in it") {
    GreyMarks many = marks_of(0.5);
    many.star.reset();
    const std::vector<MeasuredMethod> both{measured("other", false, many), measured("ours", true, many)};
    for (const Place& place : grey_places(both)) CHECK(place.what != "star discrepancy");
    const CompareRequest request{.dots = {5'000'000}, .growth = {}};
    const std::vector<CompareTable> tables = compare_tables(both, request);
    const auto& head = tables.at(1).head;
    const auto column = std::size_t(std::ranges::find(head, "star discrepancy") - head.begin());
    CHECK(tables[1].rows[0].at(column) == "-");
}

TEST_CASE("the star discrepancy is exact where a grid of boxes would only bound it") {
    // A net of 2^18 Sobol points has a discrepancy of some 1e-5; a bound by 1,024 x 1,024 boxes is over 1e-3.
    CompareRequest request{.dots = {262'144}, .growth = {}, .seconds = 100};
    const std::vector<MeasuredMethod> sobol = compare_methods(contenders_named({"sobol"}), request);
    REQUIRE(sobol.size() == 1);
    REQUIRE(sobol[0].grey[0]);
    REQUIRE(sobol[0].grey[0]->star);
    CHECK(*sobol[0].grey[0]->star < 6e-5);
    CHECK(*sobol[0].grey[0]->star > 0.5 * sobol[0].grey[0]->l2_star);
}

TEST_CASE("discs around independent dots cover what chance has them cover") {
    std::vector<float> mean(kCoveredLoads);
    const auto covered =
        mean_coverage_by_load([](const DotsWanted& wanted) { return white_noise(wanted); }, 5'000, 4);
    for (std::size_t i = 0; i < kCoveredLoads; ++i)
        CHECK(covered[i] ==
              doctest::Approx(1 - std::exp(-kCoveredLoadStep * double(i))).scale(1).epsilon(0.006));
    // Discs of a square lattice do not overlap up to a load of pi / 4, and cover all from pi / 2 on.
    PlainDots square;
    for (int i = 0; i < 400; ++i) square.push_back({(i % 20 + 0.5) / 20, (i / 20 + 0.5) / 20});
    const auto lattice = coverage_by_load(square);
    CHECK(lattice[15] == doctest::Approx(0.75).epsilon(0.005));
    CHECK(lattice[32] == 1);
}

TEST_CASE(
    "a method's own ink is that of the program's tables for Dapple, and by its own overlap for others") {
    for (const auto& [name, steps] : {std::pair{"dapple", 0}, std::pair{"dapple-relaxed", 5}}) {
        CAPTURE(name);
        const auto own = own_ink(contenders_named({name}).front());
        REQUIRE(own);
        const InkCurve table(InkedDots{.relaxing_steps = steps});
        for (float load = 0.1f; load < 1.4f; load += 0.1f) {
            const auto covered = [&](const InkCurve& ink) {
                return ink.coverage(load / static_cast<float>(ink.full_load()));
            };
            CHECK(covered(*own) == doctest::Approx(covered(table)).scale(1).epsilon(0.012));
        }
    }
    const auto noise = own_ink(contenders_named({"white-noise"}).front());
    REQUIRE(noise);
    CHECK(noise->full_load() == doctest::Approx(-std::log(0.005)).epsilon(0.1));
    CHECK(noise->coverage(1) >= kBlackCoverage);
    // A fifth of the load covers 1 - exp(-1/5 of it).
    const double fifth = 1 - std::exp(-noise->full_load() / 5);
    CHECK(noise->density(float(fifth)) == doctest::Approx(0.2).epsilon(0.05));
}

TEST_CASE("Lloyd by the density's square is told of pictures alone") {
    CompareRequest request{.dots = {256}, .growth = {1'000}};
    std::vector<MeasuredMethod> both = compare_methods(contenders_named({"lloyd", "lloyd-squared"}), request);
    REQUIRE(both.size() == 2);
    CHECK(both[0].grey[0].has_value());
    CHECK_FALSE(both[1].grey[0].has_value());
    const std::vector<CompareTable> tables = compare_tables(both, request);
    CHECK(tables.at(0).rows.size() == 1);
    CHECK(tables.at(2).rows.at(1).size() == tables[2].head.size());
}
