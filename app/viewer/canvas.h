#pragma once
// The part of the window that shows the page: keeps what was drawn as a picture and draws it again only when
// something in it changed, so that moving over the panels costs nothing.

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <span>

#include "app/viewer/camera.h"
#include "app/viewer/gl_objects.h"
#include "app/viewer/renderer.h"
#include "app/viewer/workbench.h"

namespace dapple {

/// Where the canvas lies, in ImGui's points.
struct CanvasPlace {
    glm::vec2 corner{0}, size{1};
    glm::dvec2 pixels_per_point{1, 1};
};

enum class Redraw {
    when_changed,
    always,
};

class Canvas {
 public:
    void set_drawing(const PlacedDrawing& drawing);
    /// One colour a dot, or none for the ink; until the next set_drawing().
    void set_dot_colours(std::span<const glm::u8vec4> colours);
    /// How many drawings were set.
    std::uint64_t drawings() const { return drawings_; }
    void set_picture(const Grid<glm::u8vec4>& picture);

    void fit();
    /// So many pixels for the page's longer side, about the middle.
    void zoom_to(double pixels_per_unit);
    void zoom(double factor);
    const Camera& camera() const { return camera_; }
    /// How many times larger than fitted.
    double enlargement() const;

    /// Wheel and drag, unless ImGui's windows want the mouse.
    void handle_mouse(const CanvasPlace& place);

    /// Puts the drawing behind ImGui's windows.
    void show(const CanvasPlace& place, CanvasLook look, Redraw redraw);

    /// Of the newest drawing measured.
    double draw_ms() const { return draw_ms_; }
    /// A measurement is under way: another frame will bring it.
    bool measuring() const { return timer_.waiting(); }

 private:
    Renderer renderer_;
    GlFramebuffer picture_;
    GlTimer timer_;
    Camera camera_;
    glm::dvec2 page_size_{1, 1};
    bool fitted_ = true;  // until the person zooms or moves
    bool dragging_ = false;
    std::optional<Camera> drawn_camera_;  // none: the drawing changed
    CanvasLook drawn_look_;
    double draw_ms_ = 0;
    std::uint64_t drawings_ = 0;
};

}  // namespace dapple
