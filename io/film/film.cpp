#include "io/film/film.h"

#include <fmt/format.h>

#include <webp/encode.h>
#include <webp/mux.h>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/drawing/write_drawing.h"
#include "core/output/sheet.h"
#include "core/text/shown_text.h"
#include "io/files/atomic_file.h"
#include "io/files/png_file.h"
#include "io/files/text_file.h"

namespace dapple {

namespace {

[[noreturn]] void fail(const std::string& why) {
    throw std::runtime_error("the film cannot be encoded as WebP: " + why);
}

struct WebpPixels : WebPPicture {
    explicit WebpPixels(const Grid<glm::u8vec3>& frame) : WebPPicture{} {
        if (!WebPPictureInit(this)) fail("libwebp is of another version");
        use_argb = 1;
        width = frame.width;
        height = frame.height;
        if (!WebPPictureImportRGB(this, &frame.values.front().x, 3 * frame.width)) throw std::bad_alloc();
    }
    WebpPixels& operator=(WebpPixels&&) = delete;
    ~WebpPixels() { WebPPictureFree(this); }
};

}  // namespace

struct WebpFilm::Encoder {
    WebPAnimEncoder* webp = nullptr;
    WebPConfig config{};
    double frame_ms = 0;
    int frames = 0;

    ~Encoder() { WebPAnimEncoderDelete(webp); }
    int now_ms() const { return static_cast<int>(std::lround(frames * frame_ms)); }
    void check(int done) const {
        if (!done) fail(WebPAnimEncoderGetError(webp));
    }
};

WebpFilm::WebpFilm(int frames_per_second) : encoder_(std::make_unique<Encoder>()) {
    encoder_->frame_ms = 1000.0 / frames_per_second;
    // Dots are sharp, and their few colours are small without loss; more effort saves little.
    constexpr int kFastest = 1;
    if (!WebPConfigInit(&encoder_->config) || !WebPConfigLosslessPreset(&encoder_->config, kFastest))
        fail("libwebp is of another version");
}

WebpFilm::~WebpFilm() = default;

void WebpFilm::add(const Grid<glm::u8vec3>& frame) {
    if (!encoder_->webp) {
        encoder_->webp = WebPAnimEncoderNew(frame.width, frame.height, nullptr);
        if (!encoder_->webp) throw std::bad_alloc();
    }
    WebpPixels pixels(frame);
    encoder_->check(WebPAnimEncoderAdd(encoder_->webp, &pixels, encoder_->now_ms(), &encoder_->config));
    ++encoder_->frames;
}

void WebpFilm::write(std::ostream& out) {
    encoder_->check(WebPAnimEncoderAdd(encoder_->webp, nullptr, encoder_->now_ms(), nullptr));
    struct Bytes : WebPData {
        Bytes() : WebPData{} { WebPDataInit(this); }
        ~Bytes() { WebPDataClear(this); }
    } bytes;
    encoder_->check(WebPAnimEncoderAssemble(encoder_->webp, &bytes));
    out.write(reinterpret_cast<const char*>(bytes.bytes), static_cast<std::streamsize>(bytes.size));
}

namespace {

namespace fs = std::filesystem;

bool is_film(const fs::path& path) {
    return ending_of(path) == ".webp";
}

// Where in the film a picture lies, 0..1.
double share_of(int frame, int frames) {
    return frames > 1 ? static_cast<double>(frame) / (frames - 1) : 1;
}

fs::path frame_file(const fs::path& folder, int frame) {
    return folder / fmt::format("frame-{:04}.png", frame + 1);
}

bool save_frames(const fs::path& folder, const FilmFrame& frame, int frames, const Watch& watch) {
    make_folder(folder);
    for (int i = 0; i < frames; ++i) {
        if (watch.stop.stop_requested()) return false;
        const Grid<glm::u8vec3> pixels = frame(share_of(i, frames));
        save_next(static_cast<std::size_t>(i), [&] {
            save_atomically(frame_file(folder, i), [&](std::ostream& out) {
                write_png(out, {.width = pixels.width, .height = pixels.height, .dpi = 96},
                          [&](const PixelSink& sink) { sink(pixels); });
            });
        });
        if (watch.progress) watch.progress(static_cast<double>(i + 1) / frames);
    }
    return true;
}

}  // namespace

void check_film_path(const fs::path& path) {
    std::error_code ignored;
    const bool folder = !path.has_filename() || fs::is_directory(path, ignored);
    if (folder) return;
    if (is_film(path)) return check_can_save(path);
    throw std::runtime_error(printable(path.string()) +
                             ": a film's name ends in .webp, and in / for a folder of numbered PNG files");
}

std::vector<fs::path> files_of(const fs::path& path, const FilmChoice& choice) {
    if (is_film(path)) return {path};
    std::vector<fs::path> frames;
    for (int i = 0; i < frames_of(choice); ++i) frames.push_back(frame_file(path, i));
    return frames;
}

bool save_film(const fs::path& path, const FilmFrame& frame, const FilmChoice& choice, const Watch& watch) {
    check_film_path(path);
    const int frames = frames_of(choice);
    if (!is_film(path)) return save_frames(path, frame, frames, watch);
    WebpFilm film(choice.frames_per_second);
    for (int i = 0; i < frames; ++i) {
        if (watch.stop.stop_requested()) return false;
        film.add(frame(share_of(i, frames)));
        if (watch.progress) watch.progress(static_cast<double>(i + 1) / frames);
    }
    save_atomically(path, [&](std::ostream& out) { film.write(out); });
    return true;
}

std::size_t PlotFilm::drawn_after(double passed) const {
    return static_cast<std::size_t>(std::ranges::upper_bound(seconds, passed) - seconds.begin());
}

std::optional<glm::dvec2> PlotFilm::pen_at(std::size_t drawn) const {
    if (drawn == 0) return std::nullopt;
    if (!strokes.points.empty()) return strokes.points[drawn - 1];
    std::size_t before = 0;
    for (const Dots& piece : dots.pieces) {
        const std::size_t here = drawn - 1 - before;
        if (here < piece.size()) return glm::dvec2(piece.x[here], piece.y[here]);
        before += piece.size();
    }
    return std::nullopt;
}

namespace {

// When the pen comes to the paper and when it leaves, if it takes as long for both.
std::pair<double, double> touched(const PlottingTime& before, const PlottingTime& after) {
    const double lift_s = (after.lifting_s - before.lifting_s) / 2;
    return {before.total_s() + after.moving_s - before.moving_s + lift_s, after.total_s() - lift_s};
}

}  // namespace

PlotFilm plot_film(DotPieces dots, double mm_per_page_unit, const MachineProgram& program) {
    PlotFilm film;
    film.seconds.reserve(dots.size());
    MachineClock clock(program);
    for_each_position(dots, [&](double x, double y) {
        const PlottingTime before = clock.time();
        clock.dot(glm::dvec2(x, y) * mm_per_page_unit);
        film.seconds.push_back(touched(before, clock.time()).second);
    });
    film.total_seconds = clock.finish().total_s();
    film.dots = std::move(dots);
    return film;
}

PlotFilm plot_film(Strokes strokes, const MachineProgram& program) {
    PlotFilm film;
    film.seconds.reserve(strokes.points.size());
    MachineClock clock(program);
    std::size_t first = 0;
    for (const std::size_t end : strokes.ends) {
        const std::span points(strokes.points.data() + first, end - first);
        const PlottingTime before = clock.time();
        clock.stroke(points);
        const auto [begun, ended] = touched(before, clock.time());
        double way = 0;
        for (std::size_t i = 1; i < points.size(); ++i) way += glm::distance(points[i - 1], points[i]);
        double gone = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (i > 0) gone += glm::distance(points[i - 1], points[i]);
            film.seconds.push_back(way > 0 ? begun + (ended - begun) * gone / way : ended);
        }
        first = end;
    }
    film.total_seconds = clock.finish().total_s();
    film.strokes = std::move(strokes);
    return film;
}

