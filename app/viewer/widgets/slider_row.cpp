#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/row.h"
#include "app/viewer/widgets/theme.h"
#include "core/text/number_words.h"

namespace dapple {
namespace {

constexpr float kValueWidth = 5;   // at least, so that tracks end below one another
constexpr float kValueAir = 0.4f;  // in letters' heights, between a track and a value
constexpr double kRefusalSeconds = 4;

/// The value some hundredths of the track further; of whole numbers the next one at least.
double stepped(double value, double step, const SliderRange& range) {
    constexpr double kHundredth = 0.01;
    double moved = track_value(track_position(value, range) + step * kHundredth, range);
    const bool whole = range.grouped || std::string_view(range.format).ends_with(".0f");
    if (whole) moved = std::round(moved);
    if (whole && std::abs(moved - value) < 1) moved = value + std::copysign(1.0, step);
    return std::clamp(moved, std::max(range.min, range.hard_min), std::min(range.max, range.hard_max));
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
                        colour_of(ThemeColour::off), half);
    const float filled = 1.7f * half;
    list->AddRectFilled({std::min(x, from), middle - filled}, {std::max(x, from), middle + filled},
                        colour_of(ThemeColour::accent), half);
    list->AddCircleFilled({x, middle}, hot ? knob * 1.15f : knob, colour_of(ThemeColour::accent), 24);
    list->AddCircleFilled({x, middle}, knob * 0.38f, colour_of(ThemeColour::panel), 16);
}

std::string text_of(double value, const SliderRange& range) {
    if (range.grouped) return grouped(static_cast<std::uint64_t>(std::llround(value)));
    const bool inches = range.typed == TypedKind::length && range.unit == LengthUnit::inch;
    char text[64];
    // An inch is long: as many digits tell it as tell millimetres.
    std::snprintf(text, sizeof text, inches ? "%.4g" : range.format, inches ? value / kMmPerInch : value);
    return text;
}

std::string shown_label(const char* label, const SliderRange& range) {
    if (range.typed != TypedKind::length) return label;
    return std::string(label) + (range.unit == LengthUnit::inch ? ", in" : ", mm");
}

/// Room for every value on the track, so that it never moves while it is dragged, and for the one there is.
float value_width(double value, const SliderRange& range) {
    float width = kValueWidth * ImGui::GetTextLineHeight();
    for (const double shown : {range.min, range.max, value})
        width = std::max(width, ImGui::CalcTextSize(text_of(shown, range).c_str()).x +
                                    kValueAir * ImGui::GetTextLineHeight());
    return std::ceil(width);
}

// What was wrong with what was typed last into a row.
enum Refusal { kNothing, kTooMuch, kTooLittle, kNoNumber };

Refusal refusal_of(std::optional<double> typed, const SliderRange& range) {
    if (!typed) return kNoNumber;
    return *typed > range.hard_max ? kTooMuch : *typed < range.hard_min ? kTooLittle : kNothing;
}

std::string sentence_of(Refusal refusal, const SliderRange& range) {
    if (refusal == kTooMuch) return "At most " + text_of(range.hard_max, range) + ".";
    const std::string least = text_of(range.hard_min, range);
    if (refusal == kTooLittle)
        return (range.hard_min > 0 && least == "0" ? "Over " : "At least ") + least + ".";
    if (range.typed == TypedKind::length) return "Not a length; write 210, 21cm or 8in.";
    return fmt::format("Not a {}number; write 40000, 40k or 1.5M.",
                       range.typed == TypedKind::count ? "whole " : "");
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
    begin_tooltip();
    ImGui::TextUnformatted(sentence_of(refusal, range).c_str());
    note_place("Refusal");
    ImGui::EndTooltip();
    return true;
}

// What was typed so far is kept from frame to frame: where the focus goes to a row drawn before this one,
// ImGui has forgotten it by then.
void remember_typed(const char* text) {
    ImGuiID letter = ImGui::GetID("typed text");
    do ImGui::GetStateStorage()->SetInt(letter++, *text);
    while (*text++);
}

std::string typed_before() {
    std::string text;
    ImGuiID next = ImGui::GetID("typed text");
    while (const int letter = ImGui::GetStateStorage()->GetInt(next++)) text += static_cast<char>(letter);
    return text;
}

/// The box that a value is typed in: it is taken by Enter and where the focus leaves the box; Escape alone
/// drops it. `left`: the focus leaves it by Tab.
bool typing_box(double& value, const SliderRange& range, float width, bool left) {
    ImGuiStorage* const storage = ImGui::GetStateStorage();
    const ImGuiID typing = ImGui::GetID("typing");
    const bool begins = storage->GetInt(typing) == 2;
    const std::string shown = text_of(value, range);
    if (begins) {
        ImGui::SetKeyboardFocusHere();
        storage->SetInt(typing, 1);
        remember_typed(shown.c_str());
    }
    ImGui::SetNextItemWidth(width);
    // ImGui's own copy is what is edited; this one is what it begins with.
    char text[64];
    std::snprintf(text, sizeof text, "%s", begins ? shown.c_str() : typed_before().c_str());
    const bool edited = ImGui::InputText("##typed", text, sizeof text, ImGuiInputTextFlags_AutoSelectAll);
    if (ImGui::IsItemActive()) note_place("Typing");
    if (edited) remember_typed(text);  // Escape brings back what it began with
    if (begins || !(left || ImGui::IsItemDeactivated())) return false;
    storage->SetInt(typing, 0);
    const std::string written = typed_before();
    if (written == shown) return false;  // what was not changed is not rounded
    const std::optional<double> typed = typed_value(written, range.typed, range.unit);
    const Refusal refusal = refusal_of(typed, range);
    remember_refusal(refusal);
    if (!typed || (refusal != kNothing && range.typed == TypedKind::count)) return false;
    value = std::clamp(*typed, range.hard_min, range.hard_max);
    return true;
}

/// The value as text, or a box to type it in when it was clicked.
bool value_box(double& value, const SliderRange& range, const Row& row, float width, bool left) {
    ImGuiStorage* storage = ImGui::GetStateStorage();
    ImGuiID typing = ImGui::GetID("typing");
    ImVec2 corner{row.start.x + row.width - width, row.start.y};
    ImGui::SetCursorScreenPos(corner);
    if (storage->GetInt(typing)) return typing_box(value, range, width, left);
    if (press_area("value", {width, row.height})) storage->SetInt(typing, 2);
    const std::string text = text_of(value, range);
    ImVec2 size = ImGui::CalcTextSize(text.c_str());
    auto colour = ImGui::GetColorU32(ImGui::IsItemHovered() ? ImGuiCol_Text : ImGuiCol_TextDisabled);
    ImGui::GetWindowDrawList()->AddText(
        {corner.x + width - size.x, corner.y + (row.height - ImGui::GetTextLineHeight()) / 2}, colour,
        text.c_str());
    return false;
}

}  // namespace

