#version 330 core
// All that lies within the pen's radius of a line.
flat in vec2 from;       // samples
flat in vec2 to;
flat in float radius;    // samples
flat in float softness;  // width of the edge in samples
flat in vec4 ink;        // linear light

flat in int pen;  // of several; -1: ink is what it says

layout(location = 0) out vec4 colour;
layout(location = 1) out vec4 of_pens_4_to_7;
layout(location = 2) out vec4 of_pens_8_to_11;

void main() {
    vec2 way = to - from, p = gl_FragCoord.xy - from;
    float square = dot(way, way);
    float share = square > 0.0 ? clamp(dot(p, way) / square, 0.0, 1.0) : 0.0;
    float cover = clamp((radius - length(p - share * way)) / softness + 0.5, 0.0, 1.0);
    if (cover <= 0.0) discard;
    colour = ink * cover;
    if (pen < 0) return;
    ivec4 place = ivec4(pen, pen - 1, pen - 2, pen - 3);
    colour = vec4(equal(place, ivec4(0))) * ink.a * cover;
    of_pens_4_to_7 = vec4(equal(place, ivec4(4))) * ink.a * cover;
    of_pens_8_to_11 = vec4(equal(place, ivec4(8))) * ink.a * cover;
}
