#include "app/viewer/canvas/light_scene.h"

#include <imgui.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/theme.h"
#include "app/viewer/widgets/widgets.h"
#include "core/lights/lit_objects.h"

namespace dapple {
namespace {

constexpr float kLargestObject = 1024;  // pixels: larger ones are enlarged
constexpr int kOutlinesWidth = 2048;    // pixels at least, and as many of each texel

Grid<glm::u8vec4> tone_mapped_picture(const Grid<glm::vec3>& preview, double exposure) {
    Grid<glm::u8vec4> pixels(preview.width, preview.height);
    tbb::parallel_for(0, preview.height, [&](int y) {
        for (int x = 0; x < preview.width; ++x)
            pixels.at(x, y) = glm::u8vec4(tone_mapped(preview.at(x, y), exposure), 255);
    });
    return pixels;
}

// White between texels that are nearest to different samples.
Grid<glm::u8vec4> outlines(const Grid<std::uint32_t>& nearest) {
    const int times = std::max((kOutlinesWidth + nearest.width - 1) / nearest.width, 1);
    Grid<glm::u8vec4> pixels(times * nearest.width, times * nearest.height, glm::u8vec4(255, 255, 255, 0));
    tbb::parallel_for(0, pixels.height, [&](int y) {
        const int below = std::min(y + 1, pixels.height - 1) / times;
        for (int x = 0; x < pixels.width; ++x) {
            const std::uint32_t here = nearest.at(x / times, y / times);
            const int right = (x + 1) % pixels.width / times;
            if (nearest.at(right, y / times) != here || nearest.at(x / times, below) != here)
                pixels.at(x, y).a = 255;
        }
    });
    return pixels;
}

// 0..1, however often round.
double wrapped(double u) {
    return u - std::floor(u);
}

// Many markers are small, so that they cover a tenth of the map at most: at 96 dpi.
float marker_radius(std::size_t samples, glm::vec2 map_size) {
    const float area = map_size.x * map_size.y / static_cast<float>(std::max<std::size_t>(samples, 1));
    return std::clamp(0.11f * std::sqrt(area), 0.35f, 1.6f);
}

}  // namespace

void LightScene::draw_textures(const LightsShown& shown, int object_pixels) {
    const LightsSettings& settings = shown.settings;
    const Drawn wanted{shown.map_number,      shown.samplings, settings.stops,
                       settings.turn_degrees, object_pixels,   settings.marks == SampleMarks::areas};
    if (drawn_ == wanted) return;
    const double exposure = shown.lit.natural_exposure * std::exp2(settings.stops);
    if (!drawn_ || drawn_->map_number != wanted.map_number || drawn_->stops != wanted.stops)
        map_texture_.write(tone_mapped_picture(shown.lit.preview, exposure));
    const ObjectLook look{object_pixels, settings.turn_degrees, exposure};
    for (std::size_t i = 0; i < std::size(kLitObjects); ++i) {
        objects_[0][i].write(object_picture(*shown.samples.found, kLitObjects[i], look));
        objects_[1][i].write(object_picture(shown.lit.exact, kLitObjects[i], look));
    }
    if (wanted.areas && (!drawn_ || !drawn_->areas || drawn_->samplings != wanted.samplings))
        areas_texture_.write(outlines(shown.samples.nearest));
    drawn_ = wanted;
}

LightLayout light_layout(glm::vec2 corner, glm::vec2 size) {
    const float unit = ImGui::GetFontSize() / 15, air = 16 * unit;
    const float width = std::max(std::min(size.x - 2 * air, (size.y - 3 * air) * 1.35f), 1.0f);
    LightLayout layout;
    layout.map = {{corner.x + (size.x - width) / 2, corner.y + air}, {width, width / 2}};
    const float top = std::floor(layout.map.corner.y + layout.map.size.y + air);
    // Whole, so that their pixels are the screen's: two groups of objects, less than the air between them
    // apart.
    constexpr auto kInGroup = static_cast<float>(std::size(kLitObjects));
    const float apart = std::floor(air / 2), group = (size.x - 4 * air) / 2;
    layout.object_side = std::floor(std::max(
        std::min(corner.y + size.y - top - 2 * air, (group - (kInGroup - 1) * apart) / kInGroup), 1.0f));
    const float group_width = kInGroup * (layout.object_side + apart) - apart;
    const float middle = std::floor(corner.x + size.x / 2);
    for (std::size_t i = 0; i < std::size(kLitObjects); ++i) {
        const float along = static_cast<float>(i) * (layout.object_side + apart);
        layout.objects[0][i] = {std::floor(middle - air - group_width) + along, top};
        layout.objects[1][i] = {std::floor(middle + air) + along, top};
    }
    return layout;
}

// Its rotation lays the map's seam somewhere in the view: a piece on either side.
void LightScene::show_on_map(const GlTexture& texture, const CanvasPlace& place, const Camera& camera,
                             const LightsSettings& settings) {
    ImDrawList* const list = ImGui::GetBackgroundDrawList();
    const glm::dvec2 seen_from = in_page_units(point_at(camera, {0, 0}));
    const glm::dvec2 seen_to = in_page_units(point_at(camera, camera.canvas));
    const double turn = wrapped(settings.turn_degrees / 360);
    const auto piece = [&](double from, double to, double u_at_0) {
        const double left = std::max(from, seen_from.x), right = std::min(to, seen_to.x);
        if (left >= right) return;
        const glm::vec2 a = place.corner + glm::vec2(to_canvas(camera, page_point({left, seen_from.y})));
        const glm::vec2 b = place.corner + glm::vec2(to_canvas(camera, page_point({right, seen_to.y})));
        list->AddImage(texture_id(texture.get()), {a.x, a.y}, {b.x, b.y},
                       {static_cast<float>(left + u_at_0), static_cast<float>(2 * seen_from.y)},
                       {static_cast<float>(right + u_at_0), static_cast<float>(2 * seen_to.y)});
    };
    piece(0, 1 - turn, turn);
    piece(1 - turn, 1, turn - 1);
}

void LightScene::show_points(const CanvasPlace& place, const Camera& camera, const LightsShown& shown) {
    ImDrawList* const list = ImGui::GetBackgroundDrawList();
    const auto width = static_cast<float>(camera.pixels_per_unit);
    const float radius =
        marker_radius(shown.samples.places.size(), {width, width / 2}) * ImGui::GetFontSize() / 15;
    place.clip(list);
    const auto discs = [&](float r, ImU32 colour) {
        for (const glm::dvec2 p : shown.samples.places) {
            const glm::dvec2 on_map(wrapped(p.x - shown.settings.turn_degrees / 360), p.y / 2);
            const glm::vec2 at = to_canvas(camera, page_point(on_map));
            const bool seen = at.x > -r && at.y > -r && at.x < place.size.x + r && at.y < place.size.y + r;
            if (seen) list->AddCircleFilled({place.corner.x + at.x, place.corner.y + at.y}, r, colour, 8);
        }
    };
    discs(radius * 1.6f, IM_COL32(20, 20, 20, 255));
    discs(radius, IM_COL32(255, 255, 255, 255));
    list->PopClipRect();
}

void LightScene::show(const LightLayout& layout, const Camera& camera, const LightsShown& shown) {
    const float pixels = layout.object_side * ImGui::GetIO().DisplayFramebufferScale.x;
    draw_textures(shown, static_cast<int>(std::lround(std::clamp(pixels, 8.0f, kLargestObject))));
    show_on_map(map_texture_, layout.map, camera, shown.settings);
    if (shown.settings.marks == SampleMarks::points) show_points(layout.map, camera, shown);
    if (shown.settings.marks == SampleMarks::areas)
        show_on_map(areas_texture_, layout.map, camera, shown.settings);

    ImDrawList* const list = ImGui::GetBackgroundDrawList();
    const float side = layout.object_side, air = 16 * ImGui::GetFontSize() / 15;
    const std::array labels{"lit by the samples", "lit by the whole map"};
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const auto& places = layout.objects[i];
        for (std::size_t k = 0; k < places.size(); ++k)
            list->AddImage(texture_id(objects_[i][k].get()), {places[k].x, places[k].y},
                           {places[k].x + side, places[k].y + side});
        const float width = places.back().x + side - places.front().x;
        const float text = ImGui::CalcTextSize(labels[i]).x;
        list->AddText({places.front().x + (width - text) / 2, places.front().y + side + air / 4},
                      colour_of(ThemeColour::quiet), labels[i]);
    }
}

}  // namespace dapple
