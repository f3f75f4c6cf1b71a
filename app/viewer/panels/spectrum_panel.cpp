#include "app/viewer/panels/method_panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/viewer/widgets/theme.h"
#include "app/viewer/widgets/widgets.h"
#include "core/text/number_words.h"

namespace dapple {
namespace {

constexpr double kHighestFrequency = 2;  // waves per mean spacing, at the edges of both plots
constexpr double kHighestPower = 4;      // at the top of the curve; what is above is cut off
constexpr float kLargestSide = 280;      // at 96 dpi

float pixel() {
    return ImGui::GetTextLineHeight() / 15;
}

void text_at(ImVec2 place, float align, const std::string& text) {
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    ImGui::GetWindowDrawList()->AddText({std::round(place.x - align * width), std::round(place.y)},
                                        colour_of(ThemeColour::quiet), text.c_str());
}

/// A plot's area with room for labels to the left and below.
struct PlotArea {
    ImVec2 min, max;
};

PlotArea begin_plot(const char* name, float left, float height) {
    const float width = ImGui::GetContentRegionAvail().x;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float labels = 2.2f * ImGui::GetTextLineHeight();
    ImGui::Dummy({width, height + labels});
    note_place(name);
    return {{corner.x + left, corner.y + 4 * pixel()}, {corner.x + width - 4 * pixel(), corner.y + height}};
}

void frequency_labels(const PlotArea& area, double least) {
    const float line = ImGui::GetTextLineHeight();
    for (double f = least; f <= kHighestFrequency; ++f) {
        const double t = (f - least) / (kHighestFrequency - least);
        const float x = area.min.x + (area.max.x - area.min.x) * static_cast<float>(t);
        ImGui::GetWindowDrawList()->AddLine({x, area.max.y}, {x, area.max.y + 3 * pixel()},
                                            colour_of(ThemeColour::quiet), pixel());
        text_at({x, area.max.y + 3 * pixel()},
                t < 0.01   ? 0.3f
                : t > 0.99 ? 0.9f
                           : 0.5f,
                fmt::format("{:.0f}", f));
    }
    text_at({(area.min.x + area.max.x) / 2, area.max.y + 3 * pixel() + line}, 0.5f,
            "cycles per mean dot spacing");
}

void draw_picture(ImTextureID picture) {
    const float available = ImGui::GetContentRegionAvail().x;
    const float side = std::floor(std::min(available - 8 * pixel(), kLargestSide * pixel()));
    PlotArea area = begin_plot("Spectrum picture", std::floor((available - side) / 2), side);
    area.max = {area.min.x + side, area.min.y + side - 4 * pixel()};
    area.min.x += 4 * pixel();
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled(area.min, area.max, IM_COL32_BLACK);
    if (picture) list->AddImage(picture, area.min, area.max);
    frequency_labels(area, -kHighestFrequency);
}

void draw_curve(const std::vector<Ring>& rings) {
    PlotArea area = begin_plot("Radial power", 22 * pixel(), 130 * pixel());
    area.min.y += ImGui::GetTextLineHeight();
    ImDrawList* list = ImGui::GetWindowDrawList();
    const auto place = [&](double frequency, double power) {
        const double x = frequency / kHighestFrequency, y = std::min(power / kHighestPower, 1.0);
        return ImVec2{area.min.x + (area.max.x - area.min.x) * static_cast<float>(x),
                      area.max.y - (area.max.y - area.min.y) * static_cast<float>(y)};
    };
    text_at({area.min.x - 22 * pixel(), area.min.y - 1.3f * ImGui::GetTextLineHeight()}, 0,
            "power (1 = random dots)");
    for (int power = 0; power <= static_cast<int>(kHighestPower); ++power) {
        const ImVec2 left = place(0, power), right = place(kHighestFrequency, power);
        list->AddLine(left, right, colour_of(power == 1 ? ThemeColour::quiet : ThemeColour::line), pixel());
        text_at({left.x - 6 * pixel(), left.y - ImGui::GetTextLineHeight() / 2}, 1, std::to_string(power));
    }
    std::vector<ImVec2> curve;
    for (const Ring& ring : rings) {
        if (ring.frequency <= kHighestFrequency) curve.push_back(place(ring.frequency, ring.power));
    }
    list->AddPolyline(curve.data(), static_cast<int>(curve.size()), colour_of(ThemeColour::accent), 0,
                      1.5f * pixel());
    frequency_labels(area, 0);
}

void draw_repetition(const ViewAnalysis& analysis) {
    if (!analysis.periodicity) {
        ImGui::TextUnformatted("Periodicity: too few tiles in view");
        note_place("Periodicity");
        hint("Zoom out or use more dots: a repeat shows only with two tiles side by side.");
        return;
    }
    const double value = std::clamp(analysis.periodicity->value, 0.0, 1.0);
    ImGui::TextUnformatted(fmt::format("Periodicity {:.2f}: {}", value, repetition_in_words(value)).c_str());
    note_place("Periodicity");
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = 5 * pixel();
    ImGui::Dummy({width, height});
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddRectFilled(corner, {corner.x + width, corner.y + height}, colour_of(ThemeColour::track),
                        height / 2);
    const float filled = std::max(height, width * static_cast<float>(value));
    list->AddRectFilled(corner, {corner.x + filled, corner.y + height},
                        colour_of(value >= 0.5 ? ThemeColour::warning : ThemeColour::accent), height / 2);
    hint(fmt::format("{:.0f} of 100 dots meet another when the drawing is shifted by whole tiles; 0 = "
                     "random, 100 = repeats exactly.",
                     100 * value)
             .c_str());
}

void draw_distances(const NearestSummary& nearest) {
    ImGui::TextUnformatted(
        fmt::format("Nearest dot: least {:.2f}, mean {:.2f}", nearest.minimum, nearest.mean).c_str());
    note_place("Nearest distances");
    hint("1 = honeycomb, the widest spacing possible; random dots have least 0, mean 0.47.");
}

}  // namespace

std::string spots_in_words(const std::optional<double>& periodicity) {
    constexpr double kRepeats = 0.5;
    const std::string spots = "Orange spots are stronger than chance: ";
    if (!periodicity) return spots + "some are in every tile, and repeated tiles make more.";
    if (*periodicity >= kRepeats) return spots + "here their lattice is the tile, which repeats.";
    return spots + "here they are in the tile itself, and its copies make no pattern.";
}

bool draw_spectrum_panel(const SpectrumInfo& info) {
    if (!subsection("Spectrum", false)) return false;
    if (!info.analysis) {
        hint("Measuring the dots on screen...");
        return true;
    }
    const ViewAnalysis& analysis = *info.analysis;
    if (!analysis.error.empty()) {
        hint(analysis.error.c_str());
        return true;
    }
    if (analysis.dots < 2) {
        hint("No dots on screen to measure.");
        return true;
    }
    hint(fmt::format("Measured: {} dots {}.", grouped(analysis.dots),
                     analysis.all ? "on screen" : "in the middle of the screen")
             .c_str());
    draw_repetition(analysis);
    draw_picture(info.picture);
    const std::optional<double> periodicity =
        analysis.periodicity ? std::optional(analysis.periodicity->value) : std::nullopt;
    hint(("The spectrum of the dots, low frequencies in the middle. A dark disc with an even ring is good: "
          "no clumps. " +
          spots_in_words(periodicity) +
          " A bright cross in the middle is the photograph: an even grey has none.")
             .c_str());
    draw_curve(analysis.radial_power);
    hint(fmt::format("The same, averaged around the middle. Below half a cycle: {:.2f}; the closer to 0, the "
                     "smoother an even grey looks.",
                     analysis.low_frequency_power)
             .c_str());
    hint(fmt::format("Strongest frequency: {:.0f} times random.", analysis.peaks.highest_bin).c_str());
    draw_distances(analysis.nearest);
    return true;
}

}  // namespace dapple
