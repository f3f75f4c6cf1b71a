#include <doctest/doctest.h>

#include <string>

#include "core/text/number_words.h"

using namespace dapple;

TEST_CASE("a length is read in millimetres, or in the unit that it names") {
    CHECK(millimetres_of("210") == 210);
    CHECK(millimetres_of("0.5mm") == 0.5);
    CHECK(*millimetres_of("29.7cm") == doctest::Approx(297));
    CHECK(*millimetres_of("8.5in") == doctest::Approx(215.9));
    CHECK(*millimetres_of("11 in") == doctest::Approx(279.4));
    CHECK(*millimetres_of("72pt") == doctest::Approx(25.4));
    CHECK(*millimetres_of("-2mm") == -2);  // whether it may be is for others to say
    CHECK(*millimetres_of("2", LengthUnit::inch) == doctest::Approx(50.8));
    CHECK(millimetres_of("2mm", LengthUnit::inch) == 2);
    for (const char* wrong : {"", "mm", "8 inches", "8in.", "in8", "1,5mm", "5  mm", "five", "5m", "8in8"}) {
        CAPTURE(wrong);
        CHECK_FALSE(millimetres_of(wrong));
    }
}
