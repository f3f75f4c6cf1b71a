#include "core/text/length.h"

#include <array>
#include <utility>

#include "core/text/numbers.h"

namespace dapple {

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
