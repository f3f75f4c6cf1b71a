#pragma once
// The kinds of files that a drawing is saved in, what each can hold, and who writes it.

#include <array>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

#include "core/export.h"
#include "core/output/ink.h"
#include "core/text/names.h"

namespace dapple {

enum class DrawingFormat { svg, pdf, png, tiff, gcode, hpgl, dxf, csv, json };

struct FormatTraits {
    bool pixels = false;   // it has a resolution, and its dots have no order
    bool plotted = false;  // machines go from dot to dot in the file's order
    bool touched = false;  // they do, and touch the paper once for each dot
    bool table = false;    // it says when each dot appears, which the dots have to know
    bool paper = false;    // is painted under the dots if someone asks for it; pixels always have it
    bool text = false;     // needs no library, and a terminal can show it
};

struct DrawingFormatName {
    DrawingFormat format;
    const char* word;         // on the command line: "gcode"
    const char* shown;        // in the window: "G-code"
    const char* ending;       // ".gcode"
    std::string_view others;  // endings that are read the same: ".nc"; none: empty
    FormatTraits traits;
};

/// In the order of DrawingFormat, which is the one in which they are offered.
inline constexpr std::array<DrawingFormatName, 9> kDrawingFormats{{
    {DrawingFormat::svg, "svg", "SVG", ".svg", "", {.plotted = true, .paper = true, .text = true}},
    {DrawingFormat::pdf, "pdf", "PDF", ".pdf", "", {.paper = true}},
    {DrawingFormat::png, "png", "PNG", ".png", "", {.pixels = true}},
    {DrawingFormat::tiff, "tif", "TIFF", ".tif", ".tiff", {.pixels = true}},
    {DrawingFormat::gcode, "gcode", "G-code", ".gcode", ".nc", {.touched = true, .text = true}},
    {DrawingFormat::hpgl, "hpgl", "HPGL", ".hpgl", ".plt", {.touched = true, .text = true}},
    {DrawingFormat::dxf, "dxf", "DXF", ".dxf", "", {.plotted = true, .text = true}},
    {DrawingFormat::csv, "csv", "CSV", ".csv", "", {.table = true, .text = true}},
    {DrawingFormat::json, "json", "JSON", ".json", "", {.table = true, .text = true}},
}};

/// Its word on the command line.
constexpr auto names_of(DrawingFormat) {
    std::array<const char*, kDrawingFormats.size()> words{};
    for (std::size_t i = 0; i < words.size(); ++i) words[i] = kDrawingFormats[i].word;
    return words;
}

/// ".svg, .pdf, ... or .json", the other endings too.
DAPPLE_API std::string drawing_endings();

/// What an ending in lower case says, with its point; none if it is another.
DAPPLE_API std::optional<DrawingFormat> format_with_ending(std::string_view ending);

constexpr const FormatTraits& traits_of(DrawingFormat format) {
    return kDrawingFormats[static_cast<std::size_t>(format)].traits;
}
constexpr bool has_pixels(DrawingFormat format) {
    return traits_of(format).pixels;
}
constexpr bool is_touched(DrawingFormat format) {
    return traits_of(format).touched;
}
constexpr bool is_plotted(DrawingFormat format) {
    return traits_of(format).plotted || is_touched(format);
}
constexpr bool is_table(DrawingFormat format) {
    return traits_of(format).table;
}
constexpr bool has_optional_paper(DrawingFormat format) {
    return traits_of(format).paper;
}
constexpr bool is_text(DrawingFormat format) {
    return traits_of(format).text;
}
/// For machines alone, where an SVG is for people too.
constexpr bool is_for_machines(DrawingFormat format) {
    return is_plotted(format) && !has_optional_paper(format);
}
/// Colours of the drawing's own: it is seen rather than plotted, or both.
constexpr bool has_colours(DrawingFormat format) {
    return has_pixels(format) || has_optional_paper(format);
}

// The formats that need no library: PDF and pixels are written by io/files. Each needs the memory of a
// buffer.

/// What holds the settings in an SVG's <metadata>.
inline constexpr const char* kSvgSettingsElement = "dapple:settings";

/// For plotters' and illustrators' programs. The root has its size in millimetres and a viewBox; coordinates
/// are in px of 96 to the inch, so readers that ignore the viewBox are right too, and have two decimals, or
/// three where dots are dense. A dot is a circle, a stroke a path as wide as its pen and with round ends; a
/// touch is a line of 0.05 mm, since readers drop what has no length, and a radius is 0.001 px at least.
///
/// Each pen has a layer, a direct child of the root, numbered first in its label: "1 Black"; one of
/// transparent ink multiplies what lies below it. What no pen is to draw is in layers whose names begin with
/// %, which AxiDraw's software skips: the tiles' outlines in "% Tiles" and the background in "% Background".
/// The last layer has the cut marks: "2 Cut marks".
void write_svg(std::ostream& out, const InkPage& page, const WritingProgress& progress = {});

/// For CAD programs and for those of lasers and mills: ASCII DXF of AutoCAD 2000 (AC1015), the first release
/// whose files name their unit. A dot is a CIRCLE on the layer "Dots" (they keep the radii, and many lasers'
/// programs leave POINTs out), a stroke an LWPOLYLINE on "Lines", a touch a POINT. In millimetres
/// ($INSUNITS 4) with three decimals; the origin is the page's lower left corner. Several pens have a layer
/// each instead, "1_Cyan", in the nearest of the 255 colours that a DXF knows. A radius is 0.001 mm at least,
/// as readers refuse 0.
void write_dxf(std::ostream& out, const InkPage& page, const WritingProgress& progress = {});

/// Plotter units to the millimetre, which HPGL fixes.
inline constexpr int kHpglUnitsPerMm = 40;
/// The farthest place, in millimetres, that plotters of the language's first kind take: 32,767 units.
inline constexpr double kHpglReachMm = 32'767.0 / kHpglUnitsPerMm;

/// For pen plotters. The pen goes to each dot, down and up again: PU4000,2000;PD; (a PD to where the pen is
/// already is a line of no length, which some readers leave out). Whole plotter units, 0.025 mm; the origin
/// is the page's lower left corner. The dots' size is the pen's.
///
/// The comments stand at the beginning as CO "...";, and have no quotes or semicolons in them. Plotters of
/// the language's first kind do not know CO; the IN that follows clears such an error.
void write_hpgl(std::ostream& out, const InkPage& page, const WritingProgress& progress = {});

/// A line x_mm,y_mm,radius_mm,level,rank,critical_scale,page_width_mm,page_height_mm and a line a dot.
/// Numbers have as many digits as it takes to read back the very same: x_mm / mm_per_page_unit, rounded to
/// float, is the dot's x. The page's size is in every line: a comment or a line of its own would be taken for
/// a dot by many readers of tables, and an empty field is an error to some. Where several pens draw, a last
/// column has the pen's name. Dots need thresholds; strokes are left out.
void write_csv(std::ostream& out, const InkPage& page, const WritingProgress& progress = {});

/// The same for programs and web pages: {"page": {"width_mm": 200, "height_mm": 150}, "unit": "mm",
/// "columns": ["x_mm", ...], "dots": [[...], ...]}, an array for each dot on a line of its own. Where several
/// pens draw, "pens" lists their names, colours and widths, and the last column is the number of the dot's
/// pen there, from 0.
void write_dots_json(std::ostream& out, const InkPage& page, const WritingProgress& progress = {});

/// Lines as InkPage::gcode has them: see gcode.h. Comments are a line each, before all others; a stroke of
/// one point is a dot as large as its pen, and a single pen is in the machine as it begins. Lengths have
/// three decimals at most. Throws std::runtime_error if there are several pens, or lines to draw, and the
/// template has no lines for them.
void write_gcode(std::ostream& out, const InkPage& page, const WritingProgress& progress = {});

/// By the one of these that it is; is_text() only.
void write_as(DrawingFormat format, std::ostream& out, const InkPage& page,
              const WritingProgress& progress = {});

}  // namespace dapple
