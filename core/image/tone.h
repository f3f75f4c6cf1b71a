#pragma once
// From a photograph's light to the density of dots: the darkroom.

#include <cstdint>
#include <optional>

#include "core/image/grid.h"
#include "core/image/ink.h"

namespace dapple {

/// What the tone sliders say. Exposure comes first, in stops of light. Levels, contrast, brightness and gamma
/// act on the sRGB-encoded value, 0 black to 1 white, as in photo editors; blur acts on light, and so would
/// detail, whose scale only the caller knows. The defaults change nothing: the ink covers the light that the
/// photograph lacks. Inverted, for ink that is lighter than its paper, it covers the light that the
/// photograph has, so the other settings do to what is seen what they do for dark ink.
struct Tone {
    float exposure = 0;     // stops, see exposed(); not applied by density_of()
    float black_point = 0;  // encoded value drawn as black; 0..1, below white_point
    float white_point = 1;  // encoded value drawn as white
    float contrast = 0;     // -1 flat grey .. 0 as it is .. 1 hard
    float brightness = 0;   // -1..1, added
    float gamma = 1;        // 0.1..10, over 1 brightens the middle tones
    float blur = 0;         // standard deviation in thousandths of the longer side, 0..100
    float detail = 0;       // amount of with_detail(), 0..1; not applied by density_of()
    /// How solid black gets: InkedDots::black, 0.5..1; none: usual_black() where the tone is automatic,
    /// else 1. Not applied by density_of(), whose ink curve says it.
    std::optional<double> black = {};
    bool invert = false;  // white ink on black paper

    bool operator==(const Tone&) const = default;
};

/// sRGB transfer function (IEC 61966-2-1), encoded value 0..1 to linear light 0..1, and back.
float srgb_to_linear(float encoded);
float linear_to_srgb(float linear);
/// The same as one of 256 steps, rounded, without the time that a power takes. Clamped; NaN is 0.
std::uint8_t srgb_byte(float linear);

/// The density 0..1 of a picture of linear light (0 black, 1 white; other values are clamped, NaN is white).
/// Leaves tone.detail out: its scale follows from the number of dots, so whoever knows that applies
/// with_detail() first, and exposed() before that. `ink` says which density covers how much, and how solid
/// black gets. Takes the picture by value so that a large one can be turned in place.
Grid<float> density_of(Grid<float> light, const Tone& tone, const InkCurve& ink = InkCurve());

/// The light that is to be seen, 0..1, by the same settings but for inverting.
Grid<float> toned_light(Grid<float> light, const Tone& tone);

}  // namespace dapple
