#pragma once
// How names and numbers are shown to people.

#include <cstdint>
#include <string>
#include <string_view>

namespace dapple {

/// Text that others wrote, such as the name of a file, made safe: on one line, in UTF-8: control characters,
/// what turns the direction of writing or ends lines, and bytes that are no UTF-8 are written out as \n, \t,
/// \x1b or \u202e. A name can thus neither command a terminal nor look like two lines. All else stays,
/// backslashes too, so that doing it twice changes nothing.
std::string printable(std::string_view text);

/// A number as people write it: 12345 -> "12,345".
std::string grouped(std::uint64_t number);

/// A number of any size, in three digits or as people say it: "1,234", "17.4 million", "2.20 trillion", and
/// from 10^15 on "1.5e+16". From 1 up.
std::string in_round_words(double number);

}  // namespace dapple
