#include "app/viewer/model/export_estimate.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <streambuf>
#include <vector>

#include "app/files/pdf_file.h"
#include "app/files/png_file.h"
#include "app/files/tiff_file.h"
#include "core/output/csv.h"
#include "core/output/dots_json.h"
#include "core/output/dxf.h"
#include "core/output/gcode.h"
#include "core/output/hpgl.h"
#include "core/output/raster.h"
#include "core/output/svg.h"

namespace dapple {
namespace {

constexpr std::size_t kSample = 2000;     // dots or tiles that are written
constexpr int kPatch = 64, kPatches = 8;  // pixels; along each side of the page
constexpr double kMmPerInch = 25.4;

// Counts what is written, and keeps none of it; what is written again, of a writer that goes back, once.
class ByteCount : public std::streambuf {
 public:
    double bytes() const { return static_cast<double>(end_); }

 private:
    int_type overflow(int_type c) override {
        advance(1);
        return traits_type::not_eof(c);
    }
    std::streamsize xsputn(const char*, std::streamsize count) override {
        advance(count);
        return count;
    }
    pos_type seekoff(off_type offset, std::ios::seekdir from, std::ios::openmode) override {
        const off_type base = from == std::ios::cur ? at_ : from == std::ios::end ? end_ : 0;
        return pos_type(at_ = base + offset);
    }
    pos_type seekpos(pos_type place, std::ios::openmode) override { return pos_type(at_ = off_type(place)); }
    void advance(std::streamsize count) { end_ = std::max(end_, at_ += count); }

