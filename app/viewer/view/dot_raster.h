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

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <vector>

#include "app/viewer/view/dot_samples.h"
#include "core/image/grid.h"
#include "core/image/rectangle.h"
#include "core/placing/dots.h"

namespace dapple {

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
