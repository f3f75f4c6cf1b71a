#pragma once
// The sections of the column about the method: tiles, comparison, spectrum.

#include <imgui.h>
#include <array>
#include <cstddef>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string>

#include "app/viewer/background/workbench.h"
#include "app/viewer/model/viewer_settings.h"
#include "app/viewer/panels/shortcuts.h"
#include "app/viewer/view/view_analysis.h"

namespace dapple {

/// What a row offers.
struct TileList {
    std::span<const std::string> names;    // for tile_named()
    std::function<void()> open_file = {};  // asks for another tile's file; none: the row does not offer it
};

/// A tile to choose from a list. Files stand there by their names without folders, or by their whole paths
/// where two have the same name; a tile that is not in the list is shown below it. Arrows choose tiles but
/// never ask for a file. True when another was chosen.
bool tile_row(const char* label, std::string& tile, const TileList& list, const char* tip);

// "The method", which takes the column's place: which tile the dots come from and how they are taken out of
// it, for whoever wants to know. The usual choices are good ones.

/// Five steps through the method, a click each: a tile, its copies, ranks, its period, what cures that.
void draw_steps(ViewerSettings& settings);

/// True while something changes.
bool draw_method_rows(ViewerSettings& settings, const TileList& tiles);

/// Buttons side by side that begin films; the first has the most room.
void draw_film_buttons(std::span<const Action> films, const std::function<void(Action)>& act);

/// The ranking, by which a tile's points become dots. True when another was chosen.
bool ranking_row(const char* label, std::optional<RankingMethod>& ranking);

/// Why rows that only the exact placer knows are absent; null if they are not.
const char* why_only_exact(PlacerKind placer);

/// Section "Compare": the split view on or off, and what its right side is placed with; the loupe. True while
/// something changes.
bool draw_compare_panel(ViewerSettings& settings, const TileList& tiles);

// The section "Spectrum": what is measured of the dots on screen.

struct SpectrumInfo {
    const ViewAnalysis* analysis = nullptr;  // none yet: being measured
    ImTextureID picture{};                   // of its spectrum
};

/// What the orange spots in its picture mean, for dots of such a periodicity; none: too few tiles are in view
/// to tell. A lattice of them is a repeated pattern only where there is one: a tile that never repeats has
/// some spots as well, as each of its copies has the same points.
std::string spots_in_words(const std::optional<double>& periodicity);

/// Section "Spectrum", folded at first: the spectrum of the dots on screen as a
/// picture and as a curve, how much they repeat and how far apart they are, each with a sentence that says
/// what it means. True while it is open, for only then is there anything to measure.
bool draw_spectrum_panel(const SpectrumInfo& info);

// The section "The tile": the points of the tile in use and the order in which they appear.

/// The tile itself: its points in the order of their ranks, how it is turned in its quadrants, and a slider
/// that takes points away from the last on.
void draw_tile_panel(const TileView& tile, std::size_t& most_shown);

/// The strokes of the letter F, which looks different in all eight orientations: from and to, about the
/// centre, within -1..1, y down.
using Stroke = std::array<glm::dvec2, 2>;
std::array<Stroke, 3> letter_f(Orientation orientation);

}  // namespace dapple
