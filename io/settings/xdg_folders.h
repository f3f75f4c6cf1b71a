#pragma once
// Where a program keeps what is a person's, by the XDG Base Directory Specification 0.8.

#include <filesystem>

namespace dapple {

// The folder that the program works in, which somebody may have removed meanwhile.

/// Where that folder is gone, the home folder, or the root if there is no home. Does not throw.
std::filesystem::path working_folder();

/// $XDG_CONFIG_HOME/dapple, or ~/.config/dapple: what a person chose and may copy to another computer.
/// Empty, as all of these, if there is neither that variable nor a home. Nothing is made.
std::filesystem::path config_folder();
/// $XDG_STATE_HOME/dapple, or ~/.local/state/dapple: what is only remembered.
std::filesystem::path state_folder();
/// $XDG_DATA_HOME/dapple, or ~/.local/share/dapple: what a person made and has no other place.
std::filesystem::path data_folder();
/// A folder or file within one; empty if that is.
std::filesystem::path within_folder(const std::filesystem::path& folder, const char* name);

/// $HOME; may be empty.
std::filesystem::path home_folder();

}  // namespace dapple
