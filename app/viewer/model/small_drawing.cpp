#include "app/viewer/model/small_drawing.h"

#include <algorithm>
#include <utility>

#include "app/files/page_pixels.h"
#include "app/viewer/model/drawn_sheet.h"
#include "app/viewer/model/workbench.h"
#include "core/image/linear_colour.h"

namespace dapple {
namespace {

void show_to(Workbench& bench, const SmallPicture& picture) {
    Picture shown{.light = Grid<float>(picture.width, picture.height),
                  .colours = ColourGrid(picture.width, picture.height)};
    for (std::size_t i = 0; i < picture.values.size(); ++i) {
        const glm::vec3 colour = linear_of(glm::vec3(picture.values[i]) / 255.0f);
        shown.light.values[i] = luminance(colour);
        shown.colours.values[i] = packed(colour);
    }
    bench.set_picture(std::move(shown));
}

}  // namespace

SmallPicture small_drawing(const SmallPicture& picture, DrawingSettings settings, int longer_side,
                           const std::stop_token& stop) {
    settings.relax = std::min(settings.relax.value_or(1), 1);
    Workbench bench;
    show_to(bench, picture);
    PlacedDrawing drawing;
    if (!bench.place(dots_request(settings), drawing, stop)) return {};
    const PageSize page = see_sheet(drawing).page;
    DotStream dots = stream_of(drawing.stippling.dots, drawing.stippling.scale);
    DotPieces along_curve;
    if (settings.style == DrawingStyle::line) {
        along_curve = sorted_by_pen(dots, DotOrder::space);
        dots = stream_of(along_curve, drawing.stippling.scale);
    }
    const Grid<glm::u8vec3> pixels =
        page_pixels(settings, {.dots = dots,
                               .page = page,
                               .pens = drawing.pens,
                               .dot_radius_mm = drawing.dot_radius * page.mm_per_page_unit,
                               .saving = {.dpi = dpi_for(page, longer_side)}});
    SmallPicture shown(pixels.width, pixels.height);
    std::ranges::transform(pixels.values, shown.values.begin(),
                           [](glm::u8vec3 pixel) { return glm::u8vec4(pixel, 255); });
    return shown;
}

}  // namespace dapple
