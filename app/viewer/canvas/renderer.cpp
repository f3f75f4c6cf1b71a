#include "app/viewer/canvas/renderer.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <glm/common.hpp>
#include <initializer_list>
#include <numbers>
#include <numeric>
#include <string>
#include <string_view>

#include "core/image/colour.h"
#include "dapple_viewer_embedded/shaders.h"

namespace dapple {
namespace {

constexpr int kLevelColours = 12;                  // as in tile.vert
constexpr GLuint kDotColour = 3, kDotRadius = 4;   // the attributes' locations, as in dot.vert
constexpr GLuint kLineColour = 1, kLineWidth = 2;  // as in line.vert
constexpr double kLargestSprite = 256;             // samples: a guard band as wide never is too much

/// Page to pixels, or samples, of a canvas.
struct PageToPixels {
    glm::dvec2 offset;
    double scale;
    glm::dvec2 canvas;
    // Around the canvas: points are clipped by their centres, and those just outside must still show their
    // rims.
    double guard = 0;
};

void set_transform(const GlProgram& program, const PageToPixels& map) {
    glUniform2f(program.uniform("page_scale"), static_cast<float>(map.scale), static_cast<float>(map.scale));
    const glm::vec2 offset(map.offset + map.guard), canvas(map.canvas + 2 * map.guard);
    glUniform2f(program.uniform("page_offset"), offset.x, offset.y);
    glUniform2f(program.uniform("canvas"), canvas.x, canvas.y);
    auto low = -static_cast<GLint>(map.guard);
    glViewport(low, low, static_cast<GLsizei>(canvas.x), static_cast<GLsizei>(canvas.y));
}

// Where the sheet lies, in pixels. Its corner may lie further out than a PagePoint reaches.
Rectangle<double> sheet_on_canvas(const Camera& camera, const CanvasLook& look) {
    const glm::dvec2 corner = to_canvas(camera, PagePoint(0));
    if (!look.sheet) return {corner, to_canvas(camera, page_point(look.page_size))};
    return {corner + look.sheet->low * camera.pixels_per_unit,
            corner + look.sheet->high * camera.pixels_per_unit};
}

// Where the page and the picture on it lie, for a fragment shader.
void set_page(const GlProgram& program, const Camera& camera, const CanvasLook& look) {
    const auto [low, high] = sheet_on_canvas(camera, look);
    const glm::dvec2 picture_low = to_canvas(camera, PagePoint(0)),
                     picture_high = to_canvas(camera, page_point(look.page_size));
    const auto vector = [&](const char* name, glm::vec2 value) {
        glUniform2f(program.uniform(name), value.x, value.y);
    };
    vector("picture_min", picture_low);
    vector("picture_max", picture_high);
    vector("picture_corner", look.picture_view.corner);
    vector("picture_across", look.picture_view.across);
    vector("picture_down", look.picture_view.down);
    glUniform2f(program.uniform("page_min"), static_cast<float>(low.x), static_cast<float>(low.y));
    glUniform2f(program.uniform("page_max"), static_cast<float>(high.x), static_cast<float>(high.y));
}

void set_colour(const GlProgram& program, const char* name, glm::vec3 colour) {
    glUniform3f(program.uniform(name), colour.r, colour.g, colour.b);
}

// Bytes are colours.
void column(GLuint location, const GlStreamBuffer& buffer, GLint components, GLuint divisor,
            GLenum type = GL_FLOAT) {
    buffer.bind();
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, components, type, type == GL_UNSIGNED_BYTE, 0, nullptr);
    glVertexAttribDivisor(location, divisor);
}

// Else one value is read for all.
void column_if(bool there, GLuint location, const GlStreamBuffer& buffer, GLint components, GLuint divisor,
               GLenum type = GL_FLOAT) {
    if (there)
        column(location, buffer, components, divisor, type);
    else
        glDisableVertexAttribArray(location);
}

void take(FloatBuffer& to, const FloatBuffer& from, const DotBlock& block) {
    const auto begin = from.begin() + static_cast<std::ptrdiff_t>(block.first);
    to.insert(to.end(), begin, begin + static_cast<std::ptrdiff_t>(block.count));
}

// Its number, as the shaders of dots and lines read it.
glm::u8vec4 pen_as_colour(int pen) {
    return {pen, 0, 0, 255};
}

// The same shader with a few words defined, after its first line, which says the version.
std::string with_define(std::string_view source, std::initializer_list<const char*> words) {
    std::string text(source);
    std::size_t at = text.find('\n') + 1;
    for (const char* const word : words) {
        const std::string line = std::string("#define ") + word + "\n";
        text.insert(at, line);
        at += line.size();
    }
    return text;
}

using Clock = std::chrono::steady_clock;

constexpr double kSliceSeconds = 0.008;
constexpr std::size_t kFewestDots = DotCost::kFewestDots, kMostDotsAtOnce = 1 << 19;
constexpr double kRasterSlowness = 0.06;    // of the processor's dots beside those of OpenGL on it
constexpr std::size_t kTilesAtOnce = 4096;  // and as many are drawn quickly

void learn(double& mean, double now) {
    mean += 0.5 * (now - mean);
}

}  // namespace

