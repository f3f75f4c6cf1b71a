#pragma once
// Ink as pixels, anti-aliased, without a graphics card.
//
// A pixel's coverage is the share of its 16 x 16 sample points that lie in any dot, or that a pen with a
// round end has gone over: dots and strokes that overlap unite, they do not add up. Ink and paper are mixed
// in linear light, so that a half covered pixel is as light as one that is half ink and half paper.

#include <functional>
#include <glm/gtc/type_precision.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "core/image/grid.h"
#include "core/output/ink.h"

namespace dapple {

struct RasterSize {
    int width = 0, height = 0;  // pixels
};

/// The page at that resolution, rounded to whole pixels, at least 1 x 1. Throws std::runtime_error, telling
/// the resolution that would do, if a side is over 1,000,000 pixels, which is what PNG readers take, or all
/// of it over 4 gigapixels, which is a few minutes' work.
RasterSize raster_size(const PageSize& page, double dpi);

struct RasterRequest {
    double dpi = 300;
    int threads = 1;  // the result is the same for any number; 0: all cores
    // In memory, 8 bytes each, or lines of strokes, 32 bytes each; nor has it a say in the result.
    std::uint64_t dots_at_once = std::uint64_t{1} << 24;
};

/// A stretch of rows, the first of which is row `first_row` of the whole: coverage 0..1, by each of the
/// page's pens, or by the single one.
using CoverageSink = std::function<void(int first_row, std::span<const Grid<float>> coverage)>;

/// Draws the page's dots or strokes in bands, from the top down, each handed to the sink in turn; so a
/// picture of any size, of any number of dots, needs little memory. InkPage::dot_radius_mm is that of the
/// largest where dots have radii of their own. Goes through the ink once to count it, and then once for each
/// stretch of bands that have request.dots_at_once dots or lines together.
void rasterise(const InkPage& page, const RasterRequest& request, const CoverageSink& sink);

/// All bands in one, of a single pen.
Grid<float> coverage_of(const InkPage& page, const RasterRequest& request);

/// sRGB-encoded pixels of that coverage, of 8 or 16 bits a channel. The colours are sRGB-encoded too.
template <class Channel = std::uint8_t>
Grid<glm::vec<3, Channel>> ink_on_paper(const Grid<float>& coverage, glm::vec3 ink, glm::vec3 paper);

/// The same for several pens, each over those before it: each covers its share of what is seen of a pixel, or
/// multiplies that if its ink is transparent.
template <class Channel = std::uint8_t>
Grid<glm::vec<3, Channel>> ink_on_paper(std::span<const Grid<float>> coverage, std::span<const Pen> pens,
                                        glm::vec3 paper);

/// The same for whichever pens the page has.
template <class Channel = std::uint8_t>
Grid<glm::vec<3, Channel>> ink_on_paper(std::span<const Grid<float>> coverage, const InkPage& page,
                                        glm::vec3 paper) {
    return page.pens.empty() ? ink_on_paper<Channel>(coverage[0], page.ink, paper)
                             : ink_on_paper<Channel>(coverage, page.pens, paper);
}

}  // namespace dapple
