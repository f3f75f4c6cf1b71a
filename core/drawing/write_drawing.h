#pragma once
// A drawing on its way into a file.

#include <stop_token>
#include <vector>

#include "core/drawing/drawing.h"
#include "core/drawing/pipeline.h"
#include "core/drawing/settings.h"
#include "core/image/grid.h"
#include "core/output/drawing_format.h"
#include "core/output/findings.h"
#include "core/output/gcode.h"
#include "core/output/sheet.h"

namespace dapple {

// How the chosen G-code is written, and how a machine then moves.

/// Throws std::runtime_error if the pen is up where it is down: it would draw on its way between dots.
void check_heights(const SavingChoice& saving);

/// Throws what parse_gcode_template() throws.
GcodeStyle gcode_style_of(const SavingChoice& saving);

/// What a machine does that draws the file. One that reads G-code does what the template's lines say;
/// others move as their programs do. Throws what parse_gcode_template() throws.
GcodeProgram program_for(Machine machine, const DrawingToSave& drawing);

/// What someone should know of the program, of a drawing of so many straight pieces of lines that take so
/// long.
DrawingFacts::Gcode gcode_facts(const GcodeProgram& gcode, double segments, double drawing_s);

// A plan's dots on their way into a file, or into those of its sheets, for the window and `dapple render`:
//
//     plan ──► drawing ──► the dots of its page, a sheet or a region ──► in order ──► file
//
// Only the first step, Pipeline::drawing(), needs the pipeline, which may then go on with other drawings. It
// finds the scale; dots are placed for each part anew, except for Figure 8's and those of several pens.

/// Where on a page a file's drawing lies.
struct DrawnPage {
    PageLayout layout;
    Excerpt whole;
    Excerpt part;  // the sheet or the region that is drawn, or the whole
    std::vector<CutMark> cut_marks;

    bool draws_whole() const { return part.part == whole.part; }
};

/// Throws as sheet_of() does.
DrawnPage drawn_page(const PageLayout& layout, const Sheet& sheet = {});
/// The region that is chosen, or the whole. Throws as region_of() does, and for a region narrower or lower
/// than kShortestSideMm.
DrawnPage drawn_page(const PageLayout& layout, const SavingChoice& saving);

/// A rectangle on the page, in millimetres, seen from the excerpt's corner.
Rectangle<double> seen_from(const Excerpt& excerpt, const PageLayout& layout,
                            const Rectangle<double>& on_page);

/// Where dots are placed for what is written: on the part, and on the whole page for lines, which are cut off
/// at the part's edges.
const Excerpt& placed_on(const DrawnPage& page, const DrawingFile& file);

/// Whether the dots have to tell when they appear.
bool needs_thresholds(const DrawingFile& file);

/// What goes into the file of a drawing whose plan was made for it. Formats that are seen rather than plotted
/// also get the dots that reach over the part's edges from beside it. If stopped, some are missing.
DrawingToSave drawing_on(const DrawnPage& page, const PlannedDrawing& drawing, const DrawingFile& file,
                         const std::stop_token& stop = {});

// A page as a picture in memory: small ones, to be shown or to be part of a film.

/// 8 bits a channel, with the settings' ink and paper, of dots in the order given. The file is one of pixels.
Grid<glm::u8vec3> page_pixels(const DrawingToSave& drawing);

/// The resolution at which a page's longer side has so many pixels.
double dpi_for(const PageSize& page, int longer_side);

/// What the file shows of the drawing, which must outlive it; the dots come in their order. Throws if the
/// format cannot hold such a drawing.
InkPage ink_page(const DrawingToSave& drawing);

/// The crosses that each of several pens draws, if the settings ask for them.
std::vector<CutMark> registration_of(const DrawingToSave& drawing);

}  // namespace dapple
