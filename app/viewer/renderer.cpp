#include "app/viewer/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <vector>

#include "core/output/colour.h"
#include "dapple_viewer_embedded/shaders.h"

namespace dapple {
namespace {

constexpr int kLevelColours = 12;  // as in tile.vert
constexpr GLuint kDotColour = 3;   // the attribute's location, as in dot.vert

/// Page to pixels of a canvas with a guard band around it: dots are clipped by their centres, and those just
/// outside must still show their rims.
struct PageToPixels {
    glm::dvec2 offset;
    double scale;
    glm::dvec2 canvas;
    double guard;
};

PageToPixels page_to_pixels(const Camera& camera, PagePoint origin, double guard) {
    return {to_canvas(camera, origin) + guard, camera.pixels_per_unit, camera.canvas + 2 * guard, guard};
}

void set_transform(const GlProgram& program, const PageToPixels& map) {
    glUniform2f(program.uniform("page_scale"), static_cast<float>(map.scale), static_cast<float>(map.scale));
    glUniform2f(program.uniform("page_offset"), static_cast<float>(map.offset.x),
                static_cast<float>(map.offset.y));
    glUniform2f(program.uniform("canvas"), static_cast<float>(map.canvas.x),
                static_cast<float>(map.canvas.y));
    auto low = -static_cast<GLint>(map.guard);
    glViewport(low, low, static_cast<GLsizei>(map.canvas.x), static_cast<GLsizei>(map.canvas.y));
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
      dot_quad_(shaders::dot_quad_vert(), shaders::dot_frag()),
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
    float sizes[2] = {1, 1};
    glGetFloatv(GL_POINT_SIZE_RANGE, sizes);
    largest_point_ = sizes[1];
}

void Renderer::set_dots(const DotPieces& dots, const PageWindow& window) {
    write_column(dot_x_, dots, &Dots::x);
    write_column(dot_y_, dots, &Dots::y);
    has_critical_ = std::ranges::all_of(
        dots.pieces, [](const Dots& piece) { return piece.critical.size() == piece.size(); });
    // Not looked at if it isn't there, but the column must be as long as the others.
    write_column(dot_critical_, dots, has_critical_ ? &Dots::critical : &Dots::x);
    dot_origin_ = {window.x, window.y};
    dot_count_ = dots.size();
    if (has_colours_) set_dot_colours({});
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

void Renderer::draw(const Camera& camera, const CanvasLook& look) const {
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    draw_page(camera, look);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    draw_dots(camera, look);
    if (look.tiles) draw_tiles(camera, look);
    glDisable(GL_BLEND);
    glBindVertexArray(0);
    glUseProgram(0);
}

void Renderer::draw_page(const Camera& camera, const CanvasLook& look) const {
    glViewport(0, 0, static_cast<GLsizei>(camera.canvas.x), static_cast<GLsizei>(camera.canvas.y));
    page_.use();
    set_page(page_, camera, look);
    glUniform1f(page_.uniform("shadow"), 14 * look.pixel_scale);
    glUniform1f(page_.uniform("picture_opacity"), has_picture_ ? look.picture_opacity : 0);
    glUniform1i(page_.uniform("picture"), 0);
    set_colour(page_, "desk", look.desk);
    set_colour(page_, "paper", look.paper);
    glActiveTexture(GL_TEXTURE0);
    picture_.bind();
    empty_.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Renderer::draw_dots(const Camera& camera, const CanvasLook& look) const {
    if (dot_count_ == 0 || look.dot_radius <= 0) return;
    double radius = look.dot_radius * camera.pixels_per_unit;
    // An edge one pixel wide makes a disc of radius r cover pi (r^2 + 1/12); below half a pixel the disc
    // stays and pales.
    double drawn = std::max(radius, 0.5);
    double strength = radius * radius / (drawn * drawn + 1.0 / 12);
    bool sprites = 2 * drawn + 2 <= static_cast<double>(largest_point_);
    const GlProgram& program = sprites ? dot_ : dot_quad_;
    program.use();
    set_transform(program, page_to_pixels(camera, dot_origin_, sprites ? std::ceil(drawn) + 1 : 0));
    glUniform1f(program.uniform("radius"), static_cast<float>(drawn));
    glUniform1f(program.uniform("strength"), static_cast<float>(strength));
    glUniform1i(program.uniform("sprite"), sprites);
    glUniform1f(program.uniform("fade_scale"), has_critical_ ? static_cast<float>(look.fade_scale) : 0);
    // What the shader reads where no column is attached.
    glVertexAttrib4f(kDotColour, look.ink.r, look.ink.g, look.ink.b, 1);
    auto count = static_cast<GLsizei>(dot_count_);
    if (sprites) {
        glEnable(GL_PROGRAM_POINT_SIZE);
        dot_array_.bind();
        glDrawArrays(GL_POINTS, 0, count);
    } else {
        dot_quad_array_.bind();
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
    }
}

void Renderer::draw_tiles(const Camera& camera, const CanvasLook& look) const {
    if (tile_count_ == 0) return;
    tile_.use();
    set_transform(tile_, page_to_pixels(camera, tile_origin_, 0));
    set_page(tile_, camera, look);
    glUniform1f(tile_.uniform("line_width"), look.pixel_scale);
    std::array<glm::vec3, kLevelColours> colours;
    for (int level = 0; level < kLevelColours; ++level) colours[level] = level_colour(level);
    glUniform3fv(tile_.uniform("level_colours"), kLevelColours, &colours[0].x);
    tile_array_.bind();
    glDrawArraysInstanced(GL_TRIANGLES, 0, 42, static_cast<GLsizei>(tile_count_));
}

}  // namespace dapple
