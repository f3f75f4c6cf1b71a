#pragma once
// Text within XML: SVG files and pages.

#include <string>
#include <string_view>

namespace dapple {

// Bytes as letters: RFC 4648, with padding.

std::string base64_of(std::string_view bytes);

/// Throws std::runtime_error, "are not in base64", if a text is none.
std::string bytes_of_base64(std::string_view text);

/// Text with <, >, &, and both quotes written so that it stays text. Characters that XML has no place for
/// become U+FFFD, and so do bytes that are not UTF-8.
std::string xml_text(std::string_view text);

}  // namespace dapple
