#include "app/viewer/shell/kept_drawings.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <imgui.h>
#include <sys/file.h>
#include <unistd.h>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "app/viewer/model/session.h"
#include "app/viewer/shell/asking.h"
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

KeptDrawings::KeptDrawings(UnsavedDrawings unsaved)
    : unsaved_(std::move(unsaved)), left_behind_(unsaved_.left_behind()), asks_(!left_behind_.empty()) {}

double KeptDrawings::seconds_until_kept(Document& document) const {
    constexpr double kNever = 3600, kKeepsEvery = 10;
    if (document.unsaved().empty() || document.session()->changes() == changes_kept_) return kNever;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - kept_;
    return std::max(kKeepsEvery - passed.count(), 0.0);
}

void KeptDrawings::keep(Document& document) {
    if (document.unsaved().empty()) {
        if (std::exchange(changes_kept_, -1) != -1) unsaved_.forget();
        return;
    }
    if (ImGui::IsAnyItemActive() || seconds_until_kept(document) > 0) return;
    changes_kept_ = document.session()->changes();
    kept_ = std::chrono::steady_clock::now();
    try {
        const std::filesystem::path own = unsaved_.own_file();
        if (own.empty()) return;
        document.session()->keep(own);
        if (!left_behind_.empty() && !asks_) UnsavedDrawings::remove(std::exchange(left_behind_, {}).front());
    } catch (const std::exception& error) {  // no reason to stop anybody's work
        std::fprintf(stderr, "dapple: %s; changes that are not saved are not kept\n", error.what());
    }
}

void KeptDrawings::draw_question(Document& document) {
    const std::filesystem::path first = left_behind_.front();
    switch (ask_about_kept(picture_of_kept(first), left_behind_.size() - 1)) {
        case ChangesAnswer::none:
            return;
        case ChangesAnswer::next:
            std::rotate(left_behind_.begin(), left_behind_.begin() + 1, left_behind_.end());
            return;
        case ChangesAnswer::cancel:
            left_behind_.clear();
            break;
        case ChangesAnswer::discard:
            UnsavedDrawings::remove(first);
            left_behind_.erase(left_behind_.begin());
            asks_ = !left_behind_.empty();
            return;
        case ChangesAnswer::save:
            left_behind_ = {first};
            if (Session* const session = document.session()) session->bring_back(first);
    }
    asks_ = false;
}

}  // namespace dapple
