#include "io/settings/xdg_folders.h"

#include <cstdlib>
#include <system_error>

namespace dapple {
namespace {

namespace fs = std::filesystem;

// Relative ones are to be ignored, says the specification.
fs::path absolute_in(const char* variable) {
    const char* const value = std::getenv(variable);
    const fs::path path = value ? value : "";
    return path.is_absolute() ? path : fs::path();
}

fs::path ours_in(const char* variable, const char* below_home) {
    fs::path base = absolute_in(variable);
    if (base.empty()) base = within_folder(home_folder(), below_home);
    return within_folder(base, "dapple");
}

}  // namespace

fs::path within_folder(const fs::path& folder, const char* name) {
    return folder.empty() ? folder : folder / name;
}

fs::path working_folder() {
    std::error_code gone;
    fs::path folder = fs::current_path(gone);
    if (!gone) return folder;
    folder = home_folder();
    return folder.empty() ? fs::path("/") : folder;
}

fs::path home_folder() {
    return absolute_in("HOME");
}

fs::path config_folder() {
    return ours_in("XDG_CONFIG_HOME", ".config");
}

fs::path data_folder() {
    return ours_in("XDG_DATA_HOME", ".local/share");
}

fs::path state_folder() {
    return ours_in("XDG_STATE_HOME", ".local/state");
}

}  // namespace dapple
