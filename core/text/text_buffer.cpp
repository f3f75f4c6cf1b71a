#include "core/text/text_buffer.h"

#include <cmath>
#include <cstring>

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
    static constexpr std::array<std::int64_t, 10> powers{
        1, 10, 100, 1'000, 10'000, 100'000, 1'000'000, 10'000'000, 100'000'000, 1'000'000'000};
    const std::int64_t unit = powers[decimals];
    std::int64_t scaled = std::llround(value * static_cast<double>(unit));
    if (scaled < 0) {
        *this << '-';
        scaled = -scaled;
    }
    shortest(scaled / unit);
    std::int64_t fraction = scaled % unit;
    if (fraction == 0) return *this;
    while (fraction % 10 == 0) {
        fraction /= 10;
        --decimals;
    }
    make_room(16);
    buffer_[used_] = '.';
    for (int place = decimals; place > 0; --place, fraction /= 10) {
        buffer_[used_ + place] = static_cast<char>('0' + fraction % 10);
    }
    used_ += static_cast<std::size_t>(decimals) + 1;
    return *this;
}

void TextBuffer::flush() {
    out_.write(buffer_.data(), static_cast<std::streamsize>(used_));
    used_ = 0;
}

void TextBuffer::make_room(std::size_t size) {
    if (used_ + size > buffer_.size()) flush();
}

}  // namespace dapple
