#version 330 core
// A dot as a point sprite or, where it is larger than OpenGL's points get, as a square of two triangles.
layout(location = 0) in float dot_x;  // page units
layout(location = 1) in float dot_y;
layout(location = 2) in float dot_critical;  // the scale from which it exists
layout(location = 3) in vec4 dot_colour;     // sRGB-encoded, or its pen; white for all if the ink is left to the page
layout(location = 4) in float dot_radius;    // page units, one for all or one each

uniform vec2 page_scale;   // page units to samples
uniform vec2 page_offset;  // samples
uniform vec2 canvas;       // samples, with the guard band
uniform float guard;       // samples
uniform float fade_scale;  // dots are all there a seventh above their critical scale; 0: all are
uniform bool coloured;
uniform bool by_pen;
uniform bool sprite;
uniform float point_step;  // sizes of points may be rounded by so much

flat out vec2 centre;      // samples
flat out float radius;     // samples
flat out float softness;   // width of the edge in samples
flat out vec4 ink;         // linear light, times the alpha beside it
flat out int pen;          // of several, or -1

vec3 to_light(vec3 c) {
    return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), greaterThan(c, vec3(0.04045)));
}

void main() {
    float presence = fade_scale > 0.0 ? smoothstep(0.0, 0.15, fade_scale / dot_critical - 1.0) : 1.0;
    presence *= dot_colour.a;  // hidden if it is 0
    pen = by_pen ? int(dot_colour.r * 255.0 + 0.5) : -1;
    ink = vec4((coloured ? to_light(dot_colour.rgb) : vec3(1.0)) * presence, presence);

    float true_radius = dot_radius * page_scale.x;
    // Blending unites two dots' edges in a sample as if they lay there by chance, but dots keep their distance
    // and cover more: the harder the edge, the less of that. A disc without a soft edge is right on average
    // however small it is.
    softness = clamp(true_radius / 6.0, 0.001, 1.0);
    // A disc with an edge of width w covers pi (r^2 + w^2 / 12).
    radius = sqrt(max(true_radius * true_radius - softness * softness / 12.0, 0.0));
    float reach = radius + 0.5 * softness;

    vec2 place = vec2(dot_x, dot_y) * page_scale + page_offset;
    centre = place - guard;
    gl_PointSize = 2.0 * reach + point_step;
    if (!sprite) place += (vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0) * reach;
    gl_Position = vec4(presence > 0.0 ? place / canvas * 2.0 - 1.0 : vec2(2.0), 0.0, 1.0);
}
