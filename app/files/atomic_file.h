#pragma once
// Saving so that a file is either the old one or the new one, whole.

#include <filesystem>
#include <functional>
#include <ostream>

namespace dapple {

/// Calls `write` with a stream into a temporary file beside `target`, then brings it to disk and renames it.
/// If anything goes wrong, or Ctrl+C or SIGTERM ends the program meanwhile, the temporary file is removed and
/// an existing `target` stays as it was. Links are followed; what exists and is no regular file (a pipe,
/// /dev/null) is written to directly.
///
/// Throws std::runtime_error naming the target and what is wrong: its folder is missing or read-only, it is a
/// folder or read-only itself, the disk is full. What `write` throws passes through.
void save_atomically(const std::filesystem::path& target, const std::function<void(std::ostream&)>& write);

/// Throws what save_atomically() would throw before it calls `write`, so that hours of work don't end at a
/// misspelt folder.
void check_can_save(const std::filesystem::path& target);

}  // namespace dapple
