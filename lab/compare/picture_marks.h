#pragma once
// How near a drawing comes to its photograph, as pixels.

#include <array>
#include <glm/vec2.hpp>
#include <span>

#include "core/image/grid.h"
#include "lab/analysis/seams.h"

namespace dapple {

/// What a drawing of so many dots is compared with.
struct Target {
    Grid<float> light;   // linear, 0 black .. 1 paper
    PixelPage page;      // its pixels; the longer side is one unit
    double blur_px = 0;  // one mean spacing, the root of the page's area over the number of dots
};

/// The page that a picture fills, so many pixels wide.
PixelPage page_of_width(const Grid<float>& light, int width);

/// The picture with that page's pixels, bilinear: for pages as large as the picture or larger.
Grid<float> resampled(const Grid<float>& light, const PixelPage& page);

/// The photograph's light, 0 black to 1 paper (cut off there), at its own size, or magnified (bilinear) so
/// far that a mean spacing is 4 pixels.
Target target_for(const Grid<float>& light, std::size_t dots);

/// The radius, in units, with which the drawing's mean light is the target's, within a ten-thousandth.
double fitted_radius(std::span<const glm::dvec2> dots, const Target& target);

/// Drawing and target compared after a blur of one mean spacing.
struct PictureMarks {
    double ssim = 0, gradients = 0;         // lab/compare/structure.h
    double tone_error = 0;                  // root mean square, in linear light
    double mean_error = 0;                  // of drawing - target, in linear light
    std::array<double, 4> ssim_by_light{};  // lab/compare/structure.h
};

PictureMarks picture_marks(std::span<const glm::dvec2> dots, double radius, const Target& target);

}  // namespace dapple
