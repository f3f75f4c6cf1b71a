#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "bindings/library/state.h"
#include "core/analysis/autocorrelation.h"
#include "core/drawing/drawing_figures.h"
#include "core/drawing/pipeline.h"
#include "core/drawing/write_drawing.h"
#include "core/placing/page.h"
#include "dapple/drawing.h"

namespace dapple {
namespace {

constexpr int kMostThreads = 1024;

// Thrown from within a writer to leave it.
struct Stopped {};

DrawingFormat format_of(FileFormat format) {
    switch (format) {
        case FileFormat::svg:
            return DrawingFormat::svg;
        case FileFormat::gcode:
            return DrawingFormat::gcode;
        case FileFormat::hpgl:
            return DrawingFormat::hpgl;
        case FileFormat::dxf:
            return DrawingFormat::dxf;
        case FileFormat::csv:
            return DrawingFormat::csv;
        case FileFormat::json:
            return DrawingFormat::json;
    }
    throw std::runtime_error("no such format of files");
}

std::vector<DrawingPen> pens_of(const DrawingPlan& plan, const DrawingSettings& settings) {
    const auto of = [](const std::string& name, glm::vec3 colour) {
        return DrawingPen{name, colour.r, colour.g, colour.b};
    };
    std::vector<DrawingPen> pens;
    for (const Pen& pen : plan.pens) pens.push_back(of(pen.name, pen.colour));
    if (pens.empty()) pens.push_back(of(pen_name(settings.ink), settings.ink));
    return pens;
}

Grid<float> grid_of(std::span<const float> values, int width, int height, const char* what) {
    const bool sides = width >= 1 && height >= 1;
    if (!sides || values.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
        throw std::runtime_error(
            fmt::format("{} values for {} of {} x {}", values.size(), what, width, height));
    Grid<float> grid(width, height);
    std::ranges::copy(values, grid.values.begin());
    return grid;
}

}  // namespace

FileFormat file_format(std::string_view name) {
    const std::size_t point = name.rfind('.');
    std::string ending = point == name.npos ? "." + std::string(name) : std::string(name.substr(point));
    for (char& c : ending)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    const std::optional<DrawingFormat> named = format_with_ending(ending);
    for (const FileFormat format : {FileFormat::svg, FileFormat::gcode, FileFormat::hpgl, FileFormat::dxf,
                                    FileFormat::csv, FileFormat::json})
        if (named == format_of(format)) return format;
    throw std::runtime_error(fmt::format("{}: not a format; give svg, gcode, hpgl, dxf, csv or json", name));
}

int checked_threads(int threads) {
    if (threads < 0 || threads > kMostThreads)
        throw std::runtime_error(
            fmt::format("threads is {}; give a whole number from 0 to {}", threads, kMostThreads));
    return threads;
}

struct Drawing::State {
    PlannedDrawing drawing;
    DrawingFile file;
    DrawnPage page;
    std::uint64_t count = 0;
    std::shared_ptr<const DotPieces> held;  // none: there are too many

