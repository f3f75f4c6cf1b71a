#include "core/text/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "core/text/number_words.h"

namespace dapple {

std::string_view without_byte_order_mark(std::string_view text) {
    constexpr std::string_view kMark = "\xef\xbb\xbf";
    return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}

std::string_view TextLines::next() {
    ++number_;
    if (rest_.empty()) fail("the text ends too early");
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

std::string_view TextLines::next_content() {
    for (;;) {
        const std::string_view line = next();
        const std::size_t first = line.find_first_not_of(" \t");
        if (first != std::string_view::npos && line[first] != '#') return line;
    }
}

bool TextLines::at_end() {
    TextLines ahead = *this;
    while (!ahead.rest_.empty()) {
        const std::string_view line = ahead.next();
        const std::size_t first = line.find_first_not_of(" \t");
        if (first != std::string_view::npos && line[first] != '#') return false;
    }
    return true;
}

std::string_view TextLines::value_of(std::string_view line, std::string_view key) const {
    if (line.starts_with(key) && line.substr(key.size()).starts_with(' ')) return line.substr(key.size() + 1);
    fail(fmt::format("'{}' is expected", key));
}

int TextLines::whole_number(std::string_view text, std::string_view name, int least, int most) const {
    const std::optional<int> number = number_of<int>(text);
    if (!number || *number < least || *number > most)
        fail(fmt::format("{} must be a whole number from {} to {}", name, least, most));
    return *number;
}

void TextLines::fail(std::string_view reason) const {
    throw std::runtime_error(fmt::format("{}line {}: {}", subject_, number_, reason));
}

}  // namespace dapple
