#include "app/viewer/widgets/widgets.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <imgui.h>

#include "app/shown_text.h"
#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/theme.h"

namespace dapple {
namespace {

constexpr float kLabelShare = 0.34f;  // of the row
constexpr float kValueWidth = 4.6f;   // in letters' heights, at least
constexpr float kValueAir = 0.4f;     // between a track and a value
constexpr float kTipWidth = 24;
constexpr float kTipAfter = 0.5f;  // seconds
constexpr double kRefusalSeconds = 4;

struct Row {
    ImVec2 start;
    float width, height, control_x;
};

/// Draws the label and leaves the cursor where the control begins. True if the label was double-clicked.
bool begin_row(const char* label, Row& row) {
    row.start = ImGui::GetCursorScreenPos();
    row.width = ImGui::GetContentRegionAvail().x;
    row.height = ImGui::GetFrameHeight();
    row.control_x = row.start.x + std::floor(row.width * kLabelShare);
    ImGui::PushID(label);
    press_area("label", {row.control_x - row.start.x, row.height});
    bool reset = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    float text_y = row.start.y + (row.height - ImGui::GetTextLineHeight()) / 2;
    ImGui::GetWindowDrawList()->AddText({row.start.x, text_y}, ImGui::GetColorU32(ImGuiCol_Text), label);
    ImGui::SetCursorScreenPos({row.control_x, row.start.y});
    return reset;
}

void end_row(const Row& row) {
    ImGui::PopID();
    ImGui::SetCursorScreenPos({row.start.x, row.start.y + row.height + ImGui::GetStyle().ItemSpacing.y});
    ImGui::Dummy({0, 0});
    ImGui::SetCursorScreenPos({row.start.x, row.start.y + row.height + ImGui::GetStyle().ItemSpacing.y});
}

void draw_track(ImVec2 min, ImVec2 max, double position, double neutral, bool hot) {
    ImDrawList* list = ImGui::GetWindowDrawList();
    float middle = std::floor((min.y + max.y) / 2) + 0.5f;
    float unit = ImGui::GetTextLineHeight() / 15;
    float knob = 6 * unit, half = 1.5f * unit;
    float left = min.x + knob, right = max.x - knob;
    auto x_of = [&](double t) { return left + (right - left) * static_cast<float>(t); };
    float x = x_of(position), from = x_of(neutral);
    list->AddRectFilled({left - knob, middle - half}, {right + knob, middle + half},
                        colour_of(ThemeColour::track), half);
    list->AddRectFilled({std::min(x, from), middle - half}, {std::max(x, from), middle + half},
                        colour_of(ThemeColour::accent), half);
    list->AddCircleFilled({x, middle}, hot ? knob * 1.15f : knob, colour_of(ThemeColour::accent), 24);
    list->AddCircleFilled({x, middle}, knob * 0.38f, colour_of(ThemeColour::panel), 16);
}

std::string text_of(double value, const SliderRange& range) {
    if (range.grouped) return grouped(static_cast<std::uint64_t>(std::llround(value)));
    char text[64];
    std::snprintf(text, sizeof text, range.format, value);
    return text;
}

/// Room for the longest value that the row can show, so that the track never moves.
float value_width(const SliderRange& range) {
    float width = kValueWidth * ImGui::GetTextLineHeight();
    for (const double value : {range.min, range.max, range.hard_min, range.hard_max})
        width = std::max(width, ImGui::CalcTextSize(text_of(value, range).c_str()).x +
                                    kValueAir * ImGui::GetTextLineHeight());
    return std::ceil(width);
}

// A tooltip that appears beside a dialog, in the frame in which that opens, ends the program by an assertion
// of ImGui's (see kNeverAsksForFocus, which a tooltip cannot have).
bool may_have_tooltip() {
    return !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup) ||
           ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows | ImGuiFocusedFlags_NoPopupHierarchy);
}

