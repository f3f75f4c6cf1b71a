#include <doctest/doctest.h>

#include <unistd.h>

#include "app/viewer/shell/drawing_document.h"
#include "core/drawing/settings.h"
#include "io/available_memory.h"

using namespace dapple;

TEST_CASE("what is available is some of the computer's memory") {
    const auto physical = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
                          static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    CHECK(available_memory() > 0);
    CHECK(available_memory() <= physical);
}

TEST_CASE("the most dots grow with the memory and leave room for all that is kept of a dot") {
    constexpr std::uint64_t kGigabyte = 1'000'000'000;
    CHECK(most_dots_in(0) == 1'000'000);
    CHECK(most_dots_in(16 * kGigabyte) > most_dots_in(8 * kGigabyte));
    // Three floats a dot here and with the graphics driver, each in an old and a new drawing, of two sides.
    CHECK(most_dots_in(16 * kGigabyte) * 3 * 4 * 2 * 2 * 2 < 16 * kGigabyte);
    CHECK(most_dots_in(16 * kGigabyte) > 10'000'000);
    CHECK(most_dots_in(~0ull) == kMostDots);
}
