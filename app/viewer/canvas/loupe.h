#pragma once
// A lens that follows the pointer over the canvas: the tiles around it laid on one another, so that what
// repeats becomes plain.

#include <cstdint>
#include <optional>

#include "app/viewer/canvas/camera_mouse.h"
#include "app/viewer/canvas/canvas.h"
#include "app/viewer/canvas/gl_objects.h"
#include "app/viewer/view/dot_origin.h"
#include "app/viewer/view/loupe_square.h"

namespace dapple {

// A card beside the pointer that says where the dot under it comes from; its tile lights up.

/// Over the canvas; nothing where no dot is near, or where ImGui's windows have the mouse.
void draw_dot_card(const PlacedDrawing& shown, const PlacedWith& with, const Camera& camera,
                   const CanvasPlace& place);

/// What the lens looks at: the dots of one side of the canvas and how they are drawn.
struct LoupeView {
    const PlacedDrawing& shown;
    std::uint64_t version = 0;  // changes with the dots
    std::size_t tile_size = 16;
    int step = 0;  // levels, see loupe_square()
    glm::vec3 ink{0}, paper{1};
    double mm_per_page_unit = 200;
};

class Loupe {
 public:
    /// Draws the lens over the canvas, beside the square that it looks at. Nothing if the pointer is not on
    /// the page, or where there is nothing to fold.
    void draw(const LoupeView& view, const Camera& camera, const CanvasPlace& place);

    /// What the lens drawn last shows; none if there was none.
    const std::optional<LoupeInfo>& info() const { return info_; }
    void hide() { info_.reset(); }

 private:
    struct Key {
        LoupeSquare square;
        const PlacedDrawing* shown = nullptr;
        std::uint64_t version = 0;
        glm::vec3 ink{0}, paper{1};
        bool operator==(const Key&) const = default;
    };
    void fold(const LoupeView& view, const LoupeSquare& square);

    GlTexture picture_;
    std::optional<Key> folded_;
    double repetition_ = 0;
    std::optional<LoupeInfo> info_;
};

}  // namespace dapple
