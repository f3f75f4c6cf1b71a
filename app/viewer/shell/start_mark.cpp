#include "app/viewer/shell/start_mark.h"

#include <sys/file.h>

#include <system_error>
#include <utility>

namespace dapple {

StartMark::StartMark(const std::filesystem::path& folder) : file_(folder / "starting") {
    std::error_code ignored;
    const bool was_there = std::filesystem::exists(file_, ignored);
    held_ = Descriptor(::open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600));
    if (!held_) return;
    if (::flock(held_.get(), LOCK_EX | LOCK_NB) != 0)
        held_ = Descriptor();  // another window's
    else
        was_left_ = was_there;
}

void StartMark::begun() {
    if (!held_) return;
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
    held_ = Descriptor();
}

}  // namespace dapple
