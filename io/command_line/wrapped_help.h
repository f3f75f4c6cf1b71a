#pragma once
// Help whose lines end at the terminal's edge, between words.

#include <CLI/CLI.hpp>
#include <cstddef>
#include <string>
#include <string_view>

namespace dapple {

/// Lines of at most `width` columns, but for words that are longer. What follows of a line stands under its
/// second column, where it has one: a gap of two spaces or more before it. Lines that are set in and have
/// none, such as commands to copy, stay as they are.
std::string wrapped(std::string_view text, std::size_t width);

/// The columns of the terminal that the standard output is; 0: it is none.
std::size_t terminal_columns();

/// Wrapped on a terminal alone: programs and files get each line whole.
class WrappedHelp : public CLI::Formatter {
 public:
    std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
};

}  // namespace dapple
