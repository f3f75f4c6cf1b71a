#include "app/viewer/canvas/loupe.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <string>

#include "app/viewer/view/view_analysis.h"
#include "app/viewer/widgets/keys.h"
#include "app/viewer/widgets/theme.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {
namespace {

constexpr int kPictureSide = 480;       // pixels of the folded picture, shown half as large
constexpr double kDotRadius = 0.28;     // in mean spacings: small enough to see each dot of a repeating tile
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
    const auto point = [&](PagePoint p) {
        const glm::dvec2 at = to_canvas(camera, p) / place.pixels_per_point;
        return ImVec2(place.corner.x + static_cast<float>(at.x), place.corner.y + static_cast<float>(at.y));
    };
    const std::int64_t side = (std::int64_t(1) << (62 - square.level)) * square.across;
    return {point(square.corner), point(square.corner + side)};
}

void draw_square(const Box& box, int across, float unit) {
    ImDrawList* list = ImGui::GetForegroundDrawList();
    const ImU32 line = colour_of(ThemeColour::warning);
    const float step = (box.max.x - box.min.x) / static_cast<float>(across);
    const ImU32 faint = (line & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 110);
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

struct Words {
    std::string title, number, sentence;
};

Words words_for(const LoupeSquare& square, double repetition, double mm_per_page_unit) {
    const double mm = square.period() * mm_per_page_unit;
    return {fmt::format("{} squares of {:.3g} mm as one", square.across * square.across, mm),
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

const char* folding_in_words(double repetition) {
    if (repetition >= 0.5)
        return "Each square has its dots where the others have theirs: few crisp dots are left.";
    if (repetition >= 0.2) return "Part of the dots lie where other squares have theirs.";
    return "No square is like another, so their dots fill an even grey.";
}

void Loupe::fold(const LoupeView& view, const LoupeSquare& square) {
    const Key key{square, &view.shown, view.version, view.ink, view.paper};
    if (folded_ == key) return;
    folded_ = key;
    const Folding folding = folded(view.shown, square);
    repetition_ = repetition(folding);
    const double dots_a_layer = static_cast<double>(folding.points.size()) / folding.layers;
    const double radius = std::min(kDotRadius / std::sqrt(std::max(dots_a_layer, 1e-3)), kLargestRadius);
    picture_.write(inked(mean_of_layers(folding, radius, kPictureSide), view.paper, view.ink));
}

void Loupe::draw(const LoupeView& view, const Camera& camera, const CanvasPlace& place) {
    info_.reset();
    const glm::vec2 mouse{ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y};
    const glm::vec2 in_canvas = mouse - place.corner;
    const bool inside =
        in_canvas.x >= 0 && in_canvas.y >= 0 && in_canvas.x < place.size.x && in_canvas.y < place.size.y;
    if (!inside || ImGui::GetIO().WantCaptureMouse) return;
    const PagePoint at = point_at(camera, glm::dvec2(in_canvas) * place.pixels_per_point);
    const auto square = loupe_square(view.shown, view.tile_size, at, view.step);
    if (!square) return;
    fold(view, *square);
    info_ = LoupeInfo{repetition_, square->across * square->across, square->level};
    const float unit = ImGui::GetFontSize() / 15;
    const Box box = on_screen(*square, camera, place);
    ImGui::GetForegroundDrawList()->PushClipRect(
        {place.corner.x, place.corner.y}, {place.corner.x + place.size.x, place.corner.y + place.size.y});
    draw_square(box, square->across, unit);
    draw_card(box, words_for(*square, repetition_, view.mm_per_page_unit), texture_id(picture_.get()), place);
    ImGui::GetForegroundDrawList()->PopClipRect();
}

}  // namespace dapple
