#include "core/text/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "core/failure.h"
#include "core/text/number_words.h"
#include "core/text/shown_text.h"

namespace dapple {

namespace {

constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

}  // namespace

std::string base64_of(std::string_view bytes) {
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        const std::string_view three = bytes.substr(at, 3);
        std::uint32_t bits = 0;
        for (std::size_t i = 0; i < 3; ++i)
            bits = bits << 8 | (i < three.size() ? static_cast<unsigned char>(three[i]) : 0u);
        for (std::size_t i = 0; i < 4; ++i)
            text += i <= three.size() ? kLetters[bits >> (18 - 6 * i) & 63] : '=';
    }
    return text;
}

std::string bytes_of_base64(std::string_view text) {
    std::string bytes;
    std::size_t padding = 0;
    while (padding < 2 && text.ends_with('=')) {
        text.remove_suffix(1);
        ++padding;
    }
    if ((text.size() + padding) % 4 != 0) throw std::runtime_error("are not in base64");
    std::uint32_t bits = 0;
    int kept = 0;
    for (const char letter : text) {
        const std::size_t value = kLetters.find(letter);
        if (value == kLetters.npos) throw std::runtime_error("are not in base64");
        bits = bits << 6 | static_cast<std::uint32_t>(value);
        kept += 6;
        if (kept < 8) continue;
        kept -= 8;
        bytes += static_cast<char>(bits >> kept & 255);
    }
    return bytes;
}

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

constexpr std::array<std::pair<char, std::string_view>, 5> kWritten{
    {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}}};

}  // namespace

std::string xml_text(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const auto [code, length] = first_character(text);
        const auto written =
            std::ranges::find(kWritten, text.front(), &std::pair<char, std::string_view>::first);
        const bool control = code < 0x20 && code != '\n' && code != '\t';
        if (written != kWritten.end())
            result += written->second;
        else if (length == 0 || control || code == 0xFFFE || code == 0xFFFF)
            result += kReplacement;
        else
            result += text.substr(0, length);
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return result;
}

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
    if (!(std::abs(value) < 1e9))
        throw std::range_error("a number is too large to be written, or not finite");
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
