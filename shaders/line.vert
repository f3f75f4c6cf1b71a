#version 330 core
// A line of a pen with round ends, as a rectangle around it.
layout(location = 0) in vec4 ends;         // page units: from x, y, to x, y
layout(location = 1) in vec4 line_colour;  // its pen
layout(location = 2) in float line_width;  // page units

uniform vec2 page_scale;   // page units to samples
uniform vec2 page_offset;  // samples
uniform vec2 canvas;       // samples
uniform float grow;        // of all widths
uniform bool by_pen;       // or else the ink is left to the page

flat out vec2 from;       // samples
flat out vec2 to;
flat out float radius;    // samples
flat out float softness;  // width of the edge in samples
flat out vec4 ink;        // linear light
flat out int pen;         // of several, or -1

void main() {
    ink = vec4(1.0);
    pen = by_pen ? int(line_colour.r * 255.0 + 0.5) : -1;
    float half_width = 0.5 * line_width * grow * page_scale.x;
    // As dot.vert has it: what is finer than a sample is right on average with a hard edge.
    softness = clamp(half_width / 3.0, 0.001, 1.0);
    radius = half_width;
    float reach = radius + 0.5 * softness;
    vec2 a = ends.xy * page_scale + page_offset, b = ends.zw * page_scale + page_offset;
    vec2 way = b - a;
    float apart = length(way);
    vec2 along = apart > 0.0 ? way / apart : vec2(1.0, 0.0);
    vec2 aside = vec2(-along.y, along.x);
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    vec2 place = mix(a - along * reach, b + along * reach, corner.x) + aside * (2.0 * corner.y - 1.0) * reach;
    from = a;
    to = b;
    gl_Position = vec4(place / canvas * 2.0 - 1.0, 0.0, 1.0);
}
