#include "app/viewer/panels/pen_panel.h"

#include "app/viewer/widgets/widgets.h"

namespace dapple {
bool draw_pen_panel(DrawingSettings& settings) {
    if (!section("Pens")) return false;
    const bool ink = colour_row("Ink", settings.ink, "The dots' colour, on screen and in the file.", kBlack);
    return colour_row("Paper", settings.paper,
                      "What lies under the dots; in a file only where you ask for it.", kWhite) ||
           ink;
}

}  // namespace dapple