// For how long a drawing goes forward now. Where that has no end, nobody looks at the clock: to do so he has
// to wait for OpenGL.
class Renderer::Turn {
 public:
    explicit Turn(double seconds) : seconds_(seconds) {}

    bool ends() const { return seconds_ < std::numeric_limits<double>::infinity(); }
    bool is_over() const { return over_; }
    /// About so long is what is drawn between two looks at the clock.
    double slice() const { return std::min(kSliceSeconds, seconds_); }
    /// Waits until OpenGL has drawn all, and returns how long it took since then.
    double finish(Clock::time_point since = Clock::now()) {
        glFinish();
        const Clock::time_point now = Clock::now();
        over_ = std::chrono::duration<double>(now - begin_).count() >= seconds_;
        return std::chrono::duration<double>(now - since).count();
    }

 private:
    const Clock::time_point begin_ = Clock::now();
    double seconds_;
    bool over_ = false;
};

bool have_same_desk(const CanvasLook& a, const CanvasLook& b) {
    // Tiles' lines along the sheet's edges lie on it.
    return a.desk == b.desk && a.page_size == b.page_size && a.sheet == b.sheet &&
           a.pixel_scale == b.pixel_scale && !a.tiles && !b.tiles;
}

Renderer::Renderer(DotsBy dots_by)
    : page_(shaders::page_vert(), shaders::page_frag()),
      sheet_(shaders::page_vert(), with_define(shaders::page_frag(), {"SHEET"})),
      sheet_with_picture_(shaders::page_vert(), with_define(shaders::page_frag(), {"SHEET", "PICTURE"})),
      desk_(shaders::page_vert(), with_define(shaders::page_frag(), {"DESK"})),
      dot_(shaders::dot_vert(), shaders::dot_frag()),
      line_(shaders::line_vert(), shaders::line_frag()),
      tile_(shaders::tile_vert(), shaders::tile_frag()),
      dots_by_(dots_by),
      quick_cost_(dots_by == DotsBy::processor ? kRasterSlowness : 1) {
    for (const auto& [array, divisor] : {std::pair(&dot_array_, 0u), {&dot_quad_array_, 1u}}) {
        array->bind();
        column(0, dot_x_, 1, divisor);
        column(1, dot_y_, 1, divisor);
        column(2, dot_critical_, 1, divisor);
    }
    line_array_.bind();
    column(0, line_ends_, 4, 1);
    tile_array_.bind();
    column(0, tiles_, 4, 1);
    column(1, tile_looks_, 3, 1);
    std::array<float, 2> sizes{1, 1};
    float step = 1;
    glGetFloatv(GL_POINT_SIZE_RANGE, sizes.data());
    glGetFloatv(GL_POINT_SIZE_GRANULARITY, &step);
    largest_point_ = std::min<double>(sizes[1], kLargestSprite);
    point_step_ = step;
    std::array<GLint, 2> viewport{};
    GLint texture = 0;
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
    limits_.largest_side =
        std::min({viewport[0], viewport[1], texture}) - 2 * static_cast<GLint>(kLargestSprite);
}

void Renderer::set_dots(const DotPieces& dots, std::span<const DotBlock> blocks, const PageWindow& window) {
    job_.reset();
    all_ = {.dots = &dots, .blocks = blocks};
    ink_ = {};
    pens_.clear();
    strokes_ = nullptr;
    inking_ = nullptr;
    const auto all_have = [&](FloatBuffer Dots::*column) {
        return std::ranges::all_of(dots.pieces,
                                   [&](const Dots& piece) { return (piece.*column).size() == piece.size(); });
    };
    dot_count_ = dots.size();
    has_critical_ = all_have(&Dots::critical);
    all_.has_radii = dot_count_ > 0 && all_have(&Dots::radius);
    measure_radii(all_);
    dot_origin_ = {window.x, window.y};
}

void Renderer::measure_radii(Shown& shown) {
    const auto count = static_cast<double>(shown.dots->size());
    for (const DotBlock& block : shown.blocks) {
        shown.mean_radius += block.radii / count;
        shown.largest_radius = std::max<double>(shown.largest_radius, block.largest_radius);
    }
}

void Renderer::set_ink(const InkedDots& ink, double at_full_density) {
    ink_ = ink;
    at_full_density_ = at_full_density;
}

void Renderer::set_pens(std::span<const Pen> pens) {
    job_.reset();
    pens_.clear();
    for (const Pen& pen : pens)
        pens_.emplace_back(linear_of(pen.colour), pen.ink == PenInk::transparent ? 1 : 0);
}

void Renderer::set_dot_colours(std::span<const glm::u8vec4> colours) {
    job_.reset();
    all_.colours = colours.size() == dot_count_ ? colours : std::span<const glm::u8vec4>();
}

