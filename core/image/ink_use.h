#pragma once
// What ink a tone takes for a picture of a given histogram. Blur and detail are left out.

#include "core/image/histogram.h"
#include "core/image/tone.h"

namespace dapple {

/// The mean share of paper that ink covers, 0..1. 0 for an empty histogram.
double mean_ink(const Histogram& histogram, const Tone& tone);

/// The mean of density_of(), 0..1. 0 for an empty histogram.
double mean_density(const Histogram& histogram, const Tone& tone, const InkCurve& ink);

/// The share of the dots, 0..1, that falls into nearly black parts: those whose encoded value is in the
/// lowest fifth of the range from the tone's black point to its white point. 0 without dots.
double dots_in_black(const Histogram& histogram, const Tone& tone);

/// Whether nine tenths of the dots would only draw a ground that is nearly black and covers 0.7 of the
/// picture, so that light ink on black paper would draw it better. True for a night sky (0.95 and more of the
/// dots) and for a small subject before black. False for a portrait before a dark coat or a landscape at
/// dusk, whose subjects take more than a tenth of the dots, and for a line drawing, most of which is white.
/// Never for a tone that is inverted already.
bool mostly_black(const Histogram& histogram, const Tone& tone);

}  // namespace dapple
