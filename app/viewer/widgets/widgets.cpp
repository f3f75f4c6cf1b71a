#include "app/viewer/widgets/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include "app/shown_text.h"
#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/row_keys.h"
#include "app/viewer/widgets/theme.h"
#include "core/image/colour.h"

namespace dapple {
namespace {

constexpr float kLabelShare = 0.36f;  // of the row
constexpr float kLabelAir = 0.4f;     // in letters' heights, as what follows: behind a label
constexpr float kValueWidth = 5;      // at least, so that tracks end below one another
constexpr float kValueAir = 0.4f;     // between a track and a value
constexpr float kSegmentAir = 0.9f;   // between two words side by side
constexpr float kLeastSegmentAir = 0.3f, kLeastLabel = 3;
constexpr float kTipWidth = 24;
constexpr float kTipAfter = 0.5f;  // seconds
constexpr double kRefusalSeconds = 4;

WidgetNotes* notes() {
    return static_cast<WidgetNotes*>(ImGui::GetIO().UserData);
}

/// Where rows are listed, whether the row took another value; none: it is to be drawn.
std::optional<bool> as_listed(const char* label, std::span<const char* const> names, int& chosen) {
    WidgetNotes* const list = notes();
    if (!list || !list->listed) return std::nullopt;
    const ListedRow row{.sections = list->sections,
                        .label = label,
                        .values = {names.begin(), names.end()},
                        .chosen = chosen,
                        .greyed = ImGui::GetStyle().Alpha < 1};
    list->listed->push_back(row);
    const ListedRow* const taken = list->taken;
    if (!taken || row.greyed || taken->label != row.label || taken->sections != row.sections) return false;
    return std::exchange(chosen, list->value) != list->value;
}

std::optional<bool> as_listed(const char* label) {
    int none = -1;
    return as_listed(label, {}, none);
}

struct Row {
    ImVec2 start;
    float width, height, control_x;
};

struct LabelLook {
    float control_width = 0;      // of one at the row's end; 0: it begins after the labels' column
    const char* shown = nullptr;  // none: the label itself
};

/// Draws the label and leaves the cursor where the control begins. True if the label was double-clicked. In a
/// narrow window the label is cut off before the control.
bool begin_row(const char* label, Row& row, const LabelLook& look = {}) {
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

RowKeys keys_of(const char* label, const Row& row, bool typing = false) {
    return row_keys(label, row.start, {row.start.x + row.width, row.start.y + row.height}, typing);
}

/// The value some hundredths of the track further; of whole numbers the next one at least.
double stepped(double value, double step, const SliderRange& range) {
    constexpr double kHundredth = 0.01;
    double moved = track_value(track_position(value, range) + step * kHundredth, range);
    const bool whole = range.grouped || std::string_view(range.format).ends_with(".0f");
    if (whole) moved = std::round(moved);
    if (whole && std::abs(moved - value) < 1) moved = value + std::copysign(1.0, step);
    return std::clamp(moved, std::max(range.min, range.hard_min), std::min(range.max, range.hard_max));
}

/// Which of so many entries the arrows choose next.
int stepped(int chosen, double step, std::size_t entries) {
    if (step == 0) return chosen;
    return std::clamp(chosen + (step > 0 ? 1 : -1), 0, static_cast<int>(entries) - 1);
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
    const bool inches = range.typed == TypedKind::length && range.unit == LengthUnit::inch;
    char text[64];
    // An inch is long: as many digits tell it as tell millimetres.
    std::snprintf(text, sizeof text, inches ? "%.4g" : range.format, inches ? value / kMmPerInch : value);
    return text;
}

// The row's tip.
std::string sentence_of(const Setting& setting) {
    return std::string(setting.help) + '.';
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

// A tooltip that appears beside a dialog, in the frame in which that opens, ends the program by an assertion
// of ImGui's (see kNeverAsksForFocus, which a tooltip cannot have).
bool may_have_tooltip() {
    return !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup) ||
           ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows | ImGuiFocusedFlags_NoPopupHierarchy);
}

// Round, whatever the window is that its row is in.
void begin_tooltip() {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ImGui::GetStyle().PopupRounding);
    ImGui::BeginTooltip();
    ImGui::PopStyleVar();
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
    if (refusal == kTooLittle) return (range.hard_min > 0 && least == "0" ? "Over " : "At least ") + least + ".";
    return range.typed == TypedKind::length ? "That is no length; write 210, 21cm or 8in."
                                            : "That is not a number; write 40000, 40k or 1.5M.";
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
    remember_refusal(refusal_of(typed, range));
    if (!typed) return false;
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

void close_on_escape() {
    if (key_pressed(Key::escape)) ImGui::CloseCurrentPopup();
}

// Once the mouse has come to rest on what it is about; moving on must not make it flicker.
// `beside`: a place left of which it stands, where there is room.
void show_tip(const char* text, bool hovered, std::optional<ImVec2> beside = {}) {
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
    const float width = kTipWidth * ImGui::GetFontSize(), air = ImGui::GetFontSize();
    if (beside && beside->x > width + 3 * air)
        ImGui::SetNextWindowPos({beside->x - 2 * air, beside->y}, ImGuiCond_Always, {1, 0});
    begin_tooltip();
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
    WidgetNotes* const told = notes();
    if (told && told->listed) {
        told->sections.resize(kind == FoldKind::section ? 0
                                                        : std::min<std::size_t>(told->sections.size(), 1));
        told->sections.emplace_back(title);
        return true;
    }
    float unit = ImGui::GetTextLineHeight() / 15;
    ImGui::Dummy({0, 2 * unit});
    ImGui::PushID(title);
    ImGuiStorage* storage = ImGui::GetStateStorage();
    ImGuiID state = ImGui::GetID("open");
    if (told && told->reveal && std::ranges::count(told->reveal->sections, title) > 0)
        storage->SetBool(state, true);
    bool open = storage->GetBool(state, open_at_first);
    ImVec2 start = ImGui::GetCursorScreenPos();
    float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetFrameHeight() + 3 * unit;
    if (press_area("title", {width, height})) storage->SetBool(state, open = !open);
    note_place(title);
    bool hot = ImGui::IsItemHovered();
    if (const RowKeys keys = item_keys("title keys"); keys.press || keys.step != 0)
        storage->SetBool(state, open = keys.press ? !open : keys.step > 0);
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

RowListing::RowListing(std::vector<ListedRow>& rows, const ListedRow* taken, int value)
    : notes_{.listed = &rows, .taken = taken, .value = value},
      before_(std::exchange(ImGui::GetIO().UserData, &notes_)) {}

RowListing::~RowListing() {
    ImGui::GetIO().UserData = before_;
}

void note_place(const char* label, const WidgetPlace& place) {
    if (WidgetNotes* const noted = notes()) noted->places[label] = place;
}

void new_frame() {
    constexpr float kLeastSeconds = 1e-5f;
    ImGuiIO& io = ImGui::GetIO();
    io.DeltaTime = std::max(io.DeltaTime, kLeastSeconds);
    ImGui::NewFrame();
    ImGuiContext& context = *ImGui::GetCurrentContext();
#if IMGUI_VERSION_NUM < 18800
    // A field that is typed in again begins anew.
    if (context.InputTextState.ID != context.ActiveId) context.InputTextState.ID = 0;
#elif IMGUI_VERSION_NUM >= 19000
    // Ctrl+Tab would list windows by names that are ours alone.
    context.ConfigNavWindowingKeyNext = context.ConfigNavWindowingKeyPrev = 0;
#endif
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

bool slider_row(const Setting& setting, double& value, const SliderNow& now) {
    const std::string tip = sentence_of(setting);
    SliderRange range = range_of(setting, now);
    if (!range.tip) range.tip = tip.c_str();
    return slider_row(setting.names.row, value, range);
}

bool slider_row(const Setting& setting, float& value, const SliderNow& now) {
    double wide = value;
    if (!slider_row(setting, wide, now)) return false;
    value = static_cast<float>(wide);
    return true;
}

bool slider_row(const Setting& setting, int& value, const SliderNow& now) {
    double wide = value;
    if (!slider_row(setting, wide, now)) return false;
    value = static_cast<int>(std::lround(wide));
    return true;
}

bool switch_row(const Setting& setting, bool& value) {
    return switch_row(setting.names.row, value, sentence_of(setting).c_str(), setting.usual != 0);
}

bool colour_row(const Setting& setting, glm::vec3& colour, const glm::vec3& usual) {
    return colour_row(setting.names.row, colour, sentence_of(setting).c_str(), usual);
}

bool switch_row(const char* label, bool& value, const char* tip, bool usual) {
    int on = value ? 1 : 0;
    if (const auto listed = as_listed(label, std::array{"off", "on"}, on)) {
        value = on == 1;
        return *listed;
    }
    Row row;
    const bool before = value;
    float height = std::floor(ImGui::GetTextLineHeight() * 1.1f), width = std::floor(height * 1.8f);
    if (begin_row(label, row, {.control_width = width})) value = usual;
    ImGui::SetCursorScreenPos({row.start.x + row.width - width, row.start.y});
    if (press_area("switch", {width, row.height})) value = !value;
    note_place(label);
    const RowKeys keys = keys_of(label, row);
    if (keys.press) value = !value;
    if (keys.step != 0) value = keys.step > 0;
    if (keys.reset) value = usual;
    ImVec2 min = ImGui::GetItemRectMin();
    float top = std::floor(min.y + (row.height - height) / 2), radius = height / 2;
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled({min.x, top}, {min.x + width, top + height},
                        colour_of(value ? ThemeColour::accent : ThemeColour::off), radius);
    list->AddCircleFilled({value ? min.x + width - radius : min.x + radius, top + radius}, radius * 0.72f,
                          colour_of(ThemeColour::panel), 24);
    show_row_tip(tip, row);
    end_row(row);
    return value != before;
}

bool choice_row(const char* label, int& chosen, std::span<const char* const> names, const char* tip,
                int usual) {
    return choice_row(label, chosen, names, tip,
                      ListLook{.by_arrows = static_cast<int>(names.size()), .usual = usual});
}

namespace {

/// The entries of an open list, the mark walked by arrows. Which one was taken; none: the list stays open.
std::optional<int> draw_list(int marked_at_first, std::span<const char* const> names, const ListLook& look) {
    ImGuiStorage* const storage = ImGui::GetStateStorage();
    const ImGuiID mark = ImGui::GetID("marked");
    const auto entries = static_cast<int>(names.size());
    const auto down = [](Key key) { return ImGui::IsKeyPressed(key_code(key), true) ? 1 : 0; };
    const int walked = down(Key::down) - down(Key::up);
    if (ImGui::IsWindowAppearing()) storage->SetInt(mark, marked_at_first);
    const int marked = std::clamp(storage->GetInt(mark) + walked, 0, std::max(entries - 1, 0));
    storage->SetInt(mark, marked);
    std::optional<int> taken;
    for (int i = 0; i < entries; ++i) {
        const char* const name = names[static_cast<std::size_t>(i)];
        const bool clicked = look.draw ? look.draw(i, i == marked) : ImGui::Selectable(name, i == marked);
        if (!look.draw) note_place(name);
        if (clicked) taken = i;
        if (i == marked && (walked != 0 || ImGui::IsWindowAppearing())) ImGui::SetScrollHereY();
    }
    if (key_pressed(Key::enter) || key_pressed(Key::keypad_enter)) taken = marked;
    if (taken) ImGui::CloseCurrentPopup();
    take_keyboard();
    return taken;
}

/// Opens the list of the combo box drawn last, as a click on it does.
void open_list(const char* combo) {
    ImGui::PushID(combo);
    const ImGuiID list = ImGui::GetID("##ComboPopup");
    ImGui::PopID();
    ImGui::OpenPopup(list);
}

}  // namespace

bool choice_row(const char* label, int& chosen, std::span<const char* const> names, const char* tip,
                const ListLook& look) {
    constexpr char kCombo[] = "##choice";
    const auto values = static_cast<std::size_t>(look.by_arrows);
    if (const auto listed = as_listed(label, names.first(std::min(values, names.size())), chosen))
        return *listed;
    Row row;
    const int before = chosen;
    const bool reset = begin_row(label, row);
    ImGui::SetNextItemWidth(row.start.x + row.width - row.control_x);
    bool valid = chosen >= 0 && chosen < static_cast<int>(names.size());
    if (look.lines_wide > 0) {
        const ImVec2 screen = ImGui::GetIO().DisplaySize;
        ImGui::SetNextWindowSizeConstraints(
            {std::min(look.lines_wide * ImGui::GetTextLineHeight(), screen.x), 0}, {screen.x, screen.y});
    }
    const bool open = ImGui::BeginCombo(kCombo, valid ? names[static_cast<std::size_t>(chosen)] : "",
                                        ImGuiComboFlags_HeightLarge);
    if (!open) note_place(label);
    if (open) {
        chosen = draw_list(chosen, names, look).value_or(chosen);
        close_on_escape();
        ImGui::EndCombo();
        note_place(label,
                   {{row.control_x, row.start.y}, {row.start.x + row.width, row.start.y + row.height}});
    }
    const RowKeys keys = keys_of(label, row);
    if (!open && (keys.press || (keys.step != 0 && look.by_arrows == 0))) open_list(kCombo);
    // As in other programs' lists, the arrows choose without opening it.
    if (look.by_arrows > 0) chosen = stepped(chosen, -keys.step, static_cast<std::size_t>(look.by_arrows));
    if ((reset || keys.reset) && look.usual >= 0) chosen = look.usual;
    if (!open) show_row_tip(tip, row);
    end_row(row);
    return chosen != before;
}

namespace {

/// Where each of some words side by side ends: all have the same air around them.
std::vector<float> segment_ends(float left, float right, std::span<const char* const> names) {
    float words = 0;
    for (const char* const name : names) words += ImGui::CalcTextSize(name).x;
    const auto count = static_cast<float>(names.size());
    const float air = (right - left - words) / count;
    std::vector<float> ends;
    float x = left;
    for (const char* const name : names) {
        // Where there is no room even for the words, all are cut alike.
        x += air > 0 ? ImGui::CalcTextSize(name).x + air : (right - left) / count;
        ends.push_back(std::floor(x + 0.5f));
    }
    return ends;
}

/// Whether the words fit into a row beside one another, if its label takes no more than its first letters.
bool have_room(std::span<const char* const> names) {
    const float line = ImGui::GetTextLineHeight();
    float words = 0;
    for (const char* const name : names) words += ImGui::CalcTextSize(name).x + kLeastSegmentAir * line;
    return words <= ImGui::GetContentRegionAvail().x - kLeastLabel * line;
}

/// How wide the control is: words that need more room than the labels' column leaves get what its label does
/// not need.
float segments_width(const char* label, std::span<const char* const> names) {
    const float line = ImGui::GetTextLineHeight(), row = ImGui::GetContentRegionAvail().x;
    float wanted = 0;
    for (const char* const name : names) wanted += ImGui::CalcTextSize(name).x + kSegmentAir * line;
    const float usual = row - std::floor(row * kLabelShare);
    const float most = row - std::ceil(ImGui::CalcTextSize(label).x) - std::floor(kLabelAir * line);
    return std::floor(std::clamp(wanted, usual, std::max(most, usual)));
}

}  // namespace

bool segmented_row(const char* label, int& chosen, std::span<const char* const> names, const char* tip,
                   int usual) {
    if (const auto listed = as_listed(label, names, chosen)) return *listed;
    if (!have_room(names)) return choice_row(label, chosen, names, tip, usual);
    Row row;
    const int before = chosen;
    const float width = segments_width(label, names);
    if (begin_row(label, row, {.control_width = width})) chosen = usual;
    ImDrawList* list = ImGui::GetWindowDrawList();
    const float left = row.start.x + row.width - width;
    float right = row.start.x + row.width, bottom = row.start.y + row.height;
    float rounding = ImGui::GetStyle().FrameRounding;
    const float pixel = ImGui::GetTextLineHeight() / 15;
    const bool greyed = ImGui::GetStyle().Alpha < 1;
    list->AddRectFilled({left, row.start.y}, {right, bottom}, colour_of(ThemeColour::track), rounding);
    const std::vector<float> ends = segment_ends(left, right, names);
    float x0 = left;
    for (int i = 0; i < static_cast<int>(names.size()); ++i) {
        const char* const name = names[static_cast<std::size_t>(i)];
        const float x1 = ends[static_cast<std::size_t>(i)];
        ImGui::SetCursorScreenPos({x0, row.start.y});
        if (press_area(name, {x1 - x0, row.height})) chosen = i;
        note_place(name);
        const bool on = chosen == i;
        // A greyed one is a tint under the word: pale letters on a pale colour could not be read.
        if (on)
            list->AddRectFilled(
                {x0 + 2 * pixel, row.start.y + 2 * pixel}, {x1 - 2 * pixel, bottom - 2 * pixel},
                greyed ? ImGui::GetColorU32(ImGuiCol_HeaderActive) : colour_of(ThemeColour::accent),
                rounding);
        const ImVec2 size = ImGui::CalcTextSize(name);
        const bool strong = on || ImGui::IsItemHovered();
        const auto colour = on && !greyed
                                ? colour_of(ThemeColour::panel)
                                : ImGui::GetColorU32(strong ? ImGuiCol_Text : ImGuiCol_TextDisabled);
        const float inset = std::max(pixel, (x1 - x0 - size.x) / 2);
        list->PushClipRect({x0 + pixel, row.start.y}, {x1 - pixel, bottom}, true);
        list->AddText({std::floor(x0 + inset), row.start.y + (row.height - size.y) / 2}, colour, name);
        list->PopClipRect();
        x0 = x1;
    }
    const RowKeys keys = keys_of(label, row);
    chosen = keys.reset ? usual : stepped(chosen, keys.step, names.size());
    show_row_tip(tip, row);
    end_row(row);
    return chosen != before;
}

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

bool wide_button(const char* label, const char* tip) {
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const Row row{start, ImGui::GetContentRegionAvail().x, ImGui::GetFrameHeight(), start.x};
    const bool pressed = key_button(label, {std::max(row.width, 1.0f), 0});
    note_place(label);
    show_row_tip(tip, row);
    return pressed;
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
