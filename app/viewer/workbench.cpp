#include "app/viewer/workbench.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>

#include "app/drawing_steps.h"
#include "app/files/tile_library.h"
#include "core/image/tone.h"

namespace dapple {

PlaceOrder order_of(const DrawingSettings& settings, const DensityChoice& density) {
    return {settings.tone,
            tile_in_use(settings),
            settings.ranking,
            settings.stipple,
            settings.show_tiles,
            {},
            density,
            {}};
}

void Workbench::set_picture(Grid<float> light) {
    light_ = std::move(light);
    tone_.reset();
}

const Density& Workbench::density(const Tone& tone, const DensityChoice& choice) {
    assert(has_picture());
    if (tone_ != tone || choice_ != choice) {
        tone_.reset();
        if (choice.source == DensitySource::photograph)
            density_.emplace(density_of(light_, tone));
        else
            density_.emplace(plain_density(choice));
        tone_ = tone;
        choice_ = choice;
    }
    return *density_;
}

RankedTile& Workbench::tile(const std::string& name, std::optional<RankingOrder> ranking) {
    TileKey key{name, ranking};
    if (tile_key_ != key) {
        tile_key_.reset();
        tile_.emplace(tile_named(name, ranking));
        tile_key_ = std::move(key);
    }
    return *tile_;
}

namespace {

// Figure 8's count for a scale is known once it is placed; a few rounds come within a hundredth.
bool stipple_about(RankedTile& tile, const Density& page, StippleRequest request, Stippling& result,
                   const std::stop_token& stop) {
    constexpr int kRounds = 4;
    const auto wanted = static_cast<double>(*request.count);
    request.count.reset();
    request.scale = wanted / (16 * std::max(page.mean(), 1e-9));
    for (int round = 0; round < kRounds; ++round) {
        if (!stipple(tile, page, request, result, stop)) return false;
        const double found = static_cast<double>(result.dots.size() - result.duplicates);
        if (std::abs(found / wanted - 1) < 0.01) break;
        request.scale *= std::clamp(wanted / std::max(found, 1.0), 0.25, 4.0);
    }
    return true;
}

bool place_page(RankedTile& ranked, const Density& page, const PlaceOrder& order, PlacedDrawing& drawing,
                const std::stop_token& stop) {
    const bool about = order.stipple.placer == PlacerKind::figure8 && order.stipple.count;
    if (!(about ? stipple_about(ranked, page, order.stipple, drawing.stippling, stop)
                : stipple(ranked, page, order.stipple, drawing.stippling, stop)))
        return false;
    drawing.outlines.clear();
    if (order.outlines)
        drawing.outlines = tiles_of(ranked, page, order.stipple.placer, drawing.stippling.scale);
    return true;
}

bool place_close(RankedTile& ranked, const Density& page, const PlaceOrder& order, PlacedDrawing& drawing,
                 const std::stop_token& stop) {
    const auto begin = std::chrono::steady_clock::now();
    const PlacingRequest request{.scale = order.close->scale,
                                 .window = order.close->window,
                                 .critical = true,
                                 .threads = order.stipple.threads};
    drawing.stippling.scale = request.scale;
    drawing.stippling.duplicates = 0;
    if (!ranked.placer().place(page, request, drawing.stippling.dots, stop)) return false;
    const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - begin;
    drawing.stippling.place_ms = passed.count();
    drawing.outlines.clear();
    if (order.outlines) drawing.outlines = placed_tiles(ranked.placer().table(), page, request);
    return true;
}

}  // namespace

bool Workbench::place(const PlaceOrder& order, PlacedDrawing& drawing, std::stop_token stop) {
    auto begin = std::chrono::steady_clock::now();
    bool toned = tone_ == order.tone && choice_ == order.density;
    const Density& page = density(order.tone, order.density);
    std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - begin;
    drawing.tone_ms = toned ? 0 : passed.count();
    drawing.page_size = glm::dvec2(page.width(), page.height()) / static_cast<double>(page.longer_side());
    RankedTile& ranked = tile(order.tile, order.ranking);
    drawing.window = {};
    if (order.close) drawing.window = order.close->window;
    const auto place_dots = order.close ? place_close : place_page;
    if (!place_dots(ranked, page, order, drawing, stop)) return false;
    // Figure 8 turns no tile.
    const bool turns = order.stipple.placer == PlacerKind::exact;
    drawing.colours = chosen_colours(
        drawing.stippling.dots, {ranked.tile().size(), turns ? ranked.tile().rule : Rule{}, drawing.window},
        order.colours);
    return true;
}

}  // namespace dapple
