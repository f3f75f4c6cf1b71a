#pragma once
// A picture on the clipboard, by the desktop's own programs: wl-paste and wl-copy on Wayland, xclip on X11.

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string_view>
#include <vector>

namespace dapple {

// Files that a text from the clipboard names.

/// One a line, as file managers and shells write them: a whole path, one that begins with ~/, or a file: URI
/// with %20 and the like (RFC 8089), in quotes or not; a first line "copy" or "cut" is passed over. What is
/// none of these, or not there, is left out. `home` is what ~ stands for.
std::vector<std::filesystem::path> pasted_files(std::string_view text, const std::filesystem::path& home);

/// Where a picture is written that is to be copied, for that time; empty: there is no home.
std::filesystem::path file_to_copy();

/// Puts a PNG file on the clipboard, where it stays when the file goes. False if stopped. Throws
/// std::runtime_error with one sentence for the person if neither program is there, or if it fails.
bool copy_picture(const std::filesystem::path& png, const std::stop_token& stop);

/// Where pasted pictures are kept, so that projects find them again; empty: there is no home.
std::filesystem::path pasted_folder();

/// Writes the picture on the clipboard into a new file of that folder, which is made: PNG if it can be had as
/// that, else as it is. Nothing if stopped. Throws std::runtime_error with one sentence for the person if
/// there is none, if neither program is there, or if the file cannot be written.
std::optional<std::filesystem::path> save_pasted_picture(const std::filesystem::path& folder,
                                                         const std::stop_token& stop);

}  // namespace dapple
