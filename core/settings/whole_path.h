#pragma once
// A file's name from the root on.

#include <filesystem>

namespace dapple {

/// Lexically normal. A relative one stays as it is where the working folder is gone. Does not throw.
std::filesystem::path whole_path(const std::filesystem::path& path);

}  // namespace dapple
