#pragma once
// Names of an enumeration's values, listed once, beside it and in its order. Options, files and reports read
// and write values by them:
//
//     enum class Topology { torus, window };
//     constexpr auto names_of(Topology) { return names("torus", "window"); }
//
//     name_of(Topology::window)      "window"
//     value_named<Topology>("torus") Topology::torus

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <string_view>

namespace dapple {

template <std::convertible_to<const char*>... Texts>
constexpr std::array<const char*, sizeof...(Texts)> names(Texts... texts) {
    return {texts...};
}

/// An enumeration whose values are 0, 1, 2, ... and have such a list.
template <class Value>
concept Named = requires(Value value) {
    names_of(value)[static_cast<std::size_t>(value)];
};

template <Named Value>
constexpr std::string_view name_of(Value value) {
    return names_of(value)[static_cast<std::size_t>(value)];
}

template <Named Value>
std::optional<Value> value_named(std::string_view name) {
    const auto all = names_of(Value());
    const auto found = std::ranges::find(all, name);
    if (found == all.end()) return std::nullopt;
    return static_cast<Value>(found - all.begin());
}

}  // namespace dapple
