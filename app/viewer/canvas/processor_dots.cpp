#include "app/viewer/canvas/processor_dots.h"

#include <algorithm>
#include <string_view>

namespace dapple {

DotsBy usual_dots_by() {
    const GLubyte* const text = glGetString(GL_RENDERER);
    const std::string_view name = text ? reinterpret_cast<const char*>(text) : "";
    for (const char* program : {"llvmpipe", "softpipe", "swrast", "SWR", "Software"})
        if (name.find(program) != name.npos) return DotsBy::processor;
    return DotsBy::graphics_card;
}

RasterGrain raster_grain(const RasterView& view, Fineness fineness) {
    const bool full =
        fineness == Fineness::full && DotRaster::memory(view, RasterGrain::full) <= kMostRasterMemory;
    return full ? RasterGrain::full : RasterGrain::quick;
}

// As Renderer::draw_dots() has it.
std::size_t ProcessorDots::add(const InkToDraw& ink, std::span<const std::size_t> numbers, std::size_t most) {
    std::vector<RasterDots> some;
    std::size_t count = 0, blocks = 0;
    for (; blocks < numbers.size() && count < most; ++blocks) {
        const DotBlock& block = ink.blocks[numbers[blocks]];
        count += block.count;
        if (ink.strokes) {
            const auto of = [&](const auto& column) {
                return column.empty() ? std::span(column)
                                      : std::span(column).subspan(block.first, block.count);
            };
            raster_.add({.lines = of(ink.strokes->lines),
                         .widths = of(ink.strokes->widths),
                         .pens = of(ink.strokes->pens),
                         .width = ink.strokes->width,
                         .every = ink.every},
                        ink.look);
            continue;
        }
        some.push_back({.piece = &ink.dots->pieces[block.piece],
                        .first = block.first,
                        .count = block.count,
                        .limit = ink.limit,
                        .every = ink.every,
                        .low = block.low.y,
                        .high = block.high.y});
    }
    if (!ink.strokes) raster_.add(some, ink.look);
    return blocks;
}

void ProcessorDots::upload(const GlFramebuffer& dots, bool by_pen) {
    const auto put = [&](const auto& pictures, GLenum format) {
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        for (std::size_t i = 0; i < pictures.size(); ++i) {
            dots.bind_texture(i);
            glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, pictures[i].width, pictures[i].height, format,
                            GL_UNSIGNED_BYTE, pictures[i].values.data());
        }
        glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    };
    glActiveTexture(GL_TEXTURE0);
    if (by_pen) {
        raster_.finish(pens_);
        put(pens_, GL_RGBA);
    } else {
        raster_.finish(cover_);
        put(cover_, GL_RED);
    }
}

}  // namespace dapple