// What was wrong with what was typed last into a row.
enum Refusal { kNothing, kTooMuch, kTooLittle, kNoNumber };

Refusal refusal_of(std::optional<double> typed, const SliderRange& range) {
    if (!typed) return kNoNumber;
    return *typed > range.hard_max ? kTooMuch : *typed < range.hard_min ? kTooLittle : kNothing;
}

std::string sentence_of(Refusal refusal, const SliderRange& range) {
    if (refusal == kTooMuch) return "At most " + text_of(range.hard_max, range) + ".";
    if (refusal == kTooLittle) return "At least " + text_of(range.hard_min, range) + ".";
    return range.typed == TypedKind::length ? "That is no length; write 210, 21cm or 8in."
                                            : "That is no number; write 40000, 40k or 1.5M.";
}

void remember_refusal(Refusal refusal) {
    ImGuiStorage* storage = ImGui::GetStateStorage();
    storage->SetInt(ImGui::GetID("refusal"), refusal);
    storage->SetFloat(ImGui::GetID("refused at"), static_cast<float>(ImGui::GetTime()));
}

// Under the value, for some seconds. True while there is one.
bool show_refusal(const SliderRange& range, ImVec2 under) {
    ImGuiStorage* storage = ImGui::GetStateStorage();
    const auto refusal = static_cast<Refusal>(storage->GetInt(ImGui::GetID("refusal")));
    const double since = ImGui::GetTime() - double{storage->GetFloat(ImGui::GetID("refused at"))};
    if (refusal == kNothing || since > kRefusalSeconds) return false;
    if (!may_have_tooltip()) return true;
    ImGui::SetNextWindowPos(under, ImGuiCond_Always, {1, 0});
    ImGui::BeginTooltip();
    ImGui::TextUnformatted(sentence_of(refusal, range).c_str());
    note_place("Refusal");
    ImGui::EndTooltip();
    return true;
}

/// The value as text, or a box to type it in when it was clicked.
bool value_box(double& value, const SliderRange& range, const Row& row, float width, bool start_typing) {
    ImGuiStorage* storage = ImGui::GetStateStorage();
    ImGuiID typing = ImGui::GetID("typing");
    if (start_typing) storage->SetInt(typing, 2);
    ImVec2 corner{row.start.x + row.width - width, row.start.y};
    ImGui::SetCursorScreenPos(corner);
    if (int state = storage->GetInt(typing)) {
        if (state == 2) {
            ImGui::SetKeyboardFocusHere();
            storage->SetInt(typing, 1);
        }
        ImGui::SetNextItemWidth(width);
        // ImGui's own copy is what is edited; this one is what it begins with.
        char text[64];
        std::snprintf(text, sizeof text, "%s", text_of(value, range).c_str());
        const bool entered =
            ImGui::InputText("##typed", text, sizeof text,
                             ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_EnterReturnsTrue);
        const bool left = state == 1 && ImGui::IsItemDeactivated();
        if (left || entered) storage->SetInt(typing, 0);
        if (!entered) return false;
        const std::optional<double> typed = typed_value(text, range.typed);
        remember_refusal(refusal_of(typed, range));
        if (!typed) return false;
        value = std::clamp(*typed, range.hard_min, range.hard_max);
        return true;
    }
    if (press_area("value", {width, row.height})) storage->SetInt(typing, 2);
    const std::string text = text_of(value, range);
    ImVec2 size = ImGui::CalcTextSize(text.c_str());
    auto colour = ImGui::GetColorU32(ImGui::IsItemHovered() ? ImGuiCol_Text : ImGuiCol_TextDisabled);
    ImGui::GetWindowDrawList()->AddText(
        {corner.x + width - size.x, corner.y + (row.height - ImGui::GetTextLineHeight()) / 2}, colour,
        text.c_str());
    return false;
}

void close_on_escape() {
    if (key_pressed(Key::escape)) ImGui::CloseCurrentPopup();
}

