#pragma once
// The histogram of the picture, with handles for black, middle and white.

#include "core/image/histogram.h"
#include "core/image/tone.h"

namespace dapple {

/// Where the middle handle is: the encoded value for which ink covers half of the paper by black point, white
/// point and gamma. Contrast and brightness are left out, as they bend what these make.
float middle_of(const Tone& tone);

/// A picture's histogram above three handles that can be dragged, black point, middle and white point:
///
///        ▂▅▆▇▅▃▂▂▁▁▂▃▅▂        height: square root of how often a lightness occurs
///     ───▲──────▲──────▲───    black point 0..1, white point 0..1, at least 0.01 apart; gamma 0.25..4
///
/// A press anywhere takes the nearest handle along. Lightness that becomes plain black or white is drawn
/// paler. Fills the panel's width. True while a handle changes the tone.
bool draw_histogram(const Histogram& histogram, Tone& tone);

}  // namespace dapple
