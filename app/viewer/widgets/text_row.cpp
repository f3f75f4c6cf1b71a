#include <imgui.h>
#include <imgui_stdlib.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/row.h"
#include "app/viewer/widgets/theme.h"
#include "core/image/colour.h"
#include "core/text/shown_text.h"

namespace dapple {

bool bytes_box(const char* name, std::string& bytes, ImGuiInputTextFlags flags,
               ImGuiInputTextCallback callback, void* data) {
    std::string text = editable(bytes);
    const std::string before = text;
    const bool done = ImGui::InputText(name, &text, flags, callback, data);
    if (text != before) bytes = bytes_of(text);
    return done;
}

bool text_row(const char* label, std::string& text, const std::function<bool(const std::string&)>& is_good,
              const char* wrong, const char* tip, const char* usual) {
    if (const auto listed = as_listed(label)) return *listed;
    Row row;
    bool reset = begin_row(label, row);
    ImGui::SetNextItemWidth(row.start.x + row.width - row.control_x);
    const RowKeys keys = keys_of(label, row);
    if (keys.enter) ImGui::SetKeyboardFocusHere();
    reset = usual && (reset || keys.reset);
    std::string typed = text;
    const bool edited = bytes_box("##text", typed);
    note_place(label);
    ImGuiStorage* const storage = ImGui::GetStateStorage();
    const ImGuiID bad = ImGui::GetID("bad");
    if (edited) storage->SetInt(bad, !is_good(typed));
    if (!ImGui::IsItemActive()) storage->SetInt(bad, 0);
    const bool is_bad = storage->GetInt(bad) != 0;
    if (is_bad && may_have_tooltip()) {
        ImGui::SetNextWindowPos({row.start.x + row.width, row.start.y + row.height}, ImGuiCond_Always,
                                {1, 0});
        begin_tooltip();
        ImGui::TextUnformatted(wrong);
        note_place("Refusal");
        ImGui::EndTooltip();
    } else if (!is_bad) {
        show_row_tip(tip, row);
    }
    end_row(row);
    if (reset) typed = usual;
    if (!reset && (!edited || is_bad)) return false;
    return std::exchange(text, typed) != typed;
}

namespace {

// The colour as people write it, to be typed over. A text that is none changes nothing; one that was entered
// closes the popup.
void typed_colour(glm::vec3& colour, bool begin) {
    std::array<char, 16> text{};
    hex_of(colour).copy(text.data(), text.size() - 1);
    if (begin) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(7 * ImGui::GetTextLineHeight());
    const bool entered =
        ImGui::InputText("##hex", text.data(), text.size(),
                         ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    note_place("Colour as text");
    if (ImGui::IsItemDeactivated() && key_pressed(Key::escape)) ImGui::CloseCurrentPopup();
    if (!entered) return;
    try {
        colour = parse_colour(text.data());
        ImGui::CloseCurrentPopup();
    } catch (const std::runtime_error&) {  // it stays as it is, to be typed on
    }
}

}  // namespace

bool colour_row(const char* label, glm::vec3& colour, const char* tip,
                const std::optional<glm::vec3>& usual) {
    if (const auto listed = as_listed(label)) return *listed;
    Row row;
    const glm::vec3 before = colour;
    const float width = std::floor(ImGui::GetFrameHeight() * 1.8f);
    const bool reset = begin_row(label, row, {.control_width = width});
    ImGui::SetCursorScreenPos({row.start.x + row.width - width, row.start.y});
    constexpr auto kPlain =
        ImGuiColorEditFlags_NoAlpha | ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop;
    if (ImGui::ColorButton("##colour", {colour.r, colour.g, colour.b, 1}, kPlain, {width, row.height}))
        ImGui::OpenPopup("picker");
    note_place(label);
    // White on a light panel is a colour as well.
    ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                        colour_of(ThemeColour::off), ImGui::GetStyle().FrameRounding, 0,
                                        ImGui::GetTextLineHeight() / 15);
    const RowKeys keys = keys_of(label, row);
    const bool by_key = keys.press;
    if (by_key) ImGui::OpenPopup("picker");
    if ((reset || keys.reset) && usual) colour = *usual;
    if (ImGui::BeginPopup("picker")) {
        typed_colour(colour, by_key);
        constexpr auto kWheel = ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_PickerHueWheel |
                                ImGuiColorEditFlags_DisplayRGB;
        ImGui::ColorPicker3("##picker", &colour.x, kWheel);
        note_place("Colour picker");
        if (!ImGui::GetIO().WantTextInput) close_on_escape();  // else it ends the typing
        ImGui::EndPopup();
    } else {
        show_row_tip(tip, row);
    }
    end_row(row);
    return colour != before;
}

bool colour_row(const Setting& setting, glm::vec3& colour, const glm::vec3& usual) {
    return colour_row(setting.names.row, colour, sentence_of(setting).c_str(), usual);
}

}  // namespace dapple
