// What core uses of C++20's library and Debian's emscripten has not: read before each file. Debian 12's has
// libc++ 13, with neither algorithms of ranges nor std::bit_cast, and no writing of doubles either; Debian
// 13's, 18, lacks the reading of doubles, and what it writes them by is too large.
#pragma once
#include <version>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

namespace std {

/// strtod() reads blanks, a plus and hexadecimals too.
template <floating_point Number>
from_chars_result from_chars(const char* first, const char* last, Number& value) {
    const string text(first, last);
    if (text.empty() || text.find_first_of("xX+ \t\n\v\f\r") == 0 || text.find_first_of("xX") != text.npos)
        return {first, errc::invalid_argument};
    char* end = nullptr;
    errno = 0;
    const double read = is_same_v<Number, float> ? strtof(text.c_str(), &end) : strtod(text.c_str(), &end);
    if (end == text.c_str()) return {first, errc::invalid_argument};
    const char* const rest = first + (end - text.c_str());
    if (errno == ERANGE && (read == 0 || isinf(read))) return {rest, errc::result_out_of_range};
    value = static_cast<Number>(read);
    return {rest, {}};
}

/// The shortest digits that mean the number, the plain way unless the other is shorter: 0.001, 1e+05.
template <floating_point Number>
to_chars_result shortest_to_chars(char* first, Number value) {
    string plain = fmt::format("{}", value);
    const bool negative = plain[0] == '-';
    const size_t point = min(plain.find('.'), plain.size());
    string digits = plain.substr(negative);
    erase(digits, '.');
    const size_t nought = min(digits.find_first_not_of('0'), digits.size());
    digits.erase(0, nought);
    digits.erase(digits.find_last_not_of('0') + 1);
    if (!digits.empty() && digits.find_first_not_of("0123456789") == digits.npos) {
        const int exponent = static_cast<int>(point) - negative - static_cast<int>(nought) - 1;
        if (digits.size() > 1) digits.insert(1, 1, '.');
        const string other = fmt::format("{}{}e{:+03d}", negative ? "-" : "", digits, exponent);
        if (other.size() < plain.size())
            plain = other;
        else if (point == plain.size())
            plain = fmt::format("{:.0f}", value);  // all digits of a whole number
    }
    return {std::copy(plain.begin(), plain.end(), first), {}};
}

#if _LIBCPP_VERSION < 15000
template <floating_point Number>
to_chars_result to_chars(char* first, char*, Number value) {
    return shortest_to_chars(first, value);
}

template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
    return __builtin_bit_cast(To, from);
}

namespace ranges {

template <class Less, class By>
auto ordered(Less& less, By& by) {
    return [&less, &by](const auto& a, const auto& b) { return invoke(less, invoke(by, a), invoke(by, b)); };
}

#define DAPPLE_RANGE_AND(name)                                                             \
    template <class Range, class... More>                                                  \
    constexpr auto name(Range&& range, More&&... more) {                                   \
        return std::name(std::begin(range), std::end(range), std::forward<More>(more)...); \
    }
DAPPLE_RANGE_AND(all_of)
DAPPLE_RANGE_AND(any_of)
DAPPLE_RANGE_AND(none_of)
DAPPLE_RANGE_AND(copy)
DAPPLE_RANGE_AND(move)
DAPPLE_RANGE_AND(fill)
DAPPLE_RANGE_AND(find_if)
DAPPLE_RANGE_AND(lower_bound)
DAPPLE_RANGE_AND(max_element)
DAPPLE_RANGE_AND(min_element)
DAPPLE_RANGE_AND(replace)
DAPPLE_RANGE_AND(replace_if)
DAPPLE_RANGE_AND(reverse)
DAPPLE_RANGE_AND(transform)
DAPPLE_RANGE_AND(upper_bound)
#undef DAPPLE_RANGE_AND

template <class Range, class Less = less, class By = identity>
void sort(Range&& range, Less less = {}, By by = {}) {
    std::sort(std::begin(range), std::end(range), ordered(less, by));
}
template <class Range, class Less = less, class By = identity>
void stable_sort(Range&& range, Less less = {}, By by = {}) {
    std::stable_sort(std::begin(range), std::end(range), ordered(less, by));
}
template <class Range, class Iterator>
void nth_element(Range&& range, Iterator nth) {
    std::nth_element(std::begin(range), nth, std::end(range));
}
template <class Range, class Value, class By = identity>
constexpr auto find(Range&& range, const Value& value, By by = {}) {
    return std::find_if(std::begin(range), std::end(range),
                        [&](const auto& each) { return invoke(by, each) == value; });
}
template <class Range, class Value, class By = identity>
auto count(Range&& range, const Value& value, By by = {}) {
    return std::count_if(std::begin(range), std::end(range),
                         [&](const auto& each) { return invoke(by, each) == value; });
}
template <class Range, class Alike, class By = identity>
auto adjacent_find(Range&& range, Alike alike, By by = {}) {
    return std::adjacent_find(std::begin(range), std::end(range), ordered(alike, by));
}
template <class Range, class Other, class Alike>
bool equal(Range&& range, Other&& other, Alike alike) {
    return std::equal(std::begin(range), std::end(range), std::begin(other), std::end(other), alike);
}
template <class Range>
auto minmax(Range&& range) {
    const auto [low, high] = std::minmax_element(std::begin(range), std::end(range));
    return pair(*low, *high);
}
template <class Range>
auto max(Range&& range) {
    return *std::max_element(std::begin(range), std::end(range));
}

}  // namespace ranges
#endif

}  // namespace std

#if _LIBCPP_VERSION >= 15000
// In place of the library's own, whose tables have 100 KB: the linker takes these, and leaves those out.
_LIBCPP_BEGIN_NAMESPACE_STD
inline to_chars_result to_chars(char* first, char*, float value) {
    return shortest_to_chars(first, value);
}
inline to_chars_result to_chars(char* first, char*, double value) {
    return shortest_to_chars(first, value);
}
_LIBCPP_END_NAMESPACE_STD
#endif
