#pragma once
// Bytes as letters: RFC 4648, with padding.

#include <string>
#include <string_view>

namespace dapple {

std::string base64_of(std::string_view bytes);

/// Throws std::runtime_error, "are not in base64", if a text is none.
std::string bytes_of_base64(std::string_view text);

}  // namespace dapple
