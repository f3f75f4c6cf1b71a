#pragma once
// The panels' own widgets: rows that line up, a label to the left and the control to the right.
//
//     Brightness   ────────●──────────   0.12
//     label        track (drag, click)   value (click to type)
//
// Double-click on the label brings the neutral value back; Ctrl+click on the track types into it.

#include <imgui.h>
#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <span>
#include <string>

#include "app/viewer/widgets/typed_value.h"

namespace dapple {

/// Where a widget's active part was drawn, in window coordinates: how a test knows where to click.
struct WidgetPlace {
    glm::vec2 min{}, max{};
    bool operator==(const WidgetPlace&) const = default;
};

/// Collects the places of the widgets drawn in a frame, by label, when ImGui's io.UserData points to one.
using WidgetPlaces = std::map<std::string, WidgetPlace>;

/// Notes the item drawn last under a label, or a place.
void note_place(const char* label);
void note_place(const char* label, const WidgetPlace& place);

enum class SliderCurve { linear, logarithmic };

struct SliderRange {
    double min = 0, max = 1;  // of the track
    double neutral = 0;       // what double-click on the label brings back; the filled track starts here
    SliderCurve curve = SliderCurve::linear;
    const char* format = "%.2f";
    double hard_min = min, hard_max = max;  // what can be typed
    TypedKind typed = TypedKind::number;
    bool grouped = false;       // a whole number shown as 40,000
    const char* tip = nullptr;  // what a mouse at rest on the row is told
};

/// Rows made while it lives cannot be used, and say why to a mouse that rests on them: they stay where they
/// are, so that nothing moves under the pointer when what they depend on is changed.
class Greyed {
 public:
    /// Without a reason the rows are as ever.
    explicit Greyed(const char* reason);
    ~Greyed();
    Greyed(const Greyed&) = delete;
    Greyed& operator=(const Greyed&) = delete;

 private:
    const char* reason_;
    float top_ = 0;
};

/// Of every window that is no dialog: one that asks for the focus when it appears, in the frame in which a
/// dialog opens, ends the program by an assertion of ImGui's.
inline constexpr ImGuiWindowFlags kNeverAsksForFocus = ImGuiWindowFlags_NoFocusOnAppearing;

/// A place that can be pressed, drawn by others; at least a pixel large, as ImGui insists, however small the
/// window is.
bool press_area(const char* name, ImVec2 size);

/// Position 0..1 on the track of a value, clamped, and the value at a position.
double track_position(double value, const SliderRange& range);
double track_value(double position, const SliderRange& range);

/// A slider row. True while it changes the value.
bool slider_row(const char* label, double& value, const SliderRange& range);
bool slider_row(const char* label, float& value, const SliderRange& range);

/// A tick box row. True when toggled. A row's tip is what a mouse at rest on it is told.
bool switch_row(const char* label, bool& value, const char* tip = nullptr);

/// A list to choose from. True when another entry was chosen.
bool choice_row(const char* label, int& chosen, std::span<const char* const> names,
                const char* tip = nullptr);

/// Two to four choices side by side. True when another was chosen.
bool segmented_row(const char* label, int& chosen, std::span<const char* const> names,
                   const char* tip = nullptr);

/// A colour with a picker behind it; sRGB-encoded 0..1.
bool colour_row(const char* label, glm::vec3& colour, const char* tip = nullptr);

/// A section's title with a line above; a click folds the section. Returns whether it is open.
bool section(const char* title, bool open_at_first = true);

/// The same within a section.
bool subsection(const char* title, bool open_at_first = true);

/// More about the item drawn last, while the mouse rests on it.
void tip(const char* text);

/// Small grey text under a control.
void hint(const char* text);

}  // namespace dapple
