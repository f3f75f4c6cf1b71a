#pragma once
// A drawing of the window's as it goes into a file: the page or a sheet of it, seen from its own corner.

#include <glm/vec2.hpp>

#include "app/viewer/model/placed_drawing.h"
#include "core/output/sheet.h"

namespace dapple {

struct DrawnSheet {
    PageSize page;              // the sheet's
    Rectangle<double> picture;  // page units: where it ends
    glm::dvec2 corner_mm{0};    // of the sheet, from the page's
};

/// Which dots are left, seen from where.
enum class SheetDots {
    own,          // of the sheet
    reaching,     // and those beside it that reach onto it
    of_the_page,  // all, seen from the page's corner: lines from dot to dot are cut later
};

/// Moves dots and outlines from the picture's corner to the sheet's, and leaves out the others.
DrawnSheet see_sheet(PlacedDrawing& drawing, const Sheet& sheet = {}, SheetDots dots = SheetDots::own);

}  // namespace dapple
