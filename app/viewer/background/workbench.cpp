#include "app/viewer/background/workbench.h"

#include <malloc.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <new>
#include <utility>

#include "app/viewer/background/small_pictures.h"
#include "io/files/tile_library.h"

#ifdef __GLIBC__
#endif

namespace dapple {

namespace {

std::vector<glm::vec2> points_by_rank(const Tile& tile, const std::vector<int>& ranks) {
    std::vector<glm::vec2> points(tile.size());
    for (std::size_t i = 0; i < tile.size(); ++i) points[ranks[i]] = to_unit_square(tile.points[i]);
    return points;
}

// The upper left corner of a cell in units of its side: its index's base-4 digits are quadrants.
glm::vec2 corner_of_cell(std::size_t index, int depth) {
    glm::vec2 corner{0, 0};
    for (int level = 0; level < depth; ++level) {
        const auto weight = static_cast<float>(1 << level);
        corner.x += weight * static_cast<float>(index & 1);
        corner.y += weight * static_cast<float>((index >> 1) & 1);
        index >>= 2;
    }
    return corner;
}

// The tile's own points, then the newborn ones.
std::vector<glm::vec2> points_by_rank(const PlacingTable& table) {
    std::vector<std::pair<float, glm::vec2>> born;
    const auto side = std::ldexp(1.0f, -table.cell_depth);
    for (std::size_t c = 0; c < table.cells.size(); ++c) {
        const glm::vec2 corner = corner_of_cell(c, table.cell_depth);
        const CellPoints& points = table.cells[c].all;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const CellPoint point = points[i];
            born.emplace_back(point.rank, (corner + glm::vec2(point.x, point.y) * 0.5f + 0.5f) * side);
        }
    }
    std::ranges::stable_sort(born, {}, &std::pair<float, glm::vec2>::first);
    std::vector<glm::vec2> points;
    for (const auto& [rank, point] : born) points.push_back(point);
    return points;
}

constexpr std::size_t kMostSpare = 2;
constexpr std::size_t kManyDots = 1'000'000;  // fewer are not worth giving their memory back

std::size_t room_of(const PlacedDrawing& drawing) {
    std::size_t room = 0;
    for (const Dots& piece : drawing.dots.pieces) room += piece.x.capacity();
    return room;
}

bool far_too_large(std::size_t room, std::size_t dots) {
    return room > kManyDots && room > 4 * dots;
}

// What was freed in small pieces stays with the C library otherwise.
void give_memory_back() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

// Frees what a drawing has far more room for than it has dots.
void shrink_if_far_too_large(PlacedDrawing& drawing) {
    if (!far_too_large(room_of(drawing), drawing.dots.size())) return;
    for (Dots& piece : drawing.dots.pieces) {
        for (FloatBuffer* column : {&piece.x, &piece.y, &piece.threshold, &piece.critical, &piece.radius})
            column->shrink_to_fit();
    }
    drawing.colours.shrink_to_fit();
    give_memory_back();
}

using Clock = std::chrono::steady_clock;

// A drawing that takes longer to settle is shown on its way.
constexpr std::chrono::milliseconds kFrame(16);
// With the warp that comes with them they show what the drawing will be like; the rest waits for the hand.
constexpr int kStepsWhileHeld = 2;
constexpr double kSecondsADotAndStep = 0.4e-6;  // about, on two processor cores

constexpr std::size_t kDotsRoutedSoon = 2000;

bool looks_like_environment(const Grid<float>& light) {
    return light.width == 2 * light.height && std::ranges::max(light.values) > 1;
}

bool same_tile(const DotsRequest& a, const DotsRequest& b) {
    const DrawingSettings &one = a.drawing, &other = b.drawing;
    return one.tile == other.tile && one.ranking == other.ranking && one.placer == other.placer;
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

PlacingRequest close_placing(const Density& page, const DotsRequest& request) {
    // A window may be as small as 2^-41 of the page.
    const double most = static_cast<double>(request.most_dots);
    const double limit = most / (kDotsPerScale * std::max(density_in(page, request.close->window), 1e-200));
    return {.scale = std::min(request.close->scale, limit),
            .threads = request.drawing.placing.threads,
            .thresholds = true,
            .window = request.close->window};
}

}  // namespace

TileView view_of(std::string name, RankedTile& tile, PlacerKind placer) {
    if (placer == PlacerKind::figure8)
        return {std::move(name), tile.tile().rule, points_by_rank(tile.tile(), tile.own_ranks())};
    std::vector<glm::vec2> points = points_by_rank(tile.placer().table());
    const auto own = points.begin() + static_cast<std::ptrdiff_t>(tile.tile().size());
    TileView view{std::move(name), tile.tile().rule, {points.begin(), own}, {}, tile.tile().next_kind};
    if (tile.tile().kinds() == 1) view.newborn.assign(own, points.end());
    return view;
}

// Keeps few, and none with far more room than drawings of so many dots as the last need.
void Workbench::sort_spare() {
    std::size_t freed = 0;
    std::vector<PlacedDrawing> kept;
    for (PlacedDrawing& drawing : spare_) {
        const std::size_t room = room_of(drawing);
        if (kept.size() < kMostSpare && !far_too_large(room, last_size_))
            kept.push_back(std::move(drawing));
        else
            freed += room;
    }
    spare_ = std::move(kept);
    if (freed > kManyDots) give_memory_back();
}

DrawingPlan Workbench::plan(const DotsRequest& request) {
    if (std::exchange(choice_, request.density) != request.density) {
        if (choice_.source == DensitySource::photograph)
            pipeline_.set_plain({});
        else
            pipeline_.set_plain(plain_density(choice_));
    }
    DrawingSettings drawing = request.drawing;
    if (std::pair named(drawing.tile, drawing.ranking); tile_ != named) {
        tile_.reset();
        pipeline_.set_tile(tile_named(drawing.tile, drawing.ranking));
        tile_ = std::move(named);
    }
    if (needs_thresholds(request.colours)) drawing.placing.thresholds = true;
    if (request.close) drawing.mask = drawing.mask.without_finer();  // all dots are alike there
    return pipeline_.plan(drawing, request.most_dots);
}

bool Workbench::draw(const DotsRequest& request, const DrawingPlan& plan, Stippling& drawn,
                     const DrawingWatch& watch) {
    DotsRequest unedited = request;
    unedited.drawing.edits.clear();
    const Stippling* const known = unedited_.find(unedited);
    if (known)
        drawn = *known;
    else if (!pipeline_.settle(plan, drawn, watch))
        return false;
    if (!known && drawn.dots.size() <= kManyDots && drawn.steps == plan.steps)
        unedited_.keep(std::move(unedited), drawn);
    Pipeline::finish(plan, drawn);
    return true;
}

bool Workbench::place(const DotsRequest& request, PlacedDrawing& drawing, std::stop_token stop,
                      const Unsettled& unsettled) {
    DrawingPlan made = plan(request);
    if (request.in_part) made.placing.thresholds = true;
    const Density& page = *made.density;
    if (request.close) {  // as placed
        made.placing = close_placing(page, request);
        made.steps = 0;
        made.pens = {};
    }
    Placer& placer = pipeline_.tile().placer();
    placer.report_share(share_);
    // Figure 8 turns no tile, and begins at the page's corner.
    const bool turns = request.drawing.placer == PlacerKind::exact;
    const Tile& tile = pipeline_.tile().tile();
    const auto finish = [&](PlacedDrawing& placed) {
        placed.request = request;
        placed.plan = made;
        placed.plan.density.reset();
        placed.plan.by_pen = {};
        placed.tone_ms = pipeline_.tone_ms();
        placed.layout = made.layout(placed.scale);
        placed.tile_corner = turns ? page.tile_corner() : glm::dvec2(0);
        placed.outlines.clear();
        if (request.drawing.show_tiles)
            placed.outlines = request.close ? placed_tiles(placer.table(), page, made.placing)
                                            : pipeline_.outlines(made, placed.scale);
        placed.ink = {.relaxing_steps = placed.steps, .level = level_of(placed.scale, tile.size())};
        const bool discs = request.drawing.style == DrawingStyle::dots && is_disc(request.drawing.mark.shape);
        placed.dots_for_tone = made.size.sizing == DotSizing::fixed && discs ? made.dots_for_tone() : 0;
        placed.colours = chosen_colours(
            placed.dots,
            {tile.size(), turns ? tile.rule : Rule{}, placed.window(), tile.next_kind, placed.tile_corner},
            request.colours);
    };
    DrawingWatch watch{.stop = stop, .step = {}};
    if (unsettled) {
        watch.step = [&](const Stippling& drawn, const std::function<DotPieces()>& dots) {
            return unsettled([&] {
                PlacedDrawing now;
                static_cast<Stippling&>(now) = {.dots = dots(),
                                                .steps = drawn.steps,
                                                .scale = drawn.scale,
                                                .place_ms = drawn.place_ms,
                                                .relax_ms = drawn.relax_ms};
                finish(now);
                return now;
            });
        };
    }
    if (!(request.close ? stipple(pipeline_.tile(), page, made.placer, made.placing, drawing, stop)
                        : draw(request, made, drawing, watch)))
        return false;
    finish(drawing);
    return true;
}

std::string words_of_exception() {
    try {
        throw;
    } catch (const std::bad_alloc&) {
        return "Not enough memory for this.";
    } catch (const std::exception& error) {
        return error.what();
    }
}

void Workbench::open(Picture picture, OpenedPicture about) {
    // A first look that was not shown has nothing to refine.
    if (arrived_) about.refines = about.refines && arrived_->refines;
    about.description = picture.description;
    about.longer_side = std::max(picture.light.width, picture.light.height);
    about.exposure = picture.exposure;
    about.looks_like_environment = looks_like_environment(picture.light);
    about.preview =
        std::make_shared<const std::vector<Grid<glm::u8vec4>>>(mipmaps_of(std::move(picture.preview)));
    set_picture(std::move(picture));
    arrived_ = std::move(about);
}

// What the window needs beyond the drawing, and nothing that it doesn't.
DotsPlaced Workbench::ready_for_screen(const DotsRequest& request, PlacedDrawing drawing, LineWay way,
                                       const std::stop_token& stop) {
    drawing.blocks = dot_blocks(drawing.dots);
    drawing.strokes = {};
    // Looked at closely, there are more dots with every zoom: they are shown as such.
    if (draws_strokes(request.drawing) && !request.close)
        drawing.strokes = shown_strokes(drawing.dots, request.drawing, request.line_order, drawing.plan.pens,
                                        drawing.layout.page, drawing.dot_radius(), way, stop);
    drawing.inking = {};
    if (drawing.plan.inking)
        drawing.inking =
            shown_inking(*drawing.plan.inking, drawing.plan.pens, {drawing.window().x, drawing.window().y});
    // Large tiles first: see Renderer::set_tiles().
    std::ranges::stable_sort(drawing.outlines, {}, &PlacedTile::level);
    shrink_if_far_too_large(drawing);
    DotsPlaced placed;
    placed.drawing = std::move(drawing);
    if (!tile_published_ || !same_tile(*tile_published_, request)) {
        placed.tile = view_of(request.drawing.tile, pipeline_.tile(), request.drawing.placer);
        tile_published_ = request;
    }
    placed.picture = std::exchange(arrived_, std::nullopt);
    return placed;
}

std::optional<DotsPlaced> Workbench::place_for_screen(const DotsRequest& request,
                                                      const Background<DotsPlaced>::Task& task) {
    const std::stop_token& stop = task.stop();
    share_ = &task.share();
    // What is seen of the same drawing is not replaced by less settled dots.
    DotsRequest let_go = request;
    let_go.held = false;
    const bool settled_only =
        request.settled_only || (settled_ == let_go && (!arrived_ || arrived_->refines));
    // Steps that fit into a frame are not shown one by one.
    auto shown = Clock::now();
    const std::chrono::duration<double> step(static_cast<double>(request.drawing.placing.count.value_or(0)) *
                                             kSecondsADotAndStep);
    // The longer it takes, the more rarely it is shown: whoever looks sees each whole, and relaxing goes on.
    const auto begun = shown;
    int steps = 0;
    const Unsettled unsettled = [&](const std::function<PlacedDrawing()>& drawing) {
        if (stop.stop_requested() || (request.held && steps == kStepsWhileHeld)) return false;
        ++steps;
        if (settled_only ||
            Clock::now() + step - shown < std::max<Clock::duration>(kFrame, (shown - begun) / 4))
            return true;
        task.publish(ready_for_screen(request, drawing(), LineWay::soon, stop));
        shown = Clock::now();
        return true;
    };
    PlacedDrawing drawing;
    if (!spare_.empty()) {
        drawing = std::move(spare_.back());
        spare_.pop_back();
    }
    try {
        if (!place(request, drawing, stop, unsettled) || stop.stop_requested()) {
            give_back(std::move(drawing));
            return std::nullopt;
        }
        last_size_ = drawing.dots.size();
        // A line's way takes longer than its dots.
        if (request.drawing.style == DrawingStyle::line && !request.close && !settled_only &&
            last_size_ > kDotsRoutedSoon)
            task.publish(ready_for_screen(request, drawing, LineWay::soon, stop));
        DotsPlaced placed = ready_for_screen(request, std::move(drawing), LineWay::final, stop);
        if (stop.stop_requested()) {
            give_back(std::move(placed.drawing));
            return std::nullopt;
        }
        sort_spare();
        settled_ = std::move(let_go);
        return placed;
    } catch (...) {
        DotsPlaced failed;
        failed.drawing.request = request;
        failed.error = words_of_exception();
        failed.picture = std::exchange(arrived_, std::nullopt);
        return failed;
    }
}

void Workbench::clear() {
    pipeline_ = {};
    choice_ = {};
    unedited_.forget();
    tile_.reset();
    share_ = nullptr;
    arrived_.reset();
    last_size_ = 0;
    spare_ = {};
    give_memory_back();
}

}  // namespace dapple
