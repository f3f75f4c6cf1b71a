#pragma once
// All that the panels edit: the drawing's settings and how the window shows them. One value, read each frame.

#include <cstdint>
#include <optional>
#include <string>

#include "app/viewer/background/dots_request.h"
#include "core/drawing/settings.h"
#include "core/settings/fields.h"
#include "core/text/names.h"
#include "core/text/number_words.h"

namespace dapple {

// What the panels need to know of the drawing that is shown.

/// What the drawing on screen came to: where sliders start from when the person switches between scale and
/// count, or from the automatic radius to a fixed one.
struct DrawnInfo {
    std::uint64_t dots = 0;
    double scale = 0;
    double dot_radius_mm = 0;
    std::uint64_t most_dots = kMostDots;  // that the window takes on
    Tone tone{};                          // with the values that were chosen automatically
    int steps = 0;                        // of relaxation
    int usual_steps = 0;                  // of so many dots
    PageSize page{200, 150, 200};
};

/// Where dots that are sized otherwise start from: as large as they were drawn, about.
DotSize dot_size_from(DotSizing sizing, double drawn_radius_mm);

// The split view: to the right of a divider the same density with another tile, another placer or both.

enum class CompareBy {
    scale,
    count,  // of different dots; Figure 8 comes near it only
};
constexpr auto names_of(CompareBy) {
    return names("scale", "count");
}

struct Comparison {
    bool on = false;
    PlacerKind placer = PlacerKind::exact;  // these three of the right side
    std::string tile = "paper16";
    std::optional<RankingMethod> ranking;
    CompareBy by = CompareBy::scale;
    float divider = 0.5f;  // the left side's share of the canvas, 0..1

    bool operator==(const Comparison&) const = default;
};

/// Switched on or off. Where both sides would be alike the right one gets another tile: the paper's, which
/// repeats, or the default beside the paper's.
Comparison toggled(Comparison comparison, const DrawingSettings& left);

enum class ZoomMode {
    drawing,           // dots grow with the page
    constant_density,  // dots keep their size on screen, and more of them appear
};
constexpr auto names_of(ZoomMode) {
    return names("drawing", "constant_density");
}

/// The lens over the canvas; see loupe_square().
struct LoupeChoice {
    bool on = false;
    int step = 0;  // levels deeper than its own choice

    bool operator==(const LoupeChoice&) const = default;
};

struct ViewerSettings {
    DrawingSettings drawing;
    DensityChoice density = {};
    float picture_opacity = 0;  // of the photograph under the dots, 0..1
    ZoomMode zoom_mode = ZoomMode::drawing;
    DotColouring colouring = DotColouring::ink;
    int deepest_level = kDeepestStep;  // whose dots are shown; kDeepestStep: all
    Comparison comparison = {};
    LoupeChoice loupe = {};
    bool origins = false;  // of the dot under the pointer, on a card beside it
    SavingChoice saving = {};
    LengthUnit unit = LengthUnit::mm;  // that lengths are shown and typed in; settings are in millimetres
    bool every_frame = false;          // place anew and draw without rest, to see the honest cost

    bool operator==(const ViewerSettings&) const = default;
};

/// What the whole page is requested with.
DotsRequest dots_request(const ViewerSettings& settings);

// What the window's settings are called in files. A new field of one of these structs doesn't compile until
// it is named here.

/// "drawing", "saving" and, for the window alone, "view".
void describe(Fields& fields, ViewerSettings& settings);

/// Whose dialog asks for a file to open; where the desktop has none, our own.
enum class DialogChoice { own, desktop };
constexpr auto names_of(DialogChoice) {
    return names("own", "desktop");
}

}  // namespace dapple
