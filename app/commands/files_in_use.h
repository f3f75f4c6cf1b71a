#pragma once
// All files that a run reads and writes, known before it begins: none of those written may be one of the
// others.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

#include "app/commands/render.h"
#include "app/files/atomic_file.h"

namespace dapple {

/// Throws std::runtime_error if a command would write over a file that its command line names, whatever for,
/// over one of `more_read`, or twice over another. `written_by` are the options that say what is written.
void check_apart(const CLI::App& command, std::initializer_list<std::string_view> written_by,
                 const std::vector<FileInUse>& written, const std::vector<FileInUse>& more_read = {});

/// The same for `dapple render`, of one picture or of several into a folder: its drawings, their sheets, the
/// pens' own files and the figures. Files of pens that are chosen from a picture are not known yet: what they
/// must not be written over is left in options.read.
void check_apart(const CLI::App& command, RenderOptions& options,
                 std::span<const std::filesystem::path> pictures);

}  // namespace dapple
