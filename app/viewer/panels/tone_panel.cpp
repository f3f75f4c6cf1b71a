#include "app/viewer/panels/tone_panel.h"

#include <algorithm>

#include "app/viewer/widgets.h"

namespace dapple {

bool draw_tone_panel(Tone& tone) {
    if (!section("Tone")) return false;
    constexpr float kGap = 0.01f;  // black stays below white
    bool changed = false;
    if (slider_row("Black point", tone.black_point, {.min = 0, .max = 1, .neutral = 0})) {
        tone.black_point = std::min(tone.black_point, 1 - kGap);
        tone.white_point = std::max(tone.white_point, tone.black_point + kGap);
        changed = true;
    }
    if (slider_row("White point", tone.white_point, {.min = 0, .max = 1, .neutral = 1})) {
        tone.white_point = std::max(tone.white_point, kGap);
        tone.black_point = std::min(tone.black_point, tone.white_point - kGap);
        changed = true;
    }
    changed |= slider_row("Contrast", tone.contrast, {.min = -1, .max = 1, .neutral = 0});
    changed |= slider_row("Brightness", tone.brightness, {.min = -1, .max = 1, .neutral = 0});
    changed |= slider_row("Gamma", tone.gamma,
                          {.min = 0.25,
                           .max = 4,
                           .neutral = 1,
                           .curve = SliderCurve::logarithmic,
                           .hard_min = 0.1,
                           .hard_max = 10});
    changed |=
        slider_row("Blur", tone.blur,
                   {.min = 0, .max = 20, .neutral = 0, .format = "%.1f", .hard_min = 0, .hard_max = 100});
    changed |= switch_row("Invert", tone.invert);
    return changed;
}

}  // namespace dapple
