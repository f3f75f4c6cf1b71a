#version 330 core
// All that lies within the pen's radius of a line.
flat in vec2 from;       // samples, y up
flat in vec2 to;
flat in float radius;    // samples
flat in float softness;  // width of the edge in samples
flat in vec4 ink;        // linear light

out vec4 colour;

void main() {
    vec2 way = to - from, p = gl_FragCoord.xy - from;
    float square = dot(way, way);
    float share = square > 0.0 ? clamp(dot(p, way) / square, 0.0, 1.0) : 0.0;
    float cover = clamp((radius - length(p - share * way)) / softness + 0.5, 0.0, 1.0);
    if (cover <= 0.0) discard;
    colour = ink * cover;
}