DotPieces first_dots(const DotPieces& dots, std::size_t count) {
    DotPieces first;
    for (const Dots& piece : dots.pieces) {
        if (count == 0) break;
        const std::size_t here = std::min(count, piece.size());
        Dots part;
        part.pen = piece.pen;
        for (const auto column : kDotColumns) {
            const FloatBuffer& from = piece.*column;
            const auto end = static_cast<std::ptrdiff_t>(std::min(here, from.size()));
            (part.*column).assign(from.begin(), from.begin() + end);
        }
        first.pieces.push_back(std::move(part));
        count -= here;
    }
    return first;
}

Strokes first_points(const Strokes& strokes, std::size_t count) {
    Strokes first;
    first.points.assign(strokes.points.begin(), strokes.points.begin() + static_cast<std::ptrdiff_t>(std::min(
                                                                             count, strokes.points.size())));
    std::size_t stroke = 0;
    for (; stroke < strokes.ends.size() && strokes.ends[stroke] < first.points.size(); ++stroke) {
        first.ends.push_back(strokes.ends[stroke]);
        if (!strokes.pens.empty()) first.pens.push_back(strokes.pens[stroke]);
    }
    if (stroke < strokes.ends.size()) end_stroke(first, pen_of(strokes, stroke));
    return first;
}

