#pragma once
// What is typed into a row's value.

#include <optional>
#include <string_view>

namespace dapple {

enum class TypedKind {
    number,
    length,  // in millimetres; 8in, 21cm, 595pt
};

/// A number as people write it, or several, added and taken away: 40k, 1.5M, 40,000, 210-15-15,
/// 8in+5mm. Nothing if it is none of that.
std::optional<double> typed_value(std::string_view text, TypedKind kind);

}  // namespace dapple
