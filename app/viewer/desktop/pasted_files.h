#pragma once
// Files that a text from the clipboard names.

#include <filesystem>
#include <string_view>
#include <vector>

namespace dapple {

/// The path that a line names: a URI, one that begins with ~/, any other as it is. Empty: of another
/// computer.
std::filesystem::path path_named_by(std::string_view line, const std::filesystem::path& home);

/// One a line, as file managers and shells write them: a whole path, one that begins with ~/, or a file: URI
/// with %20 and the like (RFC 8089), in quotes or not; a first line "copy" or "cut" is passed over. What is
/// none of these, or not there, is left out. `home` is what ~ stands for.
std::vector<std::filesystem::path> pasted_files(std::string_view text, const std::filesystem::path& home);

}  // namespace dapple
