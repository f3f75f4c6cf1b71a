#pragma once
// Reading a text of lines strictly, so that every complaint names its line.

#include <string>
#include <string_view>

namespace dapple {

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
