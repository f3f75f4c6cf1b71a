#pragma once
// Settings as JSON, as Dapple's projects hold them, and what there is to report of drawings, by the same
// names:
//
//     {"drawing": {"count": 20000, "pens": "cmyk", "tone": {"contrast": 0.2}, "page": {"paper": "A4"}},
//      "saving": {"dpi": 150}}

#include <span>
#include <string>
#include <string_view>

#include "core/drawing/settings.h"
#include "core/drawing/stippler.h"
#include "core/export.h"
#include "core/output/findings.h"

namespace dapple {

/// Changes what the text says, a JSON object with "drawing", "saving" or both, and leaves the rest;
/// Settings::embedded are then those that are not as usual. A project's other fields have no say. Throws
/// std::runtime_error with one sentence that names the field, what is wrong and what to give; nothing is
/// changed then. A field that is not known is wrong.
DAPPLE_API void read_json(std::string_view json, Settings& settings);

/// The usual settings but for what the text says.
DAPPLE_API Settings settings_of(std::string_view json = "{}");

/// All fields, on many lines.
DAPPLE_API std::string json_of(const Settings& settings);

/// What the program's window says of each field that has a row there, for programs with rows of their own:
/// {"drawing.tone.contrast": {"row": "Contrast", "tip": "Above 0 parts light from dark, ...", "least": -1,
/// "most": 1, "from": -1, "to": 1, "format": "%.2f"}, ...}. `from` and `to`: how far a slider goes, by ratios
/// if "logarithmic" is true; "unit": "mm" of lengths. Of fields that are one of some words: "choices".
DAPPLE_API std::string rows_json();

/// {"dots": 20000, "lowered": false, "steps": 7, "page_mm": [200, 150], "radius_mm": 0.3, "pens": [{"name":
/// "Black", "colour": [0, 0, 0]}], "tone": the fields of the settings' tone as drawn}. `dots`: of a plan
/// about so many where no count is asked for. `lowered`: more were asked for than there may be. `radius_mm`:
/// of all dots, or of the largest. `colour`: sRGB-encoded, 0..1.
DAPPLE_API std::string report_json(const DrawingPlan& plan, const DrawingSettings& settings);
DAPPLE_API std::string report_json(const Drawing& drawing);

/// [{"kind": "overlap", "text": "40 % of the dots run into others; fewer dots part them", "amount": 9000}].
DAPPLE_API std::string report_json(std::span<const Finding> findings);

}  // namespace dapple