    DotStream dots() const {
        if (held) return stream_of(held, drawing.scale);
        return drawing.dots(page.whole.part, {});
    }
    // As the format has it, its dots as they were placed.
    DrawingToSave to_save(DrawingFormat format, const std::stop_token& stop = {}) const {
        PlannedDrawing same = drawing;
        if (held) same.dots = [this](const PagePart&, const std::stop_token&) { return dots(); };
        return drawing_on(page, same, in_format(format), stop);
    }
    DrawingFile in_format(DrawingFormat format) const {
        DrawingFile result = file;
        result.format = format;
        return result;
    }
};

std::uint64_t Drawing::count() const {
    return state_->count;
}

double Drawing::page_width_mm() const {
    return state_->page.layout.page.width_mm;
}

double Drawing::page_height_mm() const {
    return state_->page.layout.page.height_mm;
}

std::vector<DrawingPen> Drawing::pens() const {
    return pens_of(state_->drawing.plan, state_->file.settings);
}

bool Drawing::for_each(const std::function<bool(const DotSpan&)>& take) const {
    const auto mm = static_cast<float>(state_->page.layout.page.mm_per_page_unit);
    const auto usual_radius = static_cast<float>(state_->drawing.radius_mm());
    std::vector<float> x, y, radius;
    bool all = true;
    state_->dots().for_each_piece([&](const Dots& piece) {
        const auto in_mm = [mm](const FloatBuffer& from, std::vector<float>& to) {
            to.resize(from.size());
            std::ranges::transform(from, to.begin(), [mm](float units) { return units * mm; });
        };
        in_mm(piece.x, x);
        in_mm(piece.y, y);
        in_mm(piece.radius, radius);
        if (piece.radius.empty()) radius.assign(piece.size(), usual_radius);
        return all = take({x, y, radius, piece.pen});
    });
    return all;
}

std::vector<DrawnTile> Drawing::tiles() const {
    const double mm = state_->page.layout.page.mm_per_page_unit;
    std::vector<PlacedTile> placed = state_->drawing.outlines();
    move_to(state_->page.whole.part, placed);
    std::vector<DrawnTile> tiles;
    tiles.reserve(placed.size());
    for (const PlacedTile& tile : placed)
        tiles.push_back({tile.level, tile.x * mm, tile.y * mm, tile.side * mm, tile.kind.value_or(0)});
    return tiles;
}

double Drawing::period_mm() const {
    const PageSize& page = state_->page.layout.page;
    const double mm = page.mm_per_page_unit;
    const double units = page.width_mm / mm * (page.height_mm / mm);
    const double points = std::max(static_cast<double>(count()), 1.0);
    return mm * tile_period(points / units / static_cast<double>(state_->drawing.tile_size));
}

bool Drawing::write(std::ostream& out, FileFormat kind, const Watch& watch) const {
    const DrawingFormat format = format_of(kind);
    const DrawingSettings& settings = state_->file.settings;
    DrawingToSave drawing = state_->to_save(format, watch.stop);
    const DotOrder order = order_of(drawing, format, settings.style);
    const auto tell = [&](double share) {
        if (watch.progress) watch.progress(share);
    };
    // Half of the progress is the pen's way.
    const double routing = order == DotOrder::shortest ? 0.5 : 0;
    if (order != DotOrder::recursion) {
        auto sorted = std::make_shared<const DotPieces>(
            sorted_by_pen(drawing.dots, order,
                          {.stop = watch.stop, .progress = [&](double share) { tell(routing * share); }}));
        if (watch.stop.stop_requested()) return false;
        drawing.dots = stream_of(std::move(sorted), drawing.dots.scale);
    }
    try {
        write_as(format, out, ink_page(settings, drawing, format), [&](double share) {
            if (watch.stop.stop_requested()) throw Stopped();
            tell(routing + (1 - routing) * share);
        });
    } catch (const Stopped&) {
        return false;
    }
    tell(1);
    return true;
}

std::vector<Advice> Drawing::advice(FileFormat kind, const Watch& watch) const {
    const DrawingFile file = state_->in_format(format_of(kind));
    DrawingToSave drawing = state_->to_save(file.format, watch.stop);
    DotPieces sorted;
    if (state_->held) {
        const DotOrder order = order_of(drawing, file.format, file.settings.style);
        sorted = sorted_by_pen(drawing.dots, order, {.stop = watch.stop, .progress = watch.progress});
        drawing.dots = stream_of(sorted, drawing.dots.scale);
    }
    if (watch.stop.stop_requested()) return {};
    const DrawingFigures figures = figures_of({.plan = state_->drawing.plan,
                                               .file = file,
                                               .page = state_->page,
                                               .drawing = drawing,
                                               .by_pen = state_->held ? &sorted : nullptr});
    std::vector<Advice> advice;
    for (const Finding& finding : figures.findings)
        advice.push_back({std::string(name_of(finding.kind)), sentence_of(finding), finding.amount});
    return advice;
}

PagePixels Drawing::pixels(double dpi) const {
    if (!(dpi > 0)) throw std::runtime_error(fmt::format("{} pixels to the inch; give more than 0", dpi));
    DrawingToSave drawing = state_->to_save(DrawingFormat::png);
    drawing.saving.dpi = dpi;
    const Grid<glm::u8vec3> pixels = page_pixels(state_->file.settings, drawing);
    PagePixels result{pixels.width, pixels.height, {}};
    result.rgb.reserve(3 * pixels.values.size());
    for (const glm::u8vec3& pixel : pixels.values)
        result.rgb.insert(result.rgb.end(), {pixel.r, pixel.g, pixel.b});
    return result;
}

struct Stippler::State {
    Pipeline pipeline;
    int threads = 0;
    std::optional<StoredTile> given;  // in place of the settings' tile
    // What the pipeline has.
    std::string tile;
    std::optional<RankingMethod> ranking;

    void take_tile(const DrawingSettings& settings) {
        const std::string name = given ? "" : tile_in_use(settings);
        if (pipeline.has_tile() && tile == name && ranking == settings.ranking) return;
        pipeline.set_tile(ranked_tile(given ? *given : stored_tile(name), settings.ranking));
        tile = name;
        ranking = settings.ranking;
    }

