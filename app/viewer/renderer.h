#pragma once
// Draws the sheet, the picture under it, dots and tile outlines with OpenGL 3.3.
//
// The page is as light as in a file (core/output/raster.h): ink and paper are mixed in linear light, dots
// that overlap unite, and what of them lies beyond the page's edges is cut off. For that the dots are first
// drawn by themselves, with more samples than the canvas has pixels where they are small.

#include <glm/gtc/type_precision.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <span>

#include "app/viewer/camera.h"
#include "app/viewer/dot_samples.h"
#include "app/viewer/gl_objects.h"
#include "core/placing/dots.h"
#include "core/placing/placer.h"

namespace dapple {

/// How the drawing looks on screen; colours sRGB-encoded 0..1.
struct CanvasLook {
    glm::vec3 desk{0.8f}, paper{1.0f}, ink{0.0f};
    glm::dvec2 page_size{1, 1};  // page units
    double dot_radius = 0.002;   // page units; of dots that have none of their own
    float picture_opacity = 0;   // 0: bare paper
    bool dots = true;            // shown
    bool tiles = false;          // outlines shown
    double fade_scale = 0;       // dots fade in below this scale; 0: none does
    float pixel_scale = 1;       // pixels of a line meant to be one pixel wide at 96 dpi

    bool operator==(const CanvasLook&) const = default;
};

/// Columns of the canvas, from the first to before the end.
struct Columns {
    int first = 0, end = std::numeric_limits<int>::max();
};

class Renderer {
 public:
    Renderer();

    /// Positions are relative to the window's corner. Dots::critical is needed for fading in only. All pieces
    /// have it or none, and so it is with Dots::radius.
    void set_dots(const DotPieces& dots, const PageWindow& window = {});
    /// One colour a dot, or none for the ink; until the next set_dots().
    void set_dot_colours(std::span<const glm::u8vec4> colours);
    void set_tiles(std::span<const PlacedTile> tiles, const PageWindow& window = {});
    void set_picture(const Grid<glm::u8vec4>& picture);

    std::size_t dot_count() const { return dot_count_; }

    /// camera.canvas must be the picture's size. Returns full if drawn fully it would look the same.
    Fineness draw(const GlFramebuffer& picture, const Camera& camera, const CanvasLook& look,
                  Fineness fineness = Fineness::full, Columns columns = {});

 private:
    /// Where dots can be seen, and how finely.
    struct DotGrid {
        glm::ivec2 low, high;  // pixels of the canvas, y down
        int samples;           // of a pixel's side; 0: there are no dots to be seen
    };

    void set_radii(const DotPieces& dots);
    DotGrid dot_grid(const Camera& camera, const CanvasLook& look, Fineness fineness, Columns columns) const;
    void draw_dots(const Camera& camera, const CanvasLook& look, const DotGrid& grid);
    void draw_page(const Camera& camera, const CanvasLook& look, const DotGrid& grid) const;
    void draw_tiles(const Camera& camera, const CanvasLook& look) const;

    GlProgram page_, dot_, tile_;
    GlVertexArray empty_, dot_array_, dot_quad_array_, tile_array_;
    GlStreamBuffer dot_x_, dot_y_, dot_critical_, dot_colour_, dot_radius_, tiles_, tile_facts_;
    GlFramebuffer dots_;
    GlTexture picture_;
    PagePoint dot_origin_{0, 0}, tile_origin_{0, 0};
    std::size_t dot_count_ = 0, tile_count_ = 0;
    bool has_critical_ = false;
    bool has_colours_ = false;
    bool has_radii_ = false;
    double mean_radius_ = 0, largest_radius_ = 0;  // page units, if they have one each
    bool has_picture_ = false;
    double largest_point_ = 1, point_step_ = 1;
    SampleLimits limits_;
};

}  // namespace dapple
