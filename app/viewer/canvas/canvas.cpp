#include "app/viewer/canvas/canvas.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace dapple {
namespace {

// Between two turns of a wheel, or two moves of a slider, there is less.
constexpr double kRestSeconds = 0.15;
// The most that drawing dots takes in a frame while something moves, and in one while all rests: see
// FrameBudget.
constexpr double kQuickSeconds = 0.025, kStepSeconds = 0.025;
// What uploading a picture's pixels takes in a frame.
constexpr double kUploadSeconds = 0.01;

bool have_same_desk(const SplitLook& a, const SplitLook& b) {
    return a.divider == b.divider && have_same_desk(a.sides[0], b.sides[0]) &&
           have_same_desk(a.sides[1], b.sides[1]);
}

}  // namespace

void Canvas::set_drawing(Side side, const PlacedDrawing& drawing) {
    Renderer& renderer = renderers_[static_cast<int>(side)];
    renderer.set_dots(drawing.dots, drawing.blocks, drawing.window());
    renderer.set_ink(drawing.ink, kDotsPerScale * drawing.scale);
    renderer.set_pens(drawing.plan.pens);
    renderer.set_dot_colours(drawing.colours);
    renderer.set_strokes(drawing.strokes);
    renderer.set_inking(drawing.inking);
    renderer.set_tiles(drawing.outlines, drawing.window());
    if (side == Side::left) page_size_ = drawing.plan.picture_size();
    drawn_camera_.reset();
}

void Canvas::set_picture(Side side, PictureLevels levels) {
    renderers_[static_cast<int>(side)].set_picture(std::move(levels));
    uploading_ = true;
    drawn_camera_.reset();
}

void Canvas::learn(double last_frame) {
    budget_.learn(last_frame, std::exchange(budgeted_, 0));
}

void Canvas::upload(double seconds) {
    if (!uploading_) return;
    uploading_ = false;
    for (Renderer& renderer : renderers_) uploading_ |= !renderer.upload(seconds / 2);
    if (!uploading_) drawn_camera_.reset();
}

void Canvas::fit() {
    fitted_ = true;
}

void Canvas::look(const Camera& camera) {
    camera_ = resized(camera, camera_.canvas);
    fitted_ = false;
}

void Canvas::zoom_to(double pixels_per_unit) {
    zoom(pixels_per_unit / camera_.pixels_per_unit);
}

void Canvas::zoom(double factor) {
    camera_ = zoomed_at(camera_, camera_.canvas * 0.5, factor);
    fitted_ = false;
}

void Canvas::pan(glm::dvec2 sides) {
    camera_ = dragged(camera_, sides * std::min(camera_.canvas.x, camera_.canvas.y));
    fitted_ = false;
}

Camera Canvas::fitted_to_sheet(glm::dvec2 canvas) const {
    return sheet_ ? fitted(canvas, sheet_->size(), sheet_->low) : fitted(canvas, page_size_);
}

double Canvas::enlargement() const {
    return camera_.pixels_per_unit / fitted_to_sheet(camera_.canvas).pixels_per_unit;
}

void Canvas::handle_mouse(const CanvasPlace& place, bool left_taken) {
    if (mouse_.move(camera_, place, left_taken)) fitted_ = false;
}

std::optional<double> Canvas::seconds_to_next_frame() const {
    if (drawn_ == Fineness::full) return std::nullopt;
    const std::chrono::duration<double> rested = Clock::now() - changed_;
    return std::max(kRestSeconds - rested.count(), 0.0);
}

Columns Canvas::columns_of(Side side, glm::ivec2 pixels) const {
    const int middle = static_cast<int>(std::lround(drawn_look_.divider * static_cast<float>(pixels.x)));
    return side == Side::left ? Columns{0, middle} : Columns{middle, pixels.x};
}

