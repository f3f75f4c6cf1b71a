#include "core/output/drawing_format.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

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

bool has_pixels(DrawingFormat format) {
    return format == DrawingFormat::png || format == DrawingFormat::tiff;
}

bool is_plotted(DrawingFormat format) {
    return format == DrawingFormat::svg || format == DrawingFormat::dxf || is_touched(format);
}

bool is_touched(DrawingFormat format) {
    return format == DrawingFormat::gcode || format == DrawingFormat::hpgl;
}

bool is_table(DrawingFormat format) {
    return format == DrawingFormat::csv || format == DrawingFormat::json;
}

bool has_optional_paper(DrawingFormat format) {
    return format == DrawingFormat::svg || format == DrawingFormat::pdf;
}

bool has_colours(DrawingFormat format) {
    return has_pixels(format) || has_optional_paper(format);
}

bool is_binary(DrawingFormat format) {
    return has_pixels(format) || format == DrawingFormat::pdf;
}

}  // namespace dapple
