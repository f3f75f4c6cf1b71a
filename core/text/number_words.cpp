#include "core/text/number_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace dapple {

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