void Renderer::set_strokes(const ShownStrokes& strokes) {
    job_.reset();
    if (strokes.lines.empty()) return;
    strokes_ = &strokes;
    all_.blocks = strokes.blocks;
    all_.has_radii = false;
    all_.colours = {};
}

void Renderer::set_inking(const ShownStrokes& inking) {
    job_.reset();
    inking_ = inking.lines.empty() ? nullptr : &inking;
}

void Renderer::set_tiles(std::span<const PlacedTile> tiles, const PageWindow& window) {
    job_.reset();
    tiles_shown_ = tiles;
    tile_window_ = window;
}

void Renderer::set_picture(PictureLevels levels) {
    job_.reset();
    has_picture_ = false;
    uploading_ = levels && !levels->empty() ? std::move(levels) : nullptr;
    upload_level_ = 0;
    upload_row_ = 0;
    if (uploading_) picture_.make_room(uploading_->front().width, uploading_->front().height);
}

bool Renderer::upload(double seconds) {
    constexpr int kPixelsAtOnce = 1 << 17;
    const auto begin = Clock::now();
    while (uploading_) {
        if (upload_level_ == uploading_->size()) {
            uploading_.reset();
            has_picture_ = true;
            return true;
        }
        if (std::chrono::duration<double>(Clock::now() - begin).count() >= seconds) return false;
        const Grid<glm::u8vec4>& level = (*uploading_)[upload_level_];
        const int rows = std::clamp(kPixelsAtOnce / level.width, 1, level.height - upload_row_);
        picture_.put_rows(static_cast<int>(upload_level_), level, upload_row_, rows);
        upload_row_ += rows;
        if (upload_row_ < level.height) continue;
        upload_row_ = 0;
        ++upload_level_;
    }
    return true;
}

Fineness Renderer::draw(const GlFramebuffer& picture, const Camera& camera, const CanvasLook& look,
                        Fineness fineness, Columns columns) {
    job_.reset();
    Job job = job_of(camera, look, fineness, columns);
    const Job finest = job_of(camera, look, Fineness::full, columns);
    go_on(job, picture, std::numeric_limits<double>::infinity());
    return job.grid.samples == finest.grid.samples && job.raster == finest.raster ? Fineness::full : fineness;
}

Fineness Renderer::draw_quickly(const GlFramebuffer& picture, const Camera& camera, const CanvasLook& look,
                                Columns columns, double seconds, Desk desk) {
    job_.reset();
    dots_seconds_ = 0;
    Job job = job_of(camera, look, Fineness::quick, columns);
    const Job finest = job_of(camera, look, Fineness::full, columns);
    job.every = quick_cost_.every(job.in_view, in_samples(job, mean_radius(camera, look)), seconds, every_);
    every_ = job.every;
    job.tiles = std::min(job.tiles, kTilesAtOnce);
    job.desk = desk;
    const bool as_good = job.grid.samples == finest.grid.samples && job.raster == finest.raster &&
                         job.every == 1 && job.tiles == finest.tiles;
    go_on(job, picture, std::numeric_limits<double>::infinity());
    return as_good ? Fineness::full : Fineness::quick;
}

void Renderer::begin(const Camera& camera, const CanvasLook& look, Columns columns) {
    job_ = job_of(camera, look, Fineness::full, columns);
}

bool Renderer::step(const GlFramebuffer& picture, double seconds) {
    if (job_ && go_on(*job_, picture, seconds)) {
        job_.reset();
        every_ = 1;  // the gesture has ended
    }
    return !job_;
}

Renderer::Job Renderer::job_of(const Camera& camera, const CanvasLook& look, Fineness fineness,
                               Columns columns) const {
    const auto width = static_cast<int>(camera.canvas.x);
    Job job{.camera = camera,
            .look = look,
            .columns = {std::max(columns.first, 0), std::min(columns.end, width)},
            .shown = &all_,
            .fineness = fineness};
    if (job.columns.first >= job.columns.end) {
        job.next_row = static_cast<int>(camera.canvas.y);  // nothing to draw
        return job;
    }
    job.grid = dot_grid(camera, look, fineness, job.columns);
    if (look.tiles) job.tiles = tiles_shown_.size();
    if (job.grid.samples == 0) return job;
    job.raster = raster_of(job);
    // Its coverage of a pixel is that of many samples. But of several pens which dots lie on others has to be
    // known where they do.
    if (job.raster && !by_pen()) job.grid.samples = 1;
    const glm::dvec2 origin = to_canvas(camera, dot_origin_);
    const double radius = strokes_         ? strokes_->width / 2
                          : all_.has_radii ? all_.largest_radius
                                           : look.dot_radius;
    const double rim = radius * camera.pixels_per_unit + 2;
    for (std::size_t i = 0; i < all_.blocks.size(); ++i) {
        const DotBlock& block = all_.blocks[i];
        const glm::dvec2 low = origin + glm::dvec2(block.low) * camera.pixels_per_unit - rim,
                         high = origin + glm::dvec2(block.high) * camera.pixels_per_unit + rim;
        if (low.x > job.columns.end || low.y > camera.canvas.y || high.x < job.columns.first || high.y < 0)
            continue;
        job.blocks.push_back(i);
        job.in_view += block.count;
    }
    return job;
}

