#include "app/viewer/canvas.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/viewer/keys.h"

namespace dapple {
namespace {

// Between two turns of a wheel, or two moves of a slider, there is less.
constexpr double kRestSeconds = 0.15;

}  // namespace

void Canvas::set_drawing(Side side, const PlacedDrawing& drawing) {
    Renderer& renderer = renderers_[static_cast<int>(side)];
    renderer.set_dots(drawing.stippling.dots, drawing.window);
    renderer.set_dot_colours(drawing.colours);
    renderer.set_tiles(drawing.outlines, drawing.window);
    if (side == Side::left) page_size_ = drawing.page_size;
    drawn_camera_.reset();
}

void Canvas::set_picture(Side side, const Grid<glm::u8vec4>& picture) {
    renderers_[static_cast<int>(side)].set_picture(picture);
    drawn_camera_.reset();
}

void Canvas::fit() {
    fitted_ = true;
}

void Canvas::zoom_to(double pixels_per_unit) {
    zoom(pixels_per_unit / camera_.pixels_per_unit);
}

void Canvas::zoom(double factor) {
    camera_ = zoomed_at(camera_, camera_.canvas * 0.5, factor);
    fitted_ = false;
}

double Canvas::enlargement() const {
    return camera_.pixels_per_unit / fitted(camera_.canvas, page_size_).pixels_per_unit;
}

void Canvas::handle_mouse(const CanvasPlace& place) {
    if (mouse_.move(camera_, place)) fitted_ = false;
}

std::optional<double> Canvas::rest() const {
    if (drawn_ == Fineness::full) return std::nullopt;
    const std::chrono::duration<double> rested = Clock::now() - changed_;
    return std::max(kRestSeconds - rested.count(), 0.0);
}

void Canvas::draw(const glm::ivec2& pixels, Fineness fineness) {
    picture_.resize(pixels);
    timer_.begin();
    const int middle = static_cast<int>(std::lround(drawn_look_.divider * static_cast<float>(pixels.x)));
    drawn_ = Fineness::full;
    for (const Side side : kSides) {
        const auto index = static_cast<std::size_t>(side);
        const Columns columns = side == Side::left ? Columns{0, middle} : Columns{middle, pixels.x};
        const Fineness drawn =
            renderers_[index].draw(picture_, camera_, drawn_look_.sides[index], fineness, columns);
        if (drawn == Fineness::quick) drawn_ = drawn;
    }
    timer_.end();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void Canvas::show(const CanvasPlace& place, SplitLook look, Redraw redraw) {
    timer_.ready(draw_ms_);
    glm::ivec2 pixels = glm::max(glm::ivec2(glm::dvec2(place.size) * place.pixels_per_point + 0.5), 1);
    camera_ = fitted_ ? fitted(pixels, page_size_) : resized(camera_, pixels);
    for (CanvasLook& side : look.sides) side.page_size = page_size_;
    if (redraw == Redraw::always || drawn_camera_ != camera_ || drawn_look_ != look) {
        drawn_camera_ = camera_;
        drawn_look_ = look;
        draw(pixels, Fineness::quick);
        changed_ = Clock::now();
    } else if (rest() == 0.0) {
        draw(pixels, Fineness::full);
    }
    auto texture = texture_id(picture_.texture());
    glm::vec2 far = place.corner + place.size;
    ImGui::GetBackgroundDrawList()->AddImage(texture, {place.corner.x, place.corner.y}, {far.x, far.y},
                                             {0, 1}, {1, 0});
}

}  // namespace dapple