void Canvas::draw_quickly(glm::ivec2 pixels, Desk desk) {
    const auto begin = Clock::now();
    job_side_.reset();
    picture_.resize(pixels, Texels::shown);
    drawn_ = Fineness::full;
    const double all = budget_.seconds(kQuickSeconds), seconds = drawn_look_.divider < 1 ? all / 2 : all;
    for (const Side side : kSides) {
        const auto index = static_cast<std::size_t>(side);
        const Fineness drawn = renderers_[index].draw_quickly(picture_, camera_, drawn_look_.sides[index],
                                                              columns_of(side, pixels), seconds, desk);
        if (drawn == Fineness::quick) drawn_ = drawn;
        budgeted_ += renderers_[index].dots_seconds();
    }
    glFinish();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    draw_ms_ = 1e3 * std::chrono::duration<double>(Clock::now() - begin).count();
}

void Canvas::go_on(glm::ivec2 pixels) {
    const auto begin = Clock::now();
    if (!job_side_) {
        full_.resize(pixels, Texels::shown);
        job_seconds_ = 0;
        job_side_ = 0;
        for (const Side side : kSides) {
            const auto index = static_cast<std::size_t>(side);
            renderers_[index].begin(camera_, drawn_look_.sides[index], columns_of(side, pixels));
        }
    }
    const double seconds = budget_.seconds(kStepSeconds);
    const auto passed = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
    while (job_side_ && passed() < seconds) {
        if (!renderers_[*job_side_].step(full_, seconds - passed())) break;
        if (++*job_side_ == kSides.size()) job_side_.reset();
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    budgeted_ = passed();
    job_seconds_ += budgeted_;
    if (job_side_) return;
    std::swap(picture_, full_);
    drawn_ = Fineness::full;
    draw_ms_ = 1e3 * job_seconds_;
}

Rectangle<int> Canvas::show(const CanvasPlace& place, SplitLook look, Redraw redraw) {
    glm::ivec2 pixels = glm::max(glm::ivec2(glm::dvec2(place.size) * place.pixels_per_point + 0.5), 1);
    // The left side's, whichever is drawn.
    sheet_ = look.sides[0].sheet;
    camera_ = fitted_ ? fitted_to_sheet(pixels) : resized(camera_, pixels);
    for (CanvasLook& side : look.sides) {
        side.page_size = page_size_;
        side.sheet = sheet_;
    }
    if (redraw == Redraw::later) return {{0, 0}, {0, 0}};
    // A person who asks for the photograph sees it at once.
    upload(look.sides[0].dots ? kUploadSeconds : double{INFINITY});
    if (redraw == Redraw::always || drawn_camera_ != camera_ || drawn_look_ != look) {
        const bool keeps_desk = desk_camera_ == camera_ && have_same_desk(drawn_look_, look);
        drawn_camera_ = desk_camera_ = camera_;
        drawn_look_ = look;
        draw_quickly(pixels, keeps_desk ? Desk::kept : Desk::drawn);
        changed_ = Clock::now();
    } else if (job_side_ || seconds_to_next_frame() == 0.0) {
        go_on(pixels);
    }
    const glm::ivec2 corner(glm::dvec2(place.corner) * place.pixels_per_point + 0.5);
    const auto height = static_cast<int>(ImGui::GetIO().DisplaySize.y * place.pixels_per_point.y + 0.5);
    shown_ = {&picture_, {corner.x, height - corner.y - pixels.y}, {corner.x + pixels.x, height - corner.y}};
    ImGui::GetBackgroundDrawList()->AddCallback(copy_to_window, &shown_);
    return {corner, corner + pixels};
}

// Copied, with its first row at the top: to draw it takes OpenGL that is a program ten times as long.
void Canvas::copy_to_window(const ImDrawList*, const ImDrawCmd* command) {
    const Shown& shown = *static_cast<const Shown*>(command->UserCallbackData);
    const glm::ivec2 size = shown.picture->size(), low = shown.low, high = shown.high;
    glDisable(GL_SCISSOR_TEST);
    shown.picture->bind_to_read();
    glBlitFramebuffer(0, 0, size.x, size.y, low.x, high.y, high.x, low.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glEnable(GL_SCISSOR_TEST);
}

}  // namespace dapple
