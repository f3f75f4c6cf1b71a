#include "app/viewer/panels/method_panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <string>

#include "app/viewer/background/dot_blocks.h"
#include "app/viewer/widgets/theme.h"
#include "app/viewer/widgets/widgets.h"
#include "core/text/number_words.h"
#include "io/files/tile_library.h"

namespace dapple {
namespace {

constexpr std::size_t kMostNumbered = 24;
constexpr float kLargestTileSide = 300;  // at 96 dpi
// It is paper in each theme, as its points have colours of ink.
constexpr ImU32 kPaperColour = IM_COL32_WHITE, kLetters = IM_COL32(222, 217, 207, 255),
                kLines = IM_COL32(190, 185, 175, 255), kKindNumbers = IM_COL32(0, 0, 0, 45),
                kSmallNumbers = IM_COL32(0, 0, 0, 150);

ImU32 colour_of_rank(std::size_t rank, std::size_t count) {
    const double last = std::max(1.0, static_cast<double>(count) - 1);
    const glm::vec3 c = rank_colour(static_cast<double>(rank) / last);
    return ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, 1});
}

struct Square {
    ImVec2 corner;
    float side;
    ImVec2 at(glm::dvec2 p) const {
        return {corner.x + side * static_cast<float>(p.x), corner.y + side * static_cast<float>(p.y)};
    }
};

void draw_text(const std::string& text, ImVec2 centre, float size, ImU32 colour) {
    const ImVec2 extent = ImGui::GetFont()->CalcTextSizeA(size, FLT_MAX, 0, text.c_str());
    ImGui::GetWindowDrawList()->AddText(
        ImGui::GetFont(), size, {std::round(centre.x - extent.x / 2), std::round(centre.y - extent.y / 2)},
        colour, text.c_str());
}

ImU32 colour_of_kind(std::size_t kind, float paper) {
    const glm::vec3 c = glm::mix(kind_colour(kind), glm::vec3(1), paper);
    return ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, 1});
}

// The kinds of the children, each in its quadrant.
void draw_children(const Square& square, const NextKinds::value_type& children, ImU32 numbers) {
    const float size = std::max(square.side * 0.2f, std::min(square.side / 2, ImGui::GetFontSize() * 0.8f));
    for (int q = 0; q < 4; ++q) {
        const glm::dvec2 centre(0.25 + 0.5 * (q & 1), 0.25 + 0.5 * (q >> 1));
        const std::uint16_t kind = children[static_cast<std::size_t>(q)];
        ImGui::GetWindowDrawList()->AddRectFilled(square.at(centre - 0.25), square.at(centre + 0.25),
                                                  colour_of_kind(kind, 0.8f));
        draw_text(std::to_string(kind), square.at(centre), size, numbers);
    }
}

// A legend of all kinds: each in its colour, and below it its children.
void draw_kinds(const NextKinds& kinds, float unit) {
    constexpr std::size_t kKindColumns = 8;
    const float width = ImGui::GetContentRegionAvail().x / kKindColumns, side = std::floor(width - 6 * unit);
    const float head = ImGui::GetTextLineHeight();
    const ImVec2 start = ImGui::GetCursorScreenPos();
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        const ImVec2 corner(std::floor(start.x + width * static_cast<float>(k % kKindColumns)),
                            start.y + (head + side + 6 * unit) * static_cast<float>(k / kKindColumns));
        ImGui::SetCursorScreenPos(corner);
        ImGui::Dummy({side, head + side});
        note_place(fmt::format("Kind {}", k).c_str());
        ImGui::GetWindowDrawList()->AddRectFilled(corner, {corner.x + side, corner.y + head},
                                                  colour_of_kind(k, 0));
        draw_text(std::to_string(k), {corner.x + side / 2, corner.y + head / 2}, ImGui::GetFontSize(),
                  IM_COL32_WHITE);
        draw_children({{corner.x, corner.y + head}, side}, kinds[k], kSmallNumbers);
    }
}

