#pragma once
// Pens of one's own in a file, for --pens FILE.
//
//     [{"name": "Sky",  "colour": "#3aa0d8", "width_mm": 0.3, "gap_mm": 0.6, "gain_mm": 0.05},
//      {"name": "Ochre", "colour": "#c08a2e"}]
//
// or a line for each, as --pens itself takes them: see parse_pen_list().

#include <filesystem>
#include <string>

#include "core/pens/pen.h"

namespace dapple {

/// What begins with [ or { is read as JSON. Throws std::runtime_error with a sentence that names the file,
/// the pen and the field that is wrong; one that is not known is wrong too.
PenChoice read_pens(const std::filesystem::path& file);

/// Such a file in JSON, of which read_pens() makes these pens again; their colours in 8 bits. Pens as
/// own_pens() takes them.
std::string pens_text(const Palette& pens);

}  // namespace dapple
