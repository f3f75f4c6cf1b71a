#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/drawing/drawing_file.h"
#include "core/drawing/page_pixels.h"
#include "core/drawing/pipeline.h"
#include "core/drawing/write_drawing.h"
#include "core/placing/page_density.h"
#include "core/tile/built_in_tiles.h"
#include "dapple/drawing.h"
#include "library/state.h"

namespace dapple {
namespace {

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

StoredTile tile_of(const std::string& name) {
    if (std::optional<StoredTile> built_in = built_in_tile(name)) return *std::move(built_in);
    if (looks_like_tile_integers(name)) return ranked(parse_tile_integers(name), RankingMethod::energy);
    throw std::runtime_error(
        fmt::format("settings: drawing.tile is {}, a file; read it, and give its text to set_tile()", name));
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

struct Drawing::State {
    DotsForFile from;
    DrawnPage page;
    std::uint64_t count = 0;
    std::shared_ptr<const DotPieces> held;  // none: there are too many

    DotStream dots() const {
        if (held) return stream_of(held, from.dots.scale);
        return from.dots.on(page.whole.part, {});
    }
    // As the format has it, its dots as they were placed.
    DrawingToSave to_save(DrawingFormat format, const std::stop_token& stop = {}) const {
        DotsForFile dots = from;
        dots.file.format = format;
        if (held)
            dots.dots.on = [this](const PagePart&, const std::stop_token&) {
                return stream_of(held, from.dots.scale);
            };
        return drawing_on(page, dots, stop);
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
    const auto of = [](const std::string& name, glm::vec3 colour) {
        return DrawingPen{name, colour.r, colour.g, colour.b};
    };
    std::vector<DrawingPen> pens;
    for (const Pen& pen : state_->from.plan.pens) pens.push_back(of(pen.name, pen.colour));
    const glm::vec3 ink = state_->from.file.settings.ink;
    if (pens.empty()) pens.push_back(of(pen_name(ink), ink));
    return pens;
}

bool Drawing::for_each(const std::function<bool(const DotSpan&)>& take) const {
    const auto mm = static_cast<float>(state_->page.layout.page.mm_per_page_unit);
    const auto usual_radius = static_cast<float>(state_->from.radius_mm());
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

bool Drawing::write(std::ostream& out, FileFormat kind, const Watch& watch) const {
    const DrawingFormat format = format_of(kind);
    const DrawingSettings& settings = state_->from.file.settings;
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
        write_text_drawing(out, format, settings, drawing, [&](double share) {
            if (watch.stop.stop_requested()) throw Stopped();
            tell(routing + (1 - routing) * share);
        });
    } catch (const Stopped&) {
        return false;
    }
    tell(1);
    return true;
}

PagePixels Drawing::pixels(double dpi) const {
    DrawingToSave drawing = state_->to_save(DrawingFormat::png);
    drawing.saving.dpi = dpi;
    const Grid<glm::u8vec3> pixels = page_pixels(state_->from.file.settings, drawing);
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
        pipeline.set_tile(ranked_tile(given ? *given : tile_of(name), settings.ranking));
        tile = name;
        ranking = settings.ranking;
    }
};

Stippler::Stippler(int threads) : state_(std::make_unique<State>()) {
    state_->threads = std::max(threads, 0);
}
Stippler::Stippler(Stippler&&) noexcept = default;
Stippler& Stippler::operator=(Stippler&&) noexcept = default;
Stippler::~Stippler() = default;

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
    Pipeline& pipeline = state_->pipeline;
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

void Stippler::set_density(std::span<const float> values, int width, int height) {
    Grid<float> grid = grid_of(values, width, height, "a density");
    if (!std::ranges::all_of(values, [](float value) { return value >= 0 && value <= 1; }))
        throw std::runtime_error("a density has a value that is not within 0 to 1");
    state_->pipeline.set_plain(page_density(std::move(grid)));
}

void Stippler::set_tile(std::string_view text) {
    std::optional<StoredTile> given;
    if (!text.empty()) given = read_tile(text);
    state_->given = std::move(given);
    state_->pipeline.forget_tile();
}

std::optional<Drawing> Stippler::draw(const Settings& settings, const Watch& watch) {
    Pipeline& pipeline = state_->pipeline;
    if (!pipeline.has_picture())
        throw std::runtime_error("there is no picture yet; give one to set_picture() or set_density()");
    DrawingFile file;
    file.settings = settings.state_->drawing;
    file.saving = settings.state_->saving;
    file.embedded = settings.changed();
    file.settings.placing.threads = state_->threads;
    file.settings.placing.thresholds = true;  // for tables, whatever is asked for later
    state_->take_tile(file.settings);
    std::optional<DotsForFile> from = dots_for(file, pipeline, pipeline.plan(file.settings), watch.stop);
    if (!from) return std::nullopt;
    auto state = std::make_shared<Drawing::State>();
    state->page = drawn_page(from->plan.layout(from->dots.scale));
    state->from = *std::move(from);
    const DotStream dots = state->from.dots.on(state->page.whole.part, watch.stop);
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
