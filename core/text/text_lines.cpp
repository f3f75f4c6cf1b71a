#include "core/text/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "core/failure.h"
#include "core/text/number_words.h"

namespace dapple {

TextBuffer& TextBuffer::operator<<(std::string_view text) {
    if (text.size() > buffer_.size()) {
        flush();
        out_.write(text.data(), static_cast<std::streamsize>(text.size()));
        return *this;
    }
    make_room(text.size());
    std::memcpy(buffer_.data() + used_, text.data(), text.size());
    used_ += text.size();
    return *this;
}

TextBuffer& TextBuffer::operator<<(char c) {
    make_room(1);
    buffer_[used_++] = c;
    return *this;
}

TextBuffer& TextBuffer::fixed(double value, int decimals) {
    static constexpr std::array<double, 10> powers{
        1, 10, 100, 1'000, 10'000, 100'000, 1'000'000, 10'000'000, 100'000'000, 1'000'000'000};
    if (!(std::abs(value) < 1e9)) throw std::range_error("a number is too large to be written, or is none");
    // To the nearest, and from the middle away from zero.
    const double scaled = std::abs(value) * powers[static_cast<std::size_t>(decimals)];
    auto rest = static_cast<std::uint64_t>(scaled);
    rest += scaled - static_cast<double>(rest) >= 0.5;
    const bool negative = value < 0 && rest > 0;
    for (; decimals > 0 && rest % 10 == 0; --decimals) rest /= 10;
    // From the last digit on.
    std::array<char, 24> digits;
    auto first = digits.end();
    const auto put = [&] {
        *--first = static_cast<char>('0' + rest % 10);
        rest /= 10;
    };
    for (; decimals > 0; --decimals) {
        put();
        if (decimals == 1) *--first = '.';
    }
    do put();
    while (rest > 0);
    if (negative) *--first = '-';
    return *this << std::string_view(&*first, static_cast<std::size_t>(digits.end() - first));
}

void TextBuffer::flush() {
    out_.write(buffer_.data(), static_cast<std::streamsize>(used_));
    used_ = 0;
}

void TextBuffer::make_room(std::size_t size) {
    if (used_ + size > buffer_.size()) flush();
}

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
    throw failure("{}line {}: {}", subject_, number_, reason);
}

}  // namespace dapple
