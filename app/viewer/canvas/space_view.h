#pragma once
// A card over the canvas with dots in space, which turn.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/viewer/background/background.h"
#include "app/viewer/background/space_dots.h"
#include "app/viewer/canvas/camera_mouse.h"
#include "app/viewer/canvas/gl_objects.h"

namespace dapple {

class SpaceView {
 public:
    explicit SpaceView(std::function<void()> wake) : placing_(std::move(wake)) {}

    /// Draws it into the canvas's lower right corner, if there is room, with the dots that came last, and has
    /// those placed that are asked for. Time and a mouse that drags turn them. `last_seconds`: what the
    /// window's frame before took.
    void draw(SpaceSettings& settings, bool boundaries, const CanvasPlace& place, double last_seconds);
    /// Nobody looks any more: gives up what is under way.
    void hide();

    /// Seconds after which it is to be drawn again; none: nothing turns.
    std::optional<double> seconds_to_next_frame() const { return next_frame_; }

    /// What is seen; null: nothing, or nothing yet.
    const SpaceDots* dots() const { return seen_ && !dots_.places.empty() ? &dots_ : nullptr; }
    /// How they were seen last.
    TurnedView view() const { return drawn_.value_or(TurnedView{}); }

 private:
    void update(const SpaceChoice& choice);
    void turn(SpaceSettings& settings, double pixels) const;
    void draw_picture(const TurnedView& view, bool boundaries);
    std::string words() const;

    Background<SpaceDots> placing_;
    std::optional<SpaceChoice> asked_;
    SpaceDots dots_;
    std::string trouble_;
    bool seen_ = false;
    std::optional<double> next_frame_;

    std::optional<bool> boundaries_;  // that the balls have; none: other dots have come
    std::vector<Ball> balls_;
    std::optional<TurnedView> drawn_;
    GlTexture picture_;
};

}  // namespace dapple
