#include "app/viewer/panels/crop_rows.h"

#include <array>

#include "app/viewer/model/crop_percent.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {
namespace {

// One side, away from the edge that it belongs to.
bool side_row(const char* label, double& percent, double edge, const char* tip) {
    return slider_row(label, percent,
                      {.min = 0,
                       .max = 100,
                       .neutral = edge,
                       .format = "%.1f",
                       .hard_min = 0,
                       .hard_max = 100,
                       .tip = tip});
}

}  // namespace

bool draw_rotate_row(int& quarter_turns) {
    return segmented_row("Rotate", quarter_turns, std::array{"0", "90", "180", "270"},
                         "Turns the picture on the page, in degrees clockwise.");
}

bool draw_crop_rows(std::optional<Crop>& crop, glm::ivec2 picture, bool& framing) {
    if (!subsection("Crop", false)) {
        framing = false;
        return false;
    }
    switch_row("Crop frame", framing,
               "Shows all of the picture, with a frame around what is drawn: drag its edges, its corners or "
               "all of it.");
    Rectangle<double> box = crop_percent(crop, picture);
    bool changed =
        side_row("From left, %", box.low.x, 0, "In percent of the picture's width, before it is turned.");
    changed |=
        side_row("From top, %", box.low.y, 0, "In percent of the picture's height, before it is turned.");
    changed |=
        side_row("To right, %", box.high.x, 100, "In percent of the picture's width, before it is turned.");
    changed |=
        side_row("To bottom, %", box.high.y, 100, "In percent of the picture's height, before it is turned.");
    if (changed) crop = crop_of_percent(box);
    return changed;
}

}  // namespace dapple