namespace {

// The page, which lies still through a film.
struct Stage {
    DrawingSettings settings;
    DrawingPlan plan;  // of the whole drawing
    double scale = 0;
    Excerpt page;
    double dpi = 0;

    DrawingToSave drawing(const DotStream& dots, double radius) const {
        return {.file = {.format = DrawingFormat::png, .settings = settings, .saving = {.dpi = dpi}},
                .dots = dots,
                .page = page.size,
                .dot_radius_mm = std::max(radius * page.size.mm_per_page_unit, plan.largest_edit_mm)};
    }
};

Stage stage_of(Pipeline& pipeline, const DrawingSettings& settings, const FilmChoice& choice) {
    Stage stage;
    stage.settings = film_settings(settings, choice.kind);
    DrawingSettings asked = stage.settings;
    asked.placing.thresholds = choice.kind == FilmKind::levels ||
                               (choice.kind == FilmKind::plot && choice.order == DotOrder::priority);
    stage.plan = pipeline.plan(asked, kMostFilmDots);
    if (stage.plan.density->mean() == 0)
        throw std::runtime_error("nothing to film: the whole picture is as light as the paper");
    stage.scale = pipeline.find_scale(stage.plan);
    stage.plan.edits_scale = stage.scale;
    const PageLayout layout = stage.plan.layout(stage.scale);
    stage.page = sheet_of(layout.page, {}, layout.picture.low);
    stage.dpi = dpi_for(layout.page, choice.longer_side);
    return stage;
}

// The first dots of the whole drawing's density, so that each stays where it is; once all are there, they
// settle.
Grid<glm::u8vec3> grown(Pipeline& pipeline, const Stage& stage, double share, std::uint64_t all) {
    const std::uint64_t dots = grown_dots(share, all);
    DrawingPlan plan = stage.plan;
    plan.steps = settling_steps(share, plan.steps);
    if (dots < all) {
        plan.placing.count = dots;
        plan.placing.cut.reset();
    }
    const DotStream stream = pipeline.stream(plan, stage.page.part);
    return page_pixels(stage.drawing(stream, plan.radius(stream.scale)));
}

// All dots, and a pen for each level.
struct Levels {
    DotPieces dots;  // one piece a level
    Palette pens;
};

Levels levels_of(const DotStream& dots, std::size_t tile_size) {
    Levels levels;
    dots.for_each_piece([&](const Dots& piece) {
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const int level = tile_rank_of(piece.threshold[i], tile_size).level;
            while (static_cast<int>(levels.pens.size()) <= level) {
                const int next = static_cast<int>(levels.pens.size());
                levels.pens.push_back({.name = "level", .colour = level_colour(next), .ink = PenInk::opaque});
                levels.dots.pieces.emplace_back().pen = next;
            }
            Dots& own = levels.dots.pieces[static_cast<std::size_t>(level)];
            own.x.push_back(piece.x[i]);
            own.y.push_back(piece.y[i]);
        }
        return true;
    });
    return levels;
}

