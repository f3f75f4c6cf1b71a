#pragma once
// Dots as pixels, anti-aliased, without a graphics card.
//
// A pixel's coverage is the share of its 16 x 16 sample points that lie in any dot: dots that overlap unite,
// they do not add up. Ink and paper are mixed in linear light, so that a half covered pixel is as light as
// one that is half ink and half paper.

#include <functional>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "core/image/grid.h"
#include "core/pens/pen.h"
#include "core/placing/dot_stream.h"
#include "core/placing/page.h"
#include "core/strokes/strokes.h"

namespace dapple {

struct RasterSize {
    int width = 0, height = 0;  // pixels
};

/// The page at that resolution, rounded to whole pixels, at least 1 x 1. Throws std::runtime_error, telling
/// the resolution that would do, if a side is over 1,000,000 pixels, which is what PNG readers take, or all
/// of it over 4 gigapixels, which is a few minutes' work.
RasterSize raster_size(const PageSize& page, double dpi);

struct RasterRequest {
    double dot_radius_mm = 0;  // the largest, where dots have radii of their own
    double dpi = 300;
    int threads = 1;  // the result is the same for any number; 0: all cores
    std::uint64_t dots_at_once = std::uint64_t{1}
                                 << 24;  // in memory, 8 bytes each; nor has it a say in the result
};

/// A stretch of rows, the first of which is row `first_row` of the whole: coverage 0..1.
using CoverageSink = std::function<void(int first_row, const Grid<float>& coverage)>;

/// Draws the page in bands, from the top down, each handed to the sink in turn; so a picture of any size, of
/// any number of dots, needs little memory. Goes through the dots once to count them, and then once for each
/// stretch of bands that have request.dots_at_once dots together.
void rasterise(const DotStream& dots, const PageSize& page, const RasterRequest& request,
               const CoverageSink& sink);

/// The same for dots of several pens, so many: a coverage for each.
using PenCoverageSink = std::function<void(int first_row, std::span<const Grid<float>> coverage)>;
void rasterise_pens(const DotStream& dots, const PageSize& page, const RasterRequest& request,
                    std::size_t pens, const PenCoverageSink& sink);

/// All bands in one, for dots in memory.
Grid<float> coverage_of(const DotStream& dots, const PageSize& page, const RasterRequest& request);

/// sRGB-encoded pixels of that coverage, of 8 or 16 bits a channel. The colours are sRGB-encoded too.
template <class Channel = std::uint8_t>
Grid<glm::vec<3, Channel>> ink_on_paper(const Grid<float>& coverage, glm::vec3 ink, glm::vec3 paper);

/// The same for several pens, each over those before it: each covers its share of what is seen of a pixel, or
/// multiplies that if its ink is transparent.
template <class Channel = std::uint8_t>
Grid<glm::vec<3, Channel>> ink_on_paper(std::span<const Grid<float>> coverage, std::span<const Pen> pens,
                                        glm::vec3 paper);

// Strokes as pixels, as core/output/raster.h has it for dots: a pixel's coverage is the share of its sample
// points that a pen of that width, with round ends, has gone over.

/// Draws the page in bands as rasterise() does of dots; request.dots_at_once is of lines here, 32 bytes each,
/// and the radius has no say.
void rasterise(const StrokeStream& strokes, const PageSize& page, const RasterRequest& request,
               const CoverageSink& sink);

/// The same for strokes of several pens, so many: a coverage for each.
void rasterise_pens(const StrokeStream& strokes, const PageSize& page, const RasterRequest& request,
                    std::size_t pens, const PenCoverageSink& sink);

/// All bands in one.
Grid<float> coverage_of(const StrokeStream& strokes, const PageSize& page, const RasterRequest& request);

}  // namespace dapple
