#pragma once
// The canvas's dots and lines where the processor draws them (dot_raster.h): blocks of them become ink on the
// pixels that are seen, and that goes to OpenGL.
//
//     begin() ──► add() blocks, as long as there is time ──► finish() ──► upload() ──► put_colours()
//     draw() all blocks ───────────────────────────────────────────┘
//
// With one ink the raster's pixels are the canvas's, each as many samples as its grain says. Of several pens
// which dots lie on others has to be known where they do: the raster's pixels are then the samples that
// OpenGL would draw, and the page's shader mixes them.

#include <glm/gtc/type_precision.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "app/viewer/background/dot_blocks.h"
#include "app/viewer/canvas/gl_objects.h"
#include "app/viewer/view/dot_raster.h"
#include "core/image/rectangle.h"
#include "core/placing/dots.h"

namespace dapple {

/// Who draws the dots.
enum class DotsBy {
    graphics_card,
    processor,
};

/// Of the OpenGL that is current: the processor, where that is a program too.
DotsBy usual_dots_by();

/// What is drawn: dots or, in their place, lines.
struct InkToDraw {
    const DotPieces* dots = nullptr;
    const ShownStrokes* strokes = nullptr;
    const ShownStrokes* inking = nullptr;  // beside either
    std::span<const DotBlock> blocks;      // of either
    RasterLook look;
    std::size_t every = 1;  // one in so many lines is drawn
};

class ProcessorDots {
 public:
    /// A picture with nothing but the inking.
    void begin(const RasterView& view, const RasterGrain& grain, const InkToDraw& ink);
    /// Draws the first ones of the blocks with those numbers that have `most` dots or a few more together.
    /// Returns how many.
    std::size_t add(const InkToDraw& ink, std::span<const std::size_t> numbers, std::size_t most);
    void finish(bool by_pen);
    /// The same at once, in half the time, of the blocks with those numbers. Returns which share of the time
    /// they took; the rest went into pixels.
    double draw(const RasterView& view, const RasterGrain& grain, const InkToDraw& ink,
                std::span<const std::size_t> numbers, bool by_pen);
    /// Puts what pens cover into the pictures of `dots`: one's into its texels, as Texels::cover, or that of
    /// four each into their components.
    void upload(const GlFramebuffer& dots, bool by_pen);
    /// Of one ink, after upload(): puts what is seen of bare paper with it into a box of the picture, all of
    /// which is covered by the raster, whose corner lies at `corner` of the picture. Copied, which takes
    /// OpenGL that is a program a tenth of the time that drawing does. Both colours are sRGB-encoded.
    void put_colours(const GlFramebuffer& picture, const Rectangle<int>& box, glm::ivec2 corner,
                     glm::vec3 paper, glm::vec3 ink);

 private:
    DotRaster raster_;
    std::vector<Grid<std::uint8_t>> cover_;  // handed to OpenGL
    std::vector<Grid<glm::u8vec4>> pens_;
    std::vector<glm::u8vec4> colours_;
};

}  // namespace dapple