FilmFrame film_of_levels(Pipeline& pipeline, Stage stage) {
    const DotStream stream = pipeline.stream(stage.plan, stage.page.part);
    auto levels = std::make_shared<Levels>(levels_of(stream, pipeline.tile().tile().size()));
    return [levels, stage = std::move(stage)](double share) {
        const int shown = level_shown(share, static_cast<int>(levels->pens.size()) - 1);
        DotPieces dots;
        for (int level = 0; level <= shown; ++level)
            dots.pieces.push_back(levels->dots.pieces[static_cast<std::size_t>(level)]);
        DrawingToSave drawing = stage.drawing(stream_of(dots), stage.plan.radius(stage.scale));
        drawing.pens = levels->pens;
        return page_pixels(drawing);
    };
}

// Dots come in as growing ones, so that none springs up.
constexpr double kComesIn = 1.07;

// What lies in the middle of the page, so many times as large, with as many times squared more dots.
Grid<glm::u8vec3> zoomed(Pipeline& pipeline, const Stage& stage, double zoom) {
    const double unit = stage.page.size.mm_per_page_unit;
    const glm::dvec2 page(stage.page.size.width_mm / unit, stage.page.size.height_mm / unit);
    const glm::dvec2 corner(stage.page.part.across.offset, stage.page.part.down.offset);
    // In page units from the picture's corner, and what of it the picture is.
    const glm::dvec2 low = corner + page * (0.5 - 0.5 / zoom), high = low + page / zoom;
    const glm::dvec2 first = glm::clamp(low, 0.0, 1.0), last = glm::clamp(high, 0.0, 1.0);
    DotPieces dots;
    const double radius = stage.plan.radius(stage.scale), scale = stage.scale * zoom * zoom * kComesIn;
    if (last.x > first.x && last.y > first.y) {
        const PageWindow window{std::llround(first.x * 0x1p62), std::llround(first.y * 0x1p62),
                                last.x - first.x, last.y - first.y};
        pipeline.tile().placer().place(
            *stage.plan.density, {.scale = scale, .threads = 0, .thresholds = true, .window = window}, dots);
    }
    const glm::dvec2 moved = first - low;
    for (Dots& piece : dots.pieces) {
        piece.radius.resize(piece.size());
        for (std::size_t i = 0; i < piece.size(); ++i) {
            piece.x[i] = static_cast<float>((piece.x[i] + moved.x) * zoom);
            piece.y[i] = static_cast<float>((piece.y[i] + moved.y) * zoom);
            const double there = (scale - piece.critical[i]) / (scale * (1 - 1 / kComesIn));
            piece.radius[i] = static_cast<float>(radius * std::clamp(there, 0.0, 1.0));
        }
    }
    return page_pixels(stage.drawing(stream_of(dots), radius));
}