// Once the mouse has come to rest on what it is about; moving on must not make it flicker.
// `beside`: a place left of which it stands, where there is room.
void show_tip(const char* text, bool hovered, std::optional<ImVec2> beside = {}) {
    ImGuiStorage* storage = ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID(text);
    const ImGuiIO& io = ImGui::GetIO();
    const bool rests = hovered && io.MouseDelta.x == 0 && io.MouseDelta.y == 0 && !io.MouseDown[0];
    const float rested = rests ? storage->GetFloat(id) + io.DeltaTime : 0;
    storage->SetFloat(id, rested);
    if (rested < kTipAfter || !may_have_tooltip()) return;
    const float width = kTipWidth * ImGui::GetFontSize(), air = ImGui::GetFontSize();
    if (beside && beside->x > width + 3 * air)
        ImGui::SetNextWindowPos({beside->x - 2 * air, beside->y}, ImGuiCond_Always, {1, 0});
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(width);
    ImGui::TextUnformatted(text);
    note_place("Tip");
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

// Beside the row, so that it hides none of the next ones.
void show_row_tip(const char* text, const Row& row) {
    // Where rows are greyed, which makes them paler, Greyed tells why.
    if (!text || ImGui::GetStyle().Alpha < 1) return;
    const ImVec2 end{row.start.x + row.width, row.start.y + row.height};
    const bool hovered = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(row.start, end);
    show_tip(text, hovered && !ImGui::IsAnyItemActive(), row.start);
}

enum class FoldKind { section, within };

bool fold(const char* title, bool open_at_first, FoldKind kind) {
    float unit = ImGui::GetTextLineHeight() / 15;
    ImGui::Dummy({0, 2 * unit});
    ImGui::PushID(title);
    ImGuiStorage* storage = ImGui::GetStateStorage();
    ImGuiID state = ImGui::GetID("open");
    bool open = storage->GetBool(state, open_at_first);
    ImVec2 start = ImGui::GetCursorScreenPos();
    float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetFrameHeight() + 3 * unit;
    if (press_area("title", {width, height})) storage->SetBool(state, open = !open);
    note_place(title);
    bool hot = ImGui::IsItemHovered();
    ImDrawList* list = ImGui::GetWindowDrawList();
    if (kind == FoldKind::section) {
        list->AddLine(start, {start.x + width, start.y}, colour_of(ThemeColour::line), unit);
        push_title_font();
    }
    list->AddText({start.x, start.y + (height - ImGui::GetTextLineHeight()) / 2 + unit},
                  ImGui::GetColorU32(ImGuiCol_Text), title);
    if (kind == FoldKind::section) pop_title_font();
    float arm = 3.5f * unit, x = start.x + width - arm - unit, y = start.y + height / 2 + unit;
    float tip = open ? -arm / 2 : arm / 2;
    const ImVec2 chevron[] = {{x - arm, y - tip}, {x, y + tip}, {x + arm, y - tip}};
    list->AddPolyline(chevron, 3, colour_of(hot ? ThemeColour::text : ThemeColour::quiet), 0, 1.5f * unit);
    ImGui::PopID();
    return open;
}

}  // namespace

void note_place(const char* label, const WidgetPlace& place) {
    if (auto* places = static_cast<WidgetPlaces*>(ImGui::GetIO().UserData)) (*places)[label] = place;
}

void note_place(const char* label) {
    const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
    note_place(label, {{min.x, min.y}, {max.x, max.y}});
}

Greyed::Greyed(const char* reason) : reason_(reason), top_(ImGui::GetCursorScreenPos().y) {
    if (reason_) ImGui::BeginDisabled();
}

