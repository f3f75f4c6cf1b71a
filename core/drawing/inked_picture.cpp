#include "core/drawing/inked_picture.h"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <utility>

#include "core/image/auto_tone.h"
#include "core/image/colour.h"
#include "core/image/tone.h"

namespace dapple {
namespace {

// Of a grid over the picture, at a place in page units: the pixel's that it lies in.
float value_at_place(const Grid<float>& grid, glm::dvec2 place) {
    const double longer = std::max(grid.width, grid.height);
    const int x = static_cast<int>(std::clamp(place.x * longer, 0.0, grid.width - 1.0)),
              y = static_cast<int>(std::clamp(place.y * longer, 0.0, grid.height - 1.0));
    return grid.at(x, y);
}

}  // namespace

Grid<float> light_for_lines(const Grid<float>& light, float exposure) {
    return exposed(means_of_blocks(light, blocks_for(std::max(light.width, light.height), kLongestForLines)),
                   exposure);
}

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
    Inking result;
    for (const InkLine& line : inking.lines) {
        InkLine part{.points = {}, .widths = {}, .strength = line.strength};
        const auto end_part = [&] {
            if (part.points.size() > 1) result.lines.push_back(part);
            part.points.clear();
            part.widths.clear();
        };
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            if (value_at_place(kept, line.points[i]) < 0.5f) {
                end_part();
                continue;
            }
            part.points.push_back(line.points[i]);
            part.widths.push_back(line.widths[i]);
        }
        end_part();
    }
    result.areas = std::move(inking.areas);
    return result;
}

Density with_room(const Density& density, const Grid<float>& room) {
    Grid<float> values = density.values();
    const double block = static_cast<double>(density.longer_side()) / std::max(room.width, room.height);
    for (int y = 0; y < values.height; ++y) {
        for (int x = 0; x < values.width; ++x) {
            const double u = std::clamp((x + 0.5) / block - 0.5, 0.0, room.width - 1.0),
                         v = std::clamp((y + 0.5) / block - 0.5, 0.0, room.height - 1.0);
            const int left = std::min(static_cast<int>(u), std::max(room.width - 2, 0)),
                      top = std::min(static_cast<int>(v), std::max(room.height - 2, 0));
            const int right = std::min(left + 1, room.width - 1), bottom = std::min(top + 1, room.height - 1);
            const auto across = static_cast<float>(u - left), down = static_cast<float>(v - top);
            const float times = std::lerp(std::lerp(room.at(left, top), room.at(right, top), across),
                                          std::lerp(room.at(left, bottom), room.at(right, bottom), across), down);
            values.at(x, y) *= times;
        }
    }
    return Density(std::move(values), density.sides(), density.tile_corner(), density.reading());
}

}  // namespace dapple
