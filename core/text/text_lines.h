#pragma once
// Reading a text of lines strictly, so that every complaint names its line.

#include <array>
#include <charconv>
#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>

namespace dapple {

// Text within XML: SVG files and pages.

// Bytes as letters: RFC 4648, with padding.

std::string base64_of(std::string_view bytes);

/// Throws std::runtime_error, "are not in base64", if a text is none.
std::string bytes_of_base64(std::string_view text);

/// Text with <, >, &, and both quotes written so that it stays text. Characters that XML has no place for
/// become U+FFFD, and so do bytes that are not UTF-8.
std::string xml_text(std::string_view text);

// Text on its way to a stream, formatted before it gets there: millions of numbers a second.

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

/// Without the three bytes that some editors put before a text in UTF-8.
std::string_view without_byte_order_mark(std::string_view text);

/// Lines end in \n or \r\n; a byte order mark before them is skipped. Whatever fails throws
/// std::runtime_error, "<subject>line 7: <reason>"; `subject` is empty or ends so that this can follow, "the
/// saved search cannot be read, ".
class TextLines {
 public:
    explicit TextLines(std::string_view text, std::string subject = {})
        : rest_(without_byte_order_mark(text)), subject_(std::move(subject)) {}

    /// Fails if there is none.
    std::string_view next();
    /// The next one that is neither blank nor a comment, which starts with #.
    std::string_view next_content();
    /// Whether nothing but blank lines and comments is left.
    bool at_end();

    /// What follows "key " on a line.
    std::string_view value_of(std::string_view line, std::string_view key) const;
    /// A whole number out of a range, in digits alone; `name` is what the message calls it.
    int whole_number(std::string_view text, std::string_view name, int least, int most) const;

    /// The number of the last line that next() gave, from 1.
    int number() const { return number_; }
    [[noreturn]] void fail(std::string_view reason) const;

 private:
    std::string_view rest_;
    std::string subject_;
    int number_ = 0;
};

}  // namespace dapple
