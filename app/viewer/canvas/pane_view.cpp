#include "app/viewer/canvas/pane_view.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "app/viewer/widgets/theme.h"

namespace dapple {

CanvasLook look_of(const Session& session, const Pane& pane, const Zoom& zoom, float pixel_scale) {
    const ViewerSettings& settings = session.settings;
    CanvasLook look;
    look.desk = rgb_of(ThemeColour::surround);
    look.paper = settings.drawing.paper;
    look.ink = settings.drawing.ink;
    look.dot_radius = pane.page().dot_radius;
    if (settings.density.source == DensitySource::photograph) look.picture_opacity = settings.picture_opacity;
    look.picture_gain = std::exp2(pane.page().tone.exposure - session.picture().exposure);
    look.tiles = settings.drawing.show_tiles;
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
    return points_in_view(shown.stippling.dots, {low, high - low});
}

}  // namespace dapple
