#version 330 core
// Tiles cover a square, the page need not be one: what lies over its edges is left out, but for the outer
// halves of the lines along them.
flat in vec4 line_colour;

uniform vec2 page_min;  // pixels
uniform vec2 page_max;
uniform float line_width;  // pixels

out vec4 colour;

void main() {
    vec2 outside = max(page_min - gl_FragCoord.xy, gl_FragCoord.xy - page_max);
    if (max(outside.x, outside.y) > line_width) discard;
    colour = line_colour;
}
