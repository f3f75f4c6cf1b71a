#include "app/viewer/panels/command_palette.h"

#include <imgui.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <sstream>
#include <string>

#include "app/viewer/widgets/dialog.h"
#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {
namespace {

constexpr float kPaletteWidth = 30;  // letters' heights

std::string in_small_letters(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return text;
}

}  // namespace

std::vector<Shortcut> shortcuts_with(std::string_view text, std::span<const Shortcut> shortcuts) {
    std::vector<Shortcut> found;
    for (const Shortcut& shortcut : shortcuts) {
        if (shortcut.action == Action::photograph || shortcut.action == Action::palette) continue;
        const std::string entry = in_small_letters(std::string(shortcut.meaning) + ' ' + shortcut.keys);
        std::istringstream words(in_small_letters(std::string(text)));
        std::string word;
        bool all = true;
        while (words >> word) all &= entry.find(word) != std::string::npos;
        if (all) found.push_back(shortcut);
    }
    return found;
}

void CommandPalette::draw(std::span<const Shortcut> shortcuts, const std::function<void(Action)>& act) {
    std::optional<Action> asked;
    {
        const Dialog dialog("What to do", open_);
        if (!dialog) return;
        if (ImGui::IsWindowAppearing()) {
            typed_[0] = 0;
            chosen_ = 0;
        }
        ImGui::SetNextItemWidth(kPaletteWidth * ImGui::GetTextLineHeight());
        if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
        const std::string before = typed_;
        const bool entered = ImGui::InputTextWithHint("##typed", "a few letters of it", typed_, sizeof typed_,
                                                      ImGuiInputTextFlags_EnterReturnsTrue);
        note_place("What to do");
        if (before != typed_) chosen_ = 0;
        const std::vector<Shortcut> found = shortcuts_with(typed_, shortcuts);
        const int last = std::max(0, static_cast<int>(found.size()) - 1);
        chosen_ =
            std::clamp(chosen_ + (key_pressed(Key::down) ? 1 : 0) - (key_pressed(Key::up) ? 1 : 0), 0, last);
        for (int i = 0; i < static_cast<int>(found.size()); ++i) {
            const Shortcut& each = found[static_cast<std::size_t>(i)];
            if (ImGui::Selectable(each.meaning, i == chosen_)) asked = each.action;
            note_place(each.meaning);
            const float width = ImGui::CalcTextSize(each.keys).x;
            ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - width);
            ImGui::TextDisabled("%s", each.keys);
        }
        if (found.empty()) hint("Nothing has all of that; try one word of it.");
        if (entered && !found.empty()) asked = found[static_cast<std::size_t>(chosen_)].action;
        if (asked) open_ = false;
    }
    if (asked) act(*asked);
}

}  // namespace dapple
