#include "io/files/separations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <string>

#include "core/output/raster.h"
#include "core/output/sheet.h"
#include "core/text/number_words.h"
#include "io/files/png_file.h"
#include "io/files/tiff_file.h"

namespace dapple {
namespace {

constexpr double kMarkMm = 0.2;  // how wide lines of crosses are

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
    own.count = 0;
    own.for_each_piece = [all = dots.for_each_piece, pen](const TakePiece& take) {
        all([&](const Dots& piece) {
            if (piece.pen != pen) return true;
            Dots alone = piece;
            alone.pen = 0;  // of one
            return take(alone);
        });
    };
    own.for_each_piece([&](const Dots& piece) {
        own.count += piece.size();
        return true;
    });
    return own;
}

// The same for strokes.
StrokeStream as_of_one(const StrokeStream& strokes, int pen) {
    StrokeStream own = only(strokes, pen);
    own.width_mm = strokes.width_of(pen);
    own.widths_mm.clear();
    own.for_each_stroke = [all = own.for_each_stroke](const TakeStroke& take) {
        all([&](std::span<const glm::dvec2> points, int) { take(points, 0); });
    };
    return own;
}

// How much of a pixel's side lies between two places, in pixels.
float share_between(double low, double high, int pixel) {
    return static_cast<float>(
        std::clamp(std::min(high, pixel + 1.0) - std::max(low, double(pixel)), 0.0, 1.0));
}

// Lines along the page's sides, over what a stretch of rows has.
void add_marks(std::span<const CutMark> marks, double px_per_mm, int first_row, Grid<float>& coverage) {
    for (const CutMark& mark : marks) {
        const glm::dvec2 half(kMarkMm / 2);
        const glm::dvec2 low = (glm::min(mark.from, mark.to) - half) * px_per_mm - glm::dvec2(0, first_row);
        const glm::dvec2 high = (glm::max(mark.from, mark.to) + half) * px_per_mm - glm::dvec2(0, first_row);
        const auto pixel = [](double place, int most) {
            return static_cast<int>(std::clamp(std::floor(place), 0.0, static_cast<double>(most)));
        };
        for (int y = pixel(low.y, coverage.height); y < pixel(high.y + 1, coverage.height); ++y)
            for (int x = pixel(low.x, coverage.width); x < pixel(high.x + 1, coverage.width); ++x) {
                float& covered = coverage.row(y)[x];
                covered =
                    std::max(covered, share_between(low.x, high.x, x) * share_between(low.y, high.y, y));
            }
    }
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

std::filesystem::path file_of_pen(const std::filesystem::path& drawing, std::size_t pen, const Pen& its_own) {
    std::filesystem::path file = drawing;
    const std::string word = file_word(its_own.name);
    file.replace_filename(fmt::format("{}-{}{}{}{}", drawing.stem().string(), pen + 1,
                                      word.empty() ? "" : "-", word, drawing.extension().string()));
    return file;
}

bool has_pen_files(DrawingFormat format, const SavingChoice& saving, std::span<const Pen> pens) {
    return saving.pen_files && !pens.empty() && !has_pixels(format) && !is_table(format);
}

bool has_separations(DrawingFormat format, const SavingChoice& saving, std::span<const Pen> pens) {
    return saving.separations && !pens.empty() && has_pixels(format);
}

std::vector<std::filesystem::path> files_of(const std::filesystem::path& drawing, DrawingFormat format,
                                            const SavingChoice& saving, std::span<const Pen> pens) {
    std::vector<std::filesystem::path> files;
    const bool each = has_pen_files(format, saving, pens);
    if (!each) files.push_back(drawing);
    for (std::size_t pen = 0; (each || has_separations(format, saving, pens)) && pen < pens.size(); ++pen)
        files.push_back(file_of_pen(drawing, pen, pens[pen]));
    return files;
}

DrawingToSave drawing_of_pen(const DrawingToSave& drawing, std::size_t pen) {
    DrawingToSave own = drawing;
    own.pens = {drawing.pens[pen]};
    own.dots = only(drawing.dots, static_cast<int>(pen));
    if (drawing.inking.pen != static_cast<int>(pen)) own.inking = {};
    own.inking.pen = 0;
    if (drawing.strokes) own.strokes = as_of_one(*drawing.strokes, static_cast<int>(pen));
    return own;
}

void write_separation(std::ostream& out, const DrawingToSave& drawing, std::size_t pen,
                      const WritingProgress& progress) {
    const DrawingToSave own = drawing_of_pen(drawing, pen);
    const InkPage page = ink_page(own);
    const double dpi = own.file.saving.dpi;
    const RasterSize size = raster_size(page.size, dpi);
    const PngHeader header{size.width, size.height, dpi, PngColours::grey};
    const auto write = [&]<class Channel>(Channel) {
        const DrawInto<Channel> draw = [&](const SinkOf<Channel>& pixels) {
            rasterise(page, {.dpi = dpi, .threads = own.file.settings.placing.threads},
                      [&](int first_row, std::span<const Grid<float>> coverage) {
                          if (progress) progress(static_cast<double>(first_row) / size.height);
                          Grid<float> marked = coverage[0];
                          add_marks(page.registration, dpi / kMmPerInch, first_row, marked);
                          pixels(grey_of<Channel>(marked));
                      });
        };
        if (own.file.format == DrawingFormat::png) return write_png<Channel>(out, header, draw);
        write_tiff<Channel>(out, header, draw);
    };
    own.file.saving.bits == 16 ? write(std::uint16_t{}) : write(std::uint8_t{});
}

}  // namespace dapple
