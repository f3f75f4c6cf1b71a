#include "app/viewer/shell/unsaved_drawings.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

#include "core/text/shown_text.h"
#include "io/settings/project.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

fs::path lock_of(const fs::path& kept) {
    return fs::path(kept).replace_extension(".lock");
}

// A lock goes with the process that has it, however it ends.
bool is_locked(const fs::path& kept) {
    const Descriptor file(::open(lock_of(kept).c_str(), O_RDWR | O_CLOEXEC));
    return file && ::flock(file.get(), LOCK_EX | LOCK_NB) != 0;
}

}  // namespace

fs::path UnsavedDrawings::own_file() {
    if (folder_.empty() || !own_.empty()) return own_;
    std::error_code failed;
    fs::create_directories(folder_, failed);
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(now).count();
    const fs::path own = folder_ / fmt::format("{}-{}{}", seconds, ::getpid(), kProjectEnding);
    lock_ = Descriptor(::open(lock_of(own).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600));
    if (!lock_ || ::flock(lock_.get(), LOCK_EX | LOCK_NB) != 0)
        throw std::runtime_error(folder_.string() + ": drawings that are not saved cannot be kept there");
    return own_ = own;
}

void UnsavedDrawings::forget() {
    if (own_.empty()) return;
    remove(own_);
    own_.clear();
    lock_ = Descriptor();
}

std::vector<fs::path> UnsavedDrawings::left_behind() const {
    std::vector<fs::path> left;
    std::error_code failed;
    if (folder_.empty()) return left;
    for (fs::directory_iterator at(folder_, failed), end; !failed && at != end; at.increment(failed)) {
        const fs::path& file = at->path();
        if (ends_as_project(file) && file != own_ && !is_locked(file)) left.push_back(file);
    }
    std::ranges::sort(left, std::greater());  // their names begin with the time
    return left;
}

void UnsavedDrawings::remove(const fs::path& left) {
    std::error_code ignored;
    fs::remove(left, ignored);
    fs::remove(lock_of(left), ignored);
}

std::string picture_of_kept(const fs::path& kept) {
    try {
        const auto json = nlohmann::json::parse(text_of_settings(kept));
        if (json.at("picture").is_null()) return "Still life";
        return printable(fs::path(json.at("picture").at("file").get<std::string>()).filename().native());
    } catch (const std::exception&) {
        return "a drawing";
    }
}

}  // namespace dapple
