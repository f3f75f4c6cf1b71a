#version 330 core
// A dot as a square of two triangles: for dots larger than the point size that OpenGL offers.
layout(location = 0) in float dot_x;  // page units, one a dot
layout(location = 1) in float dot_y;
layout(location = 2) in float dot_critical;  // the scale from which it exists
layout(location = 3) in vec4 dot_colour;     // the ink for all of them, or one each

uniform vec2 page_scale;   // page units to pixels
uniform vec2 page_offset;  // pixels
uniform vec2 canvas;       // pixels, with the guard band
uniform float radius;      // pixels
uniform float fade_scale;  // dots are all there a seventh above their critical scale; 0: all are

out vec2 from_centre;  // pixels
flat out float presence;  // 0..1
flat out vec3 ink;

void main() {
    ink = dot_colour.rgb;  // hidden if alpha is 0
    presence = fade_scale > 0.0 ? smoothstep(0.0, 0.15, fade_scale / dot_critical - 1.0) : 1.0;
    presence *= dot_colour.a;
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    from_centre = corner * (radius + 1.0);
    vec2 pixel = vec2(dot_x, dot_y) * page_scale + page_offset + from_centre;
    gl_Position = vec4(pixel.x / canvas.x * 2.0 - 1.0, 1.0 - pixel.y / canvas.y * 2.0, 0.0, 1.0);
}
