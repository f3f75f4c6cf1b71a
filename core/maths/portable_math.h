#pragma once
// The sine, the power and their like with the same bits on every processor. Those of the standard library
// differ in the last ones, by the processor that they find and from release to release. These are made of
// + - * / and square roots alone, which IEEE 754 says to the bit.
//
// They are right to 5e-16 of the result; a power to 4e-15 with exponents of a thousand. Angles over a million
// are taken round by the double that is nearest to a turn. For zeros, infinities and what is not a number
// they give what the standard's do.

#include <cstdint>

namespace dapple::portable {

/// Angles are in radians.
double sin(double angle);
double cos(double angle);
double tan(double angle);
/// From -pi to pi.
double atan2(double y, double x);
double acos(double cosine);

double exp(double x);
double exp2(double x);
/// Natural; of what is below 0, not a number.
double log(double x);
/// Whole for a power of two.
double log2(double x);
/// Of a base from 0 up; below that, not a number.
double pow(double base, double exponent);

/// The same of floats. A power is right to a unit of its last digit, up to exponents of a thousand.
float pow(float base, float exponent);
/// The cube root, below 0 too; right to a unit of its last digit.
float cbrt(float x);
inline float tan(float angle) {
    return static_cast<float>(tan(double{angle}));
}
inline float exp(float x) {
    return static_cast<float>(exp(double{x}));
}
inline float exp2(float x) {
    return static_cast<float>(exp2(double{x}));
}

/// Bits that look random, each by all of the key's (Steele, Lea & Flood 2014, SplitMix).
inline std::uint64_t mixed(std::uint64_t key) {
    key += 0x9e3779b97f4a7c15;
    key = (key ^ key >> 30) * 0xbf58476d1ce4e5b9;
    key = (key ^ key >> 27) * 0x94d049bb133111eb;
    return key ^ key >> 31;
}

}  // namespace dapple::portable
