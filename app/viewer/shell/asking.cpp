#include "app/viewer/shell/asking.h"

#include <utility>

#include "app/viewer/desktop/desktop_dialog.h"
#include "app/viewer/shell/window.h"

namespace dapple {

Asking::Asking() : desktop_dialog_(&Window::wake) {}

void Asking::ask_what_to_open(OpenQuestion question, Asked asked, DialogChoice choice) {
    if (desktop_dialog_.busy()) return;  // one at a time
    if (choice == DialogChoice::own || !has_desktop_dialog()) {
        asked_ = asked;
        return dialog_.ask_what_to_open(std::move(question));
    }
    desktop_asked_ = asked;
    desktop_dialog_.begin([asks = DesktopQuestion{question.title, question.endings, question.start}](
                              const auto& todo) { return ask_desktop(asks, todo.stop()); });
}

void Asking::ask_where_to_save(std::optional<SaveQuestion> question, Asked asked) {
    if (!question) return;
    asked_ = asked;
    dialog_.ask_where_to_save(std::move(*question));
}

std::optional<Asking::Chosen> Asking::draw(const FileDialog::DrawOptions& options) {
    auto file = dialog_.draw(options);
    if (!file) return std::nullopt;
    return Chosen{std::move(*file), asked_};
}

std::optional<Asking::Chosen> Asking::answer() {
    auto file = desktop_dialog_.result();
    if (!file) return std::nullopt;
    return Chosen{std::move(*file), desktop_asked_};
}

}  // namespace dapple
