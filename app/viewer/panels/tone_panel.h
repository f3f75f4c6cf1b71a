#pragma once
// The section "Tone": how dark the drawing is where the picture is.

#include "core/drawing/settings.h"
#include "core/image/histogram.h"

namespace dapple {

/// What the picture and its drawing came to.
struct ToneInfo {
    Histogram histogram{};        // of the picture; empty: none is shown
    Tone drawn{};                 // with the values that were chosen automatically
    float usual_exposure = 0;     // what automatic exposure comes to
    Tone usual{};                 // with the values that automatic tone chooses or would choose
    float* photograph = nullptr;  // how much of it shows under the dots; none: no row for it
};

/// The darkroom: from true light to automatic tone, the histogram with its handles, the sliders, which show
/// what is drawn. Moving one of these makes the tone the person's own; with all of them where automatic tone
/// has them it is automatic again. True while something changes.
bool draw_tone_panel(DrawingSettings& settings, const ToneInfo& info);

}  // namespace dapple
