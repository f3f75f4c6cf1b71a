#version 330 core
// The desk, the sheet's shadow, the sheet, the picture faintly on it and the dots. All of it upside down to
// OpenGL: y is 0 at the top.
//
// Compiled in four ways, as there are drivers that work out every branch for every pixel: as it is, which can
// draw anything; with SHEET, for pixels wholly on the sheet; with SHEET and PICTURE, if the picture shows
// there; with DESK, for pixels wholly beside the sheet.
uniform vec2 page_min;  // pixels
uniform vec2 page_max;
uniform vec2 picture_min;  // pixels: where the picture lies on the page
uniform vec2 picture_max;
uniform vec2 picture_corner;  // shares of the photograph: what is at the picture's upper left corner,
uniform vec2 picture_across;  // and the ways from there along its upper
uniform vec2 picture_down;    // and its left edge
uniform float shadow;  // width in pixels
uniform vec3 desk;     // these two sRGB-encoded
uniform vec3 paper;
uniform vec3 paper_light;
uniform float picture_opacity;
uniform float picture_gain;  // of its light
uniform sampler2D picture;
uniform sampler2D dots;    // linear light times alpha, alpha; of several pens how much each of four covers
uniform sampler2D dots_of_pens_4_to_7;
uniform sampler2D dots_of_pens_8_to_11;
uniform int pens;          // 0: none
uniform vec4 pen_inks[12]; // linear light; 1: multiplied by what lies below, 0: hides it
uniform int samples;       // of a pixel's side
uniform ivec4 dots_box;    // the pixels that have samples: low x, y, high x, y; empty: there are no dots
uniform ivec4 page_samples; // those on the page: low x, y, end x, y
uniform vec3 ink;          // linear light, to multiply the dots with

out vec4 colour;

vec3 to_light(vec3 c) {
    return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), greaterThan(c, vec3(0.04045)));
}

vec3 to_encoded(vec3 c) {
    return mix(c * 12.92, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}

// What the dots leave of the light of the sheet, and what they add to it.
struct Ink {
    vec3 through, own;
};

Ink sample_at(ivec2 place) {
    vec4 texel = texelFetch(dots, place, 0);
    if (pens == 0) return Ink(vec3(1.0 - texel.a), ink * texel.rgb);
    Ink seen = Ink(vec3(1.0), vec3(0.0));
    for (int first = 0; first < pens; first += 4) {
        if (first == 4) texel = texelFetch(dots_of_pens_4_to_7, place, 0);
        if (first == 8) texel = texelFetch(dots_of_pens_8_to_11, place, 0);
        for (int k = 0; k < min(4, pens - first); ++k) {
            vec4 its = pen_inks[first + k];
            vec3 left = 1.0 - texel[k] * (1.0 - its.rgb * its.a);
            seen = Ink(seen.through * left, seen.own * left + its.rgb * (1.0 - its.a) * texel[k]);
        }
    }
    return seen;
}

Ink dots_at(ivec2 pixel) {
    Ink seen = Ink(vec3(1.0), vec3(0.0));
    if (any(lessThan(pixel, dots_box.xy)) || any(greaterThanEqual(pixel, dots_box.zw))) return seen;
    // On the page's edges only what lies on the page counts, at least one sample.
    ivec2 corner = (pixel - dots_box.xy) * samples;
    ivec2 first = clamp(page_samples.xy, corner, corner + samples - 1);
    ivec2 end = clamp(page_samples.zw, first + 1, corner + samples);
    seen.through = vec3(0.0);
    for (int y = first.y; y < end.y; ++y)
        for (int x = first.x; x < end.x; ++x) {
            Ink one = sample_at(ivec2(x, y));
            seen.through += one.through;
            seen.own += one.own;
        }
    float count = float((end.x - first.x) * (end.y - first.y));
    return Ink(seen.through / count, seen.own / count);
}

#if !defined(SHEET) || defined(PICTURE)
vec3 sheet_at(vec2 pixel) {
    vec2 at = (pixel - picture_min) / (picture_max - picture_min);
    vec4 texel = texture(picture, picture_corner + at.x * picture_across + at.y * picture_down);
    if (any(lessThan(at, vec2(0.0))) || any(greaterThan(at, vec2(1.0)))) return paper_light;
    vec3 seen = to_encoded(min(to_light(texel.rgb) * picture_gain, 1.0));
    return to_light(mix(paper, seen, picture_opacity * texel.a));
}
#endif

#if !defined(SHEET)
// Of the desk's light, by the sheet's shadow.
float shade_at(vec2 pixel) {
    vec2 lowered = pixel - vec2(0.0, shadow * 0.25);
    vec2 from_sheet = max(max(page_min - lowered, lowered - page_max), 0.0);
    return exp(-length(from_sheet) / shadow * 3.0) * 0.22;
}
#endif

#if defined(DESK)
void main() {
    colour = vec4(desk * (1.0 - shade_at(gl_FragCoord.xy)), 1.0);
}
#else
void main() {
    vec2 pixel = gl_FragCoord.xy;
    vec3 sheet = paper_light;
#ifdef PICTURE
    sheet = sheet_at(pixel);
#endif
#ifndef SHEET
    vec2 outside = max(max(page_min - pixel, pixel - page_max), 0.0);
    if (picture_opacity > 0.0 && outside == vec2(0.0)) sheet = sheet_at(pixel);
#endif
    Ink seen = dots_at(ivec2(gl_FragCoord.xy));
    vec3 light = sheet * seen.through + seen.own;
#ifndef SHEET
    vec2 edge = clamp(0.5 + min(pixel - page_min, page_max - pixel), 0.0, 1.0);
    light = mix(to_light(desk * (1.0 - shade_at(pixel))), light, edge.x * edge.y);
#endif
    colour = vec4(to_encoded(light), 1.0);
}
#endif
