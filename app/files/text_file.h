#pragma once
// A whole file as it is.

#include <filesystem>
#include <string>

namespace dapple {

/// Throws std::runtime_error with one sentence if the file is missing, a folder, or cannot be read.
std::string text_of_file(const std::filesystem::path& file);

}  // namespace dapple
