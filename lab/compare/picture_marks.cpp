#include "lab/compare/picture_marks.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/image/density.h"
#include "lab/analysis/tone_fidelity.h"
#include "lab/compare/structure.h"

namespace dapple {
namespace {

constexpr double kPixelsPerSpacing = 4;
constexpr double kMeanLightError = 1e-4;

double mean_of(const Grid<float>& grid) {
    return std::accumulate(grid.values.begin(), grid.values.end(), 0.0) / double(grid.values.size());
}

}  // namespace

PixelPage page_of_width(const Grid<float>& light, int width) {
    const double magnification = double(width) / light.width;
    return {width, std::max(1, int(std::lround(light.height * magnification))),
            std::max(light.width, light.height) * magnification};
}

Grid<float> resampled(const Grid<float>& light, const PixelPage& page) {
    const Density picture(light);  // for its bilinear rule
    // Rounded to whole pixels the page may end a fraction of one after the picture.
    const glm::dvec2 last = glm::dvec2(light.width - 0.5, light.height - 0.5) / double(picture.longer_side());
    Grid<float> result(page.width, page.height);
    for (int y = 0; y < page.height; ++y) {
        for (int x = 0; x < page.width; ++x) {
            const glm::dvec2 p = glm::dvec2(x + 0.5, y + 0.5) / page.pixels_per_unit;
            result.at(x, y) = float(picture.at({std::min(p.x, last.x), std::min(p.y, last.y)}));
        }
    }
    return result;
}

Target target_for(const Grid<float>& light, std::size_t dots) {
    Grid<float> cut = light;
    for (float& value : cut.values) value = std::clamp(value, 0.0f, 1.0f);
    const double spacing = std::sqrt(double(light.values.size()) / double(dots));  // own pixels
    const double wanted = std::max(1.0, kPixelsPerSpacing / spacing);
    Target target;
    target.page = page_of_width(light, int(std::ceil(light.width * wanted)));
    target.light = wanted > 1 ? resampled(cut, target.page) : std::move(cut);
    target.blur_px = spacing * target.page.width / light.width;
    return target;
}

double fitted_radius(std::span<const glm::dvec2> dots, const Target& target) {
    const double ink = 1 - mean_of(target.light);
    const auto ink_with = [&](double radius) { return mean_of(raster_of_dots(dots, radius, target.page)); };
    double low = 0, high = target.blur_px / target.page.pixels_per_unit;
    while (ink_with(high) < ink && high < 1) high *= 2;
    while (true) {
        const double middle = (low + high) / 2, drawn = ink_with(middle);
        if (std::abs(drawn - ink) < kMeanLightError || high - low < 1e-9) return middle;
        (drawn < ink ? low : high) = middle;
    }
}

PictureMarks picture_marks(std::span<const glm::dvec2> dots, double radius, const Target& target) {
    Grid<float> drawing = raster_of_dots(dots, radius, target.page);
    for (float& value : drawing.values) value = 1 - value;
    const Structure kept = structure(drawing, target.light, target.blur_px);
    const ToneFidelity tone = tone_fidelity(drawing, target.light, target.blur_px);
    return {kept.ssim, kept.gradients, tone.rms_error, tone.mean_error, kept.ssim_by_light};
}

}  // namespace dapple