FilmFrame film_of_plot(Pipeline& pipeline, Stage stage, const FilmChoice& choice, const Watch& watch) {
    const DotStream stream = pipeline.stream(stage.plan, stage.page.part);
    const DotOrder order =
        choice.order.value_or(usual_order(DrawingFormat::svg, stream.count, stage.settings.style));
    const DotPieces sorted = sorted_by_pen(stream, order, watch);
    if (watch.stop.stop_requested()) return {};
    DrawingToSave drawing = stage.drawing(stream_of(sorted), stage.plan.radius(stage.scale));
    drawing.pens = stage.plan.pens;
    const MachineProgram program = program_of(choice.machine);
    PlotFilm film;
    if (const auto strokes = strokes_of(drawing))
        film = plot_film(collected(*strokes), program);
    else
        film = plot_film(sorted, stage.page.size.mm_per_page_unit, program);
    const auto plot = std::make_shared<const PlotFilm>(std::move(film));
    return [plot, stage = std::move(stage)](double share) {
        const std::size_t drawn = plot->drawn_after(plotted_seconds(share, plot->total_seconds));
        if (!plot->strokes.points.empty()) {
            const Strokes strokes = first_points(plot->strokes, drawn);
            DrawingToSave now = stage.drawing({}, 0);
            now.pens = stage.plan.pens;
            now.strokes = stream_of(strokes, stage.settings.pen_width_mm);
            now.strokes->widths_mm = stroke_widths(stage.settings.pens, stage.settings.pen_width_mm,
                                                   stage.plan.pens, pen_use(stage.settings));
            return page_pixels(now);
        }
        const DotPieces dots = first_dots(plot->dots, drawn);
        DrawingToSave now = stage.drawing(stream_of(dots), stage.plan.radius(stage.scale));
        now.pens = stage.plan.pens;
        return page_pixels(now);
    };
}

}  // namespace

DrawingSettings film_settings(DrawingSettings settings, FilmKind kind) {
    if (kind == FilmKind::plot) return settings;
    if (settings.dot_size.sizing == DotSizing::by_tone) settings.dot_size.sizing = DotSizing::automatic;
    settings.placer = PlacerKind::exact;
    if (kind != FilmKind::growth) {
        settings.relax = 0;
        settings.mask = settings.mask.without_finer();  // all dots are alike
    }
    settings.pens = {};
    settings.style = DrawingStyle::dots;
    settings.mark = {};
    return settings;
}

FilmFrame film_frames(Pipeline& pipeline, const DrawingSettings& settings, const FilmChoice& choice,
                      const Watch& watch) {
    Stage stage = stage_of(pipeline, settings, choice);
    switch (choice.kind) {
        case FilmKind::levels:
            return film_of_levels(pipeline, std::move(stage));
        case FilmKind::plot:
            return film_of_plot(pipeline, std::move(stage), choice, watch);
        case FilmKind::zoom:
            return [&pipeline, stage = std::move(stage), depth = choice.depth](double share) {
                return zoomed(pipeline, stage, film_zoom(share, depth));
            };
        case FilmKind::growth:
            break;
    }
    const std::uint64_t all = pipeline.stream(stage.plan).count;
    return [&pipeline, stage = std::move(stage), all](double share) {
        return grown(pipeline, stage, share, all);
    };
}

namespace {

constexpr double kFirstDots = 30;  // before that there is little to see

double done(double share) {
    return std::clamp(share / kFilmEnd, 0.0, 1.0);
}

}  // namespace

std::uint64_t grown_dots(double share, std::uint64_t dots) {
    if (done(share) == 1) return dots;
    const double first = std::min(kFirstDots, static_cast<double>(dots));
    const double now = first * std::pow(static_cast<double>(dots) / std::max(first, 1.0), done(share));
    return std::min(static_cast<std::uint64_t>(std::lround(now)), dots);
}

int settling_steps(double share, int steps) {
    const double settled = (share - kFilmEnd) / (0.5 * (1 - kFilmEnd));
    return static_cast<int>(std::lround(std::clamp(settled, 0.0, 1.0) * steps));
}

int level_shown(double share, int deepest) {
    return std::min(static_cast<int>(done(share) * (deepest + 1)), deepest);
}

double film_zoom(double share, double depth) {
    return std::pow(depth, done(share));
}

double plotted_seconds(double share, double seconds) {
    return done(share) * seconds;
}

int frames_of(const FilmChoice& choice) {
    return std::max(static_cast<int>(std::lround(choice.seconds * choice.frames_per_second)), 1);
}

}  // namespace dapple
