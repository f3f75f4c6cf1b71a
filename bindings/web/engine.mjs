// The engine: WebAssembly of engine.cpp, with nothing of a system around it. Worker and tests start it.

// `module`: a WebAssembly.Module of engine.wasm. What fails throws an Error with the library's sentence.
export async function startEngine(module) {
    const imports = {};
    for (const {module: from, name} of WebAssembly.Module.imports(module))
        (imports[from] ??= {})[name] = () => 52;  // "not there", as WASI says it
    // Clocks alone have to work.
    if (imports.wasi_snapshot_preview1?.clock_time_get)
        imports.wasi_snapshot_preview1.clock_time_get = (clock, precision, place) => {
            new DataView(exports.memory.buffer).setBigUint64(place, BigInt(Math.round(performance.now() * 1e6)), true);
            return 0;
        };
    const {exports} = await WebAssembly.instantiate(module, imports);
    exports._initialize();

    const bytes = () => new Uint8Array(exports.memory.buffer);
    // What `work` returns, given the place of a copy of `content` that is there meanwhile.
    const withCopy = (content, work) => {
        const place = exports.malloc(content.length);
        if (!place) throw new Error("there is not enough memory");
        bytes().set(content, place);
        try {
            return work(place);
        } finally {
            exports.free(place);
        }
    };
    const textAt = (place) => {
        const all = bytes();
        return new TextDecoder().decode(all.slice(place, all.indexOf(0, place)));
    };
    const given = (returned) => {
        if (!returned) throw new Error(textAt(exports.engine_error()));
        return returned;
    };
    const withText = (text, work) => withCopy(new TextEncoder().encode(text + "\0"), work);
    const textOf = (name, text) =>
        text === undefined ? textAt(given(exports[name]()))
                           : withText(text, (place) => textAt(given(exports[name](place))));

    return {
        usualSettings: () => JSON.parse(textOf("engine_usual_settings")),
        rows: () => JSON.parse(textOf("engine_rows")),
        mostDots: () => exports.engine_most_dots(),
        tiles: () => textOf("engine_tile_names").split(" "),
        // What a project's or a drawing's text changes of the usual settings.
        changed: (text) => JSON.parse(textOf("engine_changed", text)),
        // Red, green, blue and alpha, as a canvas has them.
        setPicture: ({pixels, width, height}) =>
            withCopy(pixels, (place) => given(exports.engine_set_picture(place, width, height))),
        // What was drawn, and `positions`: x, y and radius in millimetres and the pen of each dot, one after the other.
        // `tiles`, if they are shown: x, y and side in millimetres, level and kind.
        draw(settings) {
            const {page_mm: [width, height], radius_mm: radius, ...others} = JSON.parse(textOf("engine_draw", JSON.stringify(settings)));
            const drawn = {...others, width, height, radius};
            const numbers = (place, count) => new Float32Array(exports.memory.buffer, place, count).slice();
            const positions = numbers(exports.engine_dots(), 4 * drawn.dots);
            if (!settings.drawing?.show_tiles) return {...drawn, positions};
            const count = given(exports.engine_find_tiles());
            return {...drawn, positions, tiles: numbers(exports.engine_tiles(), 5 * count)};
        },
        file: (format) => textOf("engine_file", format),
        // Red, green, blue and alpha.
        pixels(dpi) {
            return pixelsAt(given(exports.engine_pixels(dpi)));
        },
        // Of the drawing: {dots, period, periodicity} of those that were measured, and the picture of their spectrum.
        spectrum() {
            const measured = JSON.parse(textOf("engine_spectrum"));
            return {...measured, ...pixelsAt(exports.engine_spectrum_pixels())};
        },
    };

    function pixelsAt(place) {
        const width = exports.engine_pixels_width(), height = exports.engine_pixels_height();
        const rgb = new Uint8Array(exports.memory.buffer, place, 3 * width * height);
        const rgba = new Uint8ClampedArray(4 * width * height).fill(255);
        for (let i = 0, j = 0; i < rgb.length; i += 3, j += 4) rgba.set(rgb.subarray(i, i + 3), j);
        return {width, height, rgba};
    }
}
