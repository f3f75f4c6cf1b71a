#pragma once
// The part of the window that shows the page: keeps what was drawn as a picture and draws it again only when
// something in it changed, so that moving over the panels costs nothing. While it goes on changing, it is
// drawn quickly; once it rests, fully.

#include <algorithm>
#include <array>
#include <chrono>
#include <glm/vec2.hpp>
#include <optional>

#include "app/viewer/background/dots_request.h"
#include "app/viewer/canvas/camera_mouse.h"
#include "app/viewer/canvas/gl_objects.h"
#include "app/viewer/canvas/renderer.h"
#include "app/viewer/view/frame_budget.h"

struct ImDrawCmd;
struct ImDrawList;

namespace dapple {

enum class Redraw {
    when_changed,
    always,
    later,  // this frame is not seen
};

/// A side of the split view; a view that is not split is the left side alone.
enum class Side { left, right };
inline constexpr std::array kSides{Side::left, Side::right};

/// How both sides look, and where they meet.
struct SplitLook {
    std::array<CanvasLook, 2> sides;
    float divider = 1;  // the left side's share of the width; 1: there is no right one

    bool operator==(const SplitLook&) const = default;
};

class Canvas {
 public:
    /// The page is as large as the left side's. The drawing is looked at until the next one is set.
    void set_drawing(Side side, const PlacedDrawing& drawing);
    /// Shown once it is uploaded, a part in each frame: see Renderer.
    void set_picture(Side side, PictureLevels levels);

    void fit();
    /// Through another camera, on this canvas.
    void look(const Camera& camera);
    /// So many pixels for the page's longer side, about the middle.
    void zoom_to(double pixels_per_unit);
    void zoom(double factor);
    /// Moved as when the page is dragged by so many of the canvas's shorter sides.
    void pan(glm::dvec2 sides);
    const Camera& camera() const { return camera_; }
    /// Whether the page fills it whatever its size, until the person zooms or moves.
    bool is_fitted() const { return fitted_; }
    /// How many times larger than fitted.
    double enlargement() const;

    /// Wheel and drag, unless ImGui's windows want the mouse. See CameraMouse.
    void handle_mouse(const CanvasPlace& place, bool left_taken = false);

    /// The frame before took so many seconds, all in all: how long it may draw in the next goes by that.
    void learn(double last_frame);

    /// Puts the drawing behind ImGui's windows; it has to be there until those are drawn. Returns the pixels
    /// of the window, from the upper left corner, that it covers.
    Rectangle<int> show(const CanvasPlace& place, SplitLook look, Redraw redraw);

    /// How long the newest drawing that is whole took, in milliseconds.
    double draw_ms() const { return draw_ms_; }
    /// Another frame is to follow at once: it is being drawn fully, or a picture uploaded, a part in each
    /// frame, so that mouse and keys are answered in between.
    bool drawing() const { return job_side_.has_value() || uploading_; }
    /// Whether dots are left out of what is seen, until all rests.
    bool shows_part() const {
        return drawn_ == Fineness::quick &&
               std::ranges::any_of(renderers_, [](const Renderer& each) { return each.leaves_out(); });
    }
    /// Seconds after which another frame will draw it fully; none if it is.
    std::optional<double> seconds_to_next_frame() const;

 private:
    using Clock = std::chrono::steady_clock;

    Camera fitted_to_sheet(glm::dvec2 canvas) const;
    Columns columns_of(Side side, glm::ivec2 pixels) const;
    void upload(double seconds);
    void draw_quickly(glm::ivec2 pixels, Desk desk);
    void go_on(glm::ivec2 pixels);

    /// What the window gets, y up as OpenGL counts.
    struct Shown {
        const GlFramebuffer* picture = nullptr;
        glm::ivec2 low{0}, high{0};  // pixels of the window
    };
    static void copy_to_window(const ImDrawList* list, const ImDrawCmd* command);

    Shown shown_;
    std::array<Renderer, 2> renderers_;
    GlFramebuffer picture_, full_;         // shown, and the one that is being drawn fully
    std::optional<std::size_t> job_side_;  // the side being drawn fully
    double job_seconds_ = 0;
    FrameBudget budget_;
    double budgeted_ = 0;  // seconds of the last frame that went by the budget
    bool uploading_ = false;
    Camera camera_;
    glm::dvec2 page_size_{1, 1};
    std::optional<Rectangle<double>> sheet_;  // as CanvasLook has it
    bool fitted_ = true;                      // until the person zooms or moves
    CameraMouse mouse_;
    std::optional<Camera> drawn_camera_;  // none: the drawing changed
    SplitLook drawn_look_;
    std::optional<Camera> desk_camera_;  // of what lies beside the sheet in `picture_`
    Fineness drawn_ = Fineness::full;
    Clock::time_point changed_;  // when it was drawn quickly last
    double draw_ms_ = 0;
};

}  // namespace dapple
