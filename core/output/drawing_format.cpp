#include "core/output/drawing_format.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>
#include <vector>

namespace dapple {

std::string drawing_endings() {
    std::vector<std::string_view> endings;
    for (const DrawingFormatName& each : kDrawingFormats) {
        endings.emplace_back(each.ending);
        if (!each.others.empty()) endings.push_back(each.others);
    }
    const std::string_view last = endings.back();
    endings.pop_back();
    return fmt::format("{} or {}", fmt::join(endings, ", "), last);
}

std::optional<DrawingFormat> format_with_ending(std::string_view ending) {
    for (const DrawingFormatName& each : kDrawingFormats)
        if (!ending.empty() && (ending == each.ending || ending == each.others)) return each.format;
    return std::nullopt;
}

void write_as(DrawingFormat format, std::ostream& out, const InkPage& page, const WritingProgress& progress) {
    switch (format) {
        case DrawingFormat::svg:
            return write_svg(out, page, progress);
        case DrawingFormat::csv:
            return write_csv(out, page, progress);
// The page in the browser saves none of these, and is to stay small.
#ifndef DAPPLE_FOR_BROWSERS
        case DrawingFormat::gcode:
            return write_gcode(out, page, progress);
        case DrawingFormat::hpgl:
            return write_hpgl(out, page, progress);
        case DrawingFormat::dxf:
            return write_dxf(out, page, progress);
        case DrawingFormat::json:
            return write_dots_json(out, page, progress);
#endif
        default:
            throw std::logic_error("no text");
    }
}

}  // namespace dapple
