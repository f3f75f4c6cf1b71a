#pragma once
// What the end of a file's name says, however it is written.

#include <filesystem>
#include <string>

namespace dapple {

/// ASCII letters only; others stay.
std::string lower_case(std::string text);

/// ".svg" of "CAT.SVG"; empty if there is none.
std::string ending_of(const std::filesystem::path& file);

}  // namespace dapple
