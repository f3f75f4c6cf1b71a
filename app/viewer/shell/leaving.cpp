#include "app/viewer/shell/leaving.h"

#include <filesystem>

#include "app/viewer/model/session.h"
#include "app/viewer/shell/changes_question.h"

namespace dapple {

std::string Leaving::question() const {
    if (waiting_ && !waiting_->saving) return "changes";
    return asks_about_saving_ ? "saving" : "";
}

std::optional<Successor> Leaving::draw(Document& document, Asking& asking) {
    const bool waits = waiting_ && !waiting_->saving;
    if (!waits && asks_about_saving_) draw_saving_question(document);
    if (!waiting_) return std::nullopt;
    return draw_changes_question(document, asking);
}

std::optional<Successor> Leaving::draw_changes_question(Document& document, Asking& asking) {
    const std::string name = document.unsaved();
    if (name.empty()) return std::exchange(waiting_, {})->next;
    if (waiting_->saving) {
        if (!asking.dialog().is_open()) waiting_.reset();  // it was not saved
        return std::nullopt;
    }
    switch (ask_about_changes(name)) {
        case ChangesAnswer::none:
        case ChangesAnswer::next:
            return std::nullopt;
        case ChangesAnswer::cancel:
            waiting_.reset();
            return std::nullopt;
        case ChangesAnswer::discard:
            return std::exchange(waiting_, {})->next;
        case ChangesAnswer::save:
            break;
    }
    waiting_->saving = true;
    Session& session = *document.session();
    if (const std::filesystem::path own = session.project_path(); !own.empty())
        session.save_project(own);
    else
        asking.ask_where_to_save(document.where_to_save_project(), Asked::project);
    return std::nullopt;
}

void Leaving::draw_saving_question(Document& document) {
    const std::string name = document.saving();
    const ChangesAnswer answer = name.empty() ? ChangesAnswer::save : dapple::ask_about_saving(name);
    if (answer == ChangesAnswer::none) return;
    if (answer == ChangesAnswer::discard) document.stop_saving();
    closes_once_saved_ = answer == ChangesAnswer::save || answer == ChangesAnswer::discard;
    asks_about_saving_ = false;
}

}  // namespace dapple
