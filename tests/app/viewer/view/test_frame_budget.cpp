// What drawing gets of a frame.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "app/viewer/view/frame_budget.h"

using namespace dapple;

namespace {

// A computer that takes so long for all but drawing, over so many frames; the last frame's length.
double frame_after(FrameBudget& budget, double other, int frames, double most = 0.025) {
    double frame = 0;
    for (int i = 0; i < frames; ++i) {
        const double drawing = budget.seconds(most);
        frame = other + drawing;
        budget.learn(frame, drawing);
    }
    return frame;
}

}  // namespace

TEST_CASE("a quick computer draws for as long as is useful, and no longer") {
    FrameBudget budget;
    frame_after(budget, 0.004, 100);
    CHECK(budget.seconds(0.025) == 0.025);
    CHECK(budget.seconds(0.015) == 0.015);
}

TEST_CASE("where the rest of a frame takes long, drawing takes less, but never nothing") {
    FrameBudget budget;
    CHECK(frame_after(budget, 0.045, 20) <= FrameBudget::kFrameSeconds + 0.001);
    CHECK(budget.seconds(0.025) < 0.017);
    frame_after(budget, 0.2, 20);
    CHECK(budget.seconds(0.025) == FrameBudget::kLeastSeconds);
}

TEST_CASE(
    "a computer that becomes slower is believed in a few frames, one that becomes quicker in some more") {
    FrameBudget budget;
    frame_after(budget, 0.004, 100);
    CHECK(frame_after(budget, 0.055, 6) < 0.07);
    frame_after(budget, 0.004, 3);
    CHECK(budget.seconds(0.025) < 0.025);
    frame_after(budget, 0.004, 30);
    CHECK(budget.seconds(0.025) == 0.025);
}

namespace {

/// A computer so many times slower than one that takes 0.7 us for a dot and 2.4 ns for each sample of the
/// square around it.
struct Computer {
    double slower;
    double seconds(double dots, double radius) const {
        return slower * dots * (0.7e-6 + 4 * (radius + 1) * (radius + 1) * 2.4e-9);
    }
    /// How many of so many dots are drawn once some frames were learnt from, and how long they take.
    std::pair<double, double> drawn(std::size_t dots, double radius, double within) const {
        DotCost cost;
        double count = 0, taken = 0;
        for (int frame = 0; frame < 20; ++frame) {
            const auto every = static_cast<double>(cost.every(dots, radius, within));
            count = static_cast<double>(dots) / every;
            taken = seconds(count, radius * std::sqrt(every));
            cost.learn(count, radius * std::sqrt(every), taken);
        }
        return {count, taken};
    }
};

}  // namespace

TEST_CASE("as many small dots are drawn as there is time for, whatever the computer") {
    for (const double slower : {0.01, 0.03, 0.05}) {
        CAPTURE(slower);
        const auto [drawn, taken] = Computer{slower}.drawn(static_cast<std::size_t>(2e5 / slower), 0.5, 0.02);
        CHECK(drawn < 1e5 / slower);
        CHECK(taken < 0.025);
        CHECK(taken > 0.01);
    }
}

TEST_CASE("however slow the computer is, half of the dots are drawn, or as many as the eye can miss") {
    for (const std::size_t dots : {1'000u, 19'999u, 40'000u, 300'000u, 1'000'000u, 54'000'000u}) {
        CAPTURE(dots);
        const double drawn = Computer{1000}.drawn(dots, 0.5, 0.02).first;
        const auto all = static_cast<double>(dots);
        CHECK(drawn >= std::min(all, 20'000.0));
        CHECK(drawn >= std::min(all / 2, 500'000.0));
        CHECK((drawn < all) == (dots >= 40'000));
    }
}

TEST_CASE("a gesture that was coarse in one frame stays as coarse, until it has fewer dots") {
    const DotCost cost;
    REQUIRE(cost.every(1'000'000, 0.5, 0.001) == 2);
    CHECK(cost.every(1'000'000, 0.5, 100, 2) == 2);
    CHECK(cost.every(30'000, 0.5, 100, 2) == 1);
    CHECK(cost.every(1'000'000, 0.5, 100, 1) == 1);
}

TEST_CASE("where what dots cover takes the time all of them are drawn, as a part covers as much") {
    const Computer computer{1};
    CHECK(computer.seconds(40'000, 20) > 0.1);
    CHECK(computer.drawn(40'000, 20, 0.015).first == 40'000);
}

TEST_CASE("few dots are all drawn, and many where there is time") {
    CHECK(DotCost().every(DotCost::kFewestDots, 50, 1e-9) == 1);
    CHECK(DotCost().every(1'000'000, 2, 100) == 1);
}
