#pragma once
// The tone that a photograph opens with, so that its middle tones can be read.
//
// A photograph's light, drawn as it is, puts most dots into its dark half: a mid-grey has 21 % of white's
// light, so ink covers 79 % of it, where dots merge and detail ends. Therefore the encoded value, along which
// steps look even, is stretched to black and white and taken for the light, e^m with m about 1, which the
// tone settings say with a gamma of 2.2 / m.

#include "core/image/grid.h"
#include "core/image/histogram.h"
#include "core/image/tone.h"

namespace dapple {

// How much light a picture is to be drawn with: stops (powers of two) that it is multiplied by first.
//
// A photograph's light ends at the white of its paper, 1. Light as it was in front of a camera, as float
// files have it, knows no paper: a sky may be at 5 and the sun at 50,000, or all of it far below 1.

/// Further than from starlight to the sun.
inline constexpr float kMostStops = 20;

/// The exposure that light as it was in front of a camera opens with. 0 if it could be a photograph's: none
/// of it over 1, and the lightest fiftieth not all below 1/16. Else the 98th percentile becomes white, but
/// where a few lamps or a bright window would leave the rest black, or fog would be bleached, the mean of the
/// logarithm comes within 0.09 .. 0.36; in tenths of a stop. Black parts (light of 0 or less) have no say.
float usual_exposure(const Grid<float>& light);

/// The light multiplied by 2^stops. 0 returns the very same values.
Grid<float> exposed(Grid<float> light, float stops);

// What ink a tone takes for a picture of a given histogram. Blur and detail are left out.

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

/// `own` with black_point, white_point and gamma chosen from the histogram of the picture's light. Its other
/// settings stay, and are not made up for: contrast and brightness say what is wanted otherwise.
///
/// Black and white point: the 0.5th and 99.5th percentile of the encoded value; but
/// - what is further out by more than 0.35 is the subject, however small (stars, thin lines): the point comes
///   that near to it;
/// - bare paper stays bare: where 70 % of the pixels lie within 15 % of the range from the end without ink
/// (the
///   paper of a scanned page, the sky at night in light ink), the point is on their far side and half as far
///   again, so that their noise draws no dots;
/// - they are at least 0.12 apart, so that fog stays fog.
///
/// Gamma: dark ink. With c0 the share of paper that ink covers at gamma 2.2, the one that covers
/// 0.42 + (c0 - 0.42) / 2, kept within 0.30..0.62: half of the way to a well balanced page, so that a dark
/// portrait stays dark. Gamma is kept within 2.2 / 1.6 .. 2.2 / 0.6; the latter comes down to 2.2 while c0
/// goes from 0.85 to 0.97, as in a picture that is nearly all black only noise would be lightened.
///
/// Gamma: light ink. The same with the ink, which now is the light, but never lighter than gamma 2.2: dark
/// parts cost no dots and need no help, and night stays night.
///
/// A picture of one tone, or nearly, has the neutral points and gamma, 0, 1 and 1.
///
/// `strength`, 0..1: so much of the way from those to what is chosen, gamma's by its logarithm. All of it
/// brings out most of what is dark and thins what is light; less keeps both.
Tone auto_tone(const Histogram& histogram, const Tone& own, double strength = 1);

}  // namespace dapple
