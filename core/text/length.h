#pragma once
// Lengths on paper, as people write them.

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/text/names.h"

namespace dapple {

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

}  // namespace dapple
