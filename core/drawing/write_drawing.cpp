#include "core/drawing/write_drawing.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "core/drawing/gcode_choice.h"
#include "core/drawing/machine_comments.h"
#include "core/output/csv.h"
#include "core/output/dots_json.h"
#include "core/output/dxf.h"
#include "core/output/hpgl.h"
#include "core/output/svg.h"

namespace dapple {

bool is_text(DrawingFormat format) {
    return !has_pixels(format) && format != DrawingFormat::pdf;
}

std::vector<CutMark> registration_of(const DrawingSettings& settings, const DrawingToSave& drawing) {
    if (!settings.registration || drawing.pens.empty()) return {};
    return registration_marks(drawing.page);
}

void write_text_drawing(std::ostream& out, DrawingFormat format, const DrawingSettings& settings,
                        const DrawingToSave& drawing, const WritingProgress& progress) {
    const double radius = drawing.dot_radius_mm;
    const CsvColumns columns{.dot_radius_mm = radius,
                             .tile_size = drawing.tile_size,
                             .pens = drawing.pens,
                             .figure8 = settings.placer == PlacerKind::figure8};
    std::optional<glm::vec3> background;
    if (settings.background) background = settings.paper;
    const PageSize& page = drawing.page;
    const std::optional<StrokeStream> strokes = strokes_of(settings, drawing, format);
    const std::vector<CutMark> marks = registration_of(settings, drawing);
    // As strokes, if it has some.
    const auto with_ink = [&](const auto& write) {
        if (strokes)
            write(*strokes);
        else
            write(drawing.dots);
    };
    switch (format) {
        case DrawingFormat::svg: {
            const SvgStyle style{.dot_radius_mm = radius,
                                 .ink = settings.ink,
                                 .pens = drawing.pens,
                                 .registration = marks,
                                 .background = background,
                                 .tiles = drawing.tiles,
                                 .picture = drawing.picture,
                                 .cut_marks = drawing.cut_marks,
                                 .settings = drawing.settings};
            return with_ink([&](const auto& ink) { write_svg(out, ink, page, style, progress); });
        }
// The page in the browser saves none of these, and is to stay small.
#ifndef DAPPLE_FOR_BROWSERS
        case DrawingFormat::gcode: {
            check_heights(drawing.saving);
            GcodeStyle style = gcode_style_of(drawing.saving);
            std::vector<std::string> comments;  // of a template of one's own they may begin otherwise
            if (drawing.saving.gcode_template.text.empty())
                comments = machine_comments(settings, drawing, strokes, format);
            style.comments = comments;
            style.dot_radius_mm = radius;
            style.pens = drawing.pens;
            style.registration = marks;
            return with_ink([&](const auto& ink) { write_gcode(out, ink, page, style, progress); });
        }
        case DrawingFormat::hpgl:
            return with_ink([&](const auto& ink) {
                write_hpgl(
                    out, ink, page, progress, marks,
                    fmt::format("{}", fmt::join(machine_comments(settings, drawing, strokes, format), ", ")));
            });
        case DrawingFormat::dxf:
            if (strokes) return write_dxf(out, *strokes, page, drawing.pens, progress, marks);
            return write_dxf(out, drawing.dots, page, radius, drawing.pens, progress, marks);
        case DrawingFormat::json:
            return write_dots_json(out, drawing.dots, page, columns, progress);
#endif
        case DrawingFormat::csv:
            return write_csv(out, drawing.dots, page, columns, progress);
#ifdef DAPPLE_FOR_BROWSERS
        default:
#endif
        case DrawingFormat::pdf:
        case DrawingFormat::png:
        case DrawingFormat::tiff:
            throw std::logic_error("no text");
    }
}

}  // namespace dapple
