#include "app/viewer/model/placing_bench.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <new>
#include <utility>

#include "app/viewer/model/mipmaps.h"

namespace dapple {
namespace {

using Clock = std::chrono::steady_clock;

// A drawing that takes longer to settle is shown on its way.
constexpr std::chrono::milliseconds kFrame(16);
constexpr double kSecondsADotAndStep = 0.4e-6;  // about, on two processor cores

bool looks_like_environment(const Grid<float>& light) {
    return light.width == 2 * light.height && std::ranges::max(light.values) > 1;
}

bool same_tile(const DotsRequest& a, const DotsRequest& b) {
    return a.tile == b.tile && a.ranking == b.ranking && a.drawing.placer == b.drawing.placer;
}

}  // namespace

std::string words_of_exception() {
    try {
        throw;
    } catch (const std::bad_alloc&) {
        return "There is not enough memory for this.";
    } catch (const std::exception& error) {
        return error.what();
    }
}

void PlacingBench::open(const std::string& name, const std::function<Picture()>& read,
                        const std::filesystem::path& file) {
    Picture picture = read();
    const int longer = std::max(picture.light.width, picture.light.height);
    const bool environment = looks_like_environment(picture.light);
    workbench_.set_picture(std::move(picture.light), picture.exposure);
    arrived_ = OpenedPicture{
        .file = file,
        .name = name,
        .description = picture.description,
        .longer_side = longer,
        .preview =
            std::make_shared<const std::vector<Grid<glm::u8vec4>>>(mipmaps_of(std::move(picture.preview))),
        .exposure = picture.exposure,
        .read = read,
        .looks_like_environment = environment,
    };
}

// What the window needs beyond the drawing, and nothing that it doesn't.
DotsPlaced PlacingBench::ready_for_screen(const DotsRequest& request, PlacedDrawing drawing) {
    drawing.blocks = dot_blocks(drawing.stippling.dots);
    // Large tiles first: see Renderer::set_tiles().
    std::ranges::stable_sort(drawing.outlines, {}, &PlacedTile::level);
    shrink_if_far_too_large(drawing);
    DotsPlaced placed;
    placed.request = request;
    placed.drawing = std::move(drawing);
    if (!tile_published_ || !same_tile(*tile_published_, request)) {
        placed.tile = view_of(request.tile, workbench_.pipeline().tile(), request.drawing.placer);
        tile_published_ = request;
    }
    placed.picture = std::exchange(arrived_, std::nullopt);
    return placed;
}

std::optional<PlacingBench::Result> PlacingBench::place(const DotsRequest& request, const Task& task) {
    const std::stop_token& stop = task.stop();
    workbench_.report_share(&task.share());
    // Steps that fit into a frame are not shown one by one.
    auto shown = Clock::now();
    const std::chrono::duration<double> step(static_cast<double>(request.drawing.placing.count.value_or(0)) *
                                             kSecondsADotAndStep);
    const Unsettled unsettled = [&](const std::function<PlacedDrawing()>& drawing) {
        if (stop.stop_requested()) return false;
        if (request.settled_only || Clock::now() + step - shown < kFrame) return true;
        task.publish(ready_for_screen(request, drawing()));
        shown = Clock::now();
        return true;
    };
    PlacedDrawing drawing = spare_.take();
    try {
        if (!workbench_.place(request, drawing, stop, unsettled) || stop.stop_requested()) {
            spare_.give_back(std::move(drawing));
            return std::nullopt;
        }
        last_size_ = drawing.stippling.dots.size();
        DotsPlaced placed = ready_for_screen(request, std::move(drawing));
        sort_spare();
        return placed;
    } catch (...) {
        DotsPlaced failed;
        failed.request = request;
        failed.error = words_of_exception();
        failed.picture = std::exchange(arrived_, std::nullopt);
        return failed;
    }
}

std::optional<PlacingBench::Result> PlacingBench::prepare(const PrepareFile& prepare, const Task& task) {
    return FilePrepared{prepare(workbench_, task.stop())};
}

void PlacingBench::clear() {
    workbench_ = {};
    arrived_.reset();
    last_size_ = 0;
    spare_ = {};
    give_memory_back();
}

}  // namespace dapple
