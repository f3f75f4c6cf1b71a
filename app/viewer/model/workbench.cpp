#include "app/viewer/model/workbench.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "app/files/tile_library.h"

namespace dapple {

DotsRequest dots_request(const DrawingSettings& settings, const DensityChoice& density) {
    return {.drawing = request_of(settings),
            .tile = tile_in_use(settings),
            .ranking = settings.ranking,
            .outlines = settings.show_tiles,
            .density = density};
}

void Workbench::set_picture(Grid<float> light, float usual_exposure) {
    pipeline_.set_light(std::move(light), usual_exposure);
}

DrawingPlan Workbench::plan(const DotsRequest& request) {
    if (std::exchange(choice_, request.density) != request.density) {
        if (choice_.source == DensitySource::photograph)
            pipeline_.set_plain({});
        else
            pipeline_.set_plain(plain_density(choice_));
    }
    TileKey key{request.tile, request.ranking};
    if (tile_key_ != key) {
        tile_key_.reset();
        pipeline_.set_tile(tile_named(request.tile, request.ranking));
        tile_key_ = std::move(key);
    }
    DrawingRequest drawing = request.drawing;
    if (needs_thresholds(request.colours)) drawing.placing.thresholds = true;
    return pipeline_.plan(drawing);
}

namespace {

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

bool place_close(Pipeline& pipeline, const DrawingPlan& plan, const DotsRequest& request,
                 PlacedDrawing& drawing, const std::stop_token& stop) {
    const auto begin = std::chrono::steady_clock::now();
    // A window may be as small as 2^-41 of the page.
    const double most = static_cast<double>(request.drawing.most_dots);
    const double limit =
        most / (kDotsPerScale * std::max(density_in(*plan.density, request.close->window), 1e-200));
    const PlacingRequest placing{.scale = std::min(request.close->scale, limit),
                                 .threads = request.drawing.placing.threads,
                                 .thresholds = true,
                                 .window = request.close->window};
    Placer& placer = pipeline.tile().placer();
    drawing.stippling.scale = placing.scale;
    drawing.stippling.duplicates = 0;
    if (!placer.place(*plan.density, placing, drawing.stippling.dots, stop)) return false;
    const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - begin;
    drawing.stippling.place_ms = passed.count();
    drawing.steps = drawing.all_steps = 0;
    drawing.relax_ms = 0;
    drawing.outlines.clear();
    if (request.outlines) drawing.outlines = placed_tiles(placer.table(), *plan.density, placing);
    return true;
}

bool place_page(Pipeline& pipeline, const DrawingPlan& plan, const DotsRequest& request,
                PlacedDrawing& drawing, const std::stop_token& stop, const auto& finish,
                const Unsettled& unsettled) {
    DrawingWatch watch{.stop = stop, .step = {}};
    if (unsettled) {
        watch.step = [&](const Drawn& drawn, const std::function<DotPieces()>& dots) {
            return unsettled([&] {
                PlacedDrawing now;
                now.stippling.dots = dots();
                now.stippling.scale = drawn.stippling.scale;
                now.stippling.place_ms = drawn.stippling.place_ms;
                now.steps = drawn.steps;
                now.all_steps = plan.steps;
                now.relax_ms = drawn.relax_ms;
                if (request.outlines) now.outlines = pipeline.outlines(plan, drawn.stippling.scale);
                finish(now);
                return now;
            });
        };
    }
    Drawn drawn{.stippling = std::move(drawing.stippling)};
    if (!pipeline.draw(plan, drawn, watch)) return false;
    drawing.stippling = std::move(drawn.stippling);
    drawing.steps = drawn.steps;
    drawing.all_steps = plan.steps;
    drawing.relax_ms = drawn.relax_ms;
    drawing.outlines.clear();
    if (request.outlines) drawing.outlines = pipeline.outlines(plan, drawing.stippling.scale);
    return true;
}

}  // namespace

bool Workbench::place(const DotsRequest& request, PlacedDrawing& drawing, std::stop_token stop,
                      const Unsettled& unsettled) {
    const DrawingPlan made = plan(request);
    pipeline_.tile().placer().report_share(share_);
    const Density& page = *made.density;
    // Figure 8 turns no tile.
    const bool turns = request.drawing.placer == PlacerKind::exact;
    const Tile& tile = pipeline_.tile().tile();
    const auto finish = [&](PlacedDrawing& placed) {
        placed.tone = made.tone;
        placed.histogram = made.histogram;
        placed.tone_ms = pipeline_.tone_ms();
        placed.page_size = glm::dvec2(page.width(), page.height()) / static_cast<double>(page.longer_side());
        placed.layout = made.layout(placed.stippling.scale);
        placed.framing = pipeline_.framing();
        placed.picture_pixels = {pipeline_.light().width, pipeline_.light().height};
        placed.window = request.close ? request.close->window : PageWindow{};
        placed.dot_radius = made.radius(placed.stippling.scale);
        placed.colours = chosen_colours(
            placed.stippling.dots, {tile.size(), turns ? tile.rule : Rule{}, placed.window}, request.colours);
    };
    if (!(request.close ? place_close(pipeline_, made, request, drawing, stop)
                        : place_page(pipeline_, made, request, drawing, stop, finish, unsettled)))
        return false;
    finish(drawing);
    return true;
}

}  // namespace dapple
