#include "app/viewer/widgets/row_keys.h"

#include <cstdint>

#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/theme.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {
namespace {

// Kept with each ImGui window, under numbers instead of names: the rows have different IDs above them.
enum Kept : ImGuiID {
    kFocus = 0x7a110001,
    kSeen,
    kFrame,
    kEarlier,
    kLast,
    kTakeNext,
    kTakeLast,
    kWalked,
    kLooked,
    kCovered,
    kWasCovered
};

ImGuiID kept(Kept what) {
    return static_cast<ImGuiID>(ImGui::GetStateStorage()->GetInt(what));
}
void keep(Kept what, ImGuiID value) {
    ImGui::GetStateStorage()->SetInt(what, static_cast<int>(value));
}

// By a dialog or a list.
bool rows_are_covered() {
    constexpr auto kAny = ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel;
    return ImGui::IsPopupOpen("", kAny) && !ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows |
                                                                   ImGuiFocusedFlags_NoPopupHierarchy);
}

// The key that closed what covered them is not the rows'.
bool rows_have_keyboard() {
    return !ImGui::GetIO().WantTextInput && !kept(kCovered) && !kept(kWasCovered);
}

// Once a frame, at its first row.
void look_above() {
    const auto frame = static_cast<ImGuiID>(ImGui::GetFrameCount());
    if (kept(kLooked) == frame) return;
    keep(kWasCovered, kept(kLooked) + 1 == frame ? kept(kCovered) : 0);
    keep(kCovered, rows_are_covered());
    keep(kLooked, frame);
}

// Once a frame, at its first row.
void begin_walk(bool here, bool tab) {
    const auto frame = static_cast<ImGuiID>(ImGui::GetFrameCount());
    if (kept(kFrame) == frame) return;
    const bool was_away = kept(kFrame) + 1 != frame;
    keep(kFrame, frame);
    keep(kEarlier, 0);
    // A row that is drawn no more, or was pressed elsewhere, has no keys.
    if (was_away || !kept(kSeen) || (here && key_pressed(Key::escape)) ||
        ImGui::IsMouseClicked(ImGuiMouseButton_Left))
        keep(kFocus, 0);
    keep(kSeen, 0);
    keep(kWalked, 0);
    if (!tab || kept(kFocus)) return;
    keep(ImGui::GetIO().KeyShift ? kTakeLast : kTakeNext, 1);
}

void walk(ImGuiID id, bool tab) {
    const bool back = ImGui::GetIO().KeyShift;
    if (kept(kTakeNext)) {
        keep(kTakeNext, 0);
        keep(kFocus, id);
    } else if (kept(kTakeLast)) {
        keep(kTakeLast, 0);
        keep(kFocus, kept(kLast));  // of the last frame
        keep(kWalked, 1);
    } else if (tab && kept(kFocus) == id && !kept(kWalked)) {
        // The one before the first is the last one, and the one after the last is the next frame's first.
        keep(kFocus, !back ? 0 : kept(kEarlier) ? kept(kEarlier) : kept(kLast));
        keep(kTakeNext, !back);
        keep(kWalked, 1);
        keep(kSeen, 1);
    }
    keep(kEarlier, id);
}

double arrow_step() {
    const ImGuiIO& io = ImGui::GetIO();
    const auto down = [](Key key) { return ImGui::IsKeyPressed(key_code(key), true) ? 1 : 0; };
    const int direction = down(Key::right) + down(Key::up) - down(Key::left) - down(Key::down);
    return direction * (io.KeyShift ? 10 : io.KeyAlt ? 0.1 : 1);
}

void show_ring(ImGuiID id, ImVec2 low, ImVec2 high) {
    if (auto* const notes = static_cast<WidgetNotes*>(ImGui::GetIO().UserData)) notes->row_with_keys = id;
    const float unit = ImGui::GetTextLineHeight() / 15;
    const ImVec2 a{low.x - 3 * unit, low.y - unit}, b{high.x + 3 * unit, high.y + unit};
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRect(a, b, colour_of(ThemeColour::accent), 3 * unit, 0, 2 * unit);
    note_place(kRowWithKeys, {{a.x, a.y}, {b.x, b.y}});
    const float top = ImGui::GetWindowPos().y, bottom = top + ImGui::GetWindowHeight();
    if (a.y < top || b.y > bottom) ImGui::SetScrollFromPosY(a.y - top, 0.5f);
}

}  // namespace

RowKeys row_keys(const char* name, ImVec2 low, ImVec2 high, bool typing) {
    const ImGuiID id = ImGui::GetID(name);
    auto* const notes = static_cast<WidgetNotes*>(ImGui::GetIO().UserData);
    const bool revealed = notes && notes->reveal && notes->reveal->label == name;
    if (revealed) {
        notes->reveal.reset();
        ImGui::SetScrollFromPosY(low.y - ImGui::GetWindowPos().y, 0.5f);
    }
    // Greyed rows are paler.
    if (ImGui::GetStyle().Alpha < 1) return {};
    look_above();
    const bool here = typing || rows_have_keyboard();
    const bool tab = here && !ImGui::GetIO().KeyCtrl && key_pressed(Key::tab);
    begin_walk(here, tab);
    if (typing || revealed) keep(kFocus, id);
    const bool had = kept(kFocus) == id;
    walk(id, tab);
    keep(kLast, id);
    if (kept(kFocus) != id) return {};
    keep(kSeen, 1);
    if (!kept(kCovered)) show_ring(id, low, high);
    // Nor is the key that brought it here its own.
    if (!here || !had || tab || typing || revealed) return {.focused = true};
    const bool enter = key_pressed(Key::enter) || key_pressed(Key::keypad_enter);
    return {.focused = true,
            .press = enter || key_pressed(Key::space),
            .enter = enter,
            .reset = key_pressed(Key::backspace),
            .step = arrow_step()};
}

bool a_row_has_keys() {
    return kept(kFocus) != 0;
}

RowKeys item_keys(const char* name, bool typing) {
    return row_keys(name, ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), typing);
}

bool key_button(const char* label, ImVec2 size) {
    const bool pressed = ImGui::Button(label, size);
    return item_keys(label).press || pressed;
}

}  // namespace dapple
