#include "core/settings/whole_path.h"

#include <system_error>

namespace dapple {

std::filesystem::path whole_path(const std::filesystem::path& path) {
    std::error_code gone;
    const std::filesystem::path whole = std::filesystem::absolute(path, gone);
    return (gone ? path : whole).lexically_normal();
}

}  // namespace dapple
