#pragma once
// The panels' own widgets: rows that line up, a label to the left and the control to the right.
//
//     Brightness   ────────●──────────   0.12
//     label        track (drag, click)   value (click to type)
//
// Double-click on a row's label, or Backspace while it has the keys, brings its usual value back; Ctrl+click
// on a track types into it. A mouse at rest on a row is told its tip: one sentence that teaches.

#include <imgui.h>
#include <cmath>
#include <concepts>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/settings/setting.h"
#include "core/text/number_words.h"

namespace dapple {

// What is typed into a row's value.

enum class TypedKind {
    number,
    count,   // as count_of() reads it, where each number that is added or taken away begins: not 10.000,
             // nor 2.5
    length,  // comes back in millimetres: 8in, 21cm, 595pt
};

/// A number as people write it, or several, added, taken away, multiplied and divided: 40k, 1.5M, 40,000,
/// 210-15-15, 2*210, 8in/2, 8in+5mm. `bare` is what a length without a unit is in. Nothing if it is none of
/// that.
std::optional<double> typed_value(std::string_view text, TypedKind kind, LengthUnit bare = LengthUnit::mm);

/// Where a widget's active part was drawn, in window coordinates: how a test knows where to click.
struct WidgetPlace {
    glm::vec2 min{}, max{};
    bool operator==(const WidgetPlace&) const = default;
};

/// The places of the widgets drawn in a frame, by label.
using WidgetPlaces = std::map<std::string, WidgetPlace>;

/// A row as a list of all of them tells it.
struct ListedRow {
    std::vector<std::string> sections{};  // that it is in, the outer one first
    std::string label{};
    std::vector<std::string> values{};  // one of which can be chosen; none: it takes more than a choice
    int chosen = -1;                    // of these, at present
    std::string why_not{};              // it cannot be used now; empty: it can
    bool is_section = false;            // a title that rows stand under

    bool operator==(const ListedRow&) const = default;
};

/// What rows tell of themselves, and are asked for, beside being drawn: ImGui's io.UserData points to one, or
/// to nothing.
struct WidgetNotes {
    WidgetPlaces places{};
    ImGuiID row_with_keys = 0;                 // see row_keys.h; 0: none
    std::vector<ListedRow>* listed = nullptr;  // see RowListing
    std::vector<std::string> sections{};       // that listed rows are in
    const ListedRow* taken = nullptr;          // the listed row that is to have `value`
    int value = -1;
    std::optional<ListedRow> reveal{};  // is to be shown: its sections unfold, and it gets the keys
    std::optional<float> tips_end{};    // see keep_tips_above()
    const char* absent = nullptr;       // see Absent
    const char* greyed = nullptr;       // see Greyed
};

/// While it lives rows are not drawn and folds are open: each adds itself to a list. One of them, as such a
/// list has it, may be told to take one of its values.
class RowListing {
 public:
    RowListing(std::vector<ListedRow>& rows, const ListedRow* taken = nullptr, int value = -1);
    ~RowListing();
    RowListing& operator=(RowListing&&) = delete;

 private:
    WidgetNotes notes_{};
    void* before_ = nullptr;
};

/// The row that is to be shown, which its column turns to; null: none.
const ListedRow* row_to_reveal();

/// ImGui::NewFrame(), guarded against what a person's typing or a clock could end the program by: some
/// releases take a text field's old undo steps for those of another text, and insist that time passes.
void new_frame();

/// Notes the item drawn last under a label, or a place, unless it is in a dialog that is not seen yet.
void note_place(const char* label);
void note_place(const char* label, const WidgetPlace& place);

enum class SliderCurve { linear, logarithmic };

struct SliderRange {
    double min = 0, max = 1;  // of the track
    double neutral = 0;       // the usual value; the filled track starts here
    SliderCurve curve = SliderCurve::linear;
    const char* format = "%.2f";
    double hard_min = min, hard_max = max;  // what can be typed; what is not is the nearest that can,
    TypedKind typed = TypedKind::number;    // but for a count, which then stays as it is
    LengthUnit unit = LengthUnit::mm;  // that lengths are shown and typed in; all above is in millimetres
    bool grouped = false;              // a whole number shown as 40,000
    const char* tip = nullptr;
};

/// Rows made while it lives are left out, if there is a reason to: what does not apply is not there. Only a
/// list of all rows has them, with the reason (RowListing). They come after the row that brings them back, so
/// that nothing moves under the pointer when that is used.
class Absent {
 public:
    /// Without a reason the rows are there as usual.
    explicit Absent(const char* reason);
    ~Absent();
    Absent& operator=(Absent&&) = delete;

