#pragma once
// How names are shown to people; numbers are shown by core/text/number_words.h.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/text/number_words.h"

namespace dapple {

struct Character {
    std::uint32_t code = 0;
    std::size_t bytes = 0;  // 0: not UTF-8
};

/// The first of a text that is not empty. Longer forms than needed, halves of pairs and what is beyond
/// Unicode are not UTF-8.
Character first_character(std::string_view text);

/// Text that others wrote, such as the name of a file, made safe: on one line, in UTF-8: control characters,
/// what turns the direction of writing or ends lines, and bytes that are no UTF-8 are written out as \n, \t,
/// \x1b or \u202e. A name can thus neither command a terminal nor look like two lines. All else stays,
/// backslashes too, so that doing it twice changes nothing.
std::string printable(std::string_view text);

/// Printable text with the middle of every word of over 500 characters left out, as of a name that is none.
std::string shortened(std::string_view text);

/// Bytes, such as a file's name, as text for a field that holds letters up to U+FFFF: others, control
/// characters and bytes that are no UTF-8 are written out byte by byte, as \xff; so is a backslash that would
/// begin such. bytes_of() reads it back.
std::string editable(std::string_view bytes);
std::string bytes_of(std::string_view edited);

bool is_utf8(std::string_view text);

}  // namespace dapple
