#pragma once
// How numbers are shown to people.

#include <cstdint>
#include <string>

namespace dapple {

/// A number as people write it: 12345 -> "12,345".
std::string grouped(std::uint64_t number);

/// "1 dot", "12,345 dots".
std::string dots_in_words(std::uint64_t dots);

/// In two digits, or a whole number from ten on: 0.314 -> "0.31 mm", 263.1 -> "263 mm"; of a way in metres,
/// in the unit that suits it: "12.3 m", "42 cm", "3.1 mm".
std::string millimetres_in_words(double mm);
std::string way_in_words(double metres);

/// As about() says it: 12,345 -> 12,000.
double in_two_digits(double number);

/// In two digits, as more would promise too much: 12,345 -> "12,000".
std::string about(double number);

/// Whether a drawing that so many times its dots would give the picture's tone is plainly paler or darker.
bool far_from_tone(double ratio);

/// A number of any size, in three digits or as people say it: "1,234", "17.4 million", "2.20 trillion", and
/// from 10^15 on "1.5 x 10^16". From 1 up.
std::string in_round_words(double number);

/// "24 MB": two digits, or a whole number below a hundred thousand bytes.
std::string bytes_in_words(double bytes);

}  // namespace dapple
