#include "app/viewer/shell/kept_drawings.h"

#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <utility>

#include "app/viewer/model/session.h"
#include "app/viewer/shell/changes_question.h"

namespace dapple {

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
