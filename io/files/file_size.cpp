#include "io/files/file_size.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>

#include "core/output/raster.h"
#include "core/text/number_words.h"
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

double bytes_of(const DrawingToSave& drawing) {
    std::stringstream out;
    write_drawing(out, drawing, "");
    return static_cast<double>(out.view().size());
}

double text_bytes(const DrawingToSave& drawing) {
    const DotPieces first = first_of(drawing.dots);
    const auto with = [&](const DotPieces& dots, std::size_t tiles) {
        DrawingToSave some = drawing;
        some.dots = stream_of(dots, drawing.dots.scale);
        some.dots.count = drawing.dots.count;  // which has a say in the number of decimals
        some.tiles.resize(tiles);
        return bytes_of(some);
    };
    const auto rest = [](std::uint64_t all, std::size_t some) {
        return static_cast<double>(all) / static_cast<double>(std::max<std::size_t>(some, 1));
    };
    const std::size_t tiles = std::min(drawing.tiles.size(), kFirst);
    const double frame = with({}, 0);
    return frame + (with(first, 0) - frame) * rest(drawing.dots.count, first.size()) +
           (with({}, tiles) - frame) * rest(drawing.tiles.size(), tiles);
}

// Of bands across the page, one below the other: a dot that reaches over a band's end is in the next one as
// what reaches into that from above would be.
double pixel_bytes(const DrawingToSave& drawing) {
    const double dpi = drawing.file.saving.dpi;
    constexpr int kBands = 12, kRows = 32;
    const double pixels_per_unit = drawing.page.mm_per_page_unit * dpi / kMmPerInch;
    const double height = raster_size(drawing.page, dpi).height, apart = height / kBands;
    const double rows = std::clamp(std::floor(apart), 1.0, double{kRows});
    DotPieces dots;
    drawing.dots.for_each_piece([&](const Dots& piece) {
        Dots& own = dots.pieces.emplace_back();
        own.pen = piece.pen;
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const double y = piece.y[i] * pixels_per_unit;
            const double band = std::clamp(std::floor(y / apart), 0.0, kBands - 1.0);
            const double in_band = y - band * apart - (apart - rows) / 2;
            if (in_band < 0 || in_band >= rows) continue;
            own.x.push_back(piece.x[i]);
            own.y.push_back(static_cast<float>((band * rows + in_band) / pixels_per_unit));
            if (!piece.radius.empty()) own.radius.push_back(piece.radius[i]);
        }
        return true;
    });
    DrawingToSave bands = drawing;
    bands.dots = stream_of(dots, drawing.dots.scale);
    bands.page.height_mm = kBands * rows / dpi * kMmPerInch;
    return bytes_of(bands) * height / (kBands * rows);
}

}  // namespace

std::optional<double> estimated_bytes(const DrawingToSave& drawing) {
    const DrawingFormat format = drawing.file.format;
    if (format == DrawingFormat::pdf) check_fits_pdf(drawing.page, drawing.dots.count);
    if (!has_pixels(format)) return text_bytes(drawing);
    raster_size(drawing.page, drawing.file.saving.dpi);  // throws for one that is too large
    const bool of_dots = drawing.file.settings.style == DrawingStyle::dots && !drawing.strokes;
    if (!of_dots || !drawing.inking.empty()) return std::nullopt;
    return pixel_bytes(drawing);
}

}  // namespace dapple
