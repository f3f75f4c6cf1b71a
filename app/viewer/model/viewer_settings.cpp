#include "app/viewer/model/viewer_settings.h"

#include <algorithm>

#include "core/settings/drawing_fields.h"
#include "core/settings/setting.h"

namespace dapple {

DotSize dot_size_from(DotSizing sizing, double drawn_radius_mm) {
    const double least = setting::radius.range.least, radius = std::max(drawn_radius_mm, least);
    return {.sizing = sizing,
            .radius_mm = radius,
            .smallest_mm = std::max(0.5 * radius, least),
            .largest_mm = 1.2 * radius};
}

Comparison toggled(Comparison comparison, const DrawingSettings& left) {
    comparison.on = !comparison.on;
    const std::string tile = tile_in_use(left);
    const bool alike =
        comparison.tile == tile && comparison.placer == left.placer && comparison.ranking == left.ranking;
    if (comparison.on && alike) comparison.tile = tile == "paper16" ? kDefaultTile : "paper16";
    return comparison;
}

// Each begins with all members by name: with one more or less it doesn't compile.

static void describe(Fields& fields, DensityChoice& density) {
    auto& [source, grey] = density;
    fields.choice({"source", "Density"}, source);
    fields.number("grey", grey, {0, 1});
}

static void describe(Fields& fields, Comparison& comparison) {
    auto& [on, placer, tile, ranking, by, divider] = comparison;
    fields.flag("on", on);
    fields.choice({"placer", "Right placer"}, placer);
    fields.tile({"tile", "Right tile"}, tile);
    fields.choice({"ranking", "Right ranking"}, ranking);
    fields.choice({"by", "Right side has"}, by);
    fields.number("divider", divider, {0, 1});
}

static void describe(Fields& fields, LoupeChoice& loupe) {
    auto& [on, step] = loupe;
    fields.flag("on", on);
    fields.whole({"step", "Its tiles"}, step, {-3, 3});
}

void describe(Fields& fields, ViewerSettings& settings) {
    auto& [drawing, density, picture_opacity, zoom_mode, colouring, deepest_level, comparison, loupe, origins,
           saving, unit, every_frame] = settings;
    static_cast<void>(every_frame);  // measures the computer: it is over with the window
    describe_drawing(fields, drawing, saving);
    fields.group("density", density);
    fields.group("view", [&](Fields& view) {
        view.number({"picture_opacity", "Photo beneath"}, settings.picture_opacity, {0, 1});
        view.choice({"zoom_mode", "Zooming in"}, settings.zoom_mode);
        view.choice({"colouring", "Dots coloured"}, settings.colouring);
        view.whole({"deepest_level", "Divided up to"}, settings.deepest_level, {0, kDeepestStep});
        view.group({"comparison", "Split view"}, settings.comparison);
        view.group({"loupe", "Loupe"}, settings.loupe);
        view.flag({"origins", "Explain dots"}, settings.origins);
        view.choice({"unit", "Lengths in"}, settings.unit);
    });
}

DotsRequest dots_request(const ViewerSettings& settings) {
    DotsRequest request = dots_request(settings.drawing, settings.density);
    if (settings.drawing.style == DrawingStyle::line) request.line_order = settings.saving.order;
    request.colours.colouring = settings.colouring;
    request.colours.deepest_level = settings.deepest_level;
    // Another ink places nothing anew as long as all dots are drawn in it.
    if (settings.deepest_level < kDeepestStep) request.colours.ink = settings.drawing.ink;
    // A plot by priority is shown with what says when each dot appears.
    const bool by_priority = settings.saving.order == DotOrder::priority;
    if (settings.origins || by_priority) request.drawing.placing.thresholds = true;
    return request;
}

}  // namespace dapple
