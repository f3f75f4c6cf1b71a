#include "app/viewer/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <vector>

#include "core/image/tone.h"
#include "core/output/colour.h"
#include "dapple_viewer_embedded/shaders.h"

namespace dapple {
namespace {

constexpr int kLevelColours = 12;                 // as in tile.vert
constexpr GLuint kDotColour = 3, kDotRadius = 4;  // the attributes' locations, as in dot.vert
constexpr double kLargestSprite = 256;            // samples: a guard band as wide never is too much

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

// Where the page lies, for a fragment shader.
void set_page(const GlProgram& program, const Camera& camera, const CanvasLook& look) {
    const glm::dvec2 low = to_canvas(camera, PagePoint(0)),
                     high = to_canvas(camera, page_point(look.page_size));
    glUniform2f(program.uniform("page_min"), static_cast<float>(low.x), static_cast<float>(low.y));
    glUniform2f(program.uniform("page_max"), static_cast<float>(high.x), static_cast<float>(high.y));
    glUniform1f(program.uniform("canvas_height"), static_cast<float>(camera.canvas.y));
}

void set_colour(const GlProgram& program, const char* name, glm::vec3 colour) {
    glUniform3f(program.uniform(name), colour.r, colour.g, colour.b);
}

glm::vec3 light_of(glm::vec3 encoded) {
    return {srgb_to_linear(encoded.r), srgb_to_linear(encoded.g), srgb_to_linear(encoded.b)};
}

void column(GLuint location, const GlStreamBuffer& buffer, GLint components, GLuint divisor) {
    buffer.bind();
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, 0, nullptr);
    glVertexAttribDivisor(location, divisor);
}

void write_column(GlStreamBuffer& buffer, const DotPieces& dots, FloatBuffer Dots::*column) {
    buffer.write(dots.size() * sizeof(float), [&](std::byte* place) {
        for (const Dots& piece : dots.pieces)
            place = std::ranges::copy(std::as_bytes(std::span(piece.*column)), place).out;
    });
}

}  // namespace

