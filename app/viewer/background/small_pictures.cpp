#include "app/viewer/background/small_pictures.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "app/viewer/background/dot_blocks.h"
#include "app/viewer/background/workbench.h"
#include "core/drawing/write_drawing.h"
#include "core/image/colour.h"

namespace dapple {

namespace {

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
