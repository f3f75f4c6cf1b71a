#pragma once
// Lengths on paper, as people write them.

#include <optional>
#include <string_view>

namespace dapple {

/// In millimetres: "210", "210mm", "21cm", "8in", "8.5 in", "595pt" (72 to the inch). Nothing if it is none.
std::optional<double> millimetres_of(std::string_view text);

}  // namespace dapple
