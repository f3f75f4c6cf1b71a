#include "io/settings/xdg_folders.h"

#include <cstdlib>
#include <system_error>

namespace dapple {

namespace fs = std::filesystem;

fs::path working_folder() {
    std::error_code gone;
    fs::path folder = fs::current_path(gone);
    if (!gone) return folder;
    folder = home_folder();
    return folder.empty() ? fs::path("/") : folder;
}

namespace {

namespace fs = std::filesystem;

// Relative ones are to be ignored, says the specification.
fs::path absolute_in(const char* variable) {
    const char* const value = std::getenv(variable);
    const fs::path path = value ? value : "";
    return path.is_absolute() ? path : fs::path();
}

fs::path base_folder(const char* variable, const char* below_home) {
    if (fs::path given = absolute_in(variable); !given.empty()) return given;
    const fs::path home = home_folder();
    return home.empty() ? fs::path() : home / below_home;
}

fs::path ours_in(const fs::path& base) {
    return base.empty() ? base : base / "dapple";
}

}  // namespace

fs::path home_folder() {
    return absolute_in("HOME");
}
fs::path config_folder() {
    return ours_in(base_folder("XDG_CONFIG_HOME", ".config"));
}
fs::path data_folder() {
    return ours_in(base_folder("XDG_DATA_HOME", ".local/share"));
}
fs::path state_folder() {
    return ours_in(base_folder("XDG_STATE_HOME", ".local/state"));
}

}  // namespace dapple
