#pragma once
// The tool "Crop": what of the picture is drawn, and how it is turned.

#include <glm/vec2.hpp>

#include "app/viewer/model/crop_percent.h"
#include "core/drawing/page_setup.h"

namespace dapple {

/// What of a picture of so many pixels is drawn, in percent of its width and height. `room`: the page's
/// within its margins, in the direction in which the picture was opened. True when crop or turns changed.
bool draw_crop_rows(PageSetup& setup, CropTool& tool, glm::ivec2 picture, glm::dvec2 room);

}  // namespace dapple
