#pragma once

#include "core/image/tone.h"

namespace dapple {

/// The darkroom's sliders. True while one changes the tone.
bool draw_tone_panel(Tone& tone);

}  // namespace dapple
