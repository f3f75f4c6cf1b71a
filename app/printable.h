#pragma once
// Text that others wrote, such as the name of a file, made safe to be shown.

#include <string>
#include <string_view>

namespace dapple {

/// The text on one line, in UTF-8: control characters, what turns the direction of writing or ends lines, and
/// bytes that are no UTF-8 are written out as \n, \t, \x1b or \u202e. A name can thus neither command a
/// terminal nor look like two lines. All else stays, backslashes too, so that doing it twice changes nothing.
std::string printable(std::string_view text);

}  // namespace dapple
