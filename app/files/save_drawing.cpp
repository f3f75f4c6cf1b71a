#include "app/files/save_drawing.h"

#include <ostream>
#include <stdexcept>
#include <string>

#include "app/files/atomic_file.h"
#include "app/files/file_ending.h"
#include "app/files/png_file.h"
#include "core/output/csv.h"
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

void write_pixels(std::ostream& out, const DrawingSettings& settings, const DrawingToSave& drawing,
                  double radius, const WritingProgress& progress) {
    const RasterSize size = raster_size(drawing.page, drawing.dpi);
    const RasterRequest request{
        .dot_radius_mm = radius, .dpi = drawing.dpi, .threads = settings.placing.threads};
    const bool grey = is_grey(settings.ink) && is_grey(settings.paper);
    const PngHeader header{size.width, size.height, drawing.dpi, grey ? PngColours::grey : PngColours::rgb};
    write_png(out, header, [&](const PixelSink& pixels) {
        rasterise(drawing.dots, drawing.page, request, [&](int first_row, const Grid<float>& coverage) {
            progress(static_cast<double>(first_row) / size.height);
            pixels(ink_on_paper(coverage, settings.ink, settings.paper));
        });
    });
}

}  // namespace

DrawingFormat drawing_format(const std::filesystem::path& path) {
    const std::string ending = ending_of(path);
    if (ending == ".svg") return DrawingFormat::svg;
    if (ending == ".png") return DrawingFormat::png;
    if (ending == ".csv") return DrawingFormat::csv;
    throw std::runtime_error(path.string() + ": a drawing's name must end in .svg, .png or .csv");
}

DotOrder usual_order(DrawingFormat format, std::uint64_t dots) {
    if (format != DrawingFormat::svg || dots > kMostSortedDots) return DotOrder::recursion;
    return dots <= kMostRoutedDots ? DotOrder::shortest : DotOrder::space;
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
    const DrawingFormat format = drawing_format(path);
    const DotOrder order = drawing.order.value_or(usual_order(format, drawing.dots.count));
    Dots sorted;
    // Of the bar, half is the pen's way.
    const double routing = order == DotOrder::shortest ? 0.5 : 0;
    if (order != DotOrder::recursion) {
        const RoutingWatch way_watch{.stop = watch.stop, .progress = [&](double share) {
                                         if (watch.progress) watch.progress(routing * share);
                                     }};
        sorted = sorted_dots(drawing.dots, order, way_watch);
        if (watch.stop.stop_requested()) return false;
    }
    const DotStream dots =
        order != DotOrder::recursion ? stream_of(sorted, drawing.dots.scale) : drawing.dots;
    const double radius = drawing.dot_radius_mm;
    const WritingProgress progress = [&](double share) {
        if (watch.stop.stop_requested()) throw Stopped();
        if (watch.progress) watch.progress(routing + (1 - routing) * share);
    };
    const auto write = [&](std::ostream& out) {
        switch (format) {
            case DrawingFormat::svg: {
                SvgStyle style{.dot_radius_mm = radius,
                               .ink = settings.ink,
                               .background = {},
                               .tiles = drawing.tiles,
                               .picture = drawing.picture};
                if (settings.background) style.background = settings.paper;
                write_svg(out, dots, drawing.page, style, progress);
                break;
            }
            case DrawingFormat::csv:
                write_csv(out, dots, drawing.page, {.dot_radius_mm = radius, .tile_size = drawing.tile_size},
                          progress);
                break;
            case DrawingFormat::png:
                write_pixels(out, settings, drawing, radius, progress);
                break;
        }
        progress(1);
    };
    try {
        save_atomically(path, write);
    } catch (const Stopped&) {
        return false;
    }
    return true;
}

}  // namespace dapple
