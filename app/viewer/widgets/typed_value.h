#pragma once
// What is typed into a row's value.

#include <optional>
#include <string_view>

#include "core/text/length.h"

namespace dapple {

enum class TypedKind {
    number,
    count,   // as count_of() reads it, where each number that is added or taken away begins: not 10.000,
             // nor 2.5
    length,  // comes back in millimetres: 8in, 21cm, 595pt
};

/// A number as people write it, or several, added, taken away, multiplied and divided: 40k, 1.5M, 40,000,
/// 210-15-15, 2*210, 8in/2, 8in+5mm. `bare` is what a length without a unit is in. Nothing if it is none of
/// that.
std::optional<double> typed_value(std::string_view text, TypedKind kind, LengthUnit bare = LengthUnit::mm);

}  // namespace dapple
