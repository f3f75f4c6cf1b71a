#pragma once
// The kinds of files that a drawing is saved in, and what each can hold.

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/export.h"
#include "core/text/names.h"

namespace dapple {

enum class DrawingFormat { svg, pdf, png, tiff, gcode, hpgl, dxf, csv, json };

struct DrawingFormatName {
    DrawingFormat format;
    const char* word;         // on the command line: "gcode"
    const char* shown;        // in the window: "G-code"
    const char* ending;       // ".gcode"
    std::string_view others;  // endings that are read the same: ".nc"; none: empty
};

/// In the order of DrawingFormat, which is the one in which they are offered.
inline constexpr std::array<DrawingFormatName, 9> kDrawingFormats{{
    {DrawingFormat::svg, "svg", "SVG", ".svg", ""},
    {DrawingFormat::pdf, "pdf", "PDF", ".pdf", ""},
    {DrawingFormat::png, "png", "PNG", ".png", ""},
    {DrawingFormat::tiff, "tif", "TIFF", ".tif", ".tiff"},
    {DrawingFormat::gcode, "gcode", "G-code", ".gcode", ".nc"},
    {DrawingFormat::hpgl, "hpgl", "HPGL", ".hpgl", ".plt"},
    {DrawingFormat::dxf, "dxf", "DXF", ".dxf", ""},
    {DrawingFormat::csv, "csv", "CSV", ".csv", ""},
    {DrawingFormat::json, "json", "JSON", ".json", ""},
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

/// PNG, TIFF: it has a resolution, and its dots have no order.
DAPPLE_API bool has_pixels(DrawingFormat format);
/// SVG, G-code, HPGL, DXF: machines go from dot to dot in the file's order.
DAPPLE_API bool is_plotted(DrawingFormat format);
/// G-code, HPGL: machines touch the paper once for each dot.
DAPPLE_API bool is_touched(DrawingFormat format);
/// CSV, JSON: it says when each dot appears, which the dots have to know.
DAPPLE_API bool is_table(DrawingFormat format);
/// SVG, PDF: paper is painted under the dots if someone asks for it. Pixels always have it.
DAPPLE_API bool has_optional_paper(DrawingFormat format);
/// Those, PNG and TIFF.
DAPPLE_API bool has_colours(DrawingFormat format);
/// No text: a terminal can make nothing of it.
DAPPLE_API bool is_binary(DrawingFormat format);

}  // namespace dapple
