#pragma once
// The page's margins and sheets as lines on it: over the canvas, behind ImGui's windows.

#include <glm/vec2.hpp>
#include <span>

#include "app/viewer/canvas/camera_mouse.h"
#include "app/viewer/canvas/canvas.h"
#include "app/viewer/view/camera.h"
#include "core/drawing/page_setup.h"
#include "core/output/sheet.h"

namespace dapple {

// The line between the two sides of the split view, with a handle to drag it by.

/// Draws it over the canvas and moves it with the mouse. `share`: of the canvas's width to its left; it stays
/// so far from the edges that the handle can always be reached. True while it moves.
bool draw_split_divider(float& share, const CanvasPlace& place);

// The pen of a plot that is shown, and where it came from.

/// Draws the pen at the last of the places, page units from the picture's corner, with a line through those
/// before it that fades.
void draw_pen_trail(std::span<const glm::dvec2> places, const Camera& camera, const CanvasPlace& place);

/// Nothing on a page without margins.
void draw_margin_lines(const PageLayout& layout, const Camera& camera, const CanvasPlace& place);

/// The edges of several sheets, the strips that they share tinted, and their names where there is room.
/// Nothing if they cannot be: see sheet_of().
void draw_sheet_lines(const PageLayout& layout, const Sheet& sheets, const Camera& camera,
                      const CanvasPlace& place);

}  // namespace dapple
