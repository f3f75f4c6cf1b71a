#version 330 core
// A disc of ink.
flat in vec2 centre;     // samples, y up
flat in float radius;    // samples
flat in float softness;  // width of the edge in samples
flat in vec4 ink;        // linear light, times the alpha beside it

out vec4 colour;

void main() {
    // Not from gl_PointCoord: how large a point really is, is for the driver to round.
    float cover = clamp((radius - distance(gl_FragCoord.xy, centre)) / softness + 0.5, 0.0, 1.0);
    if (cover <= 0.0) discard;
    colour = ink * cover;
}