    off_type at_ = 0, end_ = 0;
};

template <class Write>
double bytes_of(const Write& write) {
    ByteCount count;
    std::ostream out(&count);
    write(out);
    return count.bytes();
}

// Of when they appear any numbers with as many digits will do: a drawing on screen has none.
Dots sample_of(const DotPieces& dots, double scale) {
    Dots sample;
    const std::size_t count = dots.size(), step = 1 + count / kSample;
    std::size_t i = 0;
    for_each_position(dots, [&](float x, float y) {
        if (i++ % step != 0) return;
        sample.x.push_back(x);
        sample.y.push_back(y);
        const double share = static_cast<double>(i) / static_cast<double>(count);
        sample.threshold.push_back(static_cast<float>(scale * share));
        sample.critical.push_back(static_cast<float>(scale * share * 1.2345));
    });
    return sample;
}

template <class WriteDots>
double text_bytes(const EstimatedDrawing& drawing, const WriteDots& write) {
    const Dots sample = sample_of(drawing.dots, drawing.scale);
    DotStream stream = stream_of(sample, drawing.scale);
    const double all = static_cast<double>(drawing.dots.size());
    const double share = all / static_cast<double>(std::max<std::size_t>(sample.size(), 1));
    stream.count = drawing.dots.size();  // which has a say in the number of decimals
    DotStream none = stream;
    none.for_each_piece = [](const TakePiece&) {};
    const double frame = bytes_of([&](std::ostream& out) { write(out, none); });
    return frame + share * (bytes_of([&](std::ostream& out) { write(out, stream); }) - frame);
}

double tile_bytes(const EstimatedDrawing& drawing) {
    const Dots nothing;
    std::vector<PlacedTile> sample;
    const std::size_t step = 1 + drawing.tiles.size() / kSample;
    for (std::size_t i = 0; i < drawing.tiles.size(); i += step) sample.push_back(drawing.tiles[i]);
    const auto bytes = [&](std::span<const PlacedTile> tiles) {
        return bytes_of([&](std::ostream& out) {
            write_svg(out, stream_of(nothing), drawing.page, {.background = {}, .tiles = tiles});
        });
    };
    return (bytes(sample) - bytes({})) * static_cast<double>(step);
}

// Patches of the page, evenly spread, laid side by side.
struct Mosaic {
    Dots dots;
    PageSize page;
    double share = 1;  // of the page's pixels
};

Mosaic mosaic_of(const EstimatedDrawing& drawing, const RasterSize& size) {
    const glm::ivec2 whole(size.width, size.height);
    const glm::ivec2 patch = glm::min(whole, glm::ivec2(kPatch));
    const glm::ivec2 count = glm::clamp(whole / patch, glm::ivec2(1), glm::ivec2(kPatches));
    const glm::dvec2 cell = glm::dvec2(whole) / glm::dvec2(count);
    const glm::dvec2 pixels = glm::dvec2(patch * count);
    const double longer = std::max(pixels.x, pixels.y);
    const double mm_per_pixel = kMmPerInch / drawing.dpi;
    const double pixels_per_unit = drawing.page.mm_per_page_unit / mm_per_pixel;
    Mosaic mosaic;
    mosaic.page = {pixels.x * mm_per_pixel, pixels.y * mm_per_pixel, longer * mm_per_pixel};
    mosaic.share = pixels.x * pixels.y / (static_cast<double>(size.width) * size.height);
    for_each_position(drawing.dots, [&](float x, float y) {
        const glm::dvec2 at = glm::dvec2(x, y) * pixels_per_unit;
        const glm::dvec2 index = glm::min(glm::floor(at / cell), glm::dvec2(count - 1));
        const glm::dvec2 in_patch = at - (index + 0.5) * cell + glm::dvec2(patch) * 0.5;
        if (in_patch.x < 0 || in_patch.y < 0 || in_patch.x >= patch.x || in_patch.y >= patch.y) return;
        const glm::dvec2 place = (index * glm::dvec2(patch) + in_patch) / longer;
        mosaic.dots.x.push_back(static_cast<float>(place.x));
        mosaic.dots.y.push_back(static_cast<float>(place.y));
    });
    return mosaic;
}

double pixel_bytes(DrawingFormat format, const DrawingSettings& settings, const EstimatedDrawing& drawing,
                   double radius) {
    const Mosaic mosaic = mosaic_of(drawing, raster_size(drawing.page, drawing.dpi));
    const Grid<float> coverage = coverage_of(stream_of(mosaic.dots), mosaic.page,
                                             {.dot_radius_mm = radius, .dpi = drawing.dpi, .threads = 0});
    const auto is_grey = [](glm::vec3 colour) { return colour.r == colour.g && colour.g == colour.b; };
    PngHeader header{coverage.width, coverage.height, drawing.dpi};
    if (is_grey(settings.ink) && is_grey(settings.paper)) header.colours = PngColours::grey;
    const auto write = [&](std::ostream& out) {
        const auto draw = [&](const PixelSink& sink) {
            sink(ink_on_paper(coverage, settings.ink, settings.paper));
        };
        if (format == DrawingFormat::tiff)
            write_tiff(out, header, draw);
        else
            write_png(out, header, draw);
    };
    return bytes_of(write) / mosaic.share;
}

}  // namespace

double estimated_bytes(DrawingFormat format, const DrawingSettings& settings,
                       const EstimatedDrawing& drawing) {
    const double radius = drawing.dot_radius_mm;
    const PageSize& page = drawing.page;
    const CsvColumns columns{.dot_radius_mm = radius, .tile_size = drawing.tile_size};
    const auto written = [&](const auto& write) { return text_bytes(drawing, write); };
    switch (format) {
        case DrawingFormat::png:
        case DrawingFormat::tiff:
            return pixel_bytes(format, settings, drawing, radius);
        case DrawingFormat::csv:
            return written(
                [&](std::ostream& out, const DotStream& dots) { write_csv(out, dots, page, columns); });
        case DrawingFormat::json:
            return written(
                [&](std::ostream& out, const DotStream& dots) { write_dots_json(out, dots, page, columns); });
        case DrawingFormat::gcode: {
            GcodeStyle style{.lines = parse_gcode_template(gcode_template_of(drawing.tool))};
            style.dot_radius_mm = radius;
            return written(
                [&](std::ostream& out, const DotStream& dots) { write_gcode(out, dots, page, style); });
        }
        case DrawingFormat::hpgl:
            return written([&](std::ostream& out, const DotStream& dots) { write_hpgl(out, dots, page); });
        case DrawingFormat::dxf:
            return written(
                [&](std::ostream& out, const DotStream& dots) { write_dxf(out, dots, page, radius); });
        case DrawingFormat::pdf:
            check_fits_pdf(page, drawing.dots.size());
            return written([&](std::ostream& out, const DotStream& dots) {
                write_pdf(out, dots, page, {.dot_radius_mm = radius, .ink = settings.ink, .background = {}});
            });
        case DrawingFormat::svg:
            break;
    }
    const double dots = written([&](std::ostream& out, const DotStream& stream) {
        write_svg(out, stream, page, {.dot_radius_mm = radius, .ink = settings.ink, .background = {}});
    });
    return drawing.tiles.empty() ? dots : dots + tile_bytes(drawing);
}

ExportInfo ExportEstimate::info(const Pane& pane, const ViewerSettings& settings, DrawingFormat format) {
    const Key key{pane.placings(), format, settings.drawing, settings.saving.dpi, settings.saving.tool};
    if (key_ == key) return facts_;
    key_ = key;
    const PlacedDrawing& drawing = pane.page();
    const Stippling& stippling = drawing.stippling;
    const PageSize& page = drawing.layout.page;
    const double mm_per_unit = page.mm_per_page_unit;
    facts_ = {.dots = stippling.dots.size(),
              .bytes = {},
              .trouble = {},
              .area_mm2 = page.width_mm * page.height_mm};
    try {
        facts_.bytes = estimated_bytes(format, settings.drawing,
                                       {.dots = stippling.dots,
                                        .scale = stippling.scale,
                                        .page = page,
                                        .dot_radius_mm = drawing.dot_radius * mm_per_unit,
                                        .tiles = drawing.outlines,
                                        .tile_size = pane.tile_size(),
                                        .dpi = settings.saving.dpi,
                                        .tool = settings.saving.tool});
    } catch (const std::exception& error) {
        facts_.trouble = error.what();
    }
    return facts_;
}

}  // namespace dapple
