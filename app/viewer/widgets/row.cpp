#include "app/viewer/widgets/row.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/viewer/widgets/keys.h"

namespace dapple {
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
    ImGui::SetCursorScreenPos({row.start.x, row.start.y + row.height + ImGui::GetStyle().ItemSpacing.y});
    ImGui::Dummy({0, 0});
    ImGui::SetCursorScreenPos({row.start.x, row.start.y + row.height + ImGui::GetStyle().ItemSpacing.y});
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
