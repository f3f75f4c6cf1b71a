#pragma once
// How finely dots are sampled on screen, so that they cover as much of the page there as they do in a file.
//
// Each pixel of the canvas is a square of samples. Large dots have a soft edge and look smooth with one
// sample a pixel. Small ones need more: where dots overlap they unite, and how much two of them cover
// together cannot be told from how much of a pixel each of them covers.

#include <glm/vec2.hpp>

namespace dapple {

enum class Fineness {
    quick,  // as light and as dark, but grainy where dots are small
    full,
};

/// What OpenGL and its memory allow.
struct SampleLimits {
    int largest_side = 8192;  // samples
    double most = 32e6;       // samples in all
};

/// The samples of a pixel's side, 1 to 128: what dots of that radius (pixels, above 0) need, as far as the
/// limits allow on so many pixels. Quick takes 2.5 million samples in all at most.
int samples_per_side(double dot_radius, glm::ivec2 pixels, Fineness fineness,
                     const SampleLimits& limits = {});

}  // namespace dapple
