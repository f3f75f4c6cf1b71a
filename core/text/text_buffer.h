#pragma once
// Text on its way to a stream, formatted before it gets there: millions of numbers a second.

#include <array>
#include <charconv>
#include <cstdint>
#include <ostream>
#include <string_view>

namespace dapple {

class TextBuffer {
 public:
    explicit TextBuffer(std::ostream& out) : out_(out) {}

    TextBuffer& operator<<(std::string_view text);
    TextBuffer& operator<<(char c);
    TextBuffer& operator<<(std::int64_t value) { return shortest(value); }
    /// As few digits as read back to the same number.
    TextBuffer& operator<<(float value) { return shortest(value); }
    TextBuffer& operator<<(double value) { return shortest(value); }

    /// Rounded to so many decimals, 0..9, without zeros at the end: 12.5, 3, 0, -0.25. Throws
    /// std::range_error unless it is below 10^9, on either side of 0.
    TextBuffer& fixed(double value, int decimals);

    /// To be called at the end.
    void flush();

 private:
    void make_room(std::size_t size);

    template <class T>
    TextBuffer& shortest(T value) {
        make_room(64);
        char* const begin = buffer_.data() + used_;
        used_ += static_cast<std::size_t>(std::to_chars(begin, begin + 64, value).ptr - begin);
        return *this;
    }

    std::ostream& out_;
    std::size_t used_ = 0;
    std::array<char, 1 << 16> buffer_;
};

}  // namespace dapple
