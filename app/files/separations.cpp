#include "app/files/separations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "app/files/png_file.h"
#include "app/files/tiff_file.h"
#include "core/output/raster.h"
#include "core/output/raster_strokes.h"

namespace dapple {
namespace {

// Letters, digits and single hyphens.
std::string file_word(const std::string& name) {
    std::string word;
    for (const unsigned char c : name) {
        if (std::isalnum(c))
            word += static_cast<char>(std::tolower(c));
        else if (!word.empty() && word.back() != '-')
            word += '-';
    }
    if (word.ends_with('-')) word.pop_back();
    return word;
}

// As the dots of a single pen.
DotStream only(const DotStream& dots, int pen) {
    DotStream own = dots;
    own.for_each_piece = [all = dots.for_each_piece, pen](const TakePiece& take) {
        all([&](const Dots& piece) {
            if (piece.pen != pen) return true;
            Dots alone = piece;
            alone.pen = 0;  // of one
            return take(alone);
        });
    };
    return own;
}

template <class Channel>
Grid<glm::vec<3, Channel>> grey_of(const Grid<float>& coverage) {
    Grid<glm::vec<3, Channel>> grey(coverage.width, coverage.height);
    std::ranges::transform(coverage.values, grey.values.begin(), [](float covered) {
        return glm::vec<3, Channel>(
            static_cast<Channel>(std::lround((1 - covered) * std::numeric_limits<Channel>::max())));
    });
    return grey;
}

}  // namespace

std::filesystem::path separation_file(const std::filesystem::path& drawing, std::size_t pen,
                                      const Pen& its_own) {
    std::filesystem::path file = drawing;
    const std::string word = file_word(its_own.name);
    file.replace_filename(fmt::format("{}-{}{}{}{}", drawing.stem().string(), pen + 1,
                                      word.empty() ? "" : "-", word, drawing.extension().string()));
    return file;
}

std::vector<std::filesystem::path> separation_files(const std::filesystem::path& drawing,
                                                    std::span<const Pen> pens) {
    std::vector<std::filesystem::path> files;
    for (std::size_t pen = 0; pen < pens.size(); ++pen)
        files.push_back(separation_file(drawing, pen, pens[pen]));
    return files;
}

void write_separation(std::ostream& out, DrawingFormat format, const DrawingSettings& settings,
                      const DrawingToSave& drawing, int pen, const WritingProgress& progress) {
    const RasterSize size = raster_size(drawing.page, drawing.saving.dpi);
    const RasterRequest request{.dot_radius_mm = drawing.dot_radius_mm,
                                .dpi = drawing.saving.dpi,
                                .threads = settings.placing.threads};
    const PngHeader header{size.width, size.height, drawing.saving.dpi, PngColours::grey};
    const std::optional<StrokeStream> strokes = strokes_of(settings, drawing, format);
    const auto draw = [&]<class Channel>(Channel, const auto& pixels) {
        const CoverageSink sink = [&](int first_row, const Grid<float>& coverage) {
            if (progress) progress(static_cast<double>(first_row) / size.height);
            pixels(grey_of<Channel>(coverage));
        };
        if (!strokes) return rasterise(only(drawing.dots, pen), drawing.page, request, sink);
        StrokeStream own = only(*strokes, pen);
        own.width_mm = strokes->width_of(pen);
        own.widths_mm.clear();
        own.for_each_stroke = [all = own.for_each_stroke](const TakeStroke& take) {
            all([&](std::span<const glm::dvec2> points, int) { take(points, 0); });
        };
        rasterise(own, drawing.page, request, sink);
    };
    const auto in_8_bits = [&](const PixelSink& pixels) { draw(std::uint8_t{}, pixels); };
    const auto in_16_bits = [&](const PixelSink16& pixels) { draw(std::uint16_t{}, pixels); };
    const bool deep = drawing.saving.bits == 16, png = format == DrawingFormat::png;
    if (png && deep) return write_png_16(out, header, in_16_bits);
    if (png) return write_png(out, header, in_8_bits);
    if (deep) return write_tiff_16(out, header, in_16_bits);
    write_tiff(out, header, in_8_bits);
}

}  // namespace dapple