bool Renderer::go_on(Job& job, const GlFramebuffer& picture, double seconds) {
    Turn turn(seconds);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    begin_dots(job, turn);
    if (turn.ends())
        add_dots(job, turn);
    else
        draw_all_dots(job, turn);
    if (job.next_block == job.blocks.size()) {
        hand_over_dots(job, turn);
        add_page(job, picture, turn);
        add_tiles(job, turn);
    }
    // As others find it who draw in between: ImGui gives a program back that may be deleted meanwhile.
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    glBindVertexArray(0);
    glUseProgram(0);
    return job.is_done();
}

void Renderer::begin_dots(Job& job, Turn& turn) {
    if (job.prepared) return;
    job.prepared = true;
    if (job.grid.samples == 0) return;
    prepare_dots(job);
    if (inking_ && !job.raster) draw_inking(job);
    if (!turn.ends()) return;
    if (job.raster) processor_dots_.begin(raster_view(job), *job.raster, ink_to_draw(job));
    turn.finish();
}

// As many as there is time for.
void Renderer::add_dots(Job& job, Turn& turn) {
    while (!turn.is_over() && job.next_block < job.blocks.size()) {
        const std::size_t before = job.next_block;
        const Clock::time_point begin = Clock::now();
        draw_dots(job, std::clamp(static_cast<std::size_t>(turn.slice() / seconds_per_dot_), kFewestDots,
                                  kMostDotsAtOnce));
        std::size_t drawn = 0;
        for (std::size_t i = before; i < job.next_block; ++i) drawn += all_.blocks[job.blocks[i]].count;
        learn(seconds_per_dot_, std::max(turn.finish(begin) / static_cast<double>(drawn), 1e-9));
    }
}

// All, or a preview of them, and learns how long that takes.
void Renderer::draw_all_dots(Job& job, Turn& turn) {
    const Clock::time_point begin = Clock::now();
    double share_of_dots = 1;  // of the time
    if (job.every > 1 && !strokes_) show_preview(job);
    if (job.blocks.empty() && !inking_) return;
    if (job.raster) {
        share_of_dots =
            processor_dots_.draw(raster_view(job), *job.raster, ink_to_draw(job), job.blocks, by_pen());
        job.next_block = job.blocks.size();
    }
    while (job.next_block < job.blocks.size()) draw_dots(job, kMostDotsAtOnce);
    dots_seconds_ = share_of_dots * turn.finish(begin);
    const auto every = static_cast<double>(job.every);
    const double drawn = static_cast<double>(job.in_view) / every,
                 radius = in_samples(job, mean_radius(job.camera, job.look)) * std::sqrt(every);
    if (drawn > 1000 && job.fineness == Fineness::quick) quick_cost_.learn(drawn, radius, dots_seconds_);
}

// To OpenGL, where the processor has drawn them.
void Renderer::hand_over_dots(Job& job, const Turn& turn) {
    if (job.raster && !job.uploaded) {
        if (turn.ends()) processor_dots_.finish(by_pen());
        processor_dots_.upload(dots_of(job), by_pen());
    }
    job.uploaded = true;
}

void Renderer::add_page(Job& job, const GlFramebuffer& picture, Turn& turn) {
    const auto height = static_cast<int>(job.camera.canvas.y);
    picture.bind();
    glEnable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    while (!turn.is_over() && job.next_row < height) {
        const Clock::time_point begin = Clock::now();
        const int most =
            turn.ends() ? static_cast<int>(std::min(turn.slice() / seconds_per_row_, 1e6)) : height;
        const int rows = std::clamp(most, 1, height - job.next_row);
        draw_page(job, picture, {{job.columns.first, job.next_row}, {job.columns.end, job.next_row + rows}});
        job.next_row += rows;
        if (turn.ends()) learn(seconds_per_row_, std::max(turn.finish(begin) / rows, 1e-7));
    }
}

void Renderer::add_tiles(Job& job, Turn& turn) {
    const auto height = static_cast<int>(job.camera.canvas.y);
    if (job.next_row < height || job.columns.first >= job.columns.end) return;
    glScissor(job.columns.first, 0, job.columns.end - job.columns.first, height);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    while (!turn.is_over() && job.tiles > 0) {
        draw_tiles(job, kTilesAtOnce / 4);
        if (turn.ends()) turn.finish();
    }
}

double Renderer::mean_radius(const Camera& camera, const CanvasLook& look) const {
    return camera.pixels_per_unit * (strokes_         ? strokes_->width / 2
                                     : all_.has_radii ? all_.mean_radius
                                                      : look.dot_radius);
}