// What lies on each quadrant: how it is turned, or of which kind it is.
void draw_quadrants(const Square& square, const TileView& tile, float unit) {
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled(square.at({0, 0}), square.at({1, 1}), kPaperColour);
    const bool of_kinds = tile.next_kind.size() > 1;
    if (of_kinds) draw_children(square, tile.next_kind[0], kKindNumbers);
    for (int q = 0; q < (of_kinds ? 0 : 4); ++q) {
        const glm::dvec2 centre(0.25 + 0.5 * (q & 1), 0.25 + 0.5 * (q >> 1));
        for (const Stroke& stroke : letter_f(tile.rule.child[q])) {
            const ImVec2 from = square.at(centre + stroke[0] * 0.16),
                         to = square.at(centre + stroke[1] * 0.16);
            const float half = square.side * 0.014f;
            list->AddRectFilled({std::min(from.x, to.x) - half, std::min(from.y, to.y) - half},
                                {std::max(from.x, to.x) + half, std::max(from.y, to.y) + half}, kLetters);
        }
    }
    list->AddLine(square.at({0.5, 0}), square.at({0.5, 1}), kLines, unit);
    list->AddLine(square.at({0, 0.5}), square.at({1, 0.5}), kLines, unit);
    list->AddRect(square.at({0, 0}), square.at({1, 1}), colour_of(ThemeColour::quiet), 0, 0, unit);
}

void draw_points(const Square& square, const TileView& tile, std::size_t shown, float unit) {
    ImDrawList* list = ImGui::GetWindowDrawList();
    const std::size_t count = tile.points.size();
    const bool numbered = count <= kMostNumbered;
    const float spacing = square.side / std::sqrt(static_cast<float>(count));
    const float radius = numbered ? 9 * unit : std::clamp(0.3f * spacing, 1.2f * unit, 6 * unit);
    // Few corners where points are many and small: a draw list holds 65,536.
    const int corners = count > 1000 ? 6 : 12;
    // The first come last, so that they lie on top.
    for (std::size_t i = shown; i-- > 0;) {
        const ImVec2 centre = square.at(tile.points[i]);
        if (numbered)
            list->AddCircleFilled(centre, radius, colour_of_rank(i, count), 24);
        else
            list->AddNgonFilled(centre, radius, colour_of_rank(i, count), corners);
        if (numbered) draw_text(std::to_string(i), centre, 12 * unit, IM_COL32_WHITE);
    }
}

}  // namespace

std::array<Stroke, 3> letter_f(Orientation orientation) {
    std::array<Stroke, 3> strokes{Stroke{glm::dvec2(-0.55, -0.9), glm::dvec2(-0.55, 0.9)},
                                  Stroke{glm::dvec2(-0.55, -0.9), glm::dvec2(0.6, -0.9)},
                                  Stroke{glm::dvec2(-0.55, -0.1), glm::dvec2(0.35, -0.1)}};
    for (Stroke& stroke : strokes)
        for (glm::dvec2& end : stroke) end = apply(orientation, end);
    return strokes;
}

void draw_tile_panel(const TileView& tile, std::size_t& most_shown) {
    if (tile.points.empty() || !subsection("The tile")) return;
    const std::size_t count = tile.points.size();
    const float unit = ImGui::GetTextLineHeight() / 15;
    const float width = ImGui::GetContentRegionAvail().x;
    const float side = std::floor(std::min(width, kLargestTileSide * unit));
    const ImVec2 cursor = ImGui::GetCursorScreenPos();
    const Square square{{cursor.x + std::floor((width - side) / 2), cursor.y}, side};
    ImGui::SetCursorScreenPos(square.corner);
    ImGui::Dummy({side, side});
    note_place("Tile picture");
    draw_quadrants(square, tile, unit);
    std::size_t shown = std::min(most_shown, count);
    draw_points(square, tile, shown, unit);

    const auto all = static_cast<double>(count);
    if (slider_row("Points shown", shown,
                   {.min = 1,
                    .max = all,
                    .neutral = all,
                    .format = "%.0f",
                    .grouped = true,
                    .tip = "Hides the tile's points, those of the last ranks first."}))
        most_shown = shown >= count ? SIZE_MAX : shown;
    if (tile.next_kind.size() > 1) {
        hint(fmt::format("{}: kind 0 of {}, {} points each, dark ones first. Below: each kind as tile "
                         "boundaries show it, and the half-size kinds on its quarters.",
                         short_tile_name(tile.name), tile.next_kind.size(), grouped(count))
                 .c_str());
        draw_kinds(tile.next_kind, unit);
        return;
    }
    const bool turned =
        std::ranges::any_of(tile.rule.child, [](Orientation g) { return g != Orientation{}; });
    hint(fmt::format("{}: {} points, dark ones first. A half-size copy lies on each quarter{}.",
                     short_tile_name(tile.name), grouped(count),
                     turned ? ", turned as the letter F shows" : "; every F is upright, so it repeats")
             .c_str());
}

}  // namespace dapple
