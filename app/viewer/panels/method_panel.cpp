#include "app/viewer/panels/method_panels.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "app/viewer/widgets/row.h"
#include "app/viewer/widgets/widgets.h"

namespace dapple {
namespace {

bool draw_placer(DrawingSettings& settings) {
    return segmented_row(
        "Placer", settings.placer, std::array{"exact", "Figure 8"},
        "exact: each dot once, and none is lost. Figure 8: as printed in the article, a quarter of its dots "
        "lie on others.");
}

bool draw_density(DensityChoice& density) {
    bool changed = segmented_row(
        "Density", density.source, std::array{"photo", "grey", "ramp"},
        "What the dots draw: the photograph, an even grey or a ramp from light to dark. On the last two a "
        "repeating tile is seen best.");
    const Absent absent(density.source == DensitySource::grey ? nullptr : "Applies to a grey density only.");
    changed |= slider_row("Grey", density.grey,
                          {.min = 0.01,
                           .neutral = 0.5,
                           .hard_min = 0,
                           .tip = "How dense the even grey is; 1 is as dark as the scale makes it."});
    return changed;
}

bool draw_zooming(ViewerSettings& settings) {
    const Absent absent(
        settings.drawing.placer == PlacerKind::exact ? nullptr : "Figure 8 places whole drawings only.");
    return segmented_row(
        "Zooming in", settings.zoom_mode, std::array{"larger dots", "more dots"},
        "larger dots: as on paper under a lens. more dots: they keep their size, and new ones appear between "
        "them without end.");
}

// What is shown of the tiles that the dots come from.
bool draw_shown(ViewerSettings& settings) {
    bool changed = switch_row(setting::show_tiles, settings.drawing.show_tiles);
    changed |= choice_row(
        "Dots coloured", settings.colouring, std::array{"as ink", "by level", "by rank", "by tile"},
        "by level: how often the page was divided. by rank: how early in its tile. by tile: which kind its "
        "tile is, or how it is turned if all are of one kind.");
    return draw_zooming(settings) || changed;
}

bool draw_levels(int& deepest) {
    return slider_row(
        "Divided up to", deepest,
        {.max = kDeepestStep,
         .neutral = kDeepestStep,
         .format = deepest == kDeepestStep ? "all" : "%.0f",
         .tip = "Shows only the dots of the first levels, as if the page were not divided any further."});
}

}  // namespace

const char* why_only_exact(PlacerKind placer) {
    return placer == PlacerKind::exact
               ? nullptr
               : "The paper's placer (Figure 8) knows nothing of this: its dots stay as placed, "
                 "in the paper's order.";
}

bool ranking_row(const char* label, std::optional<RankingMethod>& ranking) {
    // The tile's own comes first, then RankingMethod's.
    int chosen = ranking ? static_cast<int>(*ranking) + 1 : 0;
    if (!choice_row(label, chosen,
                    std::array{"the tile's own", "paper's ranks", "farthest point", "even tone (energy)"},
                    "Which of the tile's points become dots first while it gets darker."))
        return false;
    ranking.reset();
    if (chosen > 0) ranking = static_cast<RankingMethod>(chosen - 1);
    return true;
}

void draw_film_buttons(std::span<const Action> films, const std::function<void(Action)>& act) {
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float air = ImGui::GetStyle().ItemSpacing.x, row = ImGui::GetContentRegionAvail().x;
    const auto count = static_cast<float>(films.size());
    const float room = row - (count - 1) * air, half = std::floor(room / 2);
    for (std::size_t i = 0; i < films.size(); ++i) {
        const Shortcut& button = shortcut_of(films[i]);
        if (i > 0) ImGui::SameLine();
        const float width = i == 0 ? half : (room - half) / (count - 1);
        if (key_button(button.label, {std::max(width, 1.0f), 0})) act(films[i]);
        note_place(button.label);
        tip_beside(start, with_keys(button.tip, i == 0 ? Action::play : films[i]).c_str());
    }
}

bool draw_method_rows(ViewerSettings& settings, const TileList& tiles) {
    DrawingSettings& drawing = settings.drawing;
    hint(
        "All dots come from a small square of points, the tile, or a few that fit together: each is "
        "divided into four smaller ones until its points are dense enough for the picture there.");
    bool changed = draw_placer(drawing);
    // What is drawn with; the own choice comes back with the exact placer.
    std::string tile = tile_in_use(drawing);
    if (tile_row("Tile", tile, tiles,
                 "The square of points that all dots come from; some repeat, some never do.")) {
        drawing.tile = tile;
        changed = true;
    }
    {
        const Absent absent(why_only_exact(drawing.placer));
        changed |= ranking_row("Ranking", drawing.ranking);
    }
    changed |= draw_density(settings.density);
    changed |= draw_shown(settings);
    changed |= draw_levels(settings.deepest_level);
    changed |=
        switch_row("Explain dots", settings.origins,
                   "Beside the pointer: the level, the rank and the density that the dot under it comes "
                   "from; its tile lights up (key I).");
    changed |= switch_row(
        "Every frame", settings.every_frame,
        "Places all dots anew in each frame, without rest, and shows how many frames a second that "
        "makes.");
    return changed;
}

}  // namespace dapple
