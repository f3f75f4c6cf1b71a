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

// Figure 8 emits every fourth dot once more, a little more or less.
constexpr double kWithDuplicates = 1.4;

// The scale of about so many dots where the density over an area has that mean.
double scale_for(std::uint64_t dots, double mean_times_area) {
    // A window may be as small as 2^-41 of the page.
    return static_cast<double>(dots) / (16 * std::max(mean_times_area, 1e-200));
}

StippleRequest within_limit(StippleRequest request, const Density& page, std::uint64_t most) {
    if (request.placer == PlacerKind::figure8)
        most = static_cast<std::uint64_t>(static_cast<double>(most) / kWithDuplicates);
    if (request.count)
        request.count = std::min(*request.count, most);
    else
        request.scale = std::min(request.scale, scale_for(most, page.mean()));
    return request;
}

// Mean over a window by so many samples along each side, times the window's area.
double density_in(const Density& page, const PageWindow& window) {
    constexpr int kSamples = 64;
    double sum = 0;
    for (int y = 0; y < kSamples; ++y)
        for (int x = 0; x < kSamples; ++x)
            sum += page.at({static_cast<double>(window.x) * 0x1p-62 + window.width * (x + 0.5) / kSamples,
                            static_cast<double>(window.y) * 0x1p-62 + window.height * (y + 0.5) / kSamples});
    return sum / (kSamples * kSamples) * window.width * window.height;
}

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
    StippleRequest request = within_limit(order.stipple, page, order.most_dots);
    if (tells_birthplaces(order.colours)) request.appearance = true;
    const bool about = request.placer == PlacerKind::figure8 && request.count;
    if (!(about ? stipple_about(ranked, page, request, drawing.stippling, stop)
                : stipple(ranked, page, request, drawing.stippling, stop)))
        return false;
    drawing.outlines.clear();
    if (order.outlines)
        drawing.outlines = tiles_of(ranked, page, order.stipple.placer, drawing.stippling.scale);
    return true;
}

bool place_close(RankedTile& ranked, const Density& page, const PlaceOrder& order, PlacedDrawing& drawing,
                 const std::stop_token& stop) {
    const auto begin = std::chrono::steady_clock::now();
    const double limit = scale_for(order.most_dots, density_in(page, order.close->window));
    const PlacingRequest request{.scale = std::min(order.close->scale, limit),
                                 .window = order.close->window,
                                 .appearance = true,
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