Renderer::DotGrid Renderer::dot_grid(const Camera& camera, const CanvasLook& look, Fineness fineness,
                                     Columns columns) const {
    const double radius = mean_radius(camera, look);
    const glm::dvec2 canvas_low(columns.first, 0), canvas_high(columns.end, camera.canvas.y);
    const Rectangle<double> sheet = sheet_on_canvas(camera, look);
    const glm::dvec2 low = glm::floor(sheet.low), high = glm::ceil(sheet.high);
    DotGrid grid{glm::clamp(low, canvas_low, canvas_high), glm::clamp(high, canvas_low, canvas_high), 0};
    const glm::ivec2 size = grid.high - grid.low;
    if (!look.dots || dot_count_ == 0 || radius <= 0 || size.x == 0 || size.y == 0)
        return {grid.low, grid.low, 0};
    SampleLimits limits = limits_;
    limits.most /= static_cast<double>(pictures_of_dots());
    if (dots_by_ == DotsBy::processor && by_pen()) {
        // Eight bytes a sample; and its samples have soft edges, of which fewer are to meet.
        constexpr double kFiner = 0.6;
        limits.most = std::min(limits.most, kMostRasterMemory / 8 / static_cast<double>(pens_.size()));
        grid.samples = samples_per_side(kFiner * radius, size, fineness, limits);
        return grid;
    }
    grid.samples = samples_per_side(radius, size, fineness, limits);
    return grid;
}

GlFramebuffer& Renderer::dots_of(const Job& job) {
    return job.fineness == Fineness::quick ? quick_dots_ : full_dots_;
}

RasterView Renderer::raster_view(const Job& job) const {
    const Camera& camera = job.camera;
    const double samples = by_pen() ? job.grid.samples : 1;
    const glm::dvec2 corner(job.grid.low);
    const Rectangle<double> sheet = sheet_on_canvas(camera, job.look);
    return {.size = (job.grid.high - job.grid.low) * static_cast<int>(samples),
            .origin = (to_canvas(camera, dot_origin_) - corner) * samples,
            .pixels_per_unit = camera.pixels_per_unit * samples,
            .page = {(sheet.low - corner) * samples, (sheet.high - corner) * samples},
            .pens = by_pen() ? pens_.size() : 1};
}

std::optional<RasterGrain> Renderer::raster_of(const Job& job) const {
    if (dots_by_ != DotsBy::processor || has_colours()) return std::nullopt;
    const double radius = mean_radius(job.camera, job.look) / job.camera.pixels_per_unit;
    // Of several pens each sample of the grid is drawn as quickly.
    return raster_grain(raster_view(job), by_pen() ? Fineness::quick : job.fineness, radius);
}

double Renderer::in_samples(const Job& job, double radius) const {
    // The processor draws 8 x 8 of its samples at once.
    return radius * job.grid.samples * (job.raster ? job.raster->samples() / 8.0 : 1);
}

InkToDraw Renderer::ink_to_draw(const Job& job) {
    // Those left away are made up for.
    const auto every = static_cast<double>(job.every);
    return {.dots = job.shown->dots,
            .strokes = strokes_,
            .inking = inking_,
            .blocks = job.shown->blocks,
            .look = {.radius = job.look.dot_radius,
                     .largest_radius = job.shown->largest_radius,
                     .grow = strokes_ ? every : 1,
                     .fade_scale = has_critical_ ? job.look.fade_scale : 0,
                     .hidden = job.look.hidden_pens},
            .every = job.every};
}

void Renderer::prepare_dots(const Job& job) {
    const glm::ivec2 size = (job.grid.high - job.grid.low) * job.grid.samples;
    GlFramebuffer& dots = dots_of(job);
    const Texels texels = by_pen() ? Texels::as_given : has_colours() ? Texels::light : Texels::cover;
    dots.resize(size, texels, pictures_of_dots());
    if (job.raster) return;
    dots.bind();
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
}

void Renderer::attach_columns(const Shown& shown) {
    for (const auto& [array, divisor] : {std::pair(&dot_array_, 0u), {&dot_quad_array_, 1u}}) {
        array->bind();
        column_if(shown.has_radii, kDotRadius, dot_radius_, 1, divisor);
        column_if(has_colours() || by_pen(), kDotColour, dot_colour_, 4, divisor, GL_UNSIGNED_BYTE);
    }
}

// In place of the job's dots.
void Renderer::show_preview(Job& job) {
    const double radius = job.look.dot_radius, unit = job.camera.pixels_per_unit;
    const glm::dvec2 corner = -to_canvas(job.camera, dot_origin_) / unit;
    preview_ = preview_dots({.dots = *all_.dots,
                             .blocks = all_.blocks,
                             .in_view = job.blocks,
                             .colours = all_.colours,
                             .view = {corner, corner + job.camera.canvas / unit},
                             .radius = radius,
                             .ink = ink_,
                             .full_load = std::numbers::pi * radius * radius * at_full_density_},
                            static_cast<double>(job.every));
    previewed_ = {
        .dots = &preview_.dots, .blocks = preview_.blocks, .colours = preview_.colours, .has_radii = true};
    measure_radii(previewed_);
    job.shown = &previewed_;
    std::iota(job.blocks.begin(), job.blocks.end(), std::size_t{0});
}

