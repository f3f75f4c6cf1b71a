#include "core/text/number_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

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

std::string grouped(std::uint64_t number) {
    std::string text = std::to_string(number);
    for (int at = static_cast<int>(text.size()) - 3; at > 0; at -= 3)
        text.insert(static_cast<std::size_t>(at), 1, ',');
    return text;
}

std::string dots_in_words(std::uint64_t dots) {
    return grouped(dots) + (dots == 1 ? " dot" : " dots");
}

std::string millimetres_in_words(double mm) {
    // Never in powers of ten.
    if (mm >= 9.95) return fmt::format("{:.0f} mm", mm);
    return fmt::format("{:.2g} mm", mm < 1e-4 ? 0 : mm);
}

std::string way_in_words(double metres) {
    if (metres >= 0.95) return fmt::format("{:.1f} m", metres);
    return metres >= 0.0995 ? fmt::format("{:.0f} cm", 100 * metres) : millimetres_in_words(1000 * metres);
}

double in_two_digits(double number) {
    const double step = std::pow(10, std::max(std::floor(std::log10(std::max(number, 1.0))) - 1, 0.0));
    return std::round(number / step) * step;
}

std::string about(double number) {
    return grouped(static_cast<std::uint64_t>(in_two_digits(number)));
}

bool far_from_tone(double ratio) {
    constexpr double kFar = 1.5;
    return ratio >= kFar || ratio <= 1 / kFar;
}

std::string in_round_words(double number) {
    if (number < 999'999.5) return grouped(static_cast<std::uint64_t>(std::llround(number)));
    for (const auto& [unit, name] : {std::pair{1e6, "million"}, {1e9, "billion"}, {1e12, "trillion"}})
        if (number < 999.5 * unit) return fmt::format("{:#.3g} {}", number / unit, name);
    const int digits = static_cast<int>(std::floor(std::log10(number)));
    return fmt::format("{:.1f} x 10^{}", number / std::pow(10.0, digits), digits);
}

std::string bytes_in_words(double bytes) {
    const char* unit = "kB";
    double size = bytes / 1e3;
    for (const char* larger : {"MB", "GB", "TB"}) {
        if (size < 999.5) break;
        size /= 1e3;
        unit = larger;
    }
    if (size < 9.95) return fmt::format("{:.1f} {}", std::max(size, 0.1), unit);
    const double step = size < 99.5 ? 1 : 10;
    return fmt::format("{:.0f} {}", std::round(size / step) * step, unit);
}

}  // namespace dapple
