#include "io/files/file_size.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <streambuf>
#include <vector>

#include "core/output/raster.h"
#include "core/text/length.h"
#include "io/files/pdf_file.h"

namespace dapple {
namespace {

constexpr std::size_t kSample = 2000;     // dots or tiles that are written
constexpr int kPatch = 96, kPatches = 8;  // pixels; along each side of the page

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

double bytes_of(DrawingFormat format, const DrawingSettings& settings, const DrawingToSave& drawing) {
    ByteCount count;
    std::ostream out(&count);
    write_drawing(out, format, settings, drawing, "");
    return count.bytes();
}

// Some of the dots in runs, as how well they are compressed follows from their neighbours, those of a pen
// together. For when they appear any numbers with as many digits will do: a drawing on screen has none.
DotPieces sample_of(const DotStream& dots) {
    DotPieces sample;
    constexpr std::uint64_t kRun = 50;
    const std::uint64_t step = 1 + dots.count / kSample;
    std::uint64_t before = 0, next = 0;  // dots of pieces before; the next one of all that is taken
    dots.for_each_piece([&](const Dots& piece) {
        if (sample.pieces.empty() || sample.pieces.back().pen != piece.pen) {
            sample.pieces.emplace_back();
            sample.pieces.back().pen = piece.pen;
        }
        Dots& own = sample.pieces.back();
        for (; next < before + piece.size(); next += (next + 1) % kRun == 0 ? (step - 1) * kRun + 1 : 1) {
            const std::size_t k = next - before;
            own.x.push_back(piece.x[k]);
            own.y.push_back(piece.y[k]);
            if (!piece.radius.empty()) own.radius.push_back(piece.radius[k]);
            const double share = static_cast<double>(next + 1) / static_cast<double>(dots.count);
            own.threshold.push_back(static_cast<float>(dots.scale * share));
            own.critical.push_back(static_cast<float>(dots.scale * share * 1.2345));
        }
        before += piece.size();
        return true;
    });
    return sample;
}

double share_of(const DotPieces& sample, const DotStream& dots) {
    return static_cast<double>(dots.count) / static_cast<double>(std::max<std::size_t>(sample.size(), 1));
}

double text_bytes(DrawingFormat format, const DrawingSettings& settings, const DrawingToSave& drawing) {
    const DotPieces sample = sample_of(drawing.dots);
    DrawingToSave some = drawing;
    some.tiles = {};
    some.dots = stream_of(sample, drawing.dots.scale);
    some.dots.count = drawing.dots.count;  // which has a say in the number of decimals
    DrawingToSave none = some;
    none.dots.for_each_piece = [](const TakePiece&) {};
    const double frame = bytes_of(format, settings, none);
    return frame + share_of(sample, drawing.dots) * (bytes_of(format, settings, some) - frame);
}

double tile_bytes(DrawingFormat format, const DrawingSettings& settings, const DrawingToSave& drawing) {
    std::vector<PlacedTile> sample;
    const std::size_t step = 1 + drawing.tiles.size() / kSample;
    for (std::size_t i = 0; i < drawing.tiles.size(); i += step) sample.push_back(drawing.tiles[i]);
    DrawingToSave some = drawing, none = drawing;
    some.dots = none.dots = {};
    some.tiles = sample;
    none.tiles = {};
    return (bytes_of(format, settings, some) - bytes_of(format, settings, none)) * static_cast<double>(step);
}

// The patches laid side by side.
struct Mosaic {
    DotPieces dots;
    PageSize page;
    double share = 1;  // of the page's pixels
};

Mosaic mosaic_of(const DrawingToSave& drawing, const RasterSize& size) {
    const PixelPatches patches(drawing.page, drawing.saving.dpi);
    const glm::dvec2 pixels = glm::dvec2(patches.patch * patches.count), patch(patches.patch);
    const double longer = std::max(pixels.x, pixels.y);
    const double mm_per_pixel = kMmPerInch / drawing.saving.dpi;
    Mosaic mosaic;
    mosaic.page = {pixels.x * mm_per_pixel, pixels.y * mm_per_pixel, longer * mm_per_pixel};
    mosaic.share = pixels.x * pixels.y / (static_cast<double>(size.width) * size.height);
    drawing.dots.for_each_piece([&](const Dots& piece) {
        Dots& own = mosaic.dots.pieces.emplace_back();
        own.pen = piece.pen;
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const glm::dvec2 at = glm::dvec2(piece.x[i], piece.y[i]) * patches.pixels_per_unit;
            const glm::dvec2 index = patches.index(at), in_patch = patches.in_patch(at, index);
            if (in_patch.x < 0 || in_patch.y < 0 || in_patch.x >= patch.x || in_patch.y >= patch.y) continue;
            const glm::dvec2 place = (index * patch + in_patch) / longer;
            own.x.push_back(static_cast<float>(place.x));
            own.y.push_back(static_cast<float>(place.y));
            if (!piece.radius.empty())
                own.radius.push_back(static_cast<float>(piece.radius[i] * patches.pixels_per_unit / longer));
        }
        return true;
    });
    return mosaic;
}

double pixel_bytes(DrawingFormat format, const DrawingSettings& settings, const DrawingToSave& drawing) {
    const Mosaic mosaic = mosaic_of(drawing, raster_size(drawing.page, drawing.saving.dpi));
    DrawingToSave patches = drawing;
    patches.dots = stream_of(mosaic.dots, drawing.dots.scale);
    patches.page = mosaic.page;
    return bytes_of(format, settings, patches) / mosaic.share;
}

}  // namespace