 private:
    WidgetNotes* notes_;
    const char* before_ = nullptr;
};

/// Rows made while it lives cannot be used, and say why to a mouse that rests on them: for those that stand
/// before the row which they depend on, and so keep their place.
class Greyed {
 public:
    /// Without a reason the rows can be used as usual.
    explicit Greyed(const char* reason);
    ~Greyed();
    Greyed& operator=(Greyed&&) = delete;

 private:
    const char *reason_, *before_ = nullptr;
    float top_ = 0;
};

/// A flag for every window that is no dialog: one that asks for the focus when it appears, in the frame in
/// which a dialog opens, ends the program by an assertion of ImGui's.
inline constexpr ImGuiWindowFlags kNeverAsksForFocus = ImGuiWindowFlags_NoFocusOnAppearing;

/// ImGui::Begin() of a bare window that stays at its place, at least a pixel large.
void begin_bare(const char* name, ImVec2 corner, ImVec2 size, ImGuiWindowFlags more = 0);

/// A place that can be pressed, drawn by others; at least a pixel large, as ImGui insists, however small the
/// window is.
bool press_area(const char* name, ImVec2 size);

/// What is drawn next begins there, and what scrolls reaches down to it.
void go_on_at(ImVec2 place);

/// Position 0..1 on the track of a value, clamped, and the value at a position.
double track_position(double value, const SliderRange& range);
double track_value(double position, const SliderRange& range);

/// A slider row. True while it changes the value. A length's label goes on with its unit: "Margin" is shown
/// as "Margin, mm".
bool slider_row(const char* label, double& value, const SliderRange& range);
bool slider_row(const char* label, float& value, const SliderRange& range);
/// Of whole numbers, typed as counts; true while it changes to another one.
template <std::integral Whole>
bool slider_row(const char* label, Whole& value, SliderRange range) {
    const Whole before = value;
    auto wide = static_cast<double>(value);
    range.typed = TypedKind::count;
    if (slider_row(label, wide, range)) value = static_cast<Whole>(std::llround(wide));
    return value != before;
}

/// The tip of a setting's row.
std::string sentence_of(const Setting& setting);

/// What depends on the moment in a setting's row.
struct SliderNow {
    std::optional<double> usual = {};  // none: the setting's
    std::optional<double> most = {};   // that can be typed, if less than the setting's
    std::optional<Track> track = {};   // none: the setting's
    const char* format = nullptr;      // none: the setting's
    LengthUnit unit = LengthUnit::mm;  // that lengths are shown and typed in
    const char* tip = nullptr;         // none: the setting's help
};
SliderRange range_of(const Setting& setting, const SliderNow& now = {});
template <class Number>
bool slider_row(const Setting& setting, Number& value, const SliderNow& now = {}) {
    const std::string tip = sentence_of(setting);
    SliderRange range = range_of(setting, now);
    if (!range.tip) range.tip = tip.c_str();
    return slider_row(setting.names.row, value, range);
}

/// A tick box row. True when its value changed.
bool switch_row(const char* label, bool& value, const char* tip, bool usual = false);
bool switch_row(const Setting& setting, bool& value);

/// A row of what can be seen or hidden: a swatch of its colour, its name, words about it, and an eye. True
/// when that was opened or shut. `label` is what lists of all rows call it.
bool eye_row(const char* label, const std::string& name, const glm::vec3& swatch, const std::string& words,
             bool& seen, const char* tip);

/// A list to choose from. True when another entry was chosen. Enter or Space opens it, arrows walk it, Enter
/// takes an entry and Escape none; while it is closed the arrows choose at once.
bool choice_row(const char* label, int& chosen, std::span<const char* const> names, const char* tip,
                int usual = 0);

/// Draws an entry, which is marked or not; true if it was clicked. Called for each, in order, while the list
/// is open.
using DrawEntry = std::function<bool(int entry, bool marked)>;

/// How a list differs from one of plain names.
struct ListLook {
    float lines_wide = 0;  // of the entries, in heights of a line of text; 0: as the row
    DrawEntry draw = {};   // none: by their names
    /// So many of the first entries are what arrows choose while the list is closed; others do something,
    /// which has to be meant. None: the arrows open the list.
    int by_arrows = 0;
    int usual = -1;  // -1: no entry is
};
bool choice_row(const char* label, int& chosen, std::span<const char* const> names, const char* tip,
                const ListLook& look);

/// Two to five short choices side by side, as wide as their words ask for. True when another was chosen. For
/// more of them choice_row() has the room, which it becomes in a window that is too narrow for the words.
bool segmented_row(const char* label, int& chosen, std::span<const char* const> names, const char* tip,
                   int usual = 0);

/// The same for an enumeration, whose values are named in their order.
template <class Value>
requires std::is_enum_v<Value>
bool choice_row(const char* label, Value& chosen, std::span<const char* const> names, const char* tip) {
    int index = static_cast<int>(chosen);
    const bool changed = choice_row(label, index, names, tip);
    chosen = static_cast<Value>(index);
    return changed;
}
template <class Value>
requires std::is_enum_v<Value>
bool segmented_row(const char* label, Value& chosen, std::span<const char* const> names, const char* tip,
                   Value usual = {}) {
    int index = static_cast<int>(chosen);
    const bool changed = segmented_row(label, index, names, tip, static_cast<int>(usual));
    chosen = static_cast<Value>(index);
    return changed;
}

/// ImGui::InputText() for a text of any bytes, such as a file's name, which is edited as editable() has it.
bool bytes_box(const char* name, std::string& bytes, ImGuiInputTextFlags flags = 0,
               ImGuiInputTextCallback callback = nullptr, void* data = nullptr);

/// A text, taken at each letter that leaves it a good one: `is_good` says so, and `wrong` what it should be,
/// while it is none. True when it changed. Without a usual text there is none to bring back.
bool text_row(const char* label, std::string& text, const std::function<bool(const std::string&)>& is_good,
              const char* wrong, const char* tip, const char* usual = nullptr);

/// A colour with a picker behind it; sRGB-encoded 0..1. Without a usual one there is none to bring back.
bool colour_row(const char* label, glm::vec3& colour, const char* tip,
                const std::optional<glm::vec3>& usual = {});
bool colour_row(const Setting& setting, glm::vec3& colour, const glm::vec3& usual);

/// A button over the whole row, which Space and Enter press too.
bool wide_button(const char* label, const char* tip);

/// A section's title with a line above; a click folds the section. Returns whether it is open.
bool section(const char* title, bool open_at_first = true);

/// The same within a section; `shown` in place of the title, which is its name, where that changes.
bool subsection(const char* title, bool open_at_first = true, const char* shown = nullptr);

/// More about the item drawn last, while the mouse rests on it.
void tip(const char* text);
/// The same beside the row that begins there, as rows have it: for items that share a row.
void tip_beside(ImVec2 row, const char* text);
/// The same above the ImGui window that the item is in: a bar, which a tip at the mouse would cover.
void tip_above(const char* text);

/// Tips beside rows end above that height: what lies below is not to be covered by them.
void keep_tips_above(float y);

/// Small grey text under a control.
void hint(const char* text);

/// Around a card that lies over others, so that it stands out from them.
void draw_shadow(ImDrawList* list, ImVec2 low, ImVec2 high);

/// The text with line ends in place of spaces where it would be wider than `width`, in pixels. ImGui alone
/// also ends lines within numbers, behind "0.".
std::string in_lines(std::string text, float width);

}  // namespace dapple
