#version 330 core
// The desk, the sheet's shadow, the sheet and the picture faintly on it.
uniform vec2 page_min;  // pixels, y down
uniform vec2 page_max;
uniform float canvas_height;
uniform float shadow;  // width in pixels
uniform vec3 desk;
uniform vec3 paper;
uniform float picture_opacity;
uniform sampler2D picture;

out vec4 colour;

void main() {
    vec2 pixel = vec2(gl_FragCoord.x, canvas_height - gl_FragCoord.y);
    vec2 outside = max(max(page_min - pixel, pixel - page_max), 0.0);
    vec2 lowered = pixel - vec2(0.0, shadow * 0.25);
    vec2 from_sheet = max(max(page_min - lowered, lowered - page_max), 0.0);
    float shade = exp(-length(from_sheet) / shadow * 3.0) * 0.22;
    vec2 edge = clamp(0.5 + min(pixel - page_min, page_max - pixel), 0.0, 1.0);
    vec3 sheet = paper;
    if (picture_opacity > 0.0 && outside == vec2(0.0)) {
        vec4 texel = texture(picture, (pixel - page_min) / (page_max - page_min));
        sheet = mix(paper, texel.rgb, picture_opacity * texel.a);
    }
    colour = vec4(mix(desk * (1.0 - shade), sheet, edge.x * edge.y), 1.0);
}
