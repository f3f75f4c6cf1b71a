#include "io/files/file_size.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <sstream>

#include "core/output/raster.h"
#include "core/text/length.h"
#include "io/files/pdf_file.h"

namespace dapple {
namespace {

constexpr std::size_t kFirst = 20'000;  // dots or tiles that are written

// A drawing on screen does not say when its dots appear: any numbers with as many digits will do.
DotPieces first_of(const DotStream& dots) {
    DotPieces first;
    dots.for_each_piece([&](const Dots& piece) {
        const std::size_t count = std::min(piece.size(), kFirst - first.size());
        Dots& own = first.pieces.emplace_back();
        own.pen = piece.pen;
        own.x.assign(piece.x.begin(), piece.x.begin() + static_cast<std::ptrdiff_t>(count));
        own.y.assign(piece.y.begin(), piece.y.begin() + static_cast<std::ptrdiff_t>(count));
        if (!piece.radius.empty())
            own.radius.assign(piece.radius.begin(),
                              piece.radius.begin() + static_cast<std::ptrdiff_t>(count));
        own.threshold.assign(count, static_cast<float>(dots.scale * 0.543219));
        own.critical.assign(count, static_cast<float>(dots.scale * 0.654321));
        return first.size() < kFirst;
    });
    return first;
}

double text_bytes(DrawingFormat format, const DrawingSettings& settings, const DrawingToSave& drawing,
                  const DotPieces& first) {
    const auto bytes_of = [&](const DotPieces& dots, std::size_t tiles) {
        DrawingToSave some = drawing;
        some.dots = stream_of(dots, drawing.dots.scale);
        some.dots.count = drawing.dots.count;  // which has a say in the number of decimals
        some.tiles.resize(tiles);
        std::ostringstream out;
        write_drawing(out, format, settings, some, "");
        return static_cast<double>(out.tellp());
    };
    const auto rest = [](std::uint64_t all, std::size_t some) {
        return static_cast<double>(all) / static_cast<double>(std::max<std::size_t>(some, 1));
    };
    const std::size_t tiles = std::min(drawing.tiles.size(), kFirst);
    const double frame = bytes_of({}, 0);
    return frame + (bytes_of(first, 0) - frame) * rest(drawing.dots.count, first.size()) +
           (bytes_of({}, tiles) - frame) * rest(drawing.tiles.size(), tiles);
}

double pixel_bytes(DrawingFormat format, const DrawingSettings& settings, const DrawingToSave& drawing,
                   const DotPieces& first) {
    double radius_mm = drawing.dot_radius_mm;
    if (first.size() > 0 && !first.pieces.front().radius.empty()) {
        double sum = 0;
        for (const Dots& piece : first.pieces)
            sum = std::reduce(piece.radius.begin(), piece.radius.end(), sum);
        radius_mm = sum / static_cast<double>(first.size()) * drawing.page.mm_per_page_unit;
    }
    const auto is_grey = [](glm::vec3 colour) { return colour.r == colour.g && colour.g == colour.b; };
    const bool coloured = !is_grey(settings.ink) || !is_grey(settings.paper);
    const double colours = !drawing.pens.empty() ? 2.3 : coloured ? 1.75 : 1;
    const double depth = drawing.saving.bits == 16 ? 1.55 : 1,
                 packing = format == DrawingFormat::tiff ? 1.22 : 1;
    const double across = 2 * radius_mm * drawing.saving.dpi / kMmPerInch;  // pixels
    const RasterSize size = raster_size(drawing.page, drawing.saving.dpi);
    const double pixels = static_cast<double>(size.width) * size.height;
    const double edges = 4 * std::max(across - 1, 0.5) * static_cast<double>(drawing.dots.count);
    return colours * depth * packing * std::min(edges, pixels);
}

}  // namespace

std::optional<double> estimated_bytes(DrawingFormat format, const DrawingSettings& settings,
                                      const DrawingToSave& drawing) {
    const DotPieces first = first_of(drawing.dots);
    if (format == DrawingFormat::pdf) check_fits_pdf(drawing.page, drawing.dots.count);
    if (!has_pixels(format)) return text_bytes(format, settings, drawing, first);
    const double bytes = pixel_bytes(format, settings, drawing, first);
    if (draws_strokes(settings) || drawing.strokes) return std::nullopt;
    return bytes;
}

}  // namespace dapple
