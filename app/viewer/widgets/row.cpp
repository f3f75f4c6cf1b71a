#include "app/viewer/widgets/row.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/theme.h"

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
    const int direction = step_between(Key::left, Key::right) + step_between(Key::down, Key::up);
    return direction * (io.KeyShift ? 10 : io.KeyAlt ? 0.1 : 1);
}

void show_ring(ImGuiID id, ImVec2 low, ImVec2 high) {
    if (WidgetNotes* const notes = widget_notes()) notes->row_with_keys = id;
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
    WidgetNotes* const notes = widget_notes();
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
    const bool enter = enter_pressed();
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

namespace {

constexpr float kTipWidth = 24;
constexpr float kTipAfter = 0.5f;  // seconds

void place_tip(const TipPlace& place, const std::string& lines) {
    const float air = ImGui::GetFontSize();
    const ImVec2 point = place.point, screen = ImGui::GetIO().DisplaySize;
    if (place.side == TipPlace::Side::above) {
        // By its share of the window's width all of the tip is in that.
        const float share = std::clamp(point.x / std::max(screen.x, 1.0f), 0.0f, 1.0f);
        return ImGui::SetNextWindowPos({point.x, point.y - air / 2}, ImGuiCond_Always, {share, 1});
    }
    if (point.x <= kTipWidth * air + 3 * air) return;
    const WidgetNotes* const notes = widget_notes();
    const float end = notes && notes->tips_end ? *notes->tips_end : screen.y;
    const float height = ImGui::CalcTextSize(lines.c_str()).y + 2 * ImGui::GetStyle().WindowPadding.y;
    const float top = std::max(std::min(point.y, end - height), 0.0f);
    ImGui::SetNextWindowPos({point.x - 2 * air, top}, ImGuiCond_Always, {1, 0});
}

}  // namespace

WidgetNotes* widget_notes() {
    return static_cast<WidgetNotes*>(ImGui::GetIO().UserData);
}

bool is_left_out() {
    const WidgetNotes* const notes = widget_notes();
    return notes && notes->absent && !notes->listed;
}

std::optional<bool> as_listed(const char* label, std::span<const char* const> names, int& chosen) {
    WidgetNotes* const list = widget_notes();
    if (is_left_out()) return false;
    if (!list || !list->listed) return std::nullopt;
    const char* const why_not = list->absent ? list->absent : list->greyed;
    const ListedRow row{.sections = list->sections,
                        .label = label,
                        .values = {names.begin(), names.end()},
                        .chosen = chosen,
                        .why_not = why_not ? why_not : ""};
    list->listed->push_back(row);
    const ListedRow* const taken = list->taken;
    if (!taken || why_not || taken->label != row.label || taken->sections != row.sections) return false;
    return std::exchange(chosen, list->value) != list->value;
}

std::optional<bool> as_listed(const char* label) {
    int none = -1;
    return as_listed(label, {}, none);
}

bool begin_row(const char* label, Row& row, const LabelLook& look) {
    const char* const shown = look.shown ? look.shown : label;
    row.start = ImGui::GetCursorScreenPos();
    row.width = ImGui::GetContentRegionAvail().x;
    row.height = ImGui::GetFrameHeight();
    row.control_x = row.start.x + std::floor(row.width * kLabelShare);
    const float air = std::floor(kLabelAir * ImGui::GetTextLineHeight());
    const float room = std::max(
        1.0f, (look.control_width > 0 ? row.width - look.control_width : row.control_x - row.start.x) - air);
    ImGui::PushID(label);
    press_area("label", {room, row.height});
    note_place((std::string(shown) + " name").c_str());
    bool reset = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    float text_y = row.start.y + (row.height - ImGui::GetTextLineHeight()) / 2;
    ImDrawList* const list = ImGui::GetWindowDrawList();
    list->PushClipRect(row.start, {row.start.x + room, row.start.y + row.height}, true);
    list->AddText({row.start.x, text_y}, ImGui::GetColorU32(ImGuiCol_Text), shown);
    list->PopClipRect();
    ImGui::SetCursorScreenPos({row.control_x, row.start.y});
    return reset;
}

void end_row(const Row& row) {
    ImGui::PopID();
    go_on_at({row.start.x, row.start.y + row.height + ImGui::GetStyle().ItemSpacing.y});
}

RowKeys keys_of(const char* label, const Row& row, bool typing) {
    return row_keys(label, row.start, {row.start.x + row.width, row.start.y + row.height}, typing);
}

int stepped(int chosen, double step, std::size_t entries) {
    if (step == 0) return chosen;
    return std::clamp(chosen + (step > 0 ? 1 : -1), 0, static_cast<int>(entries) - 1);
}

std::string sentence_of(const Setting& setting) {
    return std::string(setting.help) + '.';
}

bool may_have_tooltip() {
    return !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup) ||
           ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows | ImGuiFocusedFlags_NoPopupHierarchy);
}

void begin_tooltip() {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ImGui::GetStyle().PopupRounding);
    ImGui::BeginTooltip();
    ImGui::PopStyleVar();
}

void show_tip(const char* text, bool hovered, const std::optional<TipPlace>& place) {
    if (!hovered) return;  // rows that have the same to say leave each other's time alone
    ImGuiStorage* storage = ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID(text), seen = ImGui::GetID("tip seen in");
    const ImGuiIO& io = ImGui::GetIO();
    const bool was_hovered = storage->GetInt(seen) + 1 == ImGui::GetFrameCount();
    const bool rests = was_hovered && io.MouseDelta.x == 0 && io.MouseDelta.y == 0 && !io.MouseDown[0];
    const float rested = rests ? storage->GetFloat(id) + io.DeltaTime : 0;
    storage->SetFloat(id, rested);
    storage->SetInt(seen, ImGui::GetFrameCount());
    if (rested < kTipAfter || !may_have_tooltip()) return;
    const float width = kTipWidth * ImGui::GetFontSize();
    const std::string lines = in_lines(text, width - ImGui::GetStyle().WindowPadding.x);
    if (place) place_tip(*place, lines);
    begin_tooltip();
    ImGui::PushTextWrapPos(width);
    ImGui::TextUnformatted(lines.c_str());
    note_place("Tip");
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void show_row_tip(const char* text, const Row& row) {
    // Where rows are greyed, which makes them paler, Greyed tells why.
    if (!text || ImGui::GetStyle().Alpha < 1) return;
    const ImVec2 end{row.start.x + row.width, row.start.y + row.height};
    const bool hovered = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(row.start, end);
    show_tip(text, hovered && !ImGui::IsAnyItemActive(), TipPlace{row.start});
}

void close_on_escape() {
    if (key_pressed(Key::escape)) ImGui::CloseCurrentPopup();
}

}  // namespace dapple
