#include "app/viewer/widgets/widgets.h"

#include <imgui_internal.h>
#include <algorithm>
#include <array>
#include <utility>

#include "app/viewer/widgets/row.h"
#include "app/viewer/widgets/theme.h"

namespace dapple {

namespace {

std::string_view trimmed(std::string_view text) {
    const std::size_t first = std::min(text.find_first_not_of(' '), text.size());
    text.remove_prefix(first);
    return text.substr(0, text.find_last_not_of(' ') + 1);
}

// Where the first term ends: at the next sign, but not at the one of 1e-5.
std::size_t end_of_term(std::string_view text) {
    for (std::size_t i = 1; i < text.size(); ++i) {
        const bool sign = text[i] == '+' || text[i] == '-';
        if (sign && text[i - 1] != 'e' && text[i - 1] != 'E') return i;
    }
    return text.size();
}

// 2*210, 8in/2, from the left to the right. One factor is a length where one is wanted, and is not divided
// by.
std::optional<double> product_of(std::string_view term, TypedKind kind, LengthUnit bare) {
    const bool of_lengths = kind == TypedKind::length;
    double product = 1;
    bool has_length = !of_lengths, first = true;
    char sign = '*';
    while (true) {
        const std::size_t end = std::min(term.find_first_of("*/"), term.size());
        const std::string_view factor = trimmed(term.substr(0, end));
        std::optional<double> value = quantity_of(factor);
        if (kind == TypedKind::count && first && !count_of(factor)) return std::nullopt;
        first = false;
        // A number alone may still be the length: the last one is, if no other was.
        const bool last = end == term.size();
        if (of_lengths && sign == '*' && !has_length && (!value || last)) {
            value = millimetres_of(factor, bare);
            has_length = true;
        }
        if (!value || (sign == '/' && *value == 0)) return std::nullopt;
        product = sign == '*' ? product * *value : product / *value;
        if (last) break;
        sign = term[end];
        term.remove_prefix(end + 1);
    }
    if (has_length) return product;
    // 210/2: the numbers come to a length without a unit.
    return product * *millimetres_of("1", bare);
}

}  // namespace

std::optional<double> typed_value(std::string_view text, TypedKind kind, LengthUnit bare) {
    double sum = 0;
    text = trimmed(text);
    if (text.empty()) return std::nullopt;
    while (!text.empty()) {
        std::string_view term = text.substr(0, end_of_term(text));
        text.remove_prefix(term.size());
        double sign = 1;
        if (term.front() == '+' || term.front() == '-') {
            sign = term.front() == '-' ? -1 : 1;
            term.remove_prefix(1);
        }
        term = trimmed(term);
        const std::optional<double> value = product_of(term, kind, bare);
        if (!value) return std::nullopt;
        sum += sign * *value;
    }
    return sum;
}

namespace {

// What a switch's row is listed as, as as_listed() has it.
std::optional<bool> listed_switch(const char* label, bool& value) {
    int on = value ? 1 : 0;
    const std::optional<bool> listed = as_listed(label, std::array{"off", "on"}, on);
    value = on == 1;
    return listed;
}

bool switched(bool value, const RowKeys& keys, bool usual) {
    if (keys.reset) return usual;
    if (keys.step != 0) return keys.step > 0;
    return value != keys.press;
}

enum class FoldKind { section, within };

bool fold(const char* title, bool open_at_first, FoldKind kind, const char* shown = nullptr) {
    WidgetNotes* const told = widget_notes();
    if (told && told->listed) {
        told->sections.resize(kind == FoldKind::section ? 0
                                                        : std::min<std::size_t>(told->sections.size(), 1));
        told->listed->push_back({.sections = told->sections, .label = title, .is_section = true});
        told->sections.emplace_back(title);
        return true;
    }
    if (is_left_out()) return false;
    float unit = ImGui::GetTextLineHeight() / 15;
    ImGui::Dummy({0, 2 * unit});
    ImGui::PushID(title);
    ImGuiStorage* storage = ImGui::GetStateStorage();
    ImGuiID state = ImGui::GetID("open");
    if (told && told->reveal && std::ranges::count(told->reveal->sections, title) > 0)
        storage->SetBool(state, true);
    if (told && told->reveal && told->reveal->label == title && told->reveal->is_section) {
        storage->SetBool(state, true);
        ImGui::SetScrollHereY(0);
        told->reveal.reset();
    }
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
                  ImGui::GetColorU32(ImGuiCol_Text), shown ? shown : title);
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
    // In its first frame, which is not seen, a dialog has neither its size nor its place.
    const ImGuiWindow* const window = ImGui::GetCurrentWindowRead();
    if (window->Hidden && window->RootWindow->Flags & ImGuiWindowFlags_Modal) return;
    if (WidgetNotes* const noted = widget_notes()) noted->places[label] = place;
}

const ListedRow* row_to_reveal() {
    const WidgetNotes* const notes = widget_notes();
    return notes && notes->reveal ? &*notes->reveal : nullptr;
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

Absent::Absent(const char* reason) : notes_(widget_notes()) {
    if (notes_) before_ = std::exchange(notes_->absent, notes_->absent ? notes_->absent : reason);
}

Absent::~Absent() {
    if (notes_) notes_->absent = before_;
}

Greyed::Greyed(const char* reason) : reason_(reason), top_(ImGui::GetCursorScreenPos().y) {
    if (!reason_) return;
    ImGui::BeginDisabled();
    if (WidgetNotes* const notes = widget_notes()) before_ = std::exchange(notes->greyed, reason_);
}

Greyed::~Greyed() {
    if (!reason_) return;
    if (WidgetNotes* const notes = widget_notes()) notes->greyed = before_;
    ImGui::EndDisabled();
    const ImVec2 end = ImGui::GetCursorScreenPos();
    const ImVec2 last{end.x + ImGui::GetContentRegionAvail().x, end.y - ImGui::GetStyle().ItemSpacing.y};
    show_tip(reason_, ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect({end.x, top_}, last),
             TipPlace{{end.x, top_}});
}

void begin_bare(const char* name, ImVec2 corner, ImVec2 size, ImGuiWindowFlags more) {
    ImGui::SetNextWindowPos(corner);
    ImGui::SetNextWindowSize({std::max(size.x, 1.0f), std::max(size.y, 1.0f)});
    ImGui::Begin(name, nullptr,
                 kNeverAsksForFocus | ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | more);
}

void go_on_at(ImVec2 place) {
    ImGui::SetCursorScreenPos(place);
    ImGui::Dummy({0, 0});
    ImGui::SetCursorScreenPos(place);
}

bool press_area(const char* name, ImVec2 size) {
    return ImGui::InvisibleButton(name, {std::max(size.x, 1.0f), std::max(size.y, 1.0f)});
}

bool switch_row(const Setting& setting, bool& value) {
    return switch_row(setting.names.row, value, sentence_of(setting).c_str(), setting.usual != 0);
}

bool switch_row(const char* label, bool& value, const char* tip, bool usual) {
    if (const auto listed = listed_switch(label, value)) return *listed;
    Row row;
    const bool before = value;
    float height = std::floor(ImGui::GetTextLineHeight() * 1.1f), width = std::floor(height * 1.8f);
    if (begin_row(label, row, {.control_width = width})) value = usual;
    ImGui::SetCursorScreenPos({row.start.x + row.width - width, row.start.y});
    if (press_area("switch", {width, row.height})) value = !value;
    note_place(label);
    value = switched(value, keys_of(label, row), usual);
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

namespace {

// A lens-shaped outline around a pupil, crossed out where it is shut.
void draw_eye(ImVec2 middle, float half, bool open, ImU32 colour) {
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const float line = std::max(half / 6, 1.0f);
    const ImVec2 left{middle.x - half, middle.y}, right{middle.x + half, middle.y};
    for (const float side : {-1.0f, 1.0f})
        list->AddBezierQuadratic(left, {middle.x, middle.y + side * 1.15f * half}, right, colour, line);
    list->AddCircleFilled(middle, half / 3, colour, 16);
    if (!open)
        list->AddLine({left.x, middle.y + half * 0.7f}, {right.x, middle.y - half * 0.7f}, colour, line);
}

}  // namespace

bool eye_row(const char* label, const std::string& name, const glm::vec3& swatch, const std::string& words,
             bool& seen, const char* tip) {
    if (const auto listed = listed_switch(label, seen)) return *listed;
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float line = ImGui::GetTextLineHeight(), unit = line / 15;
    const Row row{start, ImGui::GetContentRegionAvail().x, ImGui::GetFrameHeight(), start.x};
    const bool before = seen;
    ImGui::PushID(label);
    if (press_area("eye", {row.width, row.height})) seen = !seen;
    note_place(label);
    const bool hot = ImGui::IsItemHovered();
    seen = switched(seen, keys_of(label, row), true);
    ImDrawList* const list = ImGui::GetWindowDrawList();
    const float y = start.y + (row.height - line) / 2, eye = 7 * unit, right = start.x + row.width - 2 * eye;
    const ImVec2 low{start.x, y}, high{start.x + line, y + line};
    list->AddRectFilled(low, high, ImGui::ColorConvertFloat4ToU32({swatch.r, swatch.g, swatch.b, 1}),
                        3 * unit);
    list->AddRect(low, high, colour_of(ThemeColour::off), 3 * unit, 0, unit);
    const ImU32 text = colour_of(seen ? ThemeColour::text : ThemeColour::quiet);
    const float number = right - 10 * unit - ImGui::CalcTextSize(words.c_str()).x;
    const float words_begin = high.x + 8 * unit;
    list->PushClipRect({words_begin, start.y},
                       {std::max(number - 6 * unit, words_begin), start.y + row.height}, true);
    list->AddText({words_begin, y}, text, name.c_str());
    list->PopClipRect();
    list->PushClipRect({words_begin, start.y}, {right, start.y + row.height}, true);
    list->AddText({number, y}, colour_of(ThemeColour::quiet), words.c_str());
    list->PopClipRect();
    draw_eye({right + eye, start.y + row.height / 2}, eye, seen,
             colour_of(hot || seen ? ThemeColour::text : ThemeColour::quiet));
    show_row_tip(tip, row);
    end_row(row);
    return seen != before;
}

bool wide_button(const char* label, const char* tip) {
    if (is_left_out()) return false;
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

bool subsection(const char* title, bool open_at_first, const char* shown) {
    return fold(title, open_at_first, FoldKind::within, shown);
}

void tip(const char* text) {
    show_tip(text, ImGui::IsItemHovered());
}

void tip_beside(ImVec2 row, const char* text) {
    show_tip(text, ImGui::IsItemHovered(), TipPlace{row});
}

void tip_above(const char* text) {
    const ImVec2 point{ImGui::GetItemRectMin().x, ImGui::GetWindowPos().y};
    show_tip(text, ImGui::IsItemHovered(), TipPlace{point, TipPlace::Side::above});
}

void keep_tips_above(float y) {
    if (WidgetNotes* const notes = widget_notes()) notes->tips_end = y;
}

void hint(const char* text) {
    if (is_left_out()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::TextWrapped("%s", in_lines(text, ImGui::GetContentRegionAvail().x).c_str());
    ImGui::PopStyleColor();
}

void draw_shadow(ImDrawList* list, ImVec2 low, ImVec2 high) {
    const float unit = ImGui::GetFontSize() / 15;
    for (const float spread : {6 * unit, 3 * unit, unit})
        list->AddRectFilled({low.x - spread, low.y - spread}, {high.x + spread, high.y + spread},
                            IM_COL32(0, 0, 0, 22), 8 * unit);
}

std::string in_lines(std::string text, float width) {
    std::size_t line = 0, space = text.npos;
    for (std::size_t i = 0; i <= text.size(); ++i) {
        const char end = text.c_str()[i];
        if (end != ' ' && end != '\n' && end != '\0') continue;
        if (space != text.npos && ImGui::CalcTextSize(text.data() + line, text.data() + i).x > width) {
            text[space] = '\n';
            line = space + 1;
        }
        space = i;
        if (end != '\n') continue;
        line = i + 1;
        space = text.npos;
    }
    return text;
}

}  // namespace dapple
