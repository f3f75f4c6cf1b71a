#include "core/text/length.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "core/text/number_words.h"

namespace dapple {

namespace {

// "10,000" without its commas; as it is if they don't part thousands.
std::string without_separators(std::string_view text) {
    const std::size_t whole = std::min(text.find_first_not_of("0123456789,"), text.size());
    const std::size_t first = text.find(',');
    if (first > 3 || first == 0 || (whole - first) % 4 != 0) return std::string(text);
    std::string digits;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool comma_due = i >= first && i < whole && (i - first) % 4 == 0;
        if (comma_due != (text[i] == ',')) return std::string(text);
        if (!comma_due) digits += text[i];
    }
    return digits;
}

struct Scaled {
    std::string digits;
    double unit = 1;
};

Scaled scaled(std::string_view text) {
    Scaled result{without_separators(text)};
    if (result.digits.ends_with('k') || result.digits.ends_with('K')) result.unit = 1e3;
    if (result.digits.ends_with('M')) result.unit = 1e6;
    if (result.digits.ends_with('G')) result.unit = 1e9;
    if (result.unit > 1) result.digits.pop_back();
    return result;
}

}  // namespace

std::optional<double> quantity_of(std::string_view text) {
    const Scaled number = scaled(text);
    const std::optional<double> value = number_of<double>(number.digits);
    if (!value || !std::isfinite(*value)) return std::nullopt;
    return *value * number.unit;
}

std::optional<std::uint64_t> count_of(std::string_view text) {
    const Scaled number = scaled(text);
    const bool scientific = number.digits.find('e') != std::string::npos;
    if (number.unit == 1 && !scientific) return number_of<std::uint64_t>(number.digits);
    const std::optional<double> value = quantity_of(text);
    if (!value || !(*value >= 0 && *value <= 1e15)) return std::nullopt;
    const double count = std::round(*value);
    // 1.001k is 1001 but for rounding; 1.0001k is no whole number.
    if (std::abs(count - *value) > 1e-6) return std::nullopt;
    return static_cast<std::uint64_t>(count);
}

std::optional<double> millimetres_of(std::string_view text, LengthUnit bare) {
    constexpr std::array<std::pair<std::string_view, double>, 4> kUnits{
        {{"mm", 1}, {"cm", 10}, {"in", kMmPerInch}, {"pt", kMmPerInch / 72}}};
    double unit = bare == LengthUnit::inch ? kMmPerInch : 1;
    for (const auto& [name, millimetres] : kUnits) {
        if (!text.ends_with(name)) continue;
        unit = millimetres;
        text.remove_suffix(name.size());
        if (text.ends_with(' ')) text.remove_suffix(1);
        break;
    }
    const std::optional<double> number = number_of<double>(text);
    if (!number) return std::nullopt;
    return *number * unit;
}

}  // namespace dapple
