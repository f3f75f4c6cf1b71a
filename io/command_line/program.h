#pragma once
// A program with commands, from its first word to its exit status.

#include <CLI/CLI.hpp>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "io/files/atomic_file.h"
#include "io/files/picture.h"

namespace dapple {

// All files that a run reads and writes, known before it begins: none of those written may be one of the
// others.

/// What a command line names: each word of it that is a file's name, and what stands behind a ':' in one;
/// without the options that say what is written.
std::vector<FileInUse> files_read(const CLI::App& command,
                                  std::initializer_list<std::string_view> written_by);

/// Throws std::runtime_error if a command would write over a file that its command line names, whatever for,
/// over one of `more_read`, or twice over another. `written_by` are the options that say what is written.
void check_apart(const CLI::App& command, std::initializer_list<std::string_view> written_by,
                 const std::vector<FileInUse>& written, const std::vector<FileInUse>& more_read = {});

// What people should know of how a picture was read, on the standard error.

/// "dapple: cat.exr: the file has ..."; nothing where there is no remark.
void print_remark(const std::filesystem::path& file, const std::string& remark);

/// The same as read_picture(), and prints what there is to remark on.
Picture read_with_remark(const std::filesystem::path& file, PictureLimit limit = PictureLimit::usual,
                         PictureColours colours = PictureColours::left_out);

// Help whose lines end at the terminal's edge, between words.

/// Lines of at most `width` columns, but for words that are longer. What follows of a line stands under its
/// second column, where it has one: a gap of two spaces or more before it. Lines that are set in and have
/// none, such as commands to copy, stay as they are.
std::string wrapped(std::string_view text, std::size_t width);

/// What holds a command's options: it has to live until all is parsed and done.
using Command = std::shared_ptr<const void>;

/// Says what may stand next on the command line: the shells' scripts in packaging/ ask it at each Tab, and so
/// know no option themselves.
[[nodiscard]] Command add_complete_command(CLI::App& program);

/// Help whose lines are wrapped on a terminal alone: programs and files get each of them whole.
std::shared_ptr<CLI::FormatterBase> wrapped_help();

/// Parses the command line and runs its command, or the program's own callback without one. Two commands that
/// help does not show are added: `complete`, and `manual`, which writes the page for man(1): the help of all
/// others. What is wrong is one sentence on the standard error, behind the program's name. Returns 0 if all
/// was done (`status`, which the callbacks may set), 1 if something could not be, 2 if the command line is
/// wrong. `before` is called once all is read, before anything is done; what it throws is a wrong command
/// line.
int run_program(CLI::App& program, int argc, char** argv, const int& status,
                const std::function<void()>& before = {});

}  // namespace dapple
