// The page with its dots: by WebGL 2, blended in linear light as the files' pixels are; without it by a plain canvas.

const linear = (byte) => (byte <= 0.04045 ? byte / 12.92 : ((byte + 0.055) / 1.055) ** 2.4);
const rgbOf = (hex) => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16) / 255);
const hexOf = (rgb) => "#" + rgb.map((c) => Math.round(c * 255).toString(16).padStart(2, "0")).join("");

// Six vertices a dot, which lies in a texture: where no card draws, instances of four take ten times as long.
const ROW = 2048;  // dots in a row of the texture
const DOT_VERTEX = `#version 300 es
uniform highp sampler2D dots;  // x, y and radius in millimetres, pen
uniform float zoom;     // pixels a millimetre
uniform vec2 offset;    // of the page, pixels
uniform vec2 size;      // of the canvas, pixels
uniform vec3 pens[16];  // linear light
out vec2 from_centre;   // pixels
flat out float radius;
flat out vec4 ink;
const int CORNERS[6] = int[](0, 1, 2, 2, 1, 3);
void main() {
    int which = gl_VertexID / 6, corner = CORNERS[gl_VertexID % 6];
    vec4 dot = texelFetch(dots, ivec2(which % ${ROW}, which / ${ROW}), 0);
    // Dots smaller than a pixel become paler instead of smaller.
    float true_radius = dot.z * zoom;
    radius = max(true_radius, 0.6);
    ink = vec4(pens[int(dot.w)], 1.0) * min(true_radius * true_radius / (radius * radius), 1.0);
    from_centre = (vec2(corner & 1, corner >> 1) * 2.0 - 1.0) * (radius + 0.5);
    vec2 place = (dot.xy * zoom + offset + from_centre) / size * 2.0 - 1.0;
    gl_Position = vec4(place.x, -place.y, 0.0, 1.0);
}`;
const DOT_FRAGMENT = `#version 300 es
precision highp float;
in vec2 from_centre;
flat in float radius;
flat in vec4 ink;
out vec4 colour;
void main() {
    float cover = clamp(radius - length(from_centre) + 0.5, 0.0, 1.0);
    if (cover <= 0.0) discard;
    colour = ink * cover;
}`;
// From linear light to what the screen takes.
const SCREEN_VERTEX = `#version 300 es
void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }`;
const SCREEN_FRAGMENT = `#version 300 es
precision highp float;
uniform sampler2D light;
out vec4 colour;
void main() {
    vec3 c = texelFetch(light, ivec2(gl_FragCoord.xy), 0).rgb;
    colour = vec4(mix(c * 12.92, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308))), 1.0);
}`;

function program(gl, ...sources) {
    const made = gl.createProgram();
    [gl.VERTEX_SHADER, gl.FRAGMENT_SHADER].forEach((kind, i) => {
        const shader = gl.createShader(kind);
        gl.shaderSource(shader, sources[i]);
        gl.compileShader(shader);
        gl.attachShader(made, shader);
    });
    gl.linkProgram(made);
    if (!gl.getProgramParameter(made, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(made));
    return made;
}

// Both painters: setDots(Float32Array, side), and paint(look), where look says size, zoom, offset, page {width, height},
// paper, surround, line (colours in hex), pens, whether their inks are transparent, and split: none, or where side 1 begins.
function paintByWebGL(gl) {
    const dots = program(gl, DOT_VERTEX, DOT_FRAGMENT), screen = program(gl, SCREEN_VERTEX, SCREEN_FRAGMENT);
    const place = (name) => gl.getUniformLocation(dots, name);
    const textureOf = (unit) => {
        const texture = gl.createTexture();
        gl.activeTexture(unit);
        gl.bindTexture(gl.TEXTURE_2D, texture);
        for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
        return texture;
    };
    const sides = [0, 1].map(() => ({texture: textureOf(gl.TEXTURE1), count: 0, rows: 0}));
    const frame = gl.createFramebuffer(), texture = textureOf(gl.TEXTURE0);
    let held = [0, 0];

    return {
        setDots(positions, which) {
            const side = sides[which], count = positions.length / 4, full = Math.floor(count / ROW), rows = Math.ceil(count / ROW);
            gl.activeTexture(gl.TEXTURE1);
            gl.bindTexture(gl.TEXTURE_2D, side.texture);
            if (side.rows !== rows) gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, ROW, rows, 0, gl.RGBA, gl.FLOAT, null);
            Object.assign(side, {count, rows});
            const put = (row, wide, high) => {
                if (wide * high > 0) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, row, wide, high, gl.RGBA, gl.FLOAT, positions, 4 * ROW * row);
            };
            put(0, ROW, full);
            put(full, count - ROW * full, 1);
            gl.activeTexture(gl.TEXTURE0);
        },
        paint({size, zoom, offset, page, paper, surround, line, pens, transparent, split}) {
            if (held[0] !== size[0] || held[1] !== size[1])
                gl.texImage2D(gl.TEXTURE_2D, 0, gl.SRGB8_ALPHA8, ...(held = size), 0, gl.RGBA, gl.UNSIGNED_BYTE, null);
            gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
            gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
            gl.viewport(0, 0, ...size);
            const [left, top] = offset.map(Math.round), [wide, high] = [page.width, page.height].map((mm) => Math.round(mm * zoom));
            // Pixels from `from` to `to` alone, on the page and so much around it.
            const within = (border, from = left - border, to = left + wide + border) =>
                gl.scissor(Math.max(from, left - border), size[1] - top - high - border,
                           Math.max(Math.min(to, left + wide + border) - Math.max(from, left - border), 0), high + 2 * border);
            const fill = (hex) => {
                gl.clearColor(...rgbOf(hex).map(linear), 1);
                gl.clear(gl.COLOR_BUFFER_BIT);
            };
            gl.disable(gl.SCISSOR_TEST);
            fill(surround);
            gl.enable(gl.SCISSOR_TEST);
            within(1);
            fill(line);
            within(0);
            fill(paper);
            gl.enable(gl.BLEND);
            gl.blendFunc(transparent ? gl.DST_COLOR : gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
            gl.useProgram(dots);
            gl.uniform1f(place("zoom"), zoom);
            gl.uniform2f(place("offset"), ...offset);
            gl.uniform2f(place("size"), ...size);
            gl.uniform1i(place("dots"), 1);
            gl.uniform3fv(place("pens"), pens.flatMap((pen) => pen.colour.map(linear)));
            gl.activeTexture(gl.TEXTURE1);
            for (const [side, {texture: positions, count}] of sides.slice(0, split === undefined ? 1 : 2).entries()) {
                if (split !== undefined) within(0, side ? split : undefined, side ? undefined : split);
                gl.bindTexture(gl.TEXTURE_2D, positions);
                gl.drawArrays(gl.TRIANGLES, 0, 6 * count);
            }
            gl.activeTexture(gl.TEXTURE0);
            gl.disable(gl.BLEND);
            gl.disable(gl.SCISSOR_TEST);
            gl.bindFramebuffer(gl.FRAMEBUFFER, null);
            gl.useProgram(screen);
            gl.drawArrays(gl.TRIANGLES, 0, 3);
        },
    };
}

