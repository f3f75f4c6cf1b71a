#include "app/viewer/panels/window_panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "app/viewer/widgets/widgets.h"

namespace dapple {
namespace {

constexpr SliderRange kCount{.min = 1,
                             .max = 16'384,
                             .neutral = 1024,
                             .curve = SliderCurve::logarithmic,
                             .format = "%.0f",
                             .hard_max = 100'000,
                             .grouped = true,
                             .tip = "Number of samples that share the map's light."};

bool draw_samples(LightsSettings& settings, const TileList& tiles) {
    if (!section("Samples")) return false;
    LightRequest& request = settings.request;
    bool changed = slider_row("Samples", request.count, kCount);
    const LightRequest usual;
    changed |= segmented_row("Placed", request.position, std::array{"relaxed", "dot", "random"},
                             "A sample's place in its region: at the light's centre of gravity, as placed, "
                             "or random, which has no bias.",
                             usual.position);
    changed |= segmented_row(
        "Placer", request.placer, std::array{"exact", "Figure 8"},
        "exact: each sample once, none lost. Figure 8: as printed in the article, with some twice.",
        usual.placer);
    changed |= tile_row("Tile", settings.tile, tiles, "The square of points that all samples come from.");
    bool compensated = request.importance == LightImportance::compensated;
    if (switch_row("MIS compensation", compensated,
                   "Leaves dim light to the renderer's other samples (multiple importance sampling), so that "
                   "bright areas get more of these.")) {
        request.importance = compensated ? LightImportance::compensated : LightImportance::light;
        changed = true;
    }
    changed |= slider_row(
        "Seed", request.seed,
        {.max = 100, .format = "%.0f", .tip = "Another number gives other random places, equally good."});
    return changed;
}

bool draw_view(LightsSettings& settings) {
    if (!section("View")) return false;
    bool changed =
        slider_row("Exposure", settings.stops,
                   {.min = -12,
                    .max = 12,
                    .format = "%+.1f",
                    .hard_min = -40,
                    .hard_max = 40,
                    .tip = "Exposure of the view, in stops; the samples stay. E lightens, Shift+E darkens."});
    changed |=
        slider_row("Rotation", settings.turn_degrees,
                   {.min = -180,
                    .max = 180,
                    .format = "%.0f deg",
                    .tip = "Rotates the light about the vertical axis, on the spheres and in the file."});
    changed |= segmented_row("Samples as", settings.marks, std::array{"points", "areas", "none"},
                             "Shows samples as points, or as outlines of the area nearest to each. They "
                             "light the spheres either way.");
    return changed;
}

// Nobody wants the digits of what would be 0 but for rounding.
std::string small_percentage(double share) {
    constexpr double kLeast = 1e-6;
    return share < kLeast ? "under 0.0001 %" : fmt::format("{:.3g} %", 100 * share);
}

std::string mean_and_largest(const RelativeError& error) {
    const auto per_cent = [](double share) {
        return share < 10 ? fmt::format("{:.3g} %", 100 * share) : fmt::format("{:.0f} %", 100 * share);
    };
    return per_cent(error.mean) + ", at most " + per_cent(error.largest);
}

// The value at the right edge: in a line of its own where the label leaves too little room.
void line(const char* label, const std::string& value) {
    const float row = ImGui::GetContentRegionAvail().x, width = ImGui::CalcTextSize(value.c_str()).x;
    ImGui::TextUnformatted(label);
    if (ImGui::CalcTextSize(label).x + ImGui::GetStyle().ItemSpacing.x + width <= row) ImGui::SameLine();
    const float right = ImGui::GetContentRegionAvail().x - width;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, right));
    ImGui::TextUnformatted(value.c_str());
}

}  // namespace

bool draw_lights_panel(LightsSettings& settings, const std::optional<LightsInfo>& info,
                       const TileList& tiles) {
    bool changed = draw_samples(settings, tiles);
    changed |= draw_view(settings);
    if (section("Figures")) {
        const auto figure = [&](const char* label, const auto& words) {
            line(label, info ? words(*info) : std::string("measuring"));
            note_place(label);
        };
        figure("Irradiance error", [](const LightsInfo& f) { return mean_and_largest(f.irradiance); });
        figure("Glossy light error", [](const LightsInfo& f) { return mean_and_largest(f.glossy); });
        figure("Total flux error", [](const LightsInfo& f) { return small_percentage(f.flux_error); });
        figure("Placing", [](const LightsInfo& f) { return fmt::format("{:.1f} ms", f.place_ms); });
        figure("Sharing the light", [](const LightsInfo& f) { return fmt::format("{:.1f} ms", f.share_ms); });
        hint(
            "Mean and largest difference, over all directions, between light from the samples and from every "
            "texel of the map: on a diffuse sphere and a glossy one. The largest lie in dark parts and "
            "hardly show.");
    }
    return changed;
}

bool draw_light_export_panel(LightsSettings& settings, LightFile format) {
    if (format == LightFile::png) {
        hint("The map as in its file, at the view's exposure, with the samples on top.");
        return false;
    }
    constexpr std::array kConventions{SphereConvention::openexr, SphereConvention::usd,
                                      SphereConvention::mitsuba, SphereConvention::blender,
                                      SphereConvention::pbrt};
    std::vector<std::string> words{"the file's default"};
    for (const SphereConvention convention : kConventions) words.emplace_back(name_of(convention));
    std::vector<const char*> names;
    for (const std::string& word : words) names.push_back(word.c_str());
    const auto at =
        settings.convention ? std::ranges::find(kConventions, *settings.convention) : kConventions.end();
    int chosen = at == kConventions.end() ? 0 : static_cast<int>(at - kConventions.begin()) + 1;
    const bool changed =
        choice_row("Axes", chosen, names,
                   "Which way is up and where the map's middle lies, for the renderer that reads the file.");
    if (changed) settings.convention = chosen == 0 ? std::nullopt : std::optional(kConventions[chosen - 1]);
    hint("The view's rotation turns the samples too.");
    return changed;
}

}  // namespace dapple