Renderer::Renderer()
    : page_(shaders::page_vert(), shaders::page_frag()),
      dot_(shaders::dot_vert(), shaders::dot_frag()),
      tile_(shaders::tile_vert(), shaders::tile_frag()) {
    dot_array_.bind();
    column(0, dot_x_, 1, 0);
    column(1, dot_y_, 1, 0);
    column(2, dot_critical_, 1, 0);
    dot_quad_array_.bind();
    column(0, dot_x_, 1, 1);
    column(1, dot_y_, 1, 1);
    column(2, dot_critical_, 1, 1);
    tile_array_.bind();
    column(0, tiles_, 4, 1);
    column(1, tile_facts_, 2, 1);
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

void Renderer::set_dots(const DotPieces& dots, const PageWindow& window) {
    write_column(dot_x_, dots, &Dots::x);
    write_column(dot_y_, dots, &Dots::y);
    has_critical_ = std::ranges::all_of(
        dots.pieces, [](const Dots& piece) { return piece.critical.size() == piece.size(); });
    // Not looked at if it isn't there, but the column must be as long as the others.
    write_column(dot_critical_, dots, has_critical_ ? &Dots::critical : &Dots::x);
    set_radii(dots);
    dot_origin_ = {window.x, window.y};
    dot_count_ = dots.size();
    if (has_colours_) set_dot_colours({});
}

void Renderer::set_radii(const DotPieces& dots) {
    const bool had = has_radii_;
    has_radii_ = std::ranges::all_of(dots.pieces,
                                     [](const Dots& piece) { return piece.radius.size() == piece.size(); });
    has_radii_ &= dots.size() > 0;
    if (has_radii_) {
        write_column(dot_radius_, dots, &Dots::radius);
        double sum = 0, largest = 0;
        for (const Dots& piece : dots.pieces) {
            for (const float radius : piece.radius) {
                sum += radius;
                largest = std::max<double>(largest, radius);
            }
        }
        mean_radius_ = sum / static_cast<double>(dots.size());
        largest_radius_ = largest;
    }
    if (has_radii_ == had) return;
    for (const auto& [array, divisor] : {std::pair(&dot_array_, 0u), {&dot_quad_array_, 1u}}) {
        array->bind();
        if (has_radii_)
            column(kDotRadius, dot_radius_, 1, divisor);
        else
            glDisableVertexAttribArray(kDotRadius);
    }
}

void Renderer::set_dot_colours(std::span<const glm::u8vec4> colours) {
    has_colours_ = !colours.empty() && colours.size() == dot_count_;
    if (has_colours_) dot_colour_.write(std::as_bytes(colours));
    const auto attach = [&](const GlVertexArray& array, GLuint divisor) {
        array.bind();
        if (!has_colours_) return glDisableVertexAttribArray(kDotColour);
        dot_colour_.bind();
        glEnableVertexAttribArray(kDotColour);
        glVertexAttribPointer(kDotColour, 4, GL_UNSIGNED_BYTE, GL_TRUE, 0, nullptr);
        glVertexAttribDivisor(kDotColour, divisor);
    };
    attach(dot_array_, 0);
    attach(dot_quad_array_, 1);
}

void Renderer::set_tiles(std::span<const PlacedTile> tiles, const PageWindow& window) {
    std::vector<glm::vec4> boxes;
    std::vector<glm::vec2> facts;
    boxes.reserve(tiles.size());
    facts.reserve(tiles.size());
    // Cut off a window beyond the window: a large tile's near side would be lost in its far one's rounding.
    const glm::dvec2 size(window.width, window.height);
    // The placer lists parents first; drawn last, their lines stay on top.
    for (auto tile = tiles.rbegin(); tile != tiles.rend(); ++tile) {
        const glm::dvec2 low(tile->x, tile->y), high = low + tile->side;
        const glm::dvec2 cut_low = glm::max(low, -size), cut_high = glm::min(high, 2.0 * size);
        boxes.emplace_back(cut_low.x, cut_low.y, cut_high.x, cut_high.y);
        const bool whole = cut_low == low && cut_high == high;
        facts.emplace_back(tile->level, whole ? tile->orientation.index : -1);
    }
    tiles_.write(std::as_bytes(std::span(boxes)));
    tile_facts_.write(std::as_bytes(std::span(facts)));
    tile_origin_ = {window.x, window.y};
    tile_count_ = boxes.size();
}

void Renderer::set_picture(const Grid<glm::u8vec4>& picture) {
    has_picture_ = !picture.empty();
    if (has_picture_) picture_.write(picture);
}

Fineness Renderer::draw(const GlFramebuffer& picture, const Camera& camera, const CanvasLook& look,
                        Fineness fineness, Columns columns) {
    const int first = std::max(columns.first, 0), end = std::min(columns.end, picture.size().x);
    if (first >= end) return Fineness::full;
    const DotGrid grid = dot_grid(camera, look, fineness, {first, end});
    const DotGrid finest = dot_grid(camera, look, Fineness::full, {first, end});
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    if (grid.samples > 0) draw_dots(camera, look, grid);
    picture.bind();
    glEnable(GL_SCISSOR_TEST);
    glScissor(first, 0, end - first, picture.size().y);
    glDisable(GL_BLEND);
    draw_page(camera, look, grid);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    if (look.tiles) draw_tiles(camera, look);
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    glBindVertexArray(0);
    glUseProgram(0);
    return grid.samples == finest.samples ? Fineness::full : fineness;
}

Renderer::DotGrid Renderer::dot_grid(const Camera& camera, const CanvasLook& look, Fineness fineness,
                                     Columns columns) const {
    const double radius = (has_radii_ ? mean_radius_ : look.dot_radius) * camera.pixels_per_unit;
    const glm::dvec2 canvas_low(columns.first, 0), canvas_high(columns.end, camera.canvas.y);
    const glm::dvec2 low = glm::floor(to_canvas(camera, PagePoint(0))),
                     high = glm::ceil(to_canvas(camera, page_point(look.page_size)));
    DotGrid grid{glm::clamp(low, canvas_low, canvas_high), glm::clamp(high, canvas_low, canvas_high), 0};
    const glm::ivec2 size = grid.high - grid.low;
    if (!look.dots || dot_count_ == 0 || radius <= 0 || size.x == 0 || size.y == 0)
        return {grid.low, grid.low, 0};
    grid.samples = samples_per_side(radius, size, fineness, limits_);
    return grid;
}

void Renderer::draw_dots(const Camera& camera, const CanvasLook& look, const DotGrid& grid) {
    const double scale = camera.pixels_per_unit * grid.samples;
    const double largest = (has_radii_ ? largest_radius_ : look.dot_radius) * scale;
    const double guard = std::ceil(largest) + 1;
    const bool sprites = 2 * guard <= largest_point_;
    const glm::ivec2 size = (grid.high - grid.low) * grid.samples;
    dots_.resize(size, has_colours_ ? Texels::light : Texels::cover);
    dots_.bind();
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_FRAMEBUFFER_SRGB);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    dot_.use();
    set_transform(dot_, {.offset = (to_canvas(camera, dot_origin_) - glm::dvec2(grid.low)) *
                                   static_cast<double>(grid.samples),
                         .scale = scale,
                         .canvas = glm::dvec2(size),
                         .guard = sprites ? guard : 0});
    glUniform1f(dot_.uniform("guard"), sprites ? static_cast<float>(guard) : 0);
    glUniform1i(dot_.uniform("sprite"), sprites);
    glUniform1f(dot_.uniform("point_step"), static_cast<float>(point_step_));
    glUniform1i(dot_.uniform("coloured"), has_colours_);
    glUniform1f(dot_.uniform("fade_scale"), has_critical_ ? static_cast<float>(look.fade_scale) : 0);
    // What the shader reads where no column is attached.
    glVertexAttrib4f(kDotColour, 1, 1, 1, 1);
    glVertexAttrib1f(kDotRadius, static_cast<float>(look.dot_radius));
    const auto count = static_cast<GLsizei>(dot_count_);
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

void Renderer::draw_page(const Camera& camera, const CanvasLook& look, const DotGrid& grid) const {
    glViewport(0, 0, static_cast<GLsizei>(camera.canvas.x), static_cast<GLsizei>(camera.canvas.y));
    page_.use();
    set_page(page_, camera, look);
    glUniform1f(page_.uniform("shadow"), 14 * look.pixel_scale);
    glUniform1f(page_.uniform("picture_opacity"), has_picture_ ? look.picture_opacity : 0);
    glUniform1i(page_.uniform("picture"), 0);
    glUniform1i(page_.uniform("dots"), 1);
    glUniform1i(page_.uniform("samples"), grid.samples);
    const int height = static_cast<int>(camera.canvas.y);
    glUniform4i(page_.uniform("dots_box"), grid.low.x, height - grid.high.y, grid.high.x,
                height - grid.low.y);
    const glm::dvec2 samples((grid.high - grid.low) * grid.samples);
    const auto sample = [&](PagePoint point) {
        const glm::dvec2 at =
            (to_canvas(camera, point) - glm::dvec2(grid.low)) * static_cast<double>(grid.samples);
        return glm::ivec2(glm::round(glm::clamp(at, glm::dvec2(0), samples)));
    };
    const glm::ivec2 first = sample(PagePoint(0)), end = sample(page_point(look.page_size));
    const int rows = static_cast<int>(samples.y);
    glUniform4i(page_.uniform("page_samples"), first.x, rows - end.y, end.x, rows - first.y);
    set_colour(page_, "desk", look.desk);
    set_colour(page_, "paper", look.paper);
    set_colour(page_, "ink", has_colours_ ? glm::vec3(1) : light_of(look.ink));
    glActiveTexture(GL_TEXTURE1);
    dots_.bind_texture();
    glActiveTexture(GL_TEXTURE0);
    picture_.bind();
    empty_.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Renderer::draw_tiles(const Camera& camera, const CanvasLook& look) const {
    if (tile_count_ == 0) return;
    tile_.use();
    set_transform(tile_, {.offset = to_canvas(camera, tile_origin_),
                          .scale = camera.pixels_per_unit,
                          .canvas = camera.canvas});
    set_page(tile_, camera, look);
    glUniform1f(tile_.uniform("line_width"), look.pixel_scale);
    std::array<glm::vec3, kLevelColours> colours;
    for (int level = 0; level < kLevelColours; ++level) colours[level] = level_colour(level);
    glUniform3fv(tile_.uniform("level_colours"), kLevelColours, &colours[0].x);
    tile_array_.bind();
    glDrawArraysInstanced(GL_TRIANGLES, 0, 42, static_cast<GLsizei>(tile_count_));
}

}  // namespace dapple
