#pragma once
// All files that a run reads and writes, known before it begins: none of those written may be one of the
// others.

#include <CLI/CLI.hpp>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "io/files/atomic_file.h"

namespace dapple {

/// What a command line names: each word of it that is a file's name, and what stands behind a ':' in one;
/// without the options that say what is written.
std::vector<FileInUse> files_read(const CLI::App& command,
                                  std::initializer_list<std::string_view> written_by);

/// Throws std::runtime_error if a command would write over a file that its command line names, whatever for,
/// over one of `more_read`, or twice over another. `written_by` are the options that say what is written.
void check_apart(const CLI::App& command, std::initializer_list<std::string_view> written_by,
                 const std::vector<FileInUse>& written, const std::vector<FileInUse>& more_read = {});

}  // namespace dapple
