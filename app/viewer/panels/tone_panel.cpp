#include "app/viewer/panels/settings_panels.h"

#include <algorithm>

#include "app/viewer/widgets/widgets.h"
#include "core/image/auto_tone.h"
#include "core/image/detail.h"
#include "core/settings/setting.h"

namespace dapple {
namespace {

// A tone without black and white point and the curve between them.
Tone without_curve(const Tone& tone) {
    return {.exposure = tone.exposure,
            .blur = tone.blur,
            .detail = tone.detail,
            .black = tone.black,
            .invert = tone.invert};
}

bool is_true_light(const DrawingSettings& settings) {
    return !settings.automatic_tone && settings.tone == without_curve(settings.tone);
}

// One slider from true light to automatic tone. A tone of the person's own is neither: moving the slider
// leaves it.
bool draw_automatic(DrawingSettings& settings) {
    const bool automatic = settings.automatic_tone;
    const bool is_true = is_true_light(settings);
    double strength = is_true ? 0 : settings.tone_strength;
    const char* const format = is_true || (automatic && strength == 0) ? "true"
                               : automatic                             ? nullptr
                                                                       : "custom";
    if (!slider_row(setting::tone_strength, strength, {.format = format})) return false;
    Tone& tone = settings.tone;
    tone = without_curve(tone);
    settings.automatic_tone = strength > 0;
    if (settings.automatic_tone) settings.tone_strength = strength;
    if (settings.automatic_tone && automatic) return true;
    tone.black.reset();
    tone.detail = settings.automatic_tone ? kAutoDetail : 0;
    return true;
}

bool draw_levels(Tone& tone, const Tone& usual) {
    constexpr float kLeastGap = 0.01f;  // black stays below white
    bool changed = false;
    if (slider_row(setting::black_point, tone.black_point, {.usual = usual.black_point})) {
        tone.black_point = std::min(tone.black_point, 1 - kLeastGap);
        tone.white_point = std::max(tone.white_point, tone.black_point + kLeastGap);
        changed = true;
    }
    if (slider_row(setting::white_point, tone.white_point, {.usual = usual.white_point})) {
        tone.white_point = std::max(tone.white_point, kLeastGap);
        tone.black_point = std::min(tone.black_point, tone.white_point - kLeastGap);
        changed = true;
    }
    return slider_row(setting::gamma, tone.gamma, {.usual = usual.gamma}) || changed;
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

// Where none is chosen it follows the number of dots, with automatic tone, or is solid.
bool draw_black(DrawingSettings& settings, const ToneInfo& info) {
    const Absent absent(why_no_black(settings));
    std::optional<double>& black = settings.tone.black;
    const double automatic = info.usual.black.value_or(1), none = settings.automatic_tone ? automatic : 1;
    double shown = black.value_or(none);
    if (!slider_row(setting::black, shown, {.usual = is_true_light(settings) ? 1 : automatic})) return false;
    black = shown;
    if (shown == none) black.reset();
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

bool draw_photograph(float& opacity) {
    double percent = 100 * double{opacity};
    if (!slider_row("Photo beneath", percent,
                    {.max = 100,
                     .format = "%.0f %%",
                     .tip = "How much of the photograph shows under the dots; hold C to see all of it. "
                            "Exports leave it out."}))
        return false;
    opacity = static_cast<float>(percent / 100);
    return true;
}

}  // namespace

bool draw_tone_panel(DrawingSettings& settings, const ToneInfo& info) {
    if (!section("Tone")) return false;
    bool changed = draw_automatic(settings);
    Tone shown = settings.automatic_tone ? info.drawn : settings.tone;
    bool own = draw_histogram(info.histogram, shown);
    own |= slider_row(setting::brightness, shown.brightness);
    own |= slider_row(setting::contrast, shown.contrast);
    changed |= slider_row(setting::detail, settings.tone.detail,
                          {.usual = is_true_light(settings) ? 0 : kAutoDetail});
    shown.detail = settings.tone.detail;
    const bool more = subsection("More tone settings", false);
    if (more) {
        changed |= draw_exposure(settings, info);
        own |= draw_levels(shown, info.usual);
    }
    if (own) take_own_tone(settings, shown, info.usual);
    if (more) {
        changed |= draw_black(settings, info);
        changed |= slider_row(setting::blur, settings.tone.blur);
        changed |= switch_row(setting::invert, settings.tone.invert);
        if (info.photograph) changed |= draw_photograph(*info.photograph);
    }
    return changed || own;
}

}  // namespace dapple
