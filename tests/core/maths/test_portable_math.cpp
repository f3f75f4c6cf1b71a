#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "core/maths/portable_math.h"

namespace dapple {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kTiny = std::numeric_limits<double>::denorm_min();

/// So many numbers between the two: even ones, even in their logarithms where both are above 0, and those
/// next to the whole ones and to the halves.
std::vector<double> numbers_between(double low, double high) {
    std::mt19937_64 random(7);
    std::vector<double> numbers{low, high};
    for (int i = 0; i < 20'000; ++i) {
        const double share = static_cast<double>(random()) * 0x1p-64;
        numbers.push_back(low + (high - low) * share);
        if (low > 0) numbers.push_back(low * std::pow(high / low, share));
    }
    for (double half = std::ceil(2 * std::max(low, -50.0)) / 2; half <= std::min(high, 50.0); half += 0.5)
        for (const double near : {std::nextafter(half, -100), half, std::nextafter(half, 100)})
            if (near >= low && near <= high) numbers.push_back(near);
    return numbers;
}

using Long = long double;

/// The largest error of a function of such numbers, over what it should be.
template <class Ours, class Exact>
double error_of(double low, double high, const Ours& ours, const Exact& exact) {
    double worst = 0;
    for (const double x : numbers_between(low, high)) {
        const Long right = exact(static_cast<Long>(x));
        const auto off = static_cast<double>(std::abs(static_cast<Long>(ours(x)) - right));
        if (off > 0) worst = std::max(worst, off / static_cast<double>(std::abs(right)));
    }
    return worst;
}

/// To a digit or two, with the same sign.
bool alike(double a, double b) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
    return std::signbit(a) == std::signbit(b) && (a == b || std::abs(a - b) < 1e-15 * std::abs(b));
}

}  // namespace

TEST_CASE("sines, powers and their like are right to about two units of a double's last digit") {
    constexpr double kLeast = 5e-16;
    const auto sine = [](Long x) { return std::sin(x); };
    const auto cosine = [](Long x) { return std::cos(x); };
    for (const double most : {1e-3, 0.8, 7.0, 1e6}) {
        CAPTURE(most);
        CHECK(error_of(
                  -most, most, [](double x) { return portable::sin(x); }, sine) < kLeast);
        CHECK(error_of(
                  -most, most, [](double x) { return portable::cos(x); }, cosine) < kLeast);
    }
    CHECK(error_of(
              1e-300, 1, [](double x) { return portable::sin(x); }, sine) < kLeast);
    CHECK(error_of(
              -7, 7, [](double x) { return portable::tan(x); }, [](Long x) { return std::tan(x); }) <
          2 * kLeast);
    for (const auto& [low, high] : {std::pair(-1.0, 1.0), {0.9999999, 1.0}, {-1.0, -0.9999999}})
        CHECK(error_of(
                  low, high, [](double x) { return portable::acos(x); },
                  [](Long x) { return std::acos(x); }) < kLeast);
    for (const double y : {-1e200, -3.0, -1e-9, 1e-9, 0.7, 1.0, 1e10}) {
        CAPTURE(y);
        for (const auto& [low, high] : {std::pair(-10.0, 10.0), {1e-12, 1e12}})
            CHECK(error_of(
                      low, high, [y](double x) { return portable::atan2(y, x); },
                      [y](Long x) { return std::atan2(static_cast<Long>(y), x); }) < kLeast);
    }
    for (const auto& [low, high] : {std::pair(-708.0, 709.7), {-1.0, 1.0}, {-1e-9, 1e-9}})
        CHECK(error_of(
                  low, high, [](double x) { return portable::exp(x); }, [](Long x) { return std::exp(x); }) <
              kLeast);
    CHECK(error_of(
              -1022, 1023.9, [](double x) { return portable::exp2(x); },
              [](Long x) { return std::exp2(x); }) < kLeast);
    for (const auto& [low, high] :
         {std::pair(1e-300, 1e300), {kTiny, 1e-300}, {0.5, 2.0}, {0.999999, 1.000001}}) {
        CHECK(error_of(
                  low, high, [](double x) { return portable::log(x); }, [](Long x) { return std::log(x); }) <
              kLeast);
        CHECK(error_of(
                  low, high, [](double x) { return portable::log2(x); },
                  [](Long x) { return std::log2(x); }) < kLeast);
    }
    for (const double power : {2.4, 1 / 2.4, 0.25, 4.0, -1.5, 300.0, -1000.0, 1e-9}) {
        CAPTURE(power);
        const double most = std::exp(std::min(700 / std::abs(power), 690.0));
        CHECK(error_of(
                  1 / most, most, [power](double x) { return portable::pow(x, power); },
                  [power](Long x) { return std::pow(x, static_cast<Long>(power)); }) < 8 * kLeast);
    }
    // What a float holds of it is all right.
    CHECK(error_of(
              0, 1, [](double x) { return portable::pow(static_cast<float>(x), 2.4f); },
              [](Long x) { return std::pow(static_cast<Long>(static_cast<float>(x)), Long{2.4f}); }) <
          6.1e-8);
    CHECK(error_of(
              -9, 9, [](double x) { return portable::cbrt(static_cast<float>(x)); },
              [](Long x) { return std::cbrt(static_cast<Long>(static_cast<float>(x))); }) < 6.1e-8);
}

TEST_CASE(
    "what has an exact value has it, and zeros, infinities and no numbers come out as the standard's do") {
    for (double power = -1074; power <= 1023; ++power) {
        const double right = std::exp2(power);
        REQUIRE(portable::exp2(power) == right);
        REQUIRE(portable::log2(right) == power);
        REQUIRE(portable::pow(2.0, power) == right);
    }
    const std::vector<double> edges{0.0,    -0.0,  1.0,    -1.0,      0.5,        -2.0,
                                    3.0,    kTiny, -kTiny, 1e-310,    -1e-20,     1e300,
                                    -1e300, 800.0, -800.0, kInfinity, -kInfinity, kNone};
    struct Pair {
        double (*ours)(double);
        double (*standard)(double);
    };
    const Pair pairs[] = {{portable::sin, std::sin}, {portable::cos, std::cos},
                          {portable::tan, std::tan}, {portable::acos, std::acos},
                          {portable::exp, std::exp}, {portable::exp2, std::exp2},
                          {portable::log, std::log}, {portable::log2, std::log2}};
    for (const double x : edges) {
        CAPTURE(x);
        for (const auto& [ours, standard] : pairs) {
            const auto function = &ours - &pairs[0].ours;
            CAPTURE(function);
            const bool is_angle = &ours < &pairs[3].ours;
            if (!is_angle || std::isinf(x) || std::abs(x) < 1e6) CHECK(alike(ours(x), standard(x)));
        }
        for (const double other : edges) {
            CAPTURE(other);
            CHECK(alike(portable::atan2(x, other), std::atan2(x, other)));
            if (!std::signbit(x)) CHECK(alike(portable::pow(x, other), std::pow(x, other)));
        }
        CHECK(std::isnan(portable::pow(-3.0, x == 0 ? 1 : x)));
        const auto single = static_cast<float>(x);
        CHECK(alike(portable::cbrt(single), std::cbrt(single)));
    }
    // An angle so large has lost its place, but stays one.
    CHECK(std::abs(portable::sin(1e300)) <= 1);
    CHECK(portable::sin(2e6 * std::numbers::pi) == doctest::Approx(0).epsilon(1e-8));
}

}  // namespace dapple
