#version 330 core
// A disc of ink.
flat in vec2 centre;     // samples
flat in float radius;    // samples
flat in float softness;  // width of the edge in samples
flat in vec4 ink;        // linear light, times the alpha beside it

flat in int pen;  // of several; -1: ink is what it says

layout(location = 0) out vec4 colour;
layout(location = 1) out vec4 of_pens_4_to_7;
layout(location = 2) out vec4 of_pens_8_to_11;

void main() {
    // Not from gl_PointCoord: how large a point really is, is for the driver to round.
    float cover = clamp((radius - distance(gl_FragCoord.xy, centre)) / softness + 0.5, 0.0, 1.0);
    if (cover <= 0.0) discard;
    colour = ink * cover;
    if (pen < 0) return;
    ivec4 place = ivec4(pen, pen - 1, pen - 2, pen - 3);
    colour = vec4(equal(place, ivec4(0))) * ink.a * cover;
    of_pens_4_to_7 = vec4(equal(place, ivec4(4))) * ink.a * cover;
    of_pens_8_to_11 = vec4(equal(place, ivec4(8))) * ink.a * cover;
}
