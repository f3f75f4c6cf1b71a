#include "app/viewer/panels/tone_panel.h"

#include <imgui.h>

#include <algorithm>
#include <array>

#include "app/viewer/panels/histogram_panel.h"
#include "app/viewer/widgets/widgets.h"
#include "core/image/detail.h"
#include "core/image/exposure.h"

namespace dapple {
namespace {

enum class Source { automatic, true_light, own };

// A tone without black and white point and the curve between them.
Tone without_curve(const Tone& tone) {
    return {.exposure = tone.exposure,
            .blur = tone.blur,
            .detail = tone.detail,
            .black = tone.black,
            .invert = tone.invert};
}

Source source_of(const DrawingSettings& settings) {
    if (settings.automatic_tone) return Source::automatic;
    const bool neutral = settings.tone == without_curve(settings.tone) && settings.tone.detail == 0 &&
                         settings.tone.black.value_or(1) == 1;
    return neutral ? Source::true_light : Source::own;
}

bool draw_source(DrawingSettings& settings, const Tone& drawn) {
    int chosen = static_cast<int>(source_of(settings));
    if (!segmented_row(
            "Tone from", chosen, std::array{"auto", "true", "custom"},
            "auto: black, white and middle tones chosen so that the picture reads well. true: ink covers "
            "just the light that the picture lacks. custom: as the handles and sliders say."))
        return false;
    const auto source = static_cast<Source>(chosen);
    settings.automatic_tone = source == Source::automatic;
    settings.tone = source == Source::own ? drawn : without_curve(settings.tone);
    if (source != Source::own) settings.tone.black.reset();
    if (source == Source::automatic) settings.tone.detail = kAutoDetail;
    if (source == Source::true_light) settings.tone.detail = 0;
    return true;
}

bool draw_strength(DrawingSettings& settings) {
    const Greyed greyed(settings.automatic_tone ? nullptr : "Applies to automatic tone only.");
    return slider_row(setting::tone_strength, settings.tone_strength);
}

bool draw_levels(Tone& tone, const Tone& usual) {
    constexpr float kGap = 0.01f;  // black stays below white
    bool changed = false;
    if (slider_row(setting::black_point, tone.black_point, {.usual = usual.black_point})) {
        tone.black_point = std::min(tone.black_point, 1 - kGap);
        tone.white_point = std::max(tone.white_point, tone.black_point + kGap);
        changed = true;
    }
    if (slider_row(setting::white_point, tone.white_point, {.usual = usual.white_point})) {
        tone.white_point = std::max(tone.white_point, kGap);
        tone.black_point = std::min(tone.black_point, tone.white_point - kGap);
        changed = true;
    }
    changed |= slider_row(setting::contrast, tone.contrast);
    changed |= slider_row(setting::brightness, tone.brightness);
    changed |= slider_row(setting::gamma, tone.gamma, {.usual = usual.gamma});
    return changed;
}

// The usual one is automatic again: the next picture has its own.
bool draw_exposure(DrawingSettings& settings, const ToneInfo& info) {
    float stops = settings.automatic_exposure ? info.usual_exposure : settings.tone.exposure;
    const bool changed = slider_row(setting::exposure, stops,
                                    {.usual = info.usual_exposure,
                                     .track = Track{std::min(-8.0, info.usual_exposure - 4.0),
                                                    std::max(8.0, info.usual_exposure + 4.0)}});
    if (changed) {
        settings.automatic_exposure = stops == info.usual_exposure;
        settings.tone.exposure = settings.automatic_exposure ? 0 : stops;
    }
    return changed;
}

// What its own sizes or lines make of black is not asked.
const char* why_no_black(const DrawingSettings& settings) {
    if (settings.style != DrawingStyle::dots) return "Applies to dots only.";
    return settings.dot_size.sizing == DotSizing::by_tone ? "Dots sized by tone grow until black is solid."
                                                          : nullptr;
}

// True light draws the picture as it is.
bool is_true_light(const DrawingSettings& settings) {
    return !settings.automatic_tone && settings.tone == without_curve(settings.tone);
}

// Where none is chosen it follows the number of dots, with automatic tone, or is solid.
bool draw_black(DrawingSettings& settings, const ToneInfo& info) {
    const Greyed greyed(why_no_black(settings));
    std::optional<double>& black = settings.tone.black;
    const double automatic = info.usual.black.value_or(1), none = settings.automatic_tone ? automatic : 1;
    double shown = black.value_or(none);
    if (!slider_row(setting::black, shown, {.usual = is_true_light(settings) ? 1 : automatic})) return false;
    black = shown;
    if (shown == none) black.reset();
    return true;
}

// Light ink, or dark ink again; in colour where dots would go into a black ground.
bool draw_light_ink(DrawingSettings& settings, bool mostly_black) {
    const bool light = !settings.tone.invert;
    if (mostly_black) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(ImGuiCol_ButtonActive));
    const bool pressed = wide_button(
        light ? "White ink on black paper" : "Black ink on white paper",
        mostly_black ? "Nearly all dots go into black: this draws the light of the picture instead."
        : light      ? "Draws the light of a dark picture instead of its darkness."
                     : "Draws the darkness of the picture again.");
    if (mostly_black) ImGui::PopStyleColor();
    if (!pressed) return false;
    settings.tone.invert = light;
    settings.ink = light ? kWhite : kBlack;
    settings.paper = light ? kBlack : kWhite;
    return true;
}

// The tone with what automatic tone chooses in the place of its curve.
Tone as_chosen(const Tone& tone, const Tone& usual) {
    Tone chosen = without_curve(tone);
    chosen.black_point = usual.black_point;
    chosen.white_point = usual.white_point;
    chosen.gamma = usual.gamma;
    return chosen;
}

void take_own_tone(DrawingSettings& settings, const Tone& tone, const Tone& usual) {
    settings.automatic_tone = tone == as_chosen(tone, usual);
    settings.tone = settings.automatic_tone ? without_curve(tone) : tone;
    if (settings.automatic_tone && tone.black == usual.black) settings.tone.black.reset();
}

}  // namespace

bool draw_tone_panel(DrawingSettings& settings, const ToneInfo& info) {
    bool changed = draw_source(settings, info.drawn);
    changed |= draw_strength(settings);
    changed |= draw_exposure(settings, info);
    Tone shown = settings.automatic_tone ? info.drawn : settings.tone;
    bool own = draw_histogram(info.histogram, shown);
    own |= draw_levels(shown, info.usual);
    if (own) take_own_tone(settings, shown, info.usual);
    changed |= own;
    Tone& tone = settings.tone;
    changed |= slider_row(setting::detail, tone.detail, {.usual = is_true_light(settings) ? 0 : kAutoDetail});
    changed |= draw_black(settings, info);
    changed |= slider_row(setting::blur, tone.blur);
    changed |= switch_row(setting::invert, tone.invert);
    return draw_light_ink(settings, info.mostly_black) || changed;
}

}  // namespace dapple