    DrawingPlan plan(DrawingSettings settings) {
        if (!pipeline.has_picture())
            throw std::runtime_error("there is no picture yet; give one to set_picture() or set_density()");
        settings.placing.threads = threads;
        settings.placing.thresholds = true;  // for tables, whatever is asked for later
        take_tile(settings);
        return pipeline.plan(settings);
    }
};

Stippler::Stippler(int threads) : state_(std::make_unique<State>()) {
    state_->threads = checked_threads(threads);
}
Stippler::Stippler(Stippler&&) noexcept = default;
Stippler& Stippler::operator=(Stippler&&) noexcept = default;
Stippler::~Stippler() = default;

Stippler::State& Stippler::state() {
    if (!state_) throw std::runtime_error("the stippler was moved from; assign another one to it");
    return *state_;
}

void Stippler::set_picture(const LightPicture& picture) {
    Grid<float> light = grid_of(picture.light, picture.width, picture.height, "a picture");
    const std::size_t pixels = light.values.size();
    if (!picture.colours.empty() && picture.colours.size() != 3 * pixels)
        throw std::runtime_error(
            fmt::format("{} values for the colours of a picture of {} x {}, which has {}",
                        picture.colours.size(), picture.width, picture.height, 3 * pixels));
    const auto finite = [](float value) { return std::isfinite(value); };
    if (!std::ranges::all_of(picture.light, finite) || !std::ranges::all_of(picture.colours, finite))
        throw std::runtime_error("a picture's light has a value that is not finite");
    Pipeline& pipeline = state().pipeline;
    pipeline.set_plain({});
    pipeline.set_light(std::move(light));
    if (picture.colours.empty()) return;
    ColourGrid colours(picture.width, picture.height);
    for (std::size_t i = 0; i < pixels; ++i) {
        const float* const from = &picture.colours[3 * i];
        colours.values[i] = packed({from[0], from[1], from[2]});
    }
    pipeline.set_colours(std::move(colours));
}

void Stippler::set_density(std::span<const float> values, int width, int height,
                           Interpolation interpolation) {
    Grid<float> grid = grid_of(values, width, height, "a density");
    if (!std::ranges::all_of(values, [](float value) { return value >= 0 && value <= 1; }))
        throw std::runtime_error("a density has a value that is not within 0 to 1");
    state().pipeline.set_plain(page_density(
        std::move(grid), interpolation == Interpolation::linear ? Reading::bilinear : Reading::by_cell));
}

void Stippler::set_tile(std::string_view text) {
    std::optional<StoredTile> given;
    if (!text.empty()) given = read_tile(text);
    state().given = std::move(given);
    state().pipeline.forget_tile();
}

Plan Stippler::plan(const Settings& settings) {
    DrawingPlan plan = state().plan(settings.state_->drawing);
    const double scale = state().pipeline.find_scale(plan);
    const PageSize page = plan.layout(scale).page;
    const Tone& tone = plan.tone;
    return {.dots = plan.placing.count.value_or(std::llround(expected_dots(*plan.density, scale))),
            .lowered = plan.lowered,
            .steps = plan.steps,
            .page_width_mm = page.width_mm,
            .page_height_mm = page.height_mm,
            .radius_mm = plan.radius_mm(scale),
            .pens = pens_of(plan, settings.state_->drawing),
            .exposure = tone.exposure,
            .black_point = tone.black_point,
            .white_point = tone.white_point,
            .contrast = tone.contrast,
            .brightness = tone.brightness,
            .gamma = tone.gamma,
            .black = tone.black.value_or(1)};
}

std::optional<Drawing> Stippler::draw(const Settings& settings, const Watch& watch) {
    DrawingFile file;
    file.settings = settings.state_->drawing;
    file.saving = settings.state_->saving;
    file.embedded = settings.changed();
    file.settings.placing.threads = state().threads;
    std::optional<PlannedDrawing> drawing = state().pipeline.drawing(state().plan(file.settings), watch.stop);
    if (!drawing) return std::nullopt;
    auto state = std::make_shared<Drawing::State>();
    state->drawing = *std::move(drawing);
    state->file = std::move(file);
    state->page = drawn_page(state->drawing.layout());
    const DotStream dots = state->drawing.dots(state->page.whole.part, watch.stop);
    state->count = dots.count;
    if (dots.count <= kMostSortedDots) {
        auto held = std::make_shared<DotPieces>();
        double placed = 0;
        dots.for_each_piece([&](const Dots& piece) {
            held->pieces.push_back(piece);
            placed += static_cast<double>(piece.size());
            if (watch.progress) watch.progress(placed / static_cast<double>(dots.count));
            return !watch.stop.stop_requested();
        });
        if (watch.stop.stop_requested()) return std::nullopt;
        state->held = std::move(held);
    }
    return Drawing(std::move(state));
}

}  // namespace dapple