// The next blocks with so many dots or a few more. What they cover is added to what the blocks before them
// do: dots unite in any order.
void Renderer::draw_dots(Job& job, std::size_t most) {
    if (job.raster) {
        const auto left = std::span<const std::size_t>(job.blocks).subspan(job.next_block);
        job.next_block += processor_dots_.add(ink_to_draw(job), left, most);
        return;
    }
    if (strokes_) return draw_lines(job, most);
    const CanvasLook& look = job.look;
    const Shown& shown = *job.shown;
    Dots& dots = handed_over_;
    for (FloatBuffer* numbers : {&dots.x, &dots.y, &dots.critical, &dots.radius}) numbers->clear();
    colours_handed_over_.clear();
    for (; job.next_block < job.blocks.size() && dots.size() < most; ++job.next_block) {
        const DotBlock& block = shown.blocks[job.blocks[job.next_block]];
        const Dots& from = shown.dots->pieces[block.piece];
        if (look.hidden_pens >> from.pen & 1) continue;
        take(dots.x, from.x, block);
        take(dots.y, from.y, block);
        // Not looked at if it isn't there, but the column must be as long as the others.
        take(dots.critical, has_critical_ ? from.critical : from.x, block);
        if (shown.has_radii) take(dots.radius, from.radius, block);
        if (by_pen()) colours_handed_over_.resize(dots.size(), pen_as_colour(from.pen));
        if (!has_colours()) continue;
        const auto colours = shown.colours.subspan(block.index, block.count);
        colours_handed_over_.insert(colours_handed_over_.end(), colours.begin(), colours.end());
    }
    dot_x_.write(std::as_bytes(std::span(dots.x)));
    dot_y_.write(std::as_bytes(std::span(dots.y)));
    dot_critical_.write(std::as_bytes(std::span(dots.critical)));
    if (shown.has_radii) dot_radius_.write(std::as_bytes(std::span(dots.radius)));
    if (has_colours() || by_pen()) dot_colour_.write(std::as_bytes(std::span(colours_handed_over_)));
    attach_columns(shown);
    const double scale = job.camera.pixels_per_unit * job.grid.samples;
    const double largest = (shown.has_radii ? shown.largest_radius : look.dot_radius) * scale;
    const double guard = std::ceil(largest) + 1;
    const bool sprites = 2 * guard <= largest_point_;
    begin_ink(job, dot_, sprites ? guard : 0);
    glUniform1f(dot_.uniform("guard"), sprites ? static_cast<float>(guard) : 0);
    glUniform1i(dot_.uniform("sprite"), sprites);
    glUniform1f(dot_.uniform("point_step"), static_cast<float>(point_step_));
    glUniform1i(dot_.uniform("coloured"), has_colours());
    glUniform1f(dot_.uniform("fade_scale"), has_critical_ ? static_cast<float>(look.fade_scale) : 0);
    // What the shader reads where no column is attached.
    glVertexAttrib4f(kDotColour, 1, 1, 1, 1);
    glVertexAttrib1f(kDotRadius, static_cast<float>(look.dot_radius));
    const auto count = static_cast<GLsizei>(dots.size());
    if (sprites) {
        glEnable(GL_PROGRAM_POINT_SIZE);
        dot_array_.bind();
        glDrawArrays(GL_POINTS, 0, count);
    } else {
        dot_quad_array_.bind();
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
    }
    glDisable(GL_FRAMEBUFFER_SRGB);
}

// The same for lines, in place of the dots.
void Renderer::draw_lines(Job& job, std::size_t most) {
    lines_handed_over_.clear();
    colours_handed_over_.clear();
    line_widths_handed_over_.clear();
    for (; job.next_block < job.blocks.size() && lines_handed_over_.size() < most; ++job.next_block) {
        const DotBlock& block = all_.blocks[job.blocks[job.next_block]];
        for (std::size_t i = block.first; i < block.first + block.count; i += job.every) {
            if (!strokes_->pens.empty() && job.look.hidden_pens >> strokes_->pens[i] & 1) continue;
            lines_handed_over_.push_back(strokes_->lines[i]);
            if (!by_pen()) continue;
            colours_handed_over_.push_back(pen_as_colour(strokes_->pens[i]));
            line_widths_handed_over_.push_back(strokes_->widths[i]);
        }
    }
    // Those left away are made up for: a line covers in proportion to its width.
    draw_handed_over(job, strokes_->width, static_cast<double>(job.every));
}

