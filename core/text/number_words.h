#pragma once
// How numbers are shown to people.

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "core/text/names.h"

namespace dapple {

// Lengths on paper, as people write them.

// How many of something, as people type it: "40k".

/// A number: 0.25, 40000, 40,000, 40k, 1.5M, 2G, 1e5. Nothing if it is none. "10.000" is ten, not ten
/// thousand.
std::optional<double> quantity_of(std::string_view text);

/// The same if it is a whole number, to 10^15. "10.000" is none: it is ten to some and ten thousand to
/// others.
std::optional<std::uint64_t> count_of(std::string_view text);

/// What lengths are told in.
enum class LengthUnit { mm, inch };
constexpr auto names_of(LengthUnit) {
    return names("mm", "inch");
}
inline constexpr double kMmPerInch = 25.4;

/// In millimetres: "210", "210mm", "21cm", "8in", "8.5 in", "595pt" (72 to the inch). `bare` is what a number
/// alone means. Nothing if it is none.
std::optional<double> millimetres_of(std::string_view text, LengthUnit bare = LengthUnit::mm);

// Numbers as people and files write them: the whole text has to be one, without blanks around it.

/// The number that the text is; nothing if it is none, or does not fit.
template <class Number>
std::optional<Number> number_of(std::string_view text) {
    Number number{};
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc{} || rest != end) return std::nullopt;
    return number;
}

/// So many numbers with a separator after each but the last: "3,4x5" with ",x". Nothing if the text is not
/// that.
template <class Number, std::size_t count>
std::optional<std::array<Number, count>> numbers_of(std::string_view text, std::string_view separators) {
    std::array<Number, count> numbers{};
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t end = i < separators.size() ? text.find(separators[i]) : text.size();
        if (end == std::string_view::npos) return std::nullopt;
        const std::optional<Number> number = number_of<Number>(text.substr(0, end));
        if (!number) return std::nullopt;
        numbers[i] = *number;
        text.remove_prefix(i < separators.size() ? end + 1 : end);
    }
    return numbers;
}

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
