#include "app/viewer/canvas/loupe.h"

#include <fmt/format.h>

#include <imgui.h>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <string>
#include <vector>

#include "app/viewer/view/view_analysis.h"
#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/theme.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {

namespace {

constexpr float kCardReach = 20;   // from the pointer, at 96 dpi
constexpr ImU32 kLitAlpha = 0x38;  // of 255: the dots in the tile are seen through it

/// Below and right of the pointer, or on the other side where there is no room.
ImVec2 corner_beside(ImVec2 pointer, ImVec2 card, const CanvasPlace& place, float air) {
    const glm::vec2 end = place.corner + place.size;
    const bool left = pointer.x + air + card.x > end.x, above = pointer.y + air + card.y > end.y;
    return {std::floor(std::max(left ? pointer.x - air - card.x : pointer.x + air, place.corner.x)),
            std::floor(std::max(above ? pointer.y - air - card.y : pointer.y + air, place.corner.y))};
}

void draw_card_words(ImDrawList* list, const std::vector<std::string>& lines, const CanvasPlace& place,
                     float unit) {
    const float air = 10 * unit, line = ImGui::GetTextLineHeight() + 2 * unit;
    float width = 0;
    for (const std::string& each : lines) width = std::max(width, ImGui::CalcTextSize(each.c_str()).x);
    // The title is bolder than it was measured.
    const ImVec2 card{width + 2.4f * air, line * static_cast<float>(lines.size()) + 1.6f * air};
    const ImVec2 at = corner_beside(ImGui::GetIO().MousePos, card, place, 18 * unit);
    const ImVec2 end{at.x + card.x, at.y + card.y};
    draw_shadow(list, at, end);
    list->AddRectFilled(at, end, colour_of(ThemeColour::panel), 5 * unit);
    float y = at.y + 0.8f * air;
    for (std::size_t i = 0; i < lines.size(); ++i, y += line) {
        if (i == 0) push_title_font();
        list->AddText({at.x + 1.2f * air, y}, colour_of(i == 0 ? ThemeColour::text : ThemeColour::quiet),
                      lines[i].c_str());
        if (i == 0) pop_title_font();
    }
}

}  // namespace

void draw_dot_card(const PlacedDrawing& shown, const PlacedWith& with, const Camera& camera,
                   const CanvasPlace& place) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantCaptureMouse || !place.holds(io.MousePos)) return;
    const float unit = ImGui::GetFontSize() / 15;
    const double pixels_per_point = place.pixels_per_point.x;
    const double reach =
        std::max(kCardReach * unit * pixels_per_point / camera.pixels_per_unit, shown.dot_radius());
    const auto dot = dot_under(shown, with, place.page_at(io.MousePos, camera), reach);
    if (!dot) return;
    const auto on_screen = [&](glm::dvec2 in_window) {
        const PagePoint corner(shown.window().x, shown.window().y);
        const glm::dvec2 pixel = to_canvas(camera, corner + PagePoint(in_window * 0x1p62));
        // Far outside, floats and their rounding are of no use.
        return place.point_of(glm::clamp(pixel, glm::dvec2(-9), camera.canvas + 9.0));
    };
    ImDrawList* const list = ImGui::GetForegroundDrawList();
    place.clip(list);
    const ImU32 light = colour_of(ThemeColour::accent);
    if (const auto& tile = dot->tile) {
        const ImVec2 low = on_screen({tile->x, tile->y});
        const ImVec2 high = on_screen(glm::dvec2(tile->x, tile->y) + tile->side);
        list->AddRectFilled(low, high, with_opacity(light, kLitAlpha));
        list->AddRect(low, high, light, 0, 0, 1.5f * unit);
        note_place("Lit tile", {{low.x, low.y}, {high.x, high.y}});
    }
    // Zoomed in far the ring is beyond all edges, and further in Dear ImGui cannot count its sides.
    const double radius = shown.dot_radius() * camera.pixels_per_unit / pixels_per_point;
    if (radius < double{place.size.x} + double{place.size.y})
        list->AddCircle(on_screen(dot->position), static_cast<float>(radius) + 3 * unit, light, 0, 2 * unit);
    draw_card_words(list, origin_in_words(*dot, with, shown.scale), place, unit);
    list->PopClipRect();
}

