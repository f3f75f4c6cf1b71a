#include "core/maths/portable_math.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>

namespace dapple::portable {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

// A number and what its last bit leaves of it.
struct Double2 {
    double high, low;
};

Double2 sum_of(double larger, double smaller) {
    const double sum = larger + smaller;
    return {sum, smaller - (sum - larger)};
}

// The upper half of the digits, so that a product of two is exact (Dekker 1971).
double upper(double x) {
    const double far = 134217729 * x;  // 2^27 + 1
    return far - (far - x);
}

Double2 product_of(double a, double b) {
    const double product = a * b, a1 = upper(a), a2 = a - a1, b1 = upper(b), b2 = b - b1;
    return {product, a1 * b1 - product + a1 * b2 + a2 * b1 + a2 * b2};
}

// c[0] + c[1] x + ..., in two chains that a processor follows at once.
template <std::size_t n>
constexpr double polynomial(const std::array<double, n>& c, double x) {
    const double square = x * x;
    double odd = c[n - 1], even = c[n - 2];  // or the other way round, at every second step
    for (std::size_t i = n - 2; i-- > 0;) {
        const double next = odd * square + c[i];
        odd = even;
        even = next;
    }
    return even + odd * x;
}

// The sums below are Taylor's, as long as a term counts.

// +-1 / first!, +-1 / (first + step)!, ...
template <std::size_t n>
constexpr std::array<double, n> over_factorials(int first, int step, double sign) {
    std::array<double, n> c{};
    double factorial = 1, now = 1;
    for (int i = 1; i <= first + step * (static_cast<int>(n) - 1); ++i) {
        factorial *= i;
        if (i < first || (i - first) % step) continue;
        c[static_cast<std::size_t>((i - first) / step)] = now / factorial;
        now *= sign;
    }
    return c;
}

// twice / first, twice / (first + 2), ... with the sign.
template <std::size_t n>
constexpr std::array<double, n> over_odd(double over, int first, double sign) {
    std::array<double, n> c{};
    double now = over;
    for (std::size_t i = 0; i < n; ++i, now *= sign) c[i] = now / (first + 2 * static_cast<int>(i));
    return c;
}

constexpr auto kSine = over_factorials<8>(3, 2, -1);      // of x^3, x^5, ...; to pi/4
constexpr auto kCosine = over_factorials<7>(4, 2, -1);    // of x^4, x^6, ...
constexpr auto kPower = over_factorials<12>(2, 1, 1);     // of x^2, x^3, ...; to ln 2 / 2
constexpr auto kLog = over_odd<10>(2, 3, 1);              // of s^3, s^5, ...; to 0.172
constexpr auto kExpMinus1 = over_factorials<4>(1, 1, 1);  // of x, x^2, ...; to ln 2 / 64
constexpr std::array kLog2Plus1{std::numbers::log2e, -std::numbers::log2e / 2, std::numbers::log2e / 3,
                                -std::numbers::log2e / 4, std::numbers::log2e / 5};  // of x, ...; to 1/64
constexpr auto kArc = over_odd<6>(-1, 3, -1);  // of z^3, z^5, ...; to 1/16

// The whole number next to one up to 2^51: this far from 0, doubles are whole.
double nearest(double x) {
    constexpr double kFar = 0x1.8p52;
    return x + kFar - kFar;
}

// An angle as quarters of a turn and what is left, up to pi/4 in size.
struct Angle {
    int quarters;
    double rest;
};

Angle reduced(double angle) {
    // pi/2 in three parts; the first two, times a million, are exact.
    constexpr double kFirst = 0x1.921fb544p+0, kSecond = 0x1.0b4611a6p-34, kThird = 0x1.3198a2e037073p-69;
    if (!(std::abs(angle) <= 1e6)) angle = std::remainder(angle, 2 * std::numbers::pi);
    if (std::isnan(angle)) return {0, angle};
    const double k = nearest(angle * (2 / std::numbers::pi));
    return {static_cast<int>(k), angle - k * kFirst - k * kSecond - k * kThird};
}

double sine_of(double rest) {
    if (rest == 0) return rest;  // with its sign
    const double square = rest * rest;
    return rest - rest * square * polynomial(kSine, square);
}

double cosine_of(double rest) {
    const double square = rest * rest;
    return 1 - square / 2 + square * square * polynomial(kCosine, square);
}

double sine(Angle angle) {
    const double value = angle.quarters % 2 ? cosine_of(angle.rest) : sine_of(angle.rest);
    return angle.quarters & 2 ? -value : value;
}

// ln 2 in two parts; the first, times any exponent, is exact.
constexpr double kLn2 = 0x1.62e42fefa38p-1, kLn2Rest = 0x1.ef35793c7673p-45;

// Up to 2^1023.
double power_of_two(std::int64_t exponent) {
    return std::bit_cast<double>((exponent + 1023) << 52);
}

// Up to 2^2000: in two steps, as one has no such exponent.
double times_power_of_two(double x, double exponent) {
    const auto all = static_cast<std::int64_t>(exponent), half = all / 2;
    return x * power_of_two(half) * power_of_two(all - half);
}

constexpr double exp_near_0(double rest) {
    return 1 + (rest + rest * rest * polynomial(kPower, rest));
}

// e to the x.high + x.low.
double exp_of(Double2 x) {
    if (!(x.high < 710)) return x.high > 0 ? kInfinity : x.high;
    if (x.high < -746) return 0;
    const double k = nearest(x.high * std::numbers::log2e);
    const double rest = x.high - k * kLn2 + (x.low - k * kLn2Rest);
    return times_power_of_two(exp_near_0(rest), k);
}

// A number from the root of 1/2 to that of 2, times 2 to the exponent.
struct Scaled {
    double number, exponent;
};

Scaled scaled(double x) {
    const bool subnormal = x < std::numeric_limits<double>::min();
    const auto bits = std::bit_cast<std::int64_t>(subnormal ? x * 0x1p54 : x);
    const std::int64_t exponent = (bits - std::bit_cast<std::int64_t>(std::numbers::sqrt2 / 2)) >> 52;
    return {std::bit_cast<double>(bits - (exponent << 52)),
            static_cast<double>(exponent) - (subnormal ? 54 : 0)};
}

// ln m = 2 artanh s of s = (m - 1) / (m + 1).
constexpr double log_near_1(double m) {
    const double s = (m - 1) / (m + 1);
    return 2 * s + s * (s * s) * polynomial(kLog, s * s);
}

// The same in two parts.
Double2 two_part_log(double m) {
    const double above = m - 1, sum = m + 1, sum_rest = m - (sum - 1), inverse = 1 / sum, s = above * inverse;
    const Double2 back = product_of(s, sum);
    const double s_rest = (above - back.high - back.low - s * sum_rest) * inverse;
    return sum_of(2 * s, 2 * s_rest + s * (s * s) * polynomial(kLog, s * s));
}

bool has_log(double x) {
    return x > 0 && x < kInfinity;
}

// Of numbers that have none.
double no_log(double x) {
    return x == 0 ? -kInfinity : x > 0 ? x : kNotANumber;
}

Double2 log_of(double x) {
    const auto [m, exponent] = scaled(x);
    const Double2 near = two_part_log(m);
    if (exponent == 0) return near;
    const Double2 sum = sum_of(exponent * kLn2, near.high);
    return sum_of(sum.high, sum.low + (near.low + exponent * kLn2Rest));
}

// Parts of what lies between two powers of two, so small that a few terms do for a float.
constexpr int kParts = 32;  // 2^5
struct Part {
    double inverse, log;  // of its middle, from 1 to 2, the logarithm to the base of 2
    double power;         // of two, to the part's share of 1
};
constexpr std::array<Part, kParts> kOfPart = [] {
    std::array<Part, kParts> parts{};
    for (int i = 0; i < kParts; ++i) {
        const double middle = 1 + (i + 0.5) / kParts, share = static_cast<double>(i) / kParts;
        parts[static_cast<std::size_t>(i)] = {
            1 / middle, 0.5 + log_near_1(middle / std::numbers::sqrt2) * std::numbers::log2e,
            exp_near_0((share - 0.5) * std::numbers::ln2) * std::numbers::sqrt2};
    }
    return parts;
}();

}  // namespace