PixelPatches::PixelPatches(const PageSize& page, double dpi) {
    const RasterSize size = raster_size(page, dpi);
    const glm::ivec2 whole(size.width, size.height);
    patch = glm::min(whole, glm::ivec2(kPatch));
    count = glm::clamp(whole / patch, glm::ivec2(1), glm::ivec2(kPatches));
    cell = glm::dvec2(whole) / glm::dvec2(count);
    pixels_per_unit = page.mm_per_page_unit / (kMmPerInch / dpi);
}

glm::dvec2 PixelPatches::index(glm::dvec2 at) const {
    return glm::clamp(glm::floor(at / cell), glm::dvec2(0), glm::dvec2(count - 1));
}

glm::dvec2 PixelPatches::in_patch(glm::dvec2 at, glm::dvec2 index) const {
    return at - (index + 0.5) * cell + glm::dvec2(patch) * 0.5;
}

bool PixelPatches::meet(glm::dvec2 low, glm::dvec2 high) const {
    low *= pixels_per_unit;
    high *= pixels_per_unit;
    const glm::dvec2 first = index(low), last = index(high);
    if (last.x - first.x > 1 || last.y - first.y > 1) return true;
    // Only the patches at either end can be met: the first on its far side, or the last on its near side.
    const auto along = [&](int axis) {
        const bool in_first = in_patch(low, first)[axis] < patch[axis] && in_patch(high, first)[axis] >= 0;
        const bool in_last = in_patch(low, last)[axis] < patch[axis] && in_patch(high, last)[axis] >= 0;
        return in_first || in_last;
    };
    return along(0) && along(1);
}

double estimated_bytes(DrawingFormat format, const DrawingSettings& settings, const DrawingToSave& drawing) {
    if (has_pixels(format)) return pixel_bytes(format, settings, drawing);
    if (format == DrawingFormat::pdf) check_fits_pdf(drawing.page, drawing.dots.count);
    const double dots = text_bytes(format, settings, drawing);
    return drawing.tiles.empty() ? dots : dots + tile_bytes(format, settings, drawing);
}

double estimated_bytes_at_once(DrawingFormat format, const DrawingSettings& settings,
                               const DrawingToSave& drawing) {
    constexpr std::uint64_t kFirst = 20'000;
    if (drawing.dots.count <= kFirst || has_pixels(format)) return estimated_bytes(format, settings, drawing);
    Dots first;
    drawing.dots.for_each_piece([&](const Dots& piece) {
        append(first, piece);
        return first.size() < kFirst;
    });
    DrawingToSave some = drawing;
    some.dots = stream_of(first, drawing.dots.scale);
    const double share = static_cast<double>(drawing.dots.count) / static_cast<double>(first.size());
    return share * estimated_bytes(format, settings, some);
}

}  // namespace dapple
