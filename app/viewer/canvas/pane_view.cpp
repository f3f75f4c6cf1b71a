#include "app/viewer/canvas/pane_view.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "app/viewer/widgets/theme.h"

namespace dapple {

namespace {

// Seen from the picture's corner, in page units.
std::optional<Rectangle<double>> sheet_around(const PageLayout& layout) {
    const double unit = layout.page.mm_per_page_unit;
    const glm::dvec2 page(layout.page.width_mm, layout.page.height_mm);
    if (!(unit > 0) || layout.picture == Rectangle<double>{{0, 0}, page}) return std::nullopt;
    return Rectangle<double>{-layout.picture.low / unit, (page - layout.picture.low) / unit};
}

}  // namespace

PictureView view_of(const Framing& framing, glm::ivec2 picture) {
    const glm::vec2 all(picture), low = glm::vec2(framing.pixels.low) / all,
                                  high = glm::vec2(framing.pixels.high) / all, size = high - low;
    switch (framing.quarter_turns) {
        case 1:
            return {{low.x, high.y}, {0, -size.y}, {size.x, 0}};
        case 2:
            return {high, {-size.x, 0}, {0, -size.y}};
        case 3:
            return {{high.x, low.y}, {0, size.y}, {-size.x, 0}};
        default:
            return {low, {size.x, 0}, {0, size.y}};
    }
}

CanvasLook look_of(const Session& session, const Pane& pane, const Zoom& zoom, float pixel_scale) {
    const ViewerSettings& settings = session.settings;
    const DrawingSettings& drawing = session.settings_of(pane);
    CanvasLook look;
    look.desk = rgb_of(ThemeColour::surround);
    look.paper = drawing.paper;
    look.ink = drawing.ink;
    look.dot_radius = pane.page().dot_radius;
    if (settings.density.source == DensitySource::photograph) look.picture_opacity = settings.picture_opacity;
    look.sheet = sheet_around(pane.page().layout);
    if (settings.density.source == DensitySource::photograph &&
        pane.page().framing.pixels != Rectangle<int>{})
        look.picture_view = view_of(pane.page().framing, pane.page().picture_pixels);
    look.picture_gain = std::exp2(pane.page().tone.exposure - session.picture().exposure);
    look.tiles = drawing.show_tiles;
    look.fade_scale = pane.fade_scale(zoom);
    if (look.fade_scale > 0) look.dot_radius /= zoom.enlargement;
    look.pixel_scale = pixel_scale;
    return look;
}

PointsInView points_on_screen(const PlacedDrawing& shown, const Camera& camera) {
    const PageWindow view = window_in_view(camera, 0);
    // Relative to the dots' origin, which may lie deep within the page.
    const PagePoint origin{shown.window.x, shown.window.y};
    const glm::dvec2 low = in_page_units(PagePoint{view.x, view.y} - origin);
    const glm::dvec2 page_end = shown.page_size - in_page_units(origin);
    const glm::dvec2 high = glm::min(low + glm::dvec2(view.width, view.height), page_end);
    return points_in_view(shown.dots, {low, high}, kMostAnalysed, shown.blocks);
}

}  // namespace dapple
