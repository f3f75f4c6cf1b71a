// On which screen of a desktop a window is.

#include <doctest/doctest.h>

#include <array>

#include "app/viewer/shell/window.h"

namespace dapple {
namespace {

// A laptop's, and a larger one to its left that stands higher.
constexpr std::array<Rectangle<int>, 2> kScreens{{{{0, 0}, {1920, 1080}}, {{-2560, -360}, {0, 1080}}}};

}  // namespace

TEST_CASE("full screen is the screen that most of the window is on") {
    CHECK(screen_under({{100, 100}, {900, 700}}, kScreens) == 0);
    CHECK(screen_under({{-2000, 100}, {-1200, 700}}, kScreens) == 1);
    CHECK(screen_under({{-500, 100}, {300, 700}}, kScreens) == 1);
    CHECK(screen_under({{-300, 100}, {500, 700}}, kScreens) == 0);
    CHECK(screen_under({{5000, 100}, {5800, 700}}, kScreens) == 0);
}

TEST_CASE("a window comes back to where a person can take hold of it, and to no screen that is gone") {
    CHECK(is_within_reach({{-2000, -360}, {-1200, 240}}, kScreens));
    CHECK(is_within_reach({{1880, 0}, {2680, 600}}, kScreens));
    CHECK_FALSE(is_within_reach({{1881, 0}, {2681, 600}}, kScreens));
    CHECK_FALSE(is_within_reach({{100, -1}, {900, 600}}, kScreens));
    CHECK_FALSE(is_within_reach({{100, 1041}, {900, 1641}}, kScreens));
    CHECK_FALSE(is_within_reach({{100, 100}, {900, 700}}, {}));
}

}  // namespace dapple
