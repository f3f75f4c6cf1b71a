#pragma once
// The folder that the program works in, which somebody may have removed meanwhile.

#include <filesystem>

namespace dapple {

/// Where that folder is gone, the home folder, or the root if there is no home. Does not throw.
std::filesystem::path working_folder();

}  // namespace dapple
