#pragma once
// Sentences about what went wrong.

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace dapple {

/// To be thrown: failure("{}: no such file", name).
template <class... Values>
std::runtime_error failure(fmt::format_string<Values...> sentence, Values&&... values) {
    return std::runtime_error(fmt::format(sentence, std::forward<Values>(values)...));
}

}  // namespace dapple