function paintPlainly(context) {
    const of_sides = [new Float32Array(), new Float32Array()];
    return {
        setDots(positions, side) { of_sides[side] = positions; },
        paint({size, zoom, offset, page, paper, surround, line, pens, transparent, split}) {
            const [x, y] = offset.map(Math.round), sides = [page.width * zoom, page.height * zoom].map(Math.round);
            context.setTransform(1, 0, 0, 1, 0, 0);
            context.fillStyle = surround;
            context.fillRect(0, 0, ...size);
            context.fillStyle = line;
            context.fillRect(x - 1, y - 1, sides[0] + 2, sides[1] + 2);
            context.fillStyle = paper;
            context.fillRect(x, y, ...sides);
            for (const [side, dots] of of_sides.slice(0, split === undefined ? 1 : 2).entries()) {
                context.save();
                context.beginPath();
                context.rect(x, y, ...sides);
                context.clip();
                context.beginPath();
                context.rect(side ? split : 0, 0, side ? size[0] : split ?? size[0], size[1]);
                context.clip();
                if (transparent) context.globalCompositeOperation = "multiply";
                pens.forEach((pen, which) => {
                    context.fillStyle = hexOf(pen.colour);
                    context.beginPath();
                    for (let i = 0; i < dots.length; i += 4) {
                        if (dots[i + 3] !== which) continue;
                        const cx = dots[i] * zoom + offset[0], cy = dots[i + 1] * zoom + offset[1], r = dots[i + 2] * zoom;
                        if (cx + r < 0 || cy + r < 0 || cx - r > size[0] || cy - r > size[1]) continue;
                        context.moveTo(cx + r, cy);
                        context.arc(cx, cy, r, 0, 7);
                    }
                    context.fill();
                });
                context.restore();
            }
        },
    };
}

// The finest tiles that are large enough to be seen, and those above them, coloured by their kind.
function paintTiles(context, tiles, {size, zoom, offset, page}) {
    context.canvas.width = size[0];
    context.canvas.height = size[1];
    if (!tiles) return;
    context.beginPath();
    context.rect(...offset, page.width * zoom, page.height * zoom);
    context.clip();
    for (let i = 0; i < tiles.length; i += 5) {
        const [x, y, side, level, kind] = tiles.subarray(i, i + 5), wide = side * zoom;
        if (wide < 6) continue;
        context.strokeStyle = `hsl(${kind * 45 + 205} 65% 45% / ${Math.max(1 - level * 0.08, 0.4)})`;
        context.lineWidth = Math.max(3.5 - level * 0.5, 1);
        context.strokeRect(x * zoom + offset[0], y * zoom + offset[1], wide, wide);
    }
}

