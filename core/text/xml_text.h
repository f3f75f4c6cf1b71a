#pragma once
// Text within XML: SVG files and pages.

#include <string>
#include <string_view>

namespace dapple {

/// Text with <, >, &, and both quotes written so that it stays text. Characters that XML has no place for
/// become U+FFFD, and so do bytes that are not UTF-8.
std::string xml_text(std::string_view text);

}  // namespace dapple
