#include "app/viewer/canvas/light_scene.h"

#include <imgui.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/theme.h"
#include "app/viewer/widgets/widgets.h"
#include "core/lights/direction.h"
#include "core/lights/light_picture.h"

namespace dapple {
namespace {

constexpr float kLargestSphere = 1024;  // pixels: larger ones are enlarged

Grid<glm::u8vec4> tone_mapped_picture(const Grid<glm::vec3>& preview, double exposure) {
    Grid<glm::u8vec4> pixels(preview.width, preview.height);
    tbb::parallel_for(0, preview.height, [&](int y) {
        for (int x = 0; x < preview.width; ++x)
            pixels.at(x, y) = glm::u8vec4(tone_mapped(preview.at(x, y), exposure), 255);
    });
    return pixels;
}

ImTextureID id_of(const GlTexture& texture) {
    return texture_id(texture.get());
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

void LightScene::draw_textures(const LightsShown& shown, int sphere_pixels) {
    const LightsSettings& settings = shown.settings;
    const Drawn wanted{shown.map_number, shown.samplings, settings.stops, settings.turn_degrees,
                       sphere_pixels};
    if (drawn_ == wanted) return;
    const double exposure = shown.lit.natural_exposure * std::exp2(settings.stops);
    if (!drawn_ || drawn_->map_number != wanted.map_number || drawn_->stops != wanted.stops)
        map_texture_.write(tone_mapped_picture(shown.lit.preview, exposure));
    const SphereLook look{sphere_pixels, settings.turn_degrees, exposure};
    spheres_[0].write(sphere_picture(*shown.samples.found, look));
    spheres_[1].write(sphere_picture(shown.lit.exact, look));
    drawn_ = wanted;
}

LightLayout light_layout(glm::vec2 corner, glm::vec2 size) {
    const float unit = ImGui::GetFontSize() / 15, air = 16 * unit;
    const float width = std::max(std::min(size.x - 2 * air, (size.y - 3 * air) * 1.35f), 1.0f);
    LightLayout layout;
    layout.map = {{corner.x + (size.x - width) / 2, corner.y + air}, {width, width / 2}};
    const float top = std::floor(layout.map.corner.y + layout.map.size.y + air);
    // Whole, so that their pixels are the screen's.
    layout.sphere_side =
        std::floor(std::max(std::min(corner.y + size.y - top - 2 * air, width / 2 - air), 1.0f));
    const float middle = std::floor(corner.x + size.x / 2);
    layout.spheres = {
        {{std::floor(middle - layout.sphere_side - air), top}, {std::floor(middle + air), top}}};
    return layout;
}

// Its rotation lays the map's seam somewhere in the view: a piece on either side.
void LightScene::show_map(const CanvasPlace& place, const Camera& camera,
                          const LightsSettings& settings) const {
    ImDrawList* const list = ImGui::GetBackgroundDrawList();
    const glm::dvec2 seen_from = in_page_units(point_at(camera, {0, 0}));
    const glm::dvec2 seen_to = in_page_units(point_at(camera, camera.canvas));
    const double turn = wrapped(settings.turn_degrees / 360);
    const auto piece = [&](double from, double to, double u_at_0) {
        const double left = std::max(from, seen_from.x), right = std::min(to, seen_to.x);
        if (left >= right) return;
        const glm::vec2 a = place.corner + glm::vec2(to_canvas(camera, page_point({left, seen_from.y})));
        const glm::vec2 b = place.corner + glm::vec2(to_canvas(camera, page_point({right, seen_to.y})));
        list->AddImage(id_of(map_texture_), {a.x, a.y}, {b.x, b.y},
                       {static_cast<float>(left + u_at_0), static_cast<float>(2 * seen_from.y)},
                       {static_cast<float>(right + u_at_0), static_cast<float>(2 * seen_to.y)});
    };
    piece(0, 1 - turn, turn);
    piece(1 - turn, 1, turn - 1);
}

void LightScene::show_samples(const CanvasPlace& place, const Camera& camera, const LightsShown& shown) {
    ImDrawList* const list = ImGui::GetBackgroundDrawList();
    const auto width = static_cast<float>(camera.pixels_per_unit);
    const float radius =
        marker_radius(shown.samples.places.size(), {width, width / 2}) * ImGui::GetFontSize() / 15;
    list->PushClipRect({place.corner.x, place.corner.y},
                       {place.corner.x + place.size.x, place.corner.y + place.size.y}, true);
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
    const float pixels = layout.sphere_side * ImGui::GetIO().DisplayFramebufferScale.x;
    draw_textures(shown, static_cast<int>(std::lround(std::clamp(pixels, 8.0f, kLargestSphere))));
    show_map(layout.map, camera, shown.settings);
    if (shown.settings.samples_shown) show_samples(layout.map, camera, shown);

    ImDrawList* const list = ImGui::GetBackgroundDrawList();
    const float side = layout.sphere_side, air = 16 * ImGui::GetFontSize() / 15;
    const std::array labels{"lit by the samples", "lit by the whole map"};
    for (std::size_t i = 0; i < 2; ++i) {
        const auto [left, top] = std::pair(layout.spheres[i].x, layout.spheres[i].y);
        list->AddImage(id_of(spheres_[i]), {left, top}, {left + side, top + side});
        const float text = ImGui::CalcTextSize(labels[i]).x;
        list->AddText({left + (side - text) / 2, top + side + air / 4}, colour_of(ThemeColour::quiet),
                      labels[i]);
    }
}

}  // namespace dapple