// What is seen of a page of millimetres, painted anew once a frame if something changed. `colours()` gives surround
// and line; `moved(zoom)` is told when the view has changed, and `painted` when dots have been painted.
function pageCanvas(canvas, over, {colours, moved, painted}) {
    const gl = canvas.getContext("webgl2", {alpha: false, antialias: false});
    const painter = gl ? paintByWebGL(gl) : paintPlainly(canvas.getContext("2d", {alpha: false}));
    let drawn, look, split, zoom = 1, offset = [0, 0], fitted = true, waiting = false;  // zoom in screen pixels a millimetre

    const ratio = () => window.devicePixelRatio || 1;
    function repaint() {
        if (waiting || !drawn) return;
        waiting = true;
        requestAnimationFrame(() => {
            waiting = false;
            const seen = {...look, ...colours(), size: [canvas.width, canvas.height], zoom, offset, page: drawn,
                          split: split && Math.round(split * canvas.width)};
            painter.paint(seen);
            paintTiles(over.getContext("2d"), drawn.tiles, seen);
            painted();
        });
    }
    function fit() {
        fitted = true;
        if (!drawn) return;
        const air = 24 * ratio();
        zoom = Math.max(Math.min((canvas.width - air) / drawn.width, (canvas.height - air) / drawn.height), 0.01);
        offset = [(canvas.width - zoom * drawn.width) / 2, (canvas.height - zoom * drawn.height) / 2];
        moved(zoom / ratio());
        repaint();
    }
    // About a point in screen pixels.
    function zoomBy(times, [x, y] = [canvas.width / 2, canvas.height / 2]) {
        const next = Math.min(Math.max(zoom * times, 0.05), 2000);
        offset = [x - (x - offset[0]) * next / zoom, y - (y - offset[1]) * next / zoom];
        zoom = next;
        fitted = false;
        moved(zoom / ratio());
        repaint();
    }
    function pan(x, y) {
        offset = [offset[0] + x, offset[1] + y];
        fitted = false;
        repaint();
    }

    new ResizeObserver(() => {
        const before = [canvas.width, canvas.height];
        canvas.width = Math.max(Math.round(canvas.clientWidth * ratio()), 1);
        canvas.height = Math.max(Math.round(canvas.clientHeight * ratio()), 1);
        if (fitted) return fit();
        pan((canvas.width - before[0]) / 2, (canvas.height - before[1]) / 2);
    }).observe(canvas);

    const at = (event) => [event.offsetX * ratio(), event.offsetY * ratio()];
    canvas.addEventListener("wheel", (event) => {
        event.preventDefault();
        const lines = event.deltaMode === 1 ? 20 : 1;
        zoomBy(Math.exp(-event.deltaY * lines * (event.ctrlKey ? 0.01 : 0.0015)), at(event));
    }, {passive: false});
    const held = new Map();  // pointers, by where they are
    const middle = () => [0, 1].map((i) => [...held.values()].reduce((sum, p) => sum + p[i], 0) / held.size);
    const spread = () => {
        const [a, b] = [...held.values()];
        return b ? Math.hypot(a[0] - b[0], a[1] - b[1]) : 0;
    };
    canvas.addEventListener("pointerdown", (event) => {
        canvas.setPointerCapture(event.pointerId);
        held.set(event.pointerId, at(event));
    });
    canvas.addEventListener("pointermove", (event) => {
        if (!held.has(event.pointerId)) return;
        const from = middle(), wide = spread();
        held.set(event.pointerId, at(event));
        const to = middle();
        pan(to[0] - from[0], to[1] - from[1]);
        if (wide > 0) zoomBy(spread() / wide, to);
    });
    for (const end of ["pointerup", "pointercancel"])
        canvas.addEventListener(end, (event) => held.delete(event.pointerId));
    canvas.addEventListener("dblclick", fit);
    const step = () => 60 * ratio();
    const keys = {
        ArrowLeft: () => pan(step(), 0), ArrowRight: () => pan(-step(), 0), ArrowUp: () => pan(0, step()),
        ArrowDown: () => pan(0, -step()), "+": () => zoomBy(1.25), "=": () => zoomBy(1.25), "-": () => zoomBy(0.8),
        f: fit, F: fit,
    };
    canvas.addEventListener("keydown", (event) => {
        if (event.ctrlKey || event.metaKey || event.altKey || !keys[event.key]) return;
        event.preventDefault();
        keys[event.key]();
    });

    return {
        repaint, fit,
        // `how`: paper, pens and whether they are transparent.
        show(drawing, how) {
            const other = !drawn || drawn.width !== drawing.width || drawn.height !== drawing.height;
            drawn = drawing;
            look = how;
            painter.setDots(drawing.positions, 0);
            if (fitted && other) fit();
            repaint();
        },
        // Other dots of the same page to the right of that share of the canvas; none: those of show() everywhere.
        showBeside(drawing) {
            painter.setDots(drawing.positions, 1);
            repaint();
        },
        splitAt(share) {
            split = share;
            repaint();
        },
    };
}
