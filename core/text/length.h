#pragma once
// Lengths on paper, as people write them.

#include <optional>
#include <string_view>

#include "core/text/names.h"

namespace dapple {

/// What lengths are told in.
enum class LengthUnit { mm, inch };
constexpr auto names_of(LengthUnit) {
    return names("mm", "inch");
}
inline constexpr double kMmPerInch = 25.4;

/// In millimetres: "210", "210mm", "21cm", "8in", "8.5 in", "595pt" (72 to the inch). `bare` is what a number
/// alone means. Nothing if it is none.
std::optional<double> millimetres_of(std::string_view text, LengthUnit bare = LengthUnit::mm);

}  // namespace dapple
