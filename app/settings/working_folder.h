#pragma once
// The folder that the program works in, which somebody may have removed meanwhile. Neither throws.

#include <filesystem>

namespace dapple {

/// Where that folder is gone, the home folder, or the root if there is no home.
std::filesystem::path working_folder();

/// From the root on, lexically normal. A relative one stays as it is where the working folder is gone.
std::filesystem::path whole_path(const std::filesystem::path& path);

}  // namespace dapple
