#include "io/settings/working_folder.h"

#include <system_error>

#include "io/settings/xdg_folders.h"

namespace dapple {

namespace fs = std::filesystem;

fs::path working_folder() {
    std::error_code gone;
    fs::path folder = fs::current_path(gone);
    if (!gone) return folder;
    folder = home_folder();
    return folder.empty() ? fs::path("/") : folder;
}

}  // namespace dapple