Greyed::~Greyed() {
    if (!reason_) return;
    ImGui::EndDisabled();
    const ImVec2 end = ImGui::GetCursorScreenPos();
    const ImVec2 last{end.x + ImGui::GetContentRegionAvail().x, end.y - ImGui::GetStyle().ItemSpacing.y};
    show_tip(reason_, ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect({end.x, top_}, last),
             ImVec2(end.x, top_));
}

bool press_area(const char* name, ImVec2 size) {
    return ImGui::InvisibleButton(name, {std::max(size.x, 1.0f), std::max(size.y, 1.0f)});
}

double track_position(double value, const SliderRange& range) {
    if (range.curve == SliderCurve::linear)
        return std::clamp((value - range.min) / (range.max - range.min), 0.0, 1.0);
    if (value <= range.min) return 0;
    return std::min(1.0, std::log(value / range.min) / std::log(range.max / range.min));
}

double track_value(double position, const SliderRange& range) {
    double t = std::clamp(position, 0.0, 1.0);
    if (range.curve == SliderCurve::linear) return range.min + t * (range.max - range.min);
    return range.min * std::pow(range.max / range.min, t);
}

bool slider_row(const char* label, double& value, const SliderRange& range) {
    Row row;
    bool changed = false;
    if (begin_row(label, row)) {
        value = range.neutral;
        changed = true;
    }
    float box_width = value_width(range);
    float track_width = std::max(20.0f, row.start.x + row.width - box_width - row.control_x);
    press_area("track", {track_width, row.height});
    note_place(label);
    ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
    bool hot = ImGui::IsItemHovered() || ImGui::IsItemActive();
    bool typing = ImGui::IsItemActivated() && ImGui::GetIO().KeyCtrl;
    if (ImGui::IsItemActive() && !ImGui::GetIO().KeyCtrl) {
        float knob = 6 * ImGui::GetTextLineHeight() / 15;
        double at = (ImGui::GetIO().MousePos.x - min.x - knob) / std::max(1.0f, max.x - min.x - 2 * knob);
        double moved = track_value(at, range);
        if (moved != value) {
            value = moved;
            changed = true;
        }
    }
    draw_track(min, max, track_position(value, range), track_position(range.neutral, range), hot);
    if (value_box(value, range, row, box_width, typing)) changed = true;
    note_place((std::string(label) + " value").c_str());
    if (!show_refusal(range, {row.start.x + row.width, row.start.y + row.height}))
        show_row_tip(range.tip, row);
    end_row(row);
    return changed;
}

bool slider_row(const char* label, float& value, const SliderRange& range) {
    double wide = value;
    if (!slider_row(label, wide, range)) return false;
    value = static_cast<float>(wide);
    return true;
}

bool switch_row(const char* label, bool& value, const char* tip) {
    Row row;
    bool toggled = begin_row(label, row);
    float height = std::floor(ImGui::GetTextLineHeight() * 1.1f), width = std::floor(height * 1.8f);
    ImGui::SetCursorScreenPos({row.start.x + row.width - width, row.start.y});
    if (press_area("switch", {width, row.height})) toggled = true;
    note_place(label);
    if (toggled) value = !value;
    ImVec2 min = ImGui::GetItemRectMin();
    float top = std::floor(min.y + (row.height - height) / 2), radius = height / 2;
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled({min.x, top}, {min.x + width, top + height},
                        colour_of(value ? ThemeColour::accent : ThemeColour::track), radius);
    list->AddCircleFilled({value ? min.x + width - radius : min.x + radius, top + radius}, radius * 0.72f,
                          colour_of(ThemeColour::panel), 24);
    show_row_tip(tip, row);
    end_row(row);
    return toggled;
}

