#include "app/viewer/shell/asking.h"

#include <imgui.h>
#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

#include "app/viewer/shell/window.h"
#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/picture_entry.h"
#include "app/viewer/widgets/row.h"
#include "app/viewer/widgets/widgets.h"
#include "core/text/shown_text.h"

namespace dapple {

namespace {

constexpr float kAnswersWidth = 30;     // letters' heights
constexpr float kAnswersHeight = 0.6f;  // of the window's, at most

struct Button {
    const char* label;
    const char* tip = nullptr;
    std::optional<Key> key = {};  // that presses it while no button has the keys
};

bool pressed(const Button& button) {
    const bool by_mouse = key_button(button.label);
    note_place(button.label);
    if (button.tip) tip(button.tip);
    const bool by_key = button.key && !a_row_has_keys() && !ImGui::IsWindowAppearing();
    return by_mouse || (by_key && key_pressed(*button.key));
}

// Which button was pressed, from 0 on; Cancel, and letting the dialog go, are the last. None yet: none.
std::optional<int> ask(const char* title, const std::string& sentence,
                       std::initializer_list<Button> buttons) {
    bool open = true;
    std::optional<int> answer;
    const int cancel = static_cast<int>(buttons.size());
    if (const Dialog dialog(title, open); dialog) {
        ImGui::TextUnformatted(sentence.c_str());
        int next = 0;
        for (const Button& button : buttons) {
            if (pressed(button)) answer = next;
            ++next;
            ImGui::SameLine();
        }
        if (pressed({"Cancel", "Escape"})) answer = cancel;
        if (answer) open = false;
    }
    return open || answer ? answer : cancel;
}

std::optional<ChangesAnswer> ask_about_loss(const char* title, const std::string& sentence,
                                            const Button& save, const Button& discard) {
    const auto answer = ask(title, sentence, {save, discard});
    if (!answer) return std::nullopt;
    return std::array{ChangesAnswer::save, ChangesAnswer::discard,
                      ChangesAnswer::cancel}[static_cast<std::size_t>(*answer)];
}

}  // namespace

void FileQuestion::ask(std::vector<std::filesystem::path> files, const IsBoth& is_both) {
    if (files.empty()) return;
    offered_ = std::move(files);
    is_plain_ = offered_.size() == 1 && !is_both(offered_.front());
    keys_.forget();
}

std::optional<FileQuestion::Answer> FileQuestion::draw(const IsBoth& is_both) {
    if (offered_.size() > 1) draw_several(is_both);
    if (offered_.size() != 1) return std::nullopt;
    const std::filesystem::path file = offered_.front();
    std::optional<int> answer = 0;
    if (!is_plain_)
        answer = dapple::ask("A Dapple drawing",
                             printable(file.filename().native()) + " was made with Dapple. Use its settings?",
                             {{"Use its settings"}, {"Open as a picture"}});
    if (!answer) return std::nullopt;
    offered_.clear();
    return *answer == 2 ? std::nullopt : std::optional(Answer{file, *answer == 1});
}

void FileQuestion::draw_several(const IsBoth& is_both) {
    bool open = true;
    std::vector<std::filesystem::path> chosen;
    if (const Dialog dialog("Open which file?", open); dialog) {
        const float line = ImGui::GetTextLineHeight(), air = 2 * ImGui::GetStyle().WindowPadding.y;
        const float all = static_cast<float>(offered_.size()) * ImGui::GetTextLineHeightWithSpacing() + air;
        const ImVec2 size{kAnswersWidth * line, std::min(all, kAnswersHeight * ImGui::GetIO().DisplaySize.y)};
        const ImVec2 low = ImGui::GetCursorScreenPos();
        keys_.begin("files", low, {low.x + size.x, low.y + size.y});
        ImGui::BeginChild("files", size, true);
        for (const std::filesystem::path& file : offered_) {
            const std::string name = printable(file.filename().native());
            ImGui::PushID(&file);
            const bool clicked = text_entry(name, keys_.next_is_marked());
            if (keys_.end_entry(name).press || clicked) chosen = {file};
            ImGui::PopID();
            note_place(("Open " + name).c_str());
            tip(printable(file.native()).c_str());
        }
        ImGui::EndChild();
        open = open && chosen.empty();
    }
    if (!open) offered_.clear();
    ask(std::move(chosen), is_both);
}

std::optional<ChangesAnswer> ask_about_changes(const std::string& name) {
    return ask_about_loss("Unsaved changes", "Save your drawing of " + name + "? (The photo is not changed.)",
                          {"Save", "As a project.   Return", Key::enter},
                          {"Discard", "The changes are lost.   D", Key::d});
}

std::optional<ChangesAnswer> ask_about_saving(const std::string& name) {
    return ask_about_loss("Quit while saving a file?", name + " is still being written.",
                          {"Quit when saved", "Return", Key::enter},
                          {"Quit now", "The old file is kept.   D", Key::d});
}

std::optional<ChangesAnswer> ask_about_kept(const std::string& name) {
    return ask_about_loss("Unsaved drawing",
                          "Dapple closed unexpectedly. Restore your drawing of " + name + "?",
                          {"Restore", "Return", Key::enter}, {"Discard", "The drawing is lost.   D", Key::d});
}

Asking::Asking() : desktop_dialog_(&Window::wake) {}

void Asking::ask_what_to_open(const OpenQuestion& question, Asked asked, DialogChoice choice) {
    if (desktop_dialog_.busy()) return;  // one at a time
    if (choice == DialogChoice::own || !has_desktop_dialog()) {
        asked_ = asked;
        return dialog_.ask_what_to_open(question);
    }
    desktop_asked_ = asked;
    desktop_dialog_.begin([question](const auto& todo) { return ask_desktop(question, todo.stop()); });
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