namespace {

constexpr int kPictureSide = 480;  // pixels of the folded picture, shown half as large
constexpr double kFoldedDotRadius =
    0.28;                               // in mean spacings: small enough to see each dot of a repeating tile
constexpr double kLargestRadius = 0.2;  // in periods
constexpr float kLensSide = 240;        // at 96 dpi

Grid<glm::u8vec4> inked(const Grid<float>& mean, glm::vec3 paper, glm::vec3 ink) {
    Grid<glm::u8vec4> picture(mean.width, mean.height);
    std::ranges::transform(mean.values, picture.values.begin(), [&](float share) {
        return glm::u8vec4(glm::u8vec3(glm::round(glm::mix(paper, ink, share) * 255.0f)), 255);
    });
    return picture;
}

struct Box {
    ImVec2 min, max;
};

/// The square on the canvas, in ImGui's points.
Box on_screen(const LoupeSquare& square, const Camera& camera, const CanvasPlace& place) {
    const auto point = [&](PagePoint p) { return place.point_of(to_canvas(camera, p)); };
    const std::int64_t side = (std::int64_t(1) << (62 - square.level)) * square.across;
    return {point(square.corner), point(square.corner + side)};
}

void draw_square(const Box& box, int across, float unit) {
    ImDrawList* list = ImGui::GetForegroundDrawList();
    const ImU32 line = colour_of(ThemeColour::warning);
    const float step = (box.max.x - box.min.x) / static_cast<float>(across);
    const ImU32 faint = with_opacity(line, 110);
    for (int i = 1; i < across; ++i) {
        const float at = step * static_cast<float>(i);
        list->AddLine({box.min.x + at, box.min.y}, {box.min.x + at, box.max.y}, faint, unit);
        list->AddLine({box.min.x, box.min.y + at}, {box.max.x, box.min.y + at}, faint, unit);
    }
    list->AddRect(box.min, box.max, line, 0, 0, 2 * unit);
}

/// Beside the square, on the side where there is room, within the canvas.
ImVec2 card_corner(const Box& square, ImVec2 card, const CanvasPlace& place, float air) {
    const glm::vec2 end = place.corner + place.size;
    float x = square.max.x + air;
    if (x + card.x > end.x - air) x = square.min.x - air - card.x;
    x = std::clamp(x, place.corner.x + air, std::max(place.corner.x + air, end.x - air - card.x));
    const float y = std::clamp((square.min.y + square.max.y - card.y) / 2, place.corner.y + air,
                               std::max(place.corner.y + air, end.y - air - card.y));
    return {std::floor(x), std::floor(y)};
}

/// What the eye sees in the lens.
const char* folding_in_words(double repetition) {
    if (repetition >= 0.5) return "All squares have their dots in the same places: few crisp dots remain.";
    if (repetition >= 0.2) return "Some dots lie in the same places in several squares.";
    return "No two squares are alike: their dots fill an even grey.";
}

struct Words {
    std::string title, number, sentence;
};

Words words_for(const LoupeSquare& square, double repetition, double mm_per_page_unit) {
    const double mm = square.period() * mm_per_page_unit;
    return {fmt::format("{} squares of {:.3g} mm overlaid", square.across * square.across, mm),
            fmt::format("Repetition {:.2f}: {}", std::clamp(repetition, 0.0, 1.0),
                        repetition_in_words(repetition)),
            folding_in_words(repetition)};
}

void draw_card(const Box& square, const Words& words, ImTextureID picture, const CanvasPlace& place) {
    const float unit = ImGui::GetFontSize() / 15, air = 12 * unit, line = ImGui::GetTextLineHeight();
    const float side = kLensSide * unit;
    const ImVec2 sentence = ImGui::CalcTextSize(words.sentence.c_str(), nullptr, false, side);
    const ImVec2 card{side + 2 * air, side + 2 * line + sentence.y + 3.5f * air};
    const ImVec2 at = card_corner(square, card, place, air);
    ImDrawList* list = ImGui::GetForegroundDrawList();
    draw_shadow(list, at, {at.x + card.x, at.y + card.y});
    list->AddRectFilled(at, {at.x + card.x, at.y + card.y}, colour_of(ThemeColour::panel), 6 * unit);
    const float x = at.x + air;
    float y = at.y + 0.8f * air;
    push_title_font();
    list->AddText({x, y}, colour_of(ThemeColour::text), words.title.c_str());
    pop_title_font();
    y += line + 0.6f * air;
    list->AddImage(picture, {x, y}, {x + side, y + side});
    list->AddRect({x, y}, {x + side, y + side}, colour_of(ThemeColour::warning), 0, 0, 2 * unit);
    y += side + 0.6f * air;
    list->AddText({x, y}, colour_of(ThemeColour::text), words.number.c_str());
    list->AddText(ImGui::GetFont(), ImGui::GetFontSize(), {x, y + line + 0.2f * air},
                  colour_of(ThemeColour::quiet), words.sentence.c_str(), nullptr, side + unit);
}

}  // namespace

void Loupe::fold(const LoupeView& view, const LoupeSquare& square) {
    const Key key{square, &view.shown, view.version, view.ink, view.paper};
    if (folded_ == key) return;
    folded_ = key;
    const Folding folding = folded(view.shown, square);
    repetition_ = repetition(folding);
    const double dots_a_layer = static_cast<double>(folding.points.size()) / folding.layers;
    const double radius =
        std::min(kFoldedDotRadius / std::sqrt(std::max(dots_a_layer, 1e-3)), kLargestRadius);
    picture_.write(inked(mean_of_layers(folding, radius, kPictureSide), view.paper, view.ink));
}

void Loupe::draw(const LoupeView& view, const Camera& camera, const CanvasPlace& place) {
    info_.reset();
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (!place.holds(mouse) || ImGui::GetIO().WantCaptureMouse) return;
    const PagePoint at = place.page_at(mouse, camera);
    const auto square = loupe_square(view.shown, view.tile_size, at, view.step);
    if (!square) return;
    fold(view, *square);
    info_ = LoupeInfo{repetition_, square->across * square->across, square->level};
    const float unit = ImGui::GetFontSize() / 15;
    const Box box = on_screen(*square, camera, place);
    place.clip(ImGui::GetForegroundDrawList());
    draw_square(box, square->across, unit);
    draw_card(box, words_for(*square, repetition_, view.mm_per_page_unit), texture_id(picture_.get()), place);
    ImGui::GetForegroundDrawList()->PopClipRect();
}

}  // namespace dapple
