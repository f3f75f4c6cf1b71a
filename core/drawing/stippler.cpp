#include "core/drawing/stippler.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/analysis/autocorrelation.h"
#include "core/drawing/drawing_figures.h"
#include "core/placing/page.h"

namespace dapple {
namespace {

constexpr int kMostThreads = 1024;

// Thrown from within a writer to leave it.
struct Stopped {};

DrawingFile file_of(const Settings& settings, DrawingFormat format) {
    return {.format = format,
            .settings = settings.drawing,
            .saving = settings.saving,
            .embedded = settings.embedded};
}

void check_sides(std::size_t values, int width, int height, const char* what) {
    const bool sides = width >= 1 && height >= 1;
    if (!sides || values != static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
        throw std::runtime_error(fmt::format("{} values for {} of {} x {}", values, what, width, height));
}

}  // namespace

DrawingFormat text_format(std::string_view name) {
    const std::size_t point = name.rfind('.');
    std::string ending = point == name.npos ? "." + std::string(name) : std::string(name.substr(point));
    for (char& c : ending)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    const std::optional<DrawingFormat> format = format_with_ending(ending);
    if (format && is_text(*format)) return *format;
    throw std::runtime_error(fmt::format("{}: not a format; give svg, gcode, hpgl, dxf, csv or json", name));
}

StoredTile tile_by_name(std::string_view name) {
    if (std::optional<StoredTile> known = tile_called(name)) return *std::move(known);
    throw std::runtime_error(
        fmt::format("{} is not a built-in tile; read a tile's file, and give its text to set_tile()", name));
}

Palette pens_of(const DrawingPlan& plan, const DrawingSettings& settings) {
    if (!plan.pens.empty()) return plan.pens;
    return {Pen{.name = pen_name(settings.ink), .colour = settings.ink}};
}

bool Drawing::for_each_piece(const TakePiece& take) const {
    const auto mm = static_cast<float>(page.layout.page.mm_per_page_unit);
    const auto usual_radius = static_cast<float>(radius_mm());
    bool all = true;
    Dots in_mm;
    dots(page.whole.part, {}).for_each_piece([&](const Dots& piece) {
        in_mm.pen = piece.pen;
        for (FloatBuffer Dots::*column : {&Dots::x, &Dots::y, &Dots::radius}) {
            in_mm.*column = piece.*column;
            for (float& value : in_mm.*column) value *= mm;
        }
        if (piece.radius.empty()) in_mm.radius.assign(piece.size(), usual_radius);
        return all = take(in_mm);
    });
    return all;
}

std::vector<PlacedTile> Drawing::tiles() const {
    const double mm = page.layout.page.mm_per_page_unit;
    std::vector<PlacedTile> placed = outlines();
    move_to(page.whole.part, placed);
    for (PlacedTile& tile : placed)
        for (double* const length : {&tile.x, &tile.y, &tile.side}) *length *= mm;
    return placed;
}

double Drawing::period_mm() const {
    const PageSize& size = page.layout.page;
    const double mm = size.mm_per_page_unit;
    const double units = size.width_mm / mm * (size.height_mm / mm);
    const double points = std::max(static_cast<double>(count), 1.0);
    return mm * tile_period(points / units / static_cast<double>(tile_size));
}

bool Drawing::write(std::ostream& out, DrawingFormat format, const Watch& watch) const {
    DrawingToSave drawing = drawing_on(page, *this, file_of(settings, format), watch.stop);
    const DotOrder order = order_of(drawing);
    const auto tell = [&](double share) {
        if (watch.progress) watch.progress(share);
    };
    // Half of the progress is the pen's route.
    const double routing = order == DotOrder::shortest ? 0.5 : 0;
    if (order != DotOrder::recursion) {
        auto sorted = std::make_shared<const DotPieces>(
            sorted_by_pen(drawing.dots, order,
                          {.stop = watch.stop, .progress = [&](double share) { tell(routing * share); }}));
        if (watch.stop.stop_requested()) return false;
        drawing.dots = stream_of(std::move(sorted), drawing.dots.scale);
    }
    try {
        write_as(format, out, ink_page(drawing), [&](double share) {
            if (watch.stop.stop_requested()) throw Stopped();
            tell(routing + (1 - routing) * share);
        });
    } catch (const Stopped&) {
        return false;
    }
    tell(1);
    return true;
}

std::vector<Finding> Drawing::findings(DrawingFormat format, const Watch& watch) const {
    DrawingToSave drawing = drawing_on(page, *this, file_of(settings, format), watch.stop);
    const bool measured = count <= kMostSortedDots;
    DotPieces sorted;
    if (measured) {
        sorted = sorted_by_pen(drawing.dots, order_of(drawing), watch);
        drawing.dots = stream_of(sorted, drawing.dots.scale);
    }
    if (watch.stop.stop_requested()) return {};
    return figures_of(plan, page, drawing, measured ? &sorted : nullptr).findings;
}

Grid<glm::u8vec3> Drawing::pixels(double dpi) const {
    if (!(dpi > 0)) throw std::runtime_error(fmt::format("{} pixels to the inch; give more than 0", dpi));
    DrawingToSave drawing = drawing_on(page, *this, file_of(settings, DrawingFormat::png));
    drawing.file.saving.dpi = dpi;
    return page_pixels(drawing);
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
        pipeline.set_tile(ranked_tile(given ? *given : tile_by_name(name), settings.ranking));
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
    if (threads < 0 || threads > kMostThreads)
        throw std::runtime_error(
            fmt::format("threads is {}; give a whole number from 0 to {}", threads, kMostThreads));
    state_->threads = threads;
}
Stippler::Stippler(Stippler&&) noexcept = default;
Stippler& Stippler::operator=(Stippler&&) noexcept = default;
Stippler::~Stippler() = default;

Stippler::State& Stippler::state() {
    if (!state_) throw std::runtime_error("the stippler was moved from; assign another one to it");
    return *state_;
}

void Stippler::set_picture(LightPicture picture) {
    const Grid<float>& light = picture.light;
    check_sides(light.values.size(), light.width, light.height, "a picture");
    if (!picture.colours.empty())
        check_sides(picture.colours.values.size(), light.width, light.height, "the colours of a picture");
    if (!std::ranges::all_of(light.values, [](float value) { return std::isfinite(value); }))
        throw std::runtime_error("a picture's light has a value that is not finite");
    Pipeline& pipeline = state().pipeline;
    pipeline.set_plain({});
    pipeline.set_light(std::move(picture.light));
    pipeline.set_colours(std::move(picture.colours));
}

void Stippler::set_density(Grid<float> values, Reading reading) {
    check_sides(values.values.size(), values.width, values.height, "a density");
    if (!std::ranges::all_of(values.values, [](float value) { return value >= 0 && value <= 1; }))
        throw std::runtime_error("a density has a value that is not within 0 to 1");
    state().pipeline.set_plain(page_density(std::move(values), reading));
}

void Stippler::set_tile(std::string_view text) {
    std::optional<StoredTile> given;
    if (!text.empty()) given = read_tile(text);
    state().given = std::move(given);
    state().pipeline.forget_tile();
}

DrawingPlan Stippler::plan(const DrawingSettings& settings) {
    DrawingPlan plan = state().plan(settings);
    state().pipeline.find_scale(plan);
    return plan;
}

std::optional<Drawing> Stippler::draw(const Settings& settings, const Watch& watch) {
    std::optional<PlannedDrawing> planned = state().pipeline.drawing(plan(settings.drawing), watch.stop);
    if (!planned) return std::nullopt;
    Drawing drawing{*std::move(planned), settings, {}};
    drawing.page = drawn_page(drawing.layout());
    const PagePart whole = drawing.page.whole.part;
    const DotStream dots = drawing.dots(whole, watch.stop);
    drawing.count = dots.count;
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
        drawing.dots = [held = std::move(held), scale = drawing.scale, whole,
                        other = std::move(drawing.dots)](const PagePart& part, const std::stop_token& stop) {
            return part == whole ? stream_of(held, scale) : other(part, stop);
        };
    }
    return drawing;
}

}  // namespace dapple
