// The engine in a thread of its own: {id, ask, what} comes, {id, answer} or {id, error} goes.
let engine;

const answers = {
    start: async (module) => {
        engine = await startEngine(module);
        return {};
    },
    describe: async () => ({usual: engine.usualSettings(), rows: engine.rows(), tiles: engine.tiles(), most: engine.mostDots()}),
    changed: async (text) => engine.changed(text),
    picture: async (picture) => engine.setPicture(picture),
    draw: async (settings) => engine.draw(settings),
    file: async (format) => engine.file(format),
    spectrum: async () => engine.spectrum(),
    pixels: async (dpi) => engine.pixels(dpi),
};

// One after the other, in their order.
let last = Promise.resolve();
onmessage = ({data: {id, ask, what}}) => {
    last = last.then(async () => {
        try {
            const answer = await answers[ask](what);
            const moved = [answer.positions?.buffer, answer.tiles?.buffer, answer.rgba?.buffer].filter(Boolean);
            postMessage({id, answer}, moved);
        } catch (failed) {
            const lost = failed instanceof WebAssembly.RuntimeError || failed instanceof RangeError;
            postMessage({id, error: lost ? "there is not enough memory for this" : failed.message});
        }
    });
};
