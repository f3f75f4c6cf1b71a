#pragma once
// Points from drawings that this program saved, which say themselves how large their page is.

#include <string>
#include <string_view>

#include "lab/analysis/point_table.h"

namespace dapple {

/// Dots in millimetres from the page's corner; the page is a window. Those of a file that dapple render wrote
/// as .json (core/output/drawing_format.h). Throws std::runtime_error with one sentence, naming the file, if
/// it is none or has no dots.
PlacedPoints points_of_json(std::string_view text, const std::string& name);

/// The same for .svg (core/output/drawing_format.h): its circles. They are rounded to some thousandths of a
/// millimetre.
PlacedPoints points_of_svg(std::string_view text, const std::string& name);

}  // namespace dapple
