#version 330 core
// A disc with an edge one pixel wide. `strength` makes the ink laid down equal the disc's area however small
// it is.
in vec2 from_centre;  // pixels; of use on squares only

flat in float presence;
flat in vec3 ink;

uniform float radius;  // pixels, at least 1/2
uniform float strength;
uniform bool sprite;

out vec4 colour;

void main() {
    vec2 offset = sprite ? (gl_PointCoord - 0.5) * (2.0 * radius + 2.0) : from_centre;
    float cover = clamp(radius + 0.5 - length(offset), 0.0, 1.0);
    if (cover <= 0.0) discard;
    colour = vec4(ink, cover * strength * presence);
}
