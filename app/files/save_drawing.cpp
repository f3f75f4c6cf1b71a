#include "app/files/save_drawing.h"

#include <ostream>
#include <stdexcept>
#include <string>

#include "app/files/atomic_file.h"
#include "app/files/pdf_file.h"
#include "app/files/png_file.h"
#include "app/files/tiff_file.h"
#include "app/shown_text.h"
#include "core/output/csv.h"
#include "core/output/dots_json.h"
#include "core/output/dxf.h"
#include "core/output/hpgl.h"
#include "core/output/progress.h"
#include "core/output/raster.h"
#include "core/output/svg.h"

namespace dapple {
namespace {

bool is_grey(glm::vec3 colour) {
    return colour.r == colour.g && colour.g == colour.b;
}

// Thrown from within a writer to leave it.
struct Stopped {};

using WriteImage = void (*)(std::ostream& out, const PngHeader& header,
                            const std::function<void(const PixelSink&)>& draw);

void write_pixels(std::ostream& out, WriteImage write_image, const DrawingSettings& settings,
                  const DrawingToSave& drawing, const WritingProgress& progress) {
    const RasterSize size = raster_size(drawing.page, drawing.dpi);
    const RasterRequest request{
        .dot_radius_mm = drawing.dot_radius_mm, .dpi = drawing.dpi, .threads = settings.placing.threads};
    const bool grey = is_grey(settings.ink) && is_grey(settings.paper);
    const PngHeader header{size.width, size.height, drawing.dpi, grey ? PngColours::grey : PngColours::rgb,
                           drawing.settings};
    write_image(out, header, [&](const PixelSink& pixels) {
        rasterise(drawing.dots, drawing.page, request, [&](int first_row, const Grid<float>& coverage) {
            progress(static_cast<double>(first_row) / size.height);
            pixels(ink_on_paper(coverage, settings.ink, settings.paper));
        });
    });
}

// Into the stream; the dots in their final order.
void write_drawing(std::ostream& out, DrawingFormat format, const DrawingSettings& settings,
                   const DrawingToSave& drawing, const std::string& title, const WritingProgress& progress) {
    const double radius = drawing.dot_radius_mm;
    const CsvColumns columns{.dot_radius_mm = radius, .tile_size = drawing.tile_size};
    std::optional<glm::vec3> background;
    if (settings.background) background = settings.paper;
    switch (format) {
        case DrawingFormat::svg:
            return write_svg(out, drawing.dots, drawing.page,
                             {.dot_radius_mm = radius,
                              .ink = settings.ink,
                              .background = background,
                              .tiles = drawing.tiles,
                              .picture = drawing.picture,
                              .settings = drawing.settings},
                             progress);
        case DrawingFormat::pdf:
            return write_pdf(
                out, drawing.dots, drawing.page,
                {.dot_radius_mm = radius, .ink = settings.ink, .background = background, .title = title},
                progress);
        case DrawingFormat::png:
            return write_pixels(out, &write_png, settings, drawing, progress);
        case DrawingFormat::tiff:
            return write_pixels(out, &write_tiff, settings, drawing, progress);
        case DrawingFormat::gcode: {
            GcodeStyle style = drawing.gcode;
            style.dot_radius_mm = radius;
            return write_gcode(out, drawing.dots, drawing.page, style, progress);
        }
        case DrawingFormat::hpgl:
            return write_hpgl(out, drawing.dots, drawing.page, progress);
        case DrawingFormat::dxf:
            return write_dxf(out, drawing.dots, drawing.page, radius, progress);
        case DrawingFormat::csv:
            return write_csv(out, drawing.dots, drawing.page, columns, progress);
        case DrawingFormat::json:
            return write_dots_json(out, drawing.dots, drawing.page, columns, progress);
    }
}

}  // namespace

DotOrder usual_order(DrawingFormat format, std::uint64_t dots) {
    if (!is_plotted(format) || dots > kMostSortedDots) return DotOrder::recursion;
    return dots <= kMostRoutedDots ? DotOrder::shortest : DotOrder::space;
}

Machine usual_machine(DrawingFormat format, GcodeTool tool) {
    if (format != DrawingFormat::gcode) return Machine::axidraw_v3;
    return tool == GcodeTool::laser ? Machine::grbl_laser : Machine::grbl_pen;
}

Dots sorted_dots(const DotStream& stream, DotOrder order, const RoutingWatch& watch) {
    Dots all;
    stream.for_each_piece([&](const Dots& piece) {
        all.reserve(stream.count, !piece.critical.empty());
        append(all, piece);
        return true;
    });
    sort_dots(all, order);
    if (order == DotOrder::shortest) shorten_way(all, watch);
    return all;
}

bool save_drawing(const std::filesystem::path& path, const DrawingSettings& settings,
                  const DrawingToSave& drawing, const SavingWatch& watch) {
    const bool to_standard_output = path == kStandardStream;
    const DrawingFormat format = drawing.format ? *drawing.format : drawing_format(path);
    const DotOrder order = drawing.order.value_or(usual_order(format, drawing.dots.count));
    Dots sorted;
    DrawingToSave ordered = drawing;
    // Of the bar, half is the pen's way.
    const double routing = order == DotOrder::shortest ? 0.5 : 0;
    if (order != DotOrder::recursion) {
        const RoutingWatch way_watch{.stop = watch.stop, .progress = [&](double share) {
                                         if (watch.progress) watch.progress(routing * share);
                                     }};
        sorted = sorted_dots(drawing.dots, order, way_watch);
        if (watch.stop.stop_requested()) return false;
        ordered.dots = stream_of(sorted, drawing.dots.scale);
    }
    const std::string title = to_standard_output ? "Drawing" : printable(path.stem().string());
    const WritingProgress progress = [&](double share) {
        if (watch.stop.stop_requested()) throw Stopped();
        if (watch.progress) watch.progress(routing + (1 - routing) * share);
    };
    const auto write = [&](std::ostream& out) {
        write_drawing(out, format, settings, ordered, title, progress);
        progress(1);
    };
    try {
        if (to_standard_output)
            write_to_standard_output(write);
        else
            save_atomically(path, write);
    } catch (const Stopped&) {
        return false;
    }
    return true;
}

}  // namespace dapple
