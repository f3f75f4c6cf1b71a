#include <doctest/doctest.h>

#include "app/viewer/widgets/widgets.h"
#include "core/text/number_words.h"

using namespace dapple;

namespace {

std::optional<double> number(const char* text) {
    return typed_value(text, TypedKind::number);
}
std::optional<double> length(const char* text) {
    return typed_value(text, TypedKind::length);
}

}  // namespace

TEST_CASE("a typed number may have thousands, units of a thousand, a million and a billion, and be a sum") {
    CHECK(number("0.25") == 0.25);
    CHECK(number("40k") == 40'000);
    CHECK(number("1.5M") == 1'500'000);
    CHECK(number("10G") == 1e10);
    CHECK(number("40,000") == 40'000);
    CHECK(number("1e5") == 100'000);
    CHECK(number("1e-3") == 0.001);
    CHECK(number("-0.5") == -0.5);
    CHECK(number(" 40k + 500 ") == 40'500);
    CHECK(number("1-0.25-0.5") == 0.25);
    CHECK(number("2*210 + 5") == 425);
    CHECK(number("40k/4") == 10'000);
    CHECK(number("12 / 3 * 2 - 1") == 7);
    for (const char* wrong : {"", " ", "k", "4 0", "40kk", "1,00", "two", "1+", "+", "--1", "nan", "inf",
                              "5mm", "2*", "*2", "1/0", "2/", "/2"}) {
        CAPTURE(wrong);
        CHECK_FALSE(number(wrong));
    }
}

TEST_CASE("a typed length is in millimetres, or in the unit that each of its terms names") {
    CHECK(length("210") == 210);
    CHECK(*length("8in") == doctest::Approx(203.2));
    CHECK(*length("8in + 5mm") == doctest::Approx(208.2));
    CHECK(length("210-15-15") == 180);
    CHECK(*length("2 * 8in") == doctest::Approx(406.4));
    CHECK(*length("8in/2") == doctest::Approx(101.6));
    CHECK(length("210/2") == 105);
    CHECK(*length("8in/2*3") == doctest::Approx(304.8));
    CHECK_FALSE(length("8in*2in"));
    CHECK_FALSE(length("2/8in"));
    CHECK_FALSE(length("40k"));
}

TEST_CASE("a count is a whole number, and nobody has to guess what a point stands for") {
    CHECK(count_of("40,000") == 40'000);
    CHECK(count_of("1.001k") == 1001);
    CHECK(count_of("1e5") == 100'000);
    CHECK_FALSE(count_of("1.0001k"));
    CHECK_FALSE(count_of("10.000"));
    CHECK_FALSE(count_of("-5"));
}

TEST_CASE("a typed count is one that the command takes, or several of them and what becomes of them") {
    const auto count = [](const char* text) { return typed_value(text, TypedKind::count); };
    CHECK(count("3M") == 3e6);
    CHECK(count("1e9") == 1e9);
    CHECK(count("0") == 0);
    CHECK(count("-5") == -5);
    CHECK(count("40k + 500") == 40'500);
    CHECK(count("40k*1.1") == doctest::Approx(44'000));
    for (const char* wrong : {"2,5", "10.000", "1.5", "10.000 + 5", "5 + 10.000", "0.5*40k", "1.0001k"}) {
        CAPTURE(wrong);
        CHECK_FALSE(count(wrong));
    }
}

TEST_CASE("where lengths are in inches, a number alone is inches, and a unit still says what it is") {
    const auto in_inches = [](const char* text) {
        return typed_value(text, TypedKind::length, LengthUnit::inch);
    };
    CHECK(*in_inches("8.5") == doctest::Approx(215.9));
    CHECK(*in_inches("2*4") == doctest::Approx(203.2));
    CHECK(*in_inches("1 + 5mm") == doctest::Approx(30.4));
    CHECK(*in_inches("21cm") == doctest::Approx(210));
}