double track_position(double value, const SliderRange& range) {
    if (!(range.max > range.min)) return 0;  // there is but one value
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
    if (const auto listed = as_listed(label)) return *listed;
    Row row;
    bool changed = false;
    const std::string shown = shown_label(label, range);
    if (begin_row(label, row, {.shown = shown.c_str()})) {
        value = range.neutral;
        changed = true;
    }
    float box_width = value_width(value, range);
    float track_width = std::max(1.0f, row.start.x + row.width - box_width - row.control_x);
    press_area("track", {track_width, row.height});
    note_place(shown.c_str());
    ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
    bool hot = ImGui::IsItemHovered() || ImGui::IsItemActive();
    bool typing = ImGui::IsItemActivated() && ImGui::GetIO().KeyCtrl;
    ImGuiStorage* const storage = ImGui::GetStateStorage();
    const ImGuiID types = ImGui::GetID("typing");
    const bool left = storage->GetInt(types) == 1 && key_pressed(Key::tab);
    const RowKeys keys = keys_of(label, row, left);
    typing |= keys.enter;
    if (typing) storage->SetInt(types, 2);
    const double by_keys = keys.reset       ? range.neutral
                           : keys.step != 0 ? stepped(value, keys.step, range)
                                            : value;
    changed |= by_keys != value;
    value = by_keys;
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
    if (value_box(value, range, row, box_width, left)) changed = true;
    note_place((shown + " value").c_str());
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

SliderRange range_of(const Setting& setting, const SliderNow& now) {
    const auto [least, most, at_least] = setting.range;
    const Track track = now.track.value_or(setting.track);
    const bool own = track.from < track.to;
    const double typed = std::min(now.most.value_or(most), most);
    return {.min = own ? track.from : least,
            .max = std::min(own ? track.to : most, typed),
            .neutral = now.usual.value_or(setting.usual),
            .curve = track.logarithmic ? SliderCurve::logarithmic : SliderCurve::linear,
            .format = now.format ? now.format : setting.format,
            .hard_min = at_least == NumberRange::Least::excluded ? std::nextafter(least, most) : least,
            .hard_max = typed,
            .typed = setting.length ? TypedKind::length : TypedKind::number,
            .unit = now.unit,
            .tip = now.tip};
}

}  // namespace dapple
