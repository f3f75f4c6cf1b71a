// What drawing gets of a frame.

#include <doctest/doctest.h>

#include "app/viewer/model/frame_budget.h"

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
