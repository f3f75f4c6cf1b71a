#include "app/viewer/canvas/processor_dots.h"

#include <tbb/parallel_for.h>

#include <array>
#include <glm/common.hpp>
#include <string_view>

#include "core/image/colour.h"

namespace dapple {

DotsBy usual_dots_by() {
    const GLubyte* const text = glGetString(GL_RENDERER);
    const std::string_view name = text ? reinterpret_cast<const char*>(text) : "";
    for (const char* program : {"llvmpipe", "softpipe", "swrast", "SWR", "Software"})
        if (name.find(program) != name.npos) return DotsBy::processor;
    return DotsBy::graphics_card;
}

// Adds a block to what is drawn.
static void add_block(RasterInk& raster, const InkToDraw& ink, const DotBlock& block) {
    if (!ink.strokes) {
        raster.dots.push_back({.piece = &ink.dots->pieces[block.piece],
                               .first = block.first,
                               .count = block.count,
                               .low = block.low.y,
                               .high = block.high.y});
        return;
    }
    const auto of = [&](const auto& column) {
        return column.empty() ? std::span(column) : std::span(column).subspan(block.first, block.count);
    };
    raster.lines.push_back({.lines = of(ink.strokes->lines),
                            .widths = of(ink.strokes->widths),
                            .pens = of(ink.strokes->pens),
                            .width = ink.strokes->width,
                            .every = ink.every});
}

static RasterLines lines_of(const ShownStrokes& inking) {
    return {.lines = inking.lines, .widths = inking.widths, .pens = inking.pens};
}

void ProcessorDots::begin(const RasterView& view, const RasterGrain& grain, const InkToDraw& ink) {
    raster_.begin(view, grain);
    if (ink.inking) raster_.add(lines_of(*ink.inking), ink.look);
}

std::size_t ProcessorDots::add(const InkToDraw& ink, std::span<const std::size_t> numbers, std::size_t most) {
    RasterInk raster;
    std::size_t count = 0, blocks = 0;
    for (; blocks < numbers.size() && count < most; ++blocks) {
        add_block(raster, ink, ink.blocks[numbers[blocks]]);
        count += ink.blocks[numbers[blocks]].count;
    }
    raster_.add(raster.dots, ink.look);
    for (const RasterLines& lines : raster.lines) raster_.add(lines, ink.look);
    return blocks;
}

void ProcessorDots::finish(bool by_pen) {
    if (by_pen)
        raster_.finish(pens_);
    else
        raster_.finish(cover_);
}

double ProcessorDots::draw(const RasterView& view, const RasterGrain& grain, const InkToDraw& ink,
                           std::span<const std::size_t> numbers, bool by_pen) {
    RasterInk raster;
    if (ink.inking) raster.lines.push_back(lines_of(*ink.inking));
    for (const std::size_t number : numbers) add_block(raster, ink, ink.blocks[number]);
    return by_pen ? raster_.draw(view, grain, raster, ink.look, pens_)
                  : raster_.draw(view, grain, raster, ink.look, cover_);
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
    if (by_pen)
        put(pens_, GL_RGBA);
    else
        put(cover_, GL_RED);
}

void ProcessorDots::put_colours(const GlFramebuffer& picture, const Rectangle<int>& box, glm::ivec2 corner,
                                glm::vec3 paper, glm::vec3 ink) {
    std::array<glm::u8vec4, 256> colour_of;  // a coverage; blue first, as windows have it
    for (std::size_t covered = 0; covered < colour_of.size(); ++covered) {
        const float share = static_cast<float>(covered) / 255;
        const glm::u8vec3 bytes = srgb_bytes(glm::mix(linear_of(paper), linear_of(ink), share));
        colour_of[covered] = {bytes.b, bytes.g, bytes.r, 255};
    }
    const glm::ivec2 size = box.size();
    colours_.resize(static_cast<std::size_t>(size.x) * size.y);
    tbb::parallel_for(0, size.y, [&](int y) {
        const std::uint8_t* const from = cover_[0].row(box.low.y - corner.y + y) + (box.low.x - corner.x);
        glm::u8vec4* const to = colours_.data() + static_cast<std::size_t>(y) * size.x;
        for (int x = 0; x < size.x; ++x) to[x] = colour_of[from[x]];
    });
    glActiveTexture(GL_TEXTURE0);
    picture.bind_texture();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexSubImage2D(GL_TEXTURE_2D, 0, box.low.x, box.low.y, size.x, size.y, GL_BGRA, GL_UNSIGNED_BYTE,
                    colours_.data());
}

}  // namespace dapple
