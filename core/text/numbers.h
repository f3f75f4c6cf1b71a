#pragma once
// Numbers as people and files write them: the whole text has to be one, without blanks around it.

#include <array>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string_view>
#include <system_error>

namespace dapple {

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

}  // namespace dapple
