#pragma once
// Sentences about what went wrong.

#include <fmt/format.h>

#include <stdexcept>

namespace dapple {

inline std::runtime_error failure_of(fmt::string_view sentence, fmt::format_args values) {
    return std::runtime_error(fmt::vformat(sentence, values));
}

/// To be thrown: failure("{}: no such file", name).
template <class... Values>
std::runtime_error failure(fmt::format_string<Values...> sentence, Values&&... values) {
    return failure_of(sentence, fmt::make_format_args(values...));
}

}  // namespace dapple
