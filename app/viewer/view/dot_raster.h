#pragma once
// Dots and lines on the part of the page that is seen, drawn by the processor: for computers whose OpenGL is
// a program too, which takes fifty times as long for the same.
//
//     begin() ──► add() blocks of them, as long as there is time ──► finish(): how much of each pixel is ink
//     draw(): all of it
//
// By sample points, as files are drawn (core/output/sample_band.h): what overlaps unites, each pen's by
// itself, and what lies beyond the page's edges is cut off. So it is as light as the file, however small the
// dots are: the smaller, the more sample points.

#include <algorithm>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <vector>

#include "core/image/grid.h"
#include "core/image/rectangle.h"
#include "core/output/sample_band.h"
#include "core/placing/dots.h"

namespace dapple {

// How finely dots are sampled on screen, so that they cover as much of the page there as they do in a file.
//
// Each pixel of the canvas is a square of samples. Large dots have a soft edge and look smooth with one
// sample a pixel. Small ones need more: where dots overlap they unite, and how much two of them cover
// together cannot be told from how much of a pixel each of them covers.

enum class Fineness {
    quick,  // as light and as dark, but grainy where dots are small
    full,
};

/// What OpenGL and its memory allow.
struct SampleLimits {
    int largest_side = 8192;  // samples
    double most = 32e6;       // samples in all
};

/// The samples of a pixel's side, 1 to 128: what dots of that radius (pixels, above 0) need, as far as the
/// limits allow on so many pixels. Quick takes 2.5 million samples in all at most.
int samples_per_side(double dot_radius, glm::ivec2 pixels, Fineness fineness,
                     const SampleLimits& limits = {});

// Pixels of 8 x 8 sample points that are ink or not, each in a word of its own, for pictures that are drawn
// again in each frame: dots of one radius are stamped on them, pixel by pixel, in a tenth of the time that
// rows of samples take.

/// Of a pixel's word the lowest byte is its top row of samples, the lowest bit of that the leftmost one.
/// Threads may add to it at once whose limits have no row of pixels in common.
class SampledPixels : public SampledShapes<SampledPixels> {
 public:
    static constexpr int kSide = 8;

    SampledPixels(int width, int height)
        : width_(width), height_(height), words_(static_cast<std::size_t>(width) * height) {}

    int sample_rows() const { return height_ * kSide; }
    std::int64_t columns() const { return std::int64_t{width_} * kSide; }

    /// The samples of a row from the first to the last one, all of which it has.
    void add_span(std::int64_t row, std::int64_t first, std::int64_t last) {
        std::uint64_t* const line = row_of_pixels(row / kSide);
        const auto byte = row % kSide * 8;
        const std::int64_t from = first / kSide, to = last / kSide;
        const std::uint64_t head = std::uint64_t{0xff} << first % kSide & 0xff;
        const std::uint64_t tail = std::uint64_t{0xff} >> (kSide - 1 - last % kSide);
        if (from == to) {
            line[from] |= (head & tail) << byte;
            return;
        }
        line[from] |= head << byte;
        for (std::int64_t pixel = from + 1; pixel < to; ++pixel) line[pixel] |= std::uint64_t{0xff} << byte;
        line[to] |= tail << byte;
    }

    std::uint64_t* row_of_pixels(std::int64_t y) { return words_.data() + y * width_; }

    void clear_row(int y) { std::fill_n(row_of_pixels(y), width_, 0); }

    /// How many samples of each of a row's pixels are ink.
    void count(int y, std::span<std::uint16_t> counts) const;

 private:
    int width_, height_;
    std::vector<std::uint64_t> words_;
};

/// Discs of one radius, worked out once for many places of their middles in a pixel. They lie within an
/// eighth of a pixel of where they should, small ones within a sixty-fourth; on their average they have as
/// many samples as their area.
class DiscStamps {
 public:
    /// Whether there are stamps of that radius, in samples. Smaller discs meet a sample now and then; larger
    /// ones would take longer to work out than they save.
    static bool are_there_of(double radius) { return radius >= 1 && radius <= 80; }

    explicit DiscStamps(double radius);

    /// The same as SampledShapes::add_disc(), but for its place. Of a middle that lies no further than the
    /// radius beyond the limits.
    void add(SampledPixels& pixels, double x, double y, const SampleWindow& limits) const;

 private:
    double radius_;
    int places_ = 0;                    // along a pixel's side
    std::vector<int> low_;              // for each of them: the pixel of a stamp's upper left corner
    int side_ = 0;                      // of a stamp, pixels
    std::vector<std::uint64_t> words_;  // stamp after stamp, row after row
};

/// A view of the page, in pixels from the picture's upper left corner.
struct RasterView {
    glm::ivec2 size{0, 0};    // of the picture
    glm::dvec2 origin{0, 0};  // where positions of 0 lie
    double pixels_per_unit = 1;
    Rectangle<double> page{{0, 0}, {0, 0}};  // beyond it nothing is drawn
    std::size_t pens = 1;
};

/// How dots are drawn.
struct RasterLook {
    double radius = 0;          // page units; of dots that have none of their own
    double largest_radius = 0;  // of those that have
    double grow = 1;            // of all lines' widths
    double fade_scale = 0;      // dots are all there a seventh above their critical scale; 0: all are
    std::uint32_t hidden = 0;   // pens: a bit for each
};

/// Dots that follow each other in a piece.
struct RasterDots {
    const Dots* piece = nullptr;
    std::size_t first = 0, count = 0;
    float low = 0, high = 0;  // their least and greatest y, page units
};

struct RasterLines {
    std::span<const glm::vec4> lines;    // page units: from x, y to x, y
    std::span<const float> widths = {};  // page units; none: all as wide as `width`
    std::span<const std::uint8_t> pens = {};
    double width = 0;
    std::size_t every = 1;  // one in so many
};

struct RasterInk {
    std::vector<RasterDots> dots = {};
    std::vector<RasterLines> lines = {};
};

/// How finely: a pixel is so many parts by as many, and each part 8 x 8 sample points if it is drawn quickly,
/// or 16 x 16.
struct RasterGrain {
    Fineness fineness = Fineness::quick;
    int parts = 1;

    /// Along a pixel's side.
    int samples() const { return (fineness == Fineness::quick ? 8 : 16) * parts; }

    bool operator==(const RasterGrain&) const = default;
};

/// Bytes that sample points may need.
inline constexpr double kMostRasterMemory = 256e6;

/// What dots of that mean radius, or lines of twice that width (page units), need to be as light as they are:
/// sample points a few of which lie in each, as far as there is time for them. Full only if that fits into
/// the memory.
RasterGrain raster_grain(const RasterView& view, Fineness fineness, double radius);

class DotRaster {
 public:
    DotRaster();
    ~DotRaster();

    /// An empty picture.
    void begin(const RasterView& view, const RasterGrain& grain);
    /// On all cores.
    void add(std::span<const RasterDots> dots, const RasterLook& look);
    void add(const RasterLines& lines, const RasterLook& look);
    /// The share of each pixel that is ink, 0..255: for up to four pens in a picture's four components, as
    /// many pictures as that takes.
    template <class Pixel>
    void finish(std::vector<Grid<Pixel>>& pictures);

    /// All that at once, in half the time: samples are not kept. Returns the share of the time that dots and
    /// lines took; the rest went into pixels.
    template <class Pixel>
    double draw(const RasterView& view, const RasterGrain& grain, const RasterInk& ink,
                const RasterLook& look, std::vector<Grid<Pixel>>& pictures);

 private:
    struct Samples;
    std::unique_ptr<Samples> samples_;
};

}  // namespace dapple
