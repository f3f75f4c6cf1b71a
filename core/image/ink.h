#pragma once
// How much paper dots cover: from their number and size to what is seen, and back.

namespace dapple {

/// The share of paper that dots of a given total area cover, 0..1: evenly spread dots overlap late, and then
/// as chance would have it. load = number of dots * area of one / area of paper, >= 0. Measured on dots that
/// this program places.
float coverage_of_load(float load);

/// The inverse: the load that covers so much; coverage is clamped to what kFullLoad covers.
float load_of_coverage(float coverage);

/// The load at density 1: what black is drawn with.
inline constexpr float kFullLoad = 1.6f;

/// The dot radius, in page units, with which a drawing at that scale has the photograph's tone.
double radius_for_tone(double scale);

}  // namespace dapple
