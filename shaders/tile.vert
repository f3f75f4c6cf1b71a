#version 330 core
// A tile's outline and the letter F in its middle, which tells its orientation and by its colour its kind:
// seven bars, 42 corners, one instance a tile.
layout(location = 0) in vec4 box;   // low x, y, high x, y in page units
layout(location = 1) in vec3 look;  // level; orientation 0..7, or -1: no letter; kind, or -1: there is one

uniform vec2 page_scale;
uniform vec2 page_offset;
uniform vec2 canvas;
uniform float line_width;  // pixels
uniform vec3 level_colours[12];
uniform vec3 kind_colours[64];

flat out vec4 line_colour;

const vec2 kCorners[6] = vec2[](vec2(0, 0), vec2(1, 0), vec2(1, 1), vec2(0, 0), vec2(1, 1), vec2(0, 1));

// The letter's strokes about its middle, y down: from, to.
const vec4 kLetter[3] = vec4[](vec4(-0.55, -0.9, -0.55, 0.9), vec4(-0.55, -0.9, 0.6, -0.9),
                               vec4(-0.55, -0.1, 0.35, -0.1));

vec2 turned(vec2 v, int g) {
    if (g >= 4) v.x = -v.x;
    for (int i = 0; i < (g & 3); ++i) v = vec2(-v.y, v.x);
    return v;
}

void main() {
    int side = gl_VertexID / 6;
    vec2 corner = kCorners[gl_VertexID % 6];
    vec2 low = box.xy * page_scale + page_offset;
    vec2 high = box.zw * page_scale + page_offset;
    float level = look.x;
    float width = line_width * (level < 0.5 ? 2.0 : level < 2.5 ? 1.5 : 1.0);
    vec2 half_width = vec2(width * 0.5);
    vec2 from = low, to = high;
    if (side == 0) to.y = low.y;
    if (side == 1) from.y = high.y;
    if (side == 2) to.x = low.x;
    if (side == 3) from.x = high.x;
    float apart = max(high.x - low.x, high.y - low.y);
    // Outlines only a few pixels apart would paint everything: they fade, and letters before them.
    float strength = smoothstep(3.0, 14.0, apart) * 0.85;
    vec3 colour = level_colours[min(int(level + 0.5), 11)];
    if (side >= 4) {
        float size = min(apart * 0.09, 20.0 * line_width);
        int g = int(look.y + 0.5);
        vec2 a = turned(kLetter[side - 4].xy, g), b = turned(kLetter[side - 4].zw, g);
        vec2 middle = (low + high) * 0.5;
        from = middle + min(a, b) * size;
        to = middle + max(a, b) * size;
        half_width = vec2(size * 0.17);
        strength = look.y < 0.0 ? 0.0 : smoothstep(36.0, 60.0, apart / line_width);
        if (look.z >= 0.0) colour = kind_colours[int(look.z + 0.5)];
    }
    vec2 pixel = mix(from - half_width, to + half_width, corner);
    gl_Position = vec4(pixel / canvas * 2.0 - 1.0, 0.0, 1.0);
    line_colour = vec4(colour, strength);
}