double sin(double angle) {
    return sine(reduced(angle));
}

double cos(double angle) {
    const auto [quarters, rest] = reduced(angle);
    return sine({quarters + 1, rest});
}

double tan(double angle) {
    const auto [quarters, rest] = reduced(angle);
    return sine({quarters, rest}) / sine({quarters + 1, rest});
}

double atan2(double y, double x) {
    constexpr std::array<double, 9> kOfEighths{0,
                                               0.12435499454676144,
                                               0.24497866312686414,
                                               0.35877067027057225,
                                               0.4636476090008061,
                                               0.5585993153435624,
                                               0.6435011087932844,
                                               0.7188299996216245,
                                               std::numbers::pi / 4};
    if (std::isnan(x) || std::isnan(y)) return kNotANumber;
    if (std::isinf(x) && std::isinf(y)) return atan2(std::copysign(1, y), std::copysign(1, x));
    const double across = std::abs(x), up = std::abs(y), more = std::max(across, up);
    double angle = 0;
    if (more > 0) {
        const double less = std::min(across, up), ratio = less / more;
        // From the nearest eighth c: arctan a = arctan c + arctan ((a - c) / (1 + a c)).
        const double eighth = nearest(8 * ratio), c = eighth / 8;
        const double z = eighth == 0 ? ratio : (less - c * more) / (more + c * less);
        angle = kOfEighths[static_cast<std::size_t>(eighth)] + (z + z * (z * z) * polynomial(kArc, z * z));
        if (up > across) angle = std::numbers::pi / 2 - angle;
    }
    if (std::signbit(x)) angle = std::numbers::pi - angle;
    return std::copysign(angle, y);
}

