#include "app/viewer/panels/method_panels.h"

#include <imgui.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "app/viewer/widgets/row.h"
#include "app/viewer/widgets/widgets.h"
#include "core/drawing/settings.h"
#include "io/files/tile_library.h"

namespace dapple {

namespace {

bool draw_placer(DrawingSettings& settings) {
    return segmented_row("Placer", settings.placer, std::array{"exact", "Figure 8"},
                         "exact: each dot once, none lost. Figure 8: as printed in the article; a quarter of "
                         "its dots lie on others.");
}

bool draw_density(DensityChoice& density) {
    bool changed = segmented_row("Density", density.source, std::array{"photo", "grey", "ramp"},
                                 "What the dots draw: the photograph, an even grey or a ramp from light to "
                                 "dark. The last two show best whether a tile repeats.");
    const Absent absent(density.source == DensitySource::grey ? nullptr : "Applies to a grey density only.");
    changed |= slider_row(
        "Grey", density.grey,
        {.min = 0.01, .neutral = 0.5, .hard_min = 0, .tip = "Density of the even grey; 1 is the darkest."});
    return changed;
}

bool draw_zooming(ViewerSettings& settings) {
    const Absent absent(
        settings.drawing.placer == PlacerKind::exact ? nullptr : "Figure 8 places whole drawings only.");
    return segmented_row("Zooming in", settings.zoom_mode, std::array{"larger dots", "more dots"},
                         "larger dots: like paper under a lens. more dots: dots keep their size, and new "
                         "ones appear without end.");
}

// What is shown of the tiles that the dots come from.
bool draw_shown(ViewerSettings& settings) {
    bool changed = switch_row(setting::show_tiles, settings.drawing.show_tiles);
    changed |= choice_row("Dots coloured", settings.colouring,
                          std::array{"as ink", "by level", "by rank", "by tile"},
                          "by level: how often the page was divided. by rank: how early in its tile. by "
                          "tile: the tile's kind, or how it is turned if there is only one kind.");
    return draw_zooming(settings) || changed;
}

bool draw_levels(int& deepest) {
    return slider_row("Divided up to", deepest,
                      {.max = kDeepestStep,
                       .neutral = kDeepestStep,
                       .format = deepest == kDeepestStep ? "all" : "%.0f",
                       .tip = "Shows only dots up to this level of division."});
}

}  // namespace

const char* why_only_exact(PlacerKind placer) {
    return placer == PlacerKind::exact
               ? nullptr
               : "Does not apply to Figure 8: its dots stay as placed, in the paper's order.";
}

bool ranking_row(const char* label, std::optional<RankingMethod>& ranking) {
    // The tile's own comes first, then RankingMethod's.
    int chosen = ranking ? static_cast<int>(*ranking) + 1 : 0;
    if (!choice_row(label, chosen,
                    std::array{"the tile's", "paper's ranks", "farthest point", "even tone (energy)"},
                    "Which of the tile's points become dots first as the tone darkens."))
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

void draw_steps(ViewerSettings& settings) {
    enum { tile, copies, ranks, period, cure };
    int step = -1;  // it says what to show, not what is shown
    if (!segmented_row("Steps", step, std::array{"tile", "copies", "ranks", "period", "cure"},
                       "tile: one over the whole page. copies: each divides into four, by level. ranks: in "
                       "which order a tile's dots appear. period: a tile that repeats, under the loupe. "
                       "cure: one that never does."))
        return;
    settings.drawing.placer = PlacerKind::exact;
    if (step >= period) settings.drawing.tile = step == period ? "paper16" : kDefaultTile;
    settings.drawing.show_tiles = step < period;
    settings.loupe.on = step >= period;
    settings.density.source = step < period ? DensitySource::photograph : DensitySource::grey;
    settings.deepest_level = step == tile ? 0 : kDeepestStep;
    settings.colouring = step == copies  ? DotColouring::level
                         : step == ranks ? DotColouring::rank
                                         : DotColouring::ink;
}

bool draw_method_rows(ViewerSettings& settings, const TileList& tiles) {
    DrawingSettings& drawing = settings.drawing;
    hint(
        "All dots come from a small square of points, the tile, or a few compatible ones. Each is divided "
        "into four until its points are dense enough for the picture.");
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
    changed |= switch_row(
        "Explain dots", settings.origins,
        "Shows the level, rank and density of the dot under the pointer; its tile lights up (key I).");
    changed |= switch_row("Every frame", settings.every_frame,
                          "Places all dots anew in every frame and shows the frame rate.");
    return changed;
}

bool tile_row(const char* label, std::string& tile, const TileList& list, const char* tip) {
    std::vector<std::string> tiles(list.names.begin(), list.names.end());
    auto chosen = static_cast<int>(std::ranges::find(tiles, tile) - tiles.begin());
    if (chosen == static_cast<int>(tiles.size())) tiles.push_back(tile);

    std::vector<std::string> words;
    for (const std::string& name : tiles) {
        const std::string shown = short_tile_name(name);
        const bool alone = std::ranges::count(tiles, shown, short_tile_name) == 1;
        words.push_back(alone ? shown : name);
    }
    if (list.open_file) words.emplace_back("From a file...");
    std::vector<const char*> entries;
    for (const std::string& word : words) entries.push_back(word.c_str());

    const auto usual = std::ranges::find(tiles, kDefaultTile);
    const ListLook look{.by_arrows = static_cast<int>(tiles.size()),
                        .usual = usual == tiles.end() ? -1 : static_cast<int>(usual - tiles.begin())};
    if (!choice_row(label, chosen, entries, tip, look)) return false;
    if (chosen == static_cast<int>(tiles.size())) {
        list.open_file();
        return false;
    }
    tile = tiles[static_cast<std::size_t>(chosen)];
    return true;
}

namespace {

bool draw_right_side(Comparison& right, const TileList& tiles) {
    bool changed = tile_row("Right tile", right.tile, tiles, "The tile of the right side's dots.");
    if (choice_row("Right placer", right.placer, std::array{"exact", "Figure 8"},
                   "How the right side's dots are placed: exactly, or as printed in the article.")) {
        DrawingSettings drawing;
        drawing.tile = right.tile;
        drawing.placer = right.placer;
        right.tile = tile_in_use(drawing);
        changed = true;
    }
    const bool counted = right.placer == PlacerKind::exact;
    {
        const Absent absent(why_only_exact(right.placer));
        changed |= ranking_row("Right ranking", right.ranking);
    }
    return segmented_row("Right side has", right.by,
                         std::array{"same scale", counted ? "same count" : "similar count"},
                         "What both sides share. Figure 8 has no exact count: it gets the scale for about as "
                         "many distinct dots.") ||
           changed;
}

bool draw_split(ViewerSettings& settings, const TileList& tiles) {
    Comparison& right = settings.comparison;
    bool on = right.on, changed = false;
    if (switch_row("Split view", on,
                   "Shows another tile or placer to the right of a line that you can drag.")) {
        right = toggled(right, settings.drawing);
        changed = true;
    }
    {
        const Absent absent(right.on ? nullptr : "Applies to the split view only.");
        changed |= draw_right_side(right, tiles);
    }
    hint("Repetition shows best on an even grey or a ramp: Density, above.");
    return changed;
}

bool draw_loupe(LoupeChoice& loupe) {
    bool changed = switch_row("Loupe", loupe.on, "A lens that overlays the tiles: what repeats stays crisp.");
    const Absent absent(loupe.on ? nullptr : "Applies to the loupe only.");
    const char* const words = loupe.step == 0 ? "fitting" : loupe.step > 0 ? "smaller" : "larger";
    changed |= slider_row("Its tiles", loupe.step,
                          {.min = -3,
                           .max = 3,
                           .format = words,
                           .tip = "Size of the overlaid tiles; a step to the right halves their side."});
    return changed;
}

}  // namespace

bool draw_compare_panel(ViewerSettings& settings, const TileList& tiles) {
    if (!subsection("Compare")) return false;
    const bool changed = draw_split(settings, tiles);
    return draw_loupe(settings.loupe) || changed;
}

}  // namespace dapple
