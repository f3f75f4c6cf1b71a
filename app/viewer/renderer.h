#pragma once
// Draws the sheet, the picture under it, dots and tile outlines with OpenGL 3.3 into the framebuffer that is
// bound.

#include <glm/gtc/type_precision.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "app/viewer/camera.h"
#include "app/viewer/gl_objects.h"
#include "core/placing/dots.h"
#include "core/placing/placer.h"

namespace dapple {

/// How the drawing looks on screen; colours sRGB-encoded 0..1.
struct CanvasLook {
    glm::vec3 desk{0.8f}, paper{1.0f}, ink{0.0f};
    glm::dvec2 page_size{1, 1};  // page units
    double dot_radius = 0.002;   // page units
    float picture_opacity = 0;   // 0: bare paper
    bool tiles = false;          // outlines shown
    double fade_scale = 0;       // dots fade in below this scale; 0: none does
    float pixel_scale = 1;       // pixels of a line meant to be one pixel wide at 96 dpi

    bool operator==(const CanvasLook&) const = default;
};

class Renderer {
 public:
    Renderer();

    /// Positions are relative to the window's corner. Dots::critical is needed for fading in only.
    void set_dots(const DotPieces& dots, const PageWindow& window = {});
    /// One colour a dot, or none for the ink; until the next set_dots().
    void set_dot_colours(std::span<const glm::u8vec4> colours);
    void set_tiles(std::span<const PlacedTile> tiles, const PageWindow& window = {});
    void set_picture(const Grid<glm::u8vec4>& picture);

    std::size_t dot_count() const { return dot_count_; }

    /// camera.canvas must be the framebuffer's size. Keeps to the scissor box, if that is on.
    void draw(const Camera& camera, const CanvasLook& look) const;

 private:
    void draw_page(const Camera& camera, const CanvasLook& look) const;
    void draw_dots(const Camera& camera, const CanvasLook& look) const;
    void draw_tiles(const Camera& camera, const CanvasLook& look) const;

    GlProgram page_, dot_, dot_quad_, tile_;
    GlVertexArray empty_, dot_array_, dot_quad_array_, tile_array_;
    GlStreamBuffer dot_x_, dot_y_, dot_critical_, dot_colour_, tiles_, tile_facts_;
    GlTexture picture_;
    PagePoint dot_origin_{0, 0}, tile_origin_{0, 0};
    std::size_t dot_count_ = 0, tile_count_ = 0;
    bool has_critical_ = false;
    bool has_colours_ = false;
    bool has_picture_ = false;
    float largest_point_ = 1;
};

}  // namespace dapple
