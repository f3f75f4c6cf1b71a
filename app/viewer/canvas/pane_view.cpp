#include "app/viewer/canvas/pane_view.h"

#include <cmath>

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
    const glm::dvec2 all(picture), size(framing.size());
    const auto share = [&](glm::dvec2 framed) { return glm::vec2(opened_pixel(framing, framed) / all); };
    const glm::vec2 corner = share({0, 0});
    return {corner, share({size.x, 0}) - corner, share({0, size.y}) - corner};
}

namespace {

CanvasLook look_of(const ComparedPanes& compared, const Pane& pane, const Zoom& zoom, float pixel_scale) {
    const Session& session = compared.session();
    const ViewerSettings& settings = session.settings;
    const DrawingSettings& drawing = compared.settings_of(pane);
    CanvasLook look;
    look.desk = rgb_of(ThemeColour::surround);
    look.paper = drawing.paper;
    look.ink = drawing.ink;
    look.dot_radius = pane.page().dot_radius();
    if (settings.density.source == DensitySource::photograph) look.picture_opacity = settings.picture_opacity;
    look.sheet = sheet_around(pane.page().layout);
    if (settings.density.source == DensitySource::photograph &&
        pane.page().plan.framing.pixels != Rectangle<int>{})
        look.picture_view = view_of(pane.page().plan.framing, pane.page().plan.opened);
    look.picture_gain = std::exp2(pane.page().plan.tone.exposure - session.picture().exposure);
    look.tiles = drawing.show_tiles;
    look.fade_scale = pane.fade_scale(zoom);
    if (look.fade_scale > 0) look.dot_radius /= zoom.enlargement;
    look.pixel_scale = pixel_scale;
    look.hidden_pens = hidden_among(pane.shown().plan.pens, session.shown_pens);
    if (compared.instead() == SeenInstead::photograph) {
        look.picture_opacity = 1;
        look.dots = false;
    }
    return look;
}

}  // namespace

SplitLook look_of(const ComparedPanes& compared, const Zoom& zoom, float pixel_scale) {
    const Comparison& comparison = compared.session().settings.comparison;
    const Pane &left = compared.seen(), *const right = compared.right();
    SplitLook look{{look_of(compared, left, zoom, pixel_scale),
                    look_of(compared, right ? *right : left, zoom, pixel_scale)}};
    if (comparison.on) look.divider = comparison.divider;
    return look;
}

}  // namespace dapple
