#pragma once
// The tone, rows of the section "Picture": how dark the drawing is where the picture is.

#include "core/drawing/settings.h"
#include "core/image/histogram.h"

namespace dapple {

/// What the picture and its drawing came to.
struct ToneInfo {
    Histogram histogram{};      // of the picture; empty: none is shown
    Tone drawn{};               // with the values that were chosen automatically
    float usual_exposure = 0;   // what automatic exposure comes to
    Tone usual{};               // with the values that automatic tone chooses or would choose
    bool mostly_black = false;  // light ink would draw it better; see core/image/ink_use.h
};

/// The darkroom: automatic tone, true light or the person's own, the histogram with its handles, the sliders,
/// which show what is drawn. Moving one of them makes the tone the person's own; with all of them where
/// automatic tone has them it is automatic again. True while something changes.
bool draw_tone_panel(DrawingSettings& settings, const ToneInfo& info);

}  // namespace dapple
