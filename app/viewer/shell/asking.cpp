#include "app/viewer/shell/asking.h"

#include <fmt/format.h>

#include <imgui.h>
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "app/viewer/shell/window.h"
#include "app/viewer/widgets/dialog.h"
#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/picture_entry.h"
#include "app/viewer/widgets/row.h"
#include "app/viewer/widgets/widgets.h"
#include "core/text/shown_text.h"

namespace dapple {

namespace {

constexpr float kAnswersWidth = 30;     // letters' heights
constexpr float kAnswersHeight = 0.6f;  // of the window's, at most

bool answer_button(const char* label) {
    const bool pressed = key_button(label);
    note_place(label);
    return pressed;
}

}  // namespace

void FileQuestion::ask(std::vector<std::filesystem::path> files, const IsBoth& is_both) {
    if (files.empty()) return;
    offered_ = std::move(files);
    is_plain_ = offered_.size() == 1 && !is_both(offered_.front());
    keys_.forget();
}

std::optional<FileQuestion::Answer> FileQuestion::draw(const IsBoth& is_both) {
    if (offered_.empty()) return std::nullopt;
    if (offered_.size() > 1) draw_several(is_both);
    if (offered_.size() != 1) return std::nullopt;
    if (is_plain_) return Answer{std::exchange(offered_, {}).front()};
    return draw_both();
}

std::optional<FileQuestion::Answer> FileQuestion::draw_both() {
    bool open = true;
    std::optional<Answer> answer;
    if (const Dialog dialog("A drawing of Dapple's", open); dialog) {
        const std::filesystem::path& file = offered_.front();
        const std::string name = printable(file.filename().native());
        ImGui::TextUnformatted((name + " is a picture, and holds the settings it was drawn with.").c_str());
        if (answer_button("Take its settings")) answer = {file};
        ImGui::SameLine();
        if (answer_button("Open as a picture")) answer = {file, true};
        if (answer) open = false;
    }
    if (!open) offered_.clear();
    return answer;
}

void FileQuestion::draw_several(const IsBoth& is_both) {
    bool open = true;
    std::optional<std::filesystem::path> chosen;
    if (const Dialog dialog("Which one is to be opened?", open); dialog) {
        const float line = ImGui::GetTextLineHeight(), air = 2 * ImGui::GetStyle().WindowPadding.y;
        const float all = static_cast<float>(offered_.size()) * ImGui::GetTextLineHeightWithSpacing() + air;
        const ImVec2 size{kAnswersWidth * line, std::min(all, kAnswersHeight * ImGui::GetIO().DisplaySize.y)};
        const ImVec2 low = ImGui::GetCursorScreenPos();
        keys_.begin("files", low, {low.x + size.x, low.y + size.y});
        ImGui::BeginChild("files", size, true);
        for (const std::filesystem::path& file : offered_) {
            const std::string name = printable(file.filename().native());
            ImGui::PushID(&file);
            if (text_entry(name, keys_.next_is_marked())) chosen = file;
            if (keys_.end_entry(name).press) chosen = file;
            ImGui::PopID();
            note_place(("Open " + name).c_str());
            tip(printable(file.native()).c_str());
        }
        ImGui::EndChild();
        if (chosen) open = false;
    }
    if (!open) offered_.clear();
    if (chosen) ask({*chosen}, is_both);
}

namespace {

struct Button {
    const char* label;
    std::optional<Key> key;  // that presses it while no button has the keys
    const char* tip;
};

bool pressed(const Button& button) {
    const bool by_mouse = key_button(button.label);
    note_place(button.label);
    tip(button.tip);
    const bool by_key = button.key && !a_row_has_keys() && !ImGui::IsWindowAppearing();
    return by_mouse || (by_key && key_pressed(*button.key));
}

ChangesAnswer ask(const char* title, const std::string& sentence, const Button& save, const Button& discard,
                  const std::optional<Button>& next = {}) {
    bool open = true;
    ChangesAnswer answer = ChangesAnswer::none;
    if (const Dialog dialog(title, open); dialog) {
        ImGui::TextUnformatted(sentence.c_str());
        if (pressed(save)) answer = ChangesAnswer::save;
        ImGui::SameLine();
        if (pressed(discard)) answer = ChangesAnswer::discard;
        ImGui::SameLine();
        if (next) {
            if (pressed(*next)) answer = ChangesAnswer::next;
            ImGui::SameLine();
        }
        if (pressed({"Cancel", {}, "Escape"})) answer = ChangesAnswer::cancel;
        if (answer != ChangesAnswer::none) open = false;
    }
    return open || answer != ChangesAnswer::none ? answer : ChangesAnswer::cancel;
}

}  // namespace

ChangesAnswer ask_about_changes(const std::string& name) {
    return ask("Save the changes?", name + " has changes that are not saved.",
               {"Save", Key::enter, "As a project.   Return"}, {"Discard", Key::d, "They are lost.   D"});
}

ChangesAnswer ask_about_saving(const std::string& name) {
    return ask("Quit while a file is being saved?", name + " is not completely written yet.",
               {"Quit once it is saved", Key::enter, "Return"},
               {"Quit without it", Key::d, "What was there before stays.   D"});
}

ChangesAnswer ask_about_kept(const std::string& name, std::size_t others) {
    std::string sentence = "Dapple ended before the drawing of " + name + " was saved.";
    std::optional<Button> next;
    if (others > 0) {
        sentence += fmt::format("\nThere {} from before.",
                                others == 1 ? "is one more" : fmt::format("are {} more", others));
        next = Button{"An older one", Key::o, "This one is kept, and you are asked about the next.   O"};
    }
    return ask("Bring the drawing back?", sentence, {"Bring it back", Key::enter, "Return"},
               {"Discard", Key::d, "It is lost.   D"}, next);
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
