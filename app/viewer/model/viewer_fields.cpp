#include "app/viewer/model/viewer_fields.h"

#include "app/settings/drawing_fields.h"

namespace dapple {

// Each begins with all members by name: with one more or less it doesn't compile.

static void describe(Fields& fields, DensityChoice& density) {
    auto& [source, grey] = density;
    fields.choice("source", source,
                  {NamedValue{"photograph", DensitySource::photograph},
                   NamedValue{"grey", DensitySource::grey}, NamedValue{"ramp", DensitySource::ramp}});
    fields.number("grey", grey, {0, 1});
}

static void describe(Fields& fields, Comparison& comparison) {
    auto& [on, placer, tile, ranking, by, divider] = comparison;
    fields.flag("on", on);
    fields.choice("placer", placer, {PlacerKind::exact, PlacerKind::figure8});
    fields.tile("tile", tile);
    fields.choice("ranking", ranking, {RankingMethod::paper, RankingMethod::farthest, RankingMethod::energy});
    fields.choice("by", by, {NamedValue{"scale", CompareBy::scale}, NamedValue{"count", CompareBy::count}});
    fields.number("divider", divider, {0, 1});
}

static void describe(Fields& fields, LoupeChoice& loupe) {
    auto& [on, step] = loupe;
    fields.flag("on", on);
    fields.whole("step", step, {-3, 3});
}

void describe(Fields& fields, ViewerSettings& settings) {
    auto& [drawing, density, picture_opacity, zoom_mode, colouring, deepest_level, comparison, loupe, origins,
           saving, unit, every_frame] = settings;
    static_cast<void>(every_frame);  // measures the computer: it is over with the window
    describe_drawing(fields, drawing, saving);
    fields.group("density", density);
    fields.group("view", [&](Fields& view) {
        view.number("picture_opacity", settings.picture_opacity, {0, 1});
        view.choice("zoom_mode", settings.zoom_mode,
                    {NamedValue{"drawing", ZoomMode::drawing},
                     NamedValue{"constant_density", ZoomMode::constant_density}});
        view.choice(
            "colouring", settings.colouring,
            {NamedValue{"ink", DotColouring::ink}, NamedValue{"level", DotColouring::level},
             NamedValue{"rank", DotColouring::rank}, NamedValue{"orientation", DotColouring::orientation}});
        view.whole("deepest_level", settings.deepest_level, {0, kDeepestStep});
        view.group("comparison", settings.comparison);
        view.group("loupe", settings.loupe);
        view.flag("origins", settings.origins);
        view.choice("unit", settings.unit,
                    {NamedValue{"mm", LengthUnit::mm}, NamedValue{"inch", LengthUnit::inch}});
    });
}

}  // namespace dapple
