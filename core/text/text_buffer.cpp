#include "core/text/text_buffer.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <stdexcept>

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

}  // namespace dapple