// All of it, before the dots.
void Renderer::draw_inking(const Job& job) {
    lines_handed_over_ = inking_->lines;
    line_widths_handed_over_ = inking_->widths;
    colours_handed_over_.clear();
    if (by_pen()) {
        if (job.look.hidden_pens >> inking_->pens.front() & 1) return;
        colours_handed_over_.assign(inking_->lines.size(), pen_as_colour(inking_->pens.front()));
    }
    draw_handed_over(job, 0, 1);
}

// Dots or lines, onto the picture for them with so many samples around it.
void Renderer::begin_ink(const Job& job, const GlProgram& program, double guard) {
    const DotGrid& grid = job.grid;
    const auto samples = static_cast<double>(grid.samples);
    dots_of(job).bind();
    glEnable(GL_FRAMEBUFFER_SRGB);
    glEnable(GL_BLEND);
    // Each component unites what is drawn into it.
    glBlendFunc(GL_ONE, by_pen() ? GL_ONE_MINUS_SRC_COLOR : GL_ONE_MINUS_SRC_ALPHA);
    program.use();
    set_transform(program, {.offset = (to_canvas(job.camera, dot_origin_) - glm::dvec2(grid.low)) * samples,
                            .scale = job.camera.pixels_per_unit * samples,
                            .canvas = glm::dvec2((grid.high - grid.low) * grid.samples),
                            .guard = guard});
    glUniform1i(program.uniform("by_pen"), by_pen());
}

// Lines in the memory for it, with widths of their own or that one.
void Renderer::draw_handed_over(const Job& job, double width, double grow) {
    line_ends_.write(std::as_bytes(std::span(lines_handed_over_)));
    line_array_.bind();
    if (by_pen()) dot_colour_.write(std::as_bytes(std::span(colours_handed_over_)));
    column_if(by_pen(), kLineColour, dot_colour_, 4, 1, GL_UNSIGNED_BYTE);
    const bool own_widths = !line_widths_handed_over_.empty();
    if (own_widths) line_widths_.write(std::as_bytes(std::span(line_widths_handed_over_)));
    column_if(own_widths, kLineWidth, line_widths_, 1, 1);
    begin_ink(job, line_, 0);
    glUniform1f(line_.uniform("grow"), static_cast<float>(grow));
    // What the shader reads where no column is attached.
    glVertexAttrib4f(kLineColour, 1, 1, 1, 1);
    glVertexAttrib1f(kLineWidth, static_cast<float>(width));
    line_array_.bind();
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(lines_handed_over_.size()));
    glDisable(GL_FRAMEBUFFER_SRGB);
}

// The part of it that is wholly on the sheet, which is most of it, by a program that does only what is needed
// there, and the rest about it.
void Renderer::draw_page(const Job& job, const GlFramebuffer& picture, const Rectangle<int>& box) {
    const Rectangle<double> sheet = sheet_on_canvas(job.camera, job.look);
    const glm::vec2 page_low = sheet.low, page_high = sheet.high;
    // The page may reach further than integers do.
    const auto within = [&](glm::vec2 low, glm::vec2 high) {
        return Rectangle<int>{glm::ivec2(glm::clamp(low, glm::vec2(box.low), glm::vec2(box.high))),
                              glm::ivec2(glm::clamp(high, glm::vec2(box.low), glm::vec2(box.high)))};
    };
    const Rectangle<int> inner = within(glm::ceil(page_low), glm::floor(page_high));
    // With those pixels that lie on its edges.
    const Rectangle<int> outer = within(glm::floor(page_low), glm::ceil(page_high));
    if (outer.low.x >= outer.high.x || outer.low.y >= outer.high.y) return draw_page(job, box, desk_);
    if (job.desk == Desk::drawn) draw_around(job, box, outer, desk_);
    if (inner.low.x >= inner.high.x || inner.low.y >= inner.high.y) return draw_page(job, outer, page_);
    draw_around(job, outer, inner, page_);
    if (has_picture_ && job.look.picture_opacity > 0) return draw_page(job, inner, sheet_with_picture_);
    if (!job.raster || by_pen()) return draw_page(job, inner, sheet_);
    processor_dots_.put_colours(picture, inner, job.grid.low, job.look.paper, job.look.ink);
}

void Renderer::draw_around(const Job& job, const Rectangle<int>& box, const Rectangle<int>& hole,
                           const GlProgram& program) {
    draw_page(job, {box.low, {box.high.x, hole.low.y}}, program);
    draw_page(job, {{box.low.x, hole.high.y}, box.high}, program);
    draw_page(job, {{box.low.x, hole.low.y}, {hole.low.x, hole.high.y}}, program);
    draw_page(job, {{hole.high.x, hole.low.y}, {box.high.x, hole.high.y}}, program);
}