bool choice_row(const char* label, int& chosen, std::span<const char* const> names, const char* tip) {
    Row row;
    begin_row(label, row);
    ImGui::SetNextItemWidth(row.start.x + row.width - row.control_x);
    bool valid = chosen >= 0 && chosen < static_cast<int>(names.size());
    bool open = ImGui::BeginCombo("##choice", valid ? names[chosen] : "", ImGuiComboFlags_HeightLarge);
    note_place(label);
    bool changed = false;
    if (open) {
        for (int i = 0; i < static_cast<int>(names.size()); ++i) {
            if (ImGui::Selectable(names[i], i == chosen) && i != chosen) {
                chosen = i;
                changed = true;
            }
            note_place(names[i]);
        }
        close_on_escape();
        ImGui::EndCombo();
    }
    if (!open) show_row_tip(tip, row);
    end_row(row);
    return changed;
}

bool segmented_row(const char* label, int& chosen, std::span<const char* const> names, const char* tip) {
    Row row;
    begin_row(label, row);
    ImDrawList* list = ImGui::GetWindowDrawList();
    float right = row.start.x + row.width, bottom = row.start.y + row.height;
    float rounding = ImGui::GetStyle().FrameRounding;
    list->AddRectFilled({row.control_x, row.start.y}, {right, bottom}, colour_of(ThemeColour::track),
                        rounding);
    bool changed = false;
    float width = (right - row.control_x) / static_cast<float>(names.size());
    for (int i = 0; i < static_cast<int>(names.size()); ++i) {
        float x0 = std::floor(row.control_x + width * static_cast<float>(i));
        float x1 = std::floor(row.control_x + width * static_cast<float>(i + 1));
        ImGui::SetCursorScreenPos({x0, row.start.y});
        if (press_area(names[i], {x1 - x0, row.height}) && chosen != i) {
            chosen = i;
            changed = true;
        }
        note_place(names[i]);
        bool on = chosen == i;
        if (on)
            list->AddRectFilled({x0 + 2, row.start.y + 2}, {x1 - 2, bottom - 2},
                                colour_of(ThemeColour::accent), rounding);
        ImVec2 size = ImGui::CalcTextSize(names[i]);
        auto colour = on ? colour_of(ThemeColour::panel)
                         : ImGui::GetColorU32(ImGui::IsItemHovered() ? ImGuiCol_Text : ImGuiCol_TextDisabled);
        list->AddText({std::floor((x0 + x1 - size.x) / 2), row.start.y + (row.height - size.y) / 2}, colour,
                      names[i]);
    }
    show_row_tip(tip, row);
    end_row(row);
    return changed;
}

bool colour_row(const char* label, glm::vec3& colour, const char* tip) {
    Row row;
    begin_row(label, row);
    float width = std::floor(row.height * 1.8f);
    ImGui::SetCursorScreenPos({row.start.x + row.width - width, row.start.y});
    constexpr auto kPlain = ImGuiColorEditFlags_NoAlpha | ImGuiColorEditFlags_NoTooltip;
    if (ImGui::ColorButton("##colour", {colour.r, colour.g, colour.b, 1}, kPlain, {width, row.height}))
        ImGui::OpenPopup("picker");
    note_place(label);
    bool changed = false;
    if (ImGui::BeginPopup("picker")) {
        constexpr auto kWheel = ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_PickerHueWheel |
                                ImGuiColorEditFlags_DisplayRGB | ImGuiColorEditFlags_DisplayHex;
        changed = ImGui::ColorPicker3("##picker", &colour.x, kWheel);
        note_place("Colour picker");
        if (!ImGui::GetIO().WantTextInput) close_on_escape();  // else it ends the typing
        ImGui::EndPopup();
    } else {
        show_row_tip(tip, row);
    }
    end_row(row);
    return changed;
}

bool section(const char* title, bool open_at_first) {
    return fold(title, open_at_first, FoldKind::section);
}

bool subsection(const char* title, bool open_at_first) {
    return fold(title, open_at_first, FoldKind::within);
}

void tip(const char* text) {
    show_tip(text, ImGui::IsItemHovered());
}

void hint(const char* text) {
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextWrapped("%s", text);
    ImGui::PopStyleColor();
}

}  // namespace dapple
