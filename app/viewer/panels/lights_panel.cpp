#include "app/viewer/panels/lights_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <array>
#include <cmath>

#include "app/viewer/widgets.h"

namespace dapple {
namespace {

constexpr SliderRange kCount{.min = 1,
                             .max = 16'384,
                             .neutral = 1024,
                             .curve = SliderCurve::logarithmic,
                             .format = "%.0f",
                             .hard_min = 1,
                             .hard_max = 100'000,
                             .grouped = true};

template <class Value, std::size_t n>
bool choose(const char* label, Value& value, const std::array<const char*, n>& names) {
    int chosen = static_cast<int>(value);
    if (!segmented_row(label, chosen, names)) return false;
    value = static_cast<Value>(chosen);
    return true;
}

bool draw_samples(LightRequest& request) {
    if (!section("Samples")) return false;
    bool changed = false;
    double count = static_cast<double>(request.count);
    if (slider_row("Samples", count, kCount)) {
        request.count = static_cast<std::uint64_t>(std::lround(count));
        changed = true;
    }
    changed |= choose("Placed", request.position, std::array{"centroid", "dot", "random"});
    hint(
        "Where in its region a sample is: at the light's centre of gravity, where the placer put it, or "
        "drawn "
        "at random, which has no bias.");
    changed |= choose("Placer", request.placer, std::array{"exact", "Figure 8"});
    bool compensated = request.importance == LightImportance::compensated;
    if (switch_row("MIS compensation", compensated)) {
        request.importance = compensated ? LightImportance::compensated : LightImportance::light;
        changed = true;
    }
    double seed = static_cast<double>(request.seed);
    if (slider_row("Seed", seed, {.min = 0, .max = 100, .neutral = 0, .format = "%.0f"})) {
        request.seed = static_cast<std::uint64_t>(std::lround(seed));
        changed = true;
    }
    return changed;
}

bool draw_view(LightsSettings& settings) {
    if (!section("View")) return false;
    bool changed =
        slider_row("Exposure", settings.stops,
                   {.min = -12, .max = 12, .neutral = 0, .format = "%+.1f", .hard_min = -40, .hard_max = 40});
    hint("In stops. E is lighter, Shift+E darker.");
    changed |= slider_row("Rotation", settings.turn_degrees,
                          {.min = -180, .max = 180, .neutral = 0, .format = "%.0f deg"});
    changed |= switch_row("Show samples", settings.samples_shown);
    return changed;
}

void line(const char* label, const std::string& value) {
    ImGui::TextUnformatted(label);
    ImGui::SameLine();
    const float right = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(value.c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, right));
    ImGui::TextUnformatted(value.c_str());
}

}  // namespace

bool draw_lights_panel(LightsSettings& settings, const std::optional<LightsFacts>& facts) {
    bool changed = draw_samples(settings.request);
    changed |= draw_view(settings);
    if (section("Figures")) {
        const auto figure = [&](const char* label, const auto& words) {
            line(label, facts ? words(*facts) : std::string("measuring"));
            note_place(label);
        };
        figure("Irradiance differs by",
               [](const LightsFacts& f) { return fmt::format("{:.3g} %", 100 * f.difference); });
        figure("Total flux differs by",
               [](const LightsFacts& f) { return fmt::format("{:.1e}", f.flux_error); });
        figure("Placing", [](const LightsFacts& f) { return fmt::format("{:.1f} ms", f.place_ms); });
        figure("Sharing out the light",
               [](const LightsFacts& f) { return fmt::format("{:.1f} ms", f.share_ms); });
        hint(
            "Irradiance: mean difference over all normals between the left sphere, lit by the samples, and "
            "the "
            "right one, lit by every texel of the map.");
    }
    return changed;
}

}  // namespace dapple
