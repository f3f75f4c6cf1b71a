#include "app/viewer/shell/kept_drawings.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <imgui.h>
#include <sys/file.h>
#include <unistd.h>
#include <algorithm>
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

void remove_kept(const fs::path& kept) {
    std::error_code ignored;
    fs::remove(kept, ignored);
    fs::remove(lock_of(kept), ignored);
}

}  // namespace

KeptDrawings::KeptDrawings(fs::path folder) : folder_(std::move(folder)) {
    std::error_code failed;
    if (folder_.empty()) return;
    for (fs::directory_iterator at(folder_, failed), end; !failed && at != end; at.increment(failed))
        if (ends_as_project(at->path()) && !is_locked(at->path())) left_behind_.push_back(at->path());
    std::ranges::sort(left_behind_, std::greater());  // their names begin with the time
}

fs::path KeptDrawings::own_file() {
    if (folder_.empty() || !own_.empty()) return own_;
    std::error_code failed;
    fs::create_directories(folder_, failed);
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(now).count();
    const fs::path own = folder_ / fmt::format("{}-{}{}", seconds, ::getpid(), kProjectEnding);
    lock_ = Descriptor(::open(lock_of(own).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600));
    if (!lock_ || ::flock(lock_.get(), LOCK_EX | LOCK_NB) != 0)
        throw std::runtime_error(folder_.string() + ": unsaved drawings cannot be kept there");
    return own_ = own;
}

void KeptDrawings::forget() {
    if (own_.empty()) return;
    remove_kept(own_);
    own_.clear();
    lock_ = Descriptor();
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

double KeptDrawings::seconds_until_kept(Document& document) const {
    constexpr double kNever = 3600, kKeepsEvery = 10;
    if (document.unsaved().empty() || document.session()->changes() == changes_kept_) return kNever;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - kept_;
    return std::max(kKeepsEvery - passed.count(), 0.0);
}

void KeptDrawings::keep(Document& document) {
    if (document.unsaved().empty()) {
        if (std::exchange(changes_kept_, -1) != -1) forget();
        return;
    }
    if (ImGui::IsAnyItemActive() || seconds_until_kept(document) > 0) return;
    changes_kept_ = document.session()->changes();
    kept_ = std::chrono::steady_clock::now();
    try {
        const fs::path own = own_file();
        if (own.empty()) return;
        document.session()->keep(own);
        if (!brought_back_.empty()) remove_kept(std::exchange(brought_back_, {}));
    } catch (const std::exception& error) {  // no reason to stop anybody's work
        std::fprintf(stderr, "dapple: %s; unsaved changes are not kept\n", error.what());
    }
}

void KeptDrawings::draw_question(Document& document) {
    const fs::path first = left_behind_.front();
    const auto answer = ask_about_kept(picture_of_kept(first));
    if (!answer) return;
    left_behind_.erase(left_behind_.begin());
    if (answer == ChangesAnswer::discard) remove_kept(first);
    if (answer != ChangesAnswer::save) return;
    left_behind_.clear();
    brought_back_ = first;
    if (Session* const session = document.session()) session->bring_back(first);
}

}  // namespace dapple
