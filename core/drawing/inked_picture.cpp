#include "core/drawing/inked_picture.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <utility>

#include "core/image/colour.h"
#include "core/image/tone.h"
#include "core/lines/line_field.h"

namespace dapple {
Grid<float> negative(Grid<float> light) {
    for (float& value : light.values)
        value = srgb_to_linear(1 - linear_to_srgb(std::clamp(value, 0.0f, 1.0f)));
    return light;
}

int pen_for_inking(std::span<const Pen> pens) {
    const auto light = [](const Pen& pen) { return luminance(linear_of(pen.colour)); };
    return pens.empty() ? 0 : static_cast<int>(std::ranges::min_element(pens, {}, light) - pens.begin());
}

std::vector<InkLine> lines_shown(const std::vector<InkLine>& lines, double contours) {
    std::vector<InkLine> shown;
    if (contours <= 0) return shown;
    const double least = 1 - contours;
    for (const InkLine& line : lines) {
        if (line.strength < least) continue;
        // They come in as hairs while the strength rises.
        const auto share = static_cast<float>(std::min(0.5 + 2 * (line.strength - least), 1.0));
        InkLine& one = shown.emplace_back(line);
        for (float& width : one.widths) width = std::max(width * share, std::min(width, kHairWidth));
    }
    return shown;
}

Inking within(Inking inking, const Grid<float>& kept) {
    const double longer = std::max(kept.width, kept.height);
    Inking result{.lines = {}, .areas = std::move(inking.areas), .white = {}};
    for (const InkLine& line : inking.lines)
        for (InkLine& piece : pieces_of(line, [&](const InkLine&all, std::size_t i) {
                 return value_at(kept, glm::vec2(all.points[i] * longer) - 0.5f) >= 0.5f;
             }))
            result.lines.push_back(std::move(piece));
    return result;
}

Density with_room(const Density& density, const Grid<float>& room) {
    Grid<float> values = density.values();
    const float share = 1 / static_cast<float>(reduction(values));
    tbb::parallel_for(0, values.height, [&](int y) {
        for (int x = 0; x < values.width; ++x)
            values.at(x, y) *= value_at(room, (glm::vec2(x, y) + 0.5f) * share - 0.5f);
    });
    return Density(std::move(values), density.sides(), density.tile_corner(), density.reading());
}

}  // namespace dapple