void Renderer::draw_page(const Job& job, const Rectangle<int>& box, const GlProgram& program) {
    const glm::ivec2 size_of_box = box.size();
    if (size_of_box.x <= 0 || size_of_box.y <= 0) return;
    glScissor(box.low.x, box.low.y, size_of_box.x, size_of_box.y);
    const Camera& camera = job.camera;
    const CanvasLook& look = job.look;
    const DotGrid& grid = job.grid;
    glViewport(0, 0, static_cast<GLsizei>(camera.canvas.x), static_cast<GLsizei>(camera.canvas.y));
    program.use();
    set_page(program, camera, look);
    glUniform1f(program.uniform("shadow"), 14 * look.pixel_scale);
    glUniform1f(program.uniform("picture_opacity"), has_picture_ ? look.picture_opacity : 0);
    glUniform1f(program.uniform("picture_gain"), look.picture_gain);
    glUniform1i(program.uniform("picture"), 0);
    constexpr std::array kDotPictures{"dots", "dots_of_pens_4_to_7", "dots_of_pens_8_to_11"};
    const GlFramebuffer& dots = dots_of(job);
    for (std::size_t i = 0; i < kDotPictures.size(); ++i) {
        glUniform1i(program.uniform(kDotPictures[i]), static_cast<GLint>(i) + 1);
        glActiveTexture(GL_TEXTURE1 + static_cast<GLenum>(i));
        dots.bind_texture(std::min(i, dots.pictures() - 1));
    }
    glUniform1i(program.uniform("pens"), by_pen() ? static_cast<GLint>(pens_.size()) : 0);
    if (by_pen()) glUniform4fv(program.uniform("pen_inks"), static_cast<GLsizei>(pens_.size()), &pens_[0].x);
    glUniform1i(program.uniform("samples"), grid.samples);
    glUniform4i(program.uniform("dots_box"), grid.low.x, grid.low.y, grid.high.x, grid.high.y);
    const glm::dvec2 samples((grid.high - grid.low) * grid.samples);
    const auto sample = [&](glm::dvec2 point) {
        const glm::dvec2 at = (point - glm::dvec2(grid.low)) * static_cast<double>(grid.samples);
        return glm::ivec2(glm::round(glm::clamp(at, glm::dvec2(0), samples)));
    };
    const Rectangle<double> sheet = sheet_on_canvas(camera, look);
    const glm::ivec2 first = sample(sheet.low), end = sample(sheet.high);
    glUniform4i(program.uniform("page_samples"), first.x, first.y, end.x, end.y);
    set_colour(program, "desk", look.desk);
    set_colour(program, "paper", look.paper);
    set_colour(program, "paper_light", linear_of(look.paper));
    set_colour(program, "ink", has_colours() ? glm::vec3(1) : linear_of(look.ink));
    glActiveTexture(GL_TEXTURE0);
    picture_.bind();
    empty_.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

// The last ones of those that are left.
void Renderer::draw_tiles(Job& job, std::size_t most) {
    const std::size_t count = std::min(job.tiles, most);
    std::vector<glm::vec4> boxes;
    std::vector<glm::vec3> info;
    boxes.reserve(count);
    info.reserve(count);
    // Cut off a window beyond the window: a large tile's near side would be lost in its far one's rounding.
    const glm::dvec2 size(tile_window_.width, tile_window_.height);
    for (std::size_t i = job.tiles; i-- > job.tiles - count;) {
        const PlacedTile& tile = tiles_shown_[i];
        const glm::dvec2 low(tile.x, tile.y), high = low + tile.side;
        const glm::dvec2 cut_low = glm::max(low, -size), cut_high = glm::min(high, 2.0 * size);
        boxes.emplace_back(cut_low.x, cut_low.y, cut_high.x, cut_high.y);
        const bool whole = cut_low == low && cut_high == high;
        info.emplace_back(tile.level, whole ? tile.orientation.index : -1,
                          tile.kind ? static_cast<float>(*tile.kind) : -1);
    }
    job.tiles -= count;
    tiles_.write(std::as_bytes(std::span(boxes)));
    tile_looks_.write(std::as_bytes(std::span(info)));
    tile_.use();
    set_transform(tile_, {.offset = to_canvas(job.camera, PagePoint{tile_window_.x, tile_window_.y}),
                          .scale = job.camera.pixels_per_unit,
                          .canvas = job.camera.canvas});
    set_page(tile_, job.camera, job.look);
    glUniform1f(tile_.uniform("line_width"), job.look.pixel_scale);
    std::array<glm::vec3, kLevelColours> levels;
    for (int level = 0; level < kLevelColours; ++level) levels[level] = level_colour(level);
    glUniform3fv(tile_.uniform("level_colours"), kLevelColours, &levels[0].x);
    std::array<glm::vec3, kMaxKinds> kinds;
    for (std::size_t kind = 0; kind < kMaxKinds; ++kind) kinds[kind] = kind_colour(kind);
    glUniform3fv(tile_.uniform("kind_colours"), kMaxKinds, &kinds[0].x);
    tile_array_.bind();
    glDrawArraysInstanced(GL_TRIANGLES, 0, 42, static_cast<GLsizei>(count));
}

}  // namespace dapple