double acos(double cosine) {
    return atan2(std::sqrt((1 - cosine) * (1 + cosine)), cosine);
}

double exp(double x) {
    return exp_of({x, 0});
}

double exp2(double x) {
    if (!(std::abs(x) < 1100)) return x > 0 ? kInfinity : x < 0 ? 0 : x;
    const double whole = nearest(x), rest = (x - whole) * std::numbers::ln2;
    return times_power_of_two(exp_near_0(rest), whole);
}

double log(double x) {
    if (!has_log(x)) return no_log(x);
    const auto [m, exponent] = scaled(x);
    return exponent * kLn2 + (exponent * kLn2Rest + log_near_1(m));
}

double log2(double x) {
    if (!has_log(x)) return no_log(x);
    const auto [m, exponent] = scaled(x);
    return exponent + log_near_1(m) * std::numbers::log2e;
}

double pow(double base, double exponent) {
    if (exponent == 0 || base == 1) return 1;
    if (std::isnan(exponent)) return exponent;
    if (!has_log(base))
        return base == 0 || base > 0 ? ((base > 0) == (exponent > 0) ? kInfinity : 0) : kNotANumber;
    const Double2 logarithm = log_of(base);
    if (std::abs(logarithm.high * exponent) > 800) return exp(logarithm.high * exponent);
    const Double2 product = product_of(logarithm.high, exponent);
    return exp_of({product.high, product.low + logarithm.low * exponent});
}

float pow(float base, float exponent) {
    const auto at_length = [=] { return static_cast<float>(pow(double{base}, double{exponent})); };
    if (!has_log(base)) return at_length();
    // As a double it is not subnormal.
    const auto bits = std::bit_cast<std::int64_t>(double{base}), power = (bits >> 52) - 1023;
    const Part& part = kOfPart[static_cast<std::size_t>(bits >> 47 & (kParts - 1))];
    const double rest = std::bit_cast<double>(bits - (power << 52)) * part.inverse - 1;
    const double log = static_cast<double>(power) + part.log + rest * polynomial(kLog2Plus1, rest);
    const double product = exponent * log, parts = nearest(product * kParts);
    if (!(std::abs(product) < 1000)) return at_length();
    const double left = (product - parts / kParts) * std::numbers::ln2;
    const auto whole = static_cast<std::int64_t>(parts);
    const double value = kOfPart[static_cast<std::size_t>(whole & (kParts - 1))].power;
    return static_cast<float>((value + value * left * polynomial(kExpMinus1, left)) *
                              power_of_two(whole >> 5));
}

float cbrt(float x) {
    if (x == 0 || !std::isfinite(x)) return x;
    const double size = std::abs(double{x});
    // A third of the exponent, and two of Halley's steps, each of which leaves of an error its cube.
    double root = std::bit_cast<double>(std::bit_cast<std::uint64_t>(size) / 3 + (std::uint64_t{682} << 52));
    for (int i = 0; i < 2; ++i) {
        const double cube = root * root * root;
        root *= (cube + 2 * size) / (2 * cube + size);
    }
    return std::copysign(static_cast<float>(root), x);
}

}  // namespace dapple::portable
