#include "app/viewer/background/small_pictures.h"

#include <algorithm>
#include <exception>
#include <glm/vec4.hpp>
#include <utility>

#include "app/viewer/background/dot_blocks.h"
#include "app/viewer/background/workbench.h"
#include "core/drawing/write_drawing.h"
#include "core/image/colour.h"

namespace dapple {

namespace {

Grid<glm::u8vec4> halved(const Grid<glm::u8vec4>& picture) {
    Grid<glm::u8vec4> half(std::max(picture.width / 2, 1), std::max(picture.height / 2, 1));
    for (int y = 0; y < half.height; ++y) {
        const glm::u8vec4* const upper = picture.row(std::min(2 * y, picture.height - 1));
        const glm::u8vec4* const lower = picture.row(std::min(2 * y + 1, picture.height - 1));
        for (int x = 0; x < half.width; ++x) {
            const int left = std::min(2 * x, picture.width - 1),
                      right = std::min(2 * x + 1, picture.width - 1);
            const glm::uvec4 sum = glm::uvec4(upper[left]) + glm::uvec4(upper[right]) +
                                   glm::uvec4(lower[left]) + glm::uvec4(lower[right]);
            half.at(x, y) = glm::u8vec4((sum + 2u) / 4u);
        }
    }
    return half;
}

void show_to(Workbench& bench, const SmallPicture& picture) {
    Picture shown{.light = Grid<float>(picture.width, picture.height),
                  .colours = ColourGrid(picture.width, picture.height)};
    for (std::size_t i = 0; i < picture.values.size(); ++i) {
        const glm::vec3 colour = linear_of(glm::vec3(picture.values[i]) / 255.0f);
        shown.light.values[i] = luminance(colour);
        shown.colours.values[i] = packed(colour);
    }
    bench.set_picture(std::move(shown));
}

}  // namespace

std::vector<Grid<glm::u8vec4>> mipmaps_of(Grid<glm::u8vec4> picture) {
    std::vector<Grid<glm::u8vec4>> levels;
    if (picture.empty()) return levels;
    levels.push_back(std::move(picture));
    while (levels.back().width > 1 || levels.back().height > 1) levels.push_back(halved(levels.back()));
    return levels;
}

Grid<glm::u8vec4> small_copy(const std::vector<Grid<glm::u8vec4>>& mipmaps, int longest_side) {
    const auto fits = [&](const Grid<glm::u8vec4>& copy) {
        return std::max(copy.width, copy.height) <= longest_side;
    };
    const auto first = std::ranges::find_if(mipmaps, fits);
    return first == mipmaps.end() ? Grid<glm::u8vec4>{} : *first;
}

SmallPicture small_drawing(const SmallPicture& picture, DrawingSettings settings, int longer_side,
                           const std::stop_token& stop) {
    settings.relax = std::min(settings.relax.value_or(1), 1);
    Workbench bench;
    show_to(bench, picture);
    const DrawingFile file{.format = DrawingFormat::png, .settings = settings};
    const auto placed = bench.pipeline().drawing(bench.plan(dots_request(settings)), stop);
    if (!placed) return {};
    DrawingToSave drawing = drawing_on(drawn_page(placed->layout()), *placed, file, stop);
    if (settings.style == DrawingStyle::line)
        drawing.dots = stream_of(
            std::make_shared<const DotPieces>(sorted_by_pen(drawing.dots, DotOrder::space)), placed->scale);
    drawing.file.saving.dpi = dpi_for(drawing.page, longer_side);
    return with_alpha(page_pixels(drawing));
}

void SmallPictures::take_made() {
    try {
        while (auto made = making_.result())
            made_.insert_or_assign(std::move(made->key), std::move(made->picture));
    } catch (const std::exception&) {
        made_.insert_or_assign(under_way_, SmallPicture{});  // not again in each frame
    }
}

const SmallPicture* SmallPictures::of(const std::string& key, const Make& make) {
    take_made();
    if (const auto found = made_.find(key); found != made_.end()) return &found->second;
    if (making_.busy()) return nullptr;
    under_way_ = key;
    making_.begin([key, make](const Background<Made>::Task& task) -> std::optional<Made> {
        SmallPicture picture;
        try {
            picture = make(task.stop());
        } catch (const std::exception&) {
            // Whoever opens the entry is told what is wrong with it.
        }
        if (task.stop().stop_requested()) return std::nullopt;
        return Made{key, std::move(picture)};
    });
    return nullptr;
}

void SmallPictures::forget() {
    making_.stop();
    take_made();
    made_.clear();
}

}  // namespace dapple
